//! The user's expressions on the graph: as values, and as jets where their time derivatives are needed.

use super::coordinates::{Layout, Symbols};
use super::jet::{Jet, Moving};
use super::kinematics::Kinematics;
use super::{Wrench, conditions, friction, loads, look_up, plane, space};
use crate::model::{
    Comparison, Condition, Coordinate, Expr, Function1, Function2, JointId, Load, LoadId, Mechanism,
    MemoryId, Place, Quantity, ReactionPart, Rotor, Vector,
};
use crate::symbolic::{Compare, Node, On, Scalar, Sheet, Unary};
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// What expressions may refer to.
#[derive(Clone, Copy)]
pub struct Laws<'a> {
    /// What they are written on.
    pub g: Sheet<'a>,
    pub mechanism: &'a Mechanism,
    pub symbols: &'a Symbols,
    pub layout: &'a Layout,
    kinematics: &'a Kinematics,
    totals: &'a Totals,
    known: Option<&'a Known>,
    /// What the parameter of a curve is.
    along: Option<&'a Moving<'a>>,
}

/// Values of coordinates that have been found: for expressions that name the same ones over and over.
#[derive(Default)]
pub struct Known(RefCell<Vec<(Coordinate, Node)>>);

/// Quantities of the whole mechanism that only outputs may name.
#[derive(Clone, Debug, Default)]
pub struct Totals {
    pub kinetic: Option<Node>,
    pub potential: Option<Node>,
    /// Per load.
    pub powers: Vec<Node>,
    /// Per driver.
    pub efforts: Vec<Node>,
    pub driver_powers: Vec<Node>,
    /// Per coupling or equation.
    pub constraint_efforts: Vec<Node>,
    /// Per joint, force and torque.
    pub reactions: Vec<Wrench>,
}

static NO_LAYOUT: Layout =
    Layout { linear: Vec::new(), rotations: Vec::new(), quaternions: Vec::new(), angles: Vec::new() };
static NO_PLANE: plane::Kinematics = plane::Kinematics {
    frames: Vec::new(),
    velocities: Vec::new(),
    bodies: Vec::new(),
    travels: BTreeMap::new(),
};
static NO_KINEMATICS: Kinematics = Kinematics::Plane(plane::Kinematics {
    frames: Vec::new(),
    velocities: Vec::new(),
    bodies: Vec::new(),
    travels: BTreeMap::new(),
});
static NO_TOTALS: Totals = Totals {
    kinetic: None,
    potential: None,
    powers: Vec::new(),
    efforts: Vec::new(),
    driver_powers: Vec::new(),
    constraint_efforts: Vec::new(),
    reactions: Vec::new(),
};

impl<'a> Laws<'a> {
    /// For expressions of parameters and time.
    pub fn constant(g: Sheet<'a>, mechanism: &'a Mechanism, symbols: &'a Symbols) -> Self {
        let (layout, kinematics, totals) = (&NO_LAYOUT, &NO_KINEMATICS, &NO_TOTALS);
        Laws { g, mechanism, symbols, layout, kinematics, totals, known: None, along: None }
    }

    /// For expressions of the motion.
    pub fn moving(
        g: Sheet<'a>,
        mechanism: &'a Mechanism,
        symbols: &'a Symbols,
        layout: &'a Layout,
        kinematics: &'a Kinematics,
    ) -> Self {
        Laws { g, mechanism, symbols, layout, kinematics, totals: &NO_TOTALS, known: None, along: None }
    }

    /// A jet in the velocities of the motion.
    pub fn moving_by(&self, jet: Jet) -> Moving<'a> {
        self.g.zero().moving(self.velocities(), jet)
    }

    /// Of other kinematics with the same meaning.
    pub fn of<'b>(&self, kinematics: &'b Kinematics) -> Laws<'b>
    where
        'a: 'b,
    {
        Laws { kinematics, ..*self }
    }

    /// That find each coordinate once.
    pub fn knowing<'b>(&self, known: &'b Known) -> Laws<'b>
    where
        'a: 'b,
    {
        Laws { known: Some(known), ..*self }
    }

    /// For the functions of a curve: the parameter in them is this.
    pub fn along<'b>(&self, parameter: &'b Moving<'b>) -> Laws<'b>
    where
        'a: 'b,
    {
        Laws { known: None, along: Some(parameter), ..*self }
    }

    /// v.
    fn velocities(&self) -> &'a [Node] {
        self.along.map_or_else(|| self.kinematics.velocities(), |parameter| parameter.velocities)
    }

    /// For outputs, which may also name energies, powers and drivers' efforts.
    pub fn with_totals(self, totals: &'a Totals) -> Self {
        Laws { totals, ..self }
    }

    pub fn kinematics(&self) -> On<'a, &'a Kinematics> {
        self.g.on(self.kinematics)
    }

    /// The kinematics of a planar mechanism.
    pub fn plane(&self) -> On<'a, &'a plane::Kinematics> {
        self.g.on(match self.kinematics {
            Kinematics::Plane(plane) => plane,
            Kinematics::Space(_) => &NO_PLANE,
        })
    }

    /// The kinematics of a spatial mechanism.
    pub fn space(&self) -> Option<On<'a, &'a space::Kinematics>> {
        match self.kinematics {
            Kinematics::Plane(_) => None,
            Kinematics::Space(space) => Some(self.g.on(space)),
        }
    }

    pub fn value(&self, expr: &Expr) -> Scalar<'a> {
        match expr {
            Expr::Number(value) => self.g.number(*value),
            Expr::Parameter(parameter) => self.g.on(self.symbols.parameters[parameter.0]),
            Expr::Input(input) => self.g.on(self.symbols.inputs[input.0]),
            Expr::State(state) => self.g.on(self.symbols.internal[state.0]),
            Expr::Memory(memory) => self.memory(*memory),
            Expr::Gate(load, which) => self.gate(*load, *which),
            Expr::Time => self.g.on(self.symbols.time),
            Expr::Quantity(quantity) => self.quantity(quantity),
            Expr::Unary(function, a) => {
                let a = self.value(a);
                unary(*function).map_or_else(|| -a, |function| a.unary(function))
            }
            Expr::Binary(function, a, b) => {
                let (a, b) = (self.value(a), self.value(b));
                match function {
                    Function2::Add => a + b,
                    Function2::Sub => a - b,
                    Function2::Mul => a * b,
                    Function2::Div => a / b,
                    Function2::Min => a.min(b),
                    Function2::Max => a.max(b),
                    Function2::Atan2 => a.atan2(b),
                }
            }
            Expr::Power(base, exponent) => power(self.value(base), *exponent),
            Expr::If(condition, then, otherwise) => {
                self.mask(condition).select(self.value(then), self.value(otherwise))
            }
            Expr::Rate(of) => self.jet(of).rate(),
            Expr::Table(look_up) => {
                let arguments: Vec<Scalar> = look_up.arguments.iter().map(|it| self.value(it)).collect();
                look_up::value(look_up, &arguments, &self.turns(), self.g)
            }
        }
    }

    /// The gate of one of a contact's gaps.
    pub fn gate(&self, load: LoadId, which: usize) -> Scalar<'a> {
        let at = self.mechanism.gates().position(|gate| gate == (load, which));
        at.map_or_else(|| self.g.zero(), |at| self.g.on(self.symbols.gates[at]))
    }

    /// What a memory holds.
    pub fn memory(&self, memory: MemoryId) -> Scalar<'a> {
        self.g.on(self.symbols.gates[self.mechanism.place_of_memory(memory)])
    }

    /// The internal states that a load has.
    pub fn states(&self, load: &Load) -> Vec<Scalar<'a>> {
        self.g.all(&self.symbols.internal[load.states.clone()])
    }

    pub fn vector(&self, vector: &Vector) -> On<'a, [Node; 3]> {
        self.g.on([0, 1, 2].map(|k| self.value(&vector[k]).bare))
    }

    /// The components in the plane.
    pub fn pair_of(&self, vector: &Vector) -> On<'a, [Node; 2]> {
        self.g.on([0, 1].map(|k| self.value(&vector[k]).bare))
    }

    /// (cos, sin) of an angle that does not move.
    pub fn pair(&self, angle: &Expr) -> On<'a, [Node; 2]> {
        let angle = self.value(angle);
        self.g.on([angle.cos().bare, angle.sin().bare])
    }

    /// What does not move.
    pub fn still(&self, value: Scalar<'a>) -> Moving<'a> {
        value.moving(self.velocities(), Jet::constant(value))
    }

    pub fn jet(&self, expr: &Expr) -> Moving<'a> {
        match expr {
            Expr::Number(_)
            | Expr::Parameter(_)
            | Expr::Input(_)
            | Expr::State(_)
            | Expr::Memory(_)
            | Expr::Gate(..) => self.still(self.value(expr)),
            Expr::Time => {
                let time = self.g.on(self.symbols.time);
                time.moving(self.velocities(), Jet::time(time))
            }
            Expr::Quantity(Quantity::Coordinate(coordinate)) => self.coordinate(coordinate),
            // Nothing whose derivative is needed depends on these.
            Expr::Quantity(result) => self.still(self.quantity(result)),
            Expr::Rate(_) => self.still(self.value(expr)),
            Expr::Unary(function, a) => {
                let a = self.jet(a);
                unary(*function).map_or_else(|| -&a, |function| a.unary(function))
            }
            Expr::Binary(function, a, b) => {
                let (a, b) = (self.jet(a), self.jet(b));
                match function {
                    Function2::Add => a + b,
                    Function2::Sub => a - b,
                    Function2::Mul => a * b,
                    Function2::Div => a / b,
                    Function2::Min => a.min(&b),
                    Function2::Max => a.max(&b),
                    Function2::Atan2 => a.atan2(&b),
                }
            }
            Expr::Power(base, exponent) => {
                // (xⁿ)′ = n xⁿ⁻¹
                let n = *exponent;
                let jet = self.jet(base);
                let x = jet.value();
                let (value, first) = (power(x, n), n * power(x, n - 1.0));
                jet.chain(value, first, n * ((n - 1.0) * power(x, n - 2.0)))
            }
            Expr::Table(look_up) => {
                let arguments: Vec<Moving> = look_up.arguments.iter().map(|it| self.jet(it)).collect();
                look_up::jet(look_up, &arguments, &self.turns()).unwrap_or_else(|| self.still(self.g.zero()))
            }
            Expr::If(condition, then, otherwise) => {
                Moving::select(self.mask(condition), &self.jet(then), &self.jet(otherwise))
            }
        }
    }

    /// A place of the ground in world axes, as a function of time.
    pub fn ground(&self, at: &Vector) -> [Moving<'a>; 3] {
        [0, 1, 2].map(|k| self.jet(&at[k]))
    }

    /// Whether the dynamics count a rotor's turns.
    pub fn is_counted(&self, rotor: Rotor) -> bool {
        self.layout.angles.iter().any(|angle| angle.rotor == rotor)
    }

    /// Angle of a rotor: the multi-turn coordinate if the dynamics carry one, else atan2 in (−π, π].
    pub fn angle(&self, rotor: Rotor) -> Moving<'a> {
        let value = match self.layout.angles.iter().position(|angle| angle.rotor == rotor) {
            Some(index) => {
                let at = self.layout.turns(index);
                TAU * self.g.on(self.symbols.q[at]) + self.symbols.q[at + 1]
            }
            None => {
                let [cosine, sine] = self.kinematics().rotor_pair(self, rotor).parts();
                sine.atan2(cosine)
            }
        };
        let mut angle = self.kinematics().rotor_rate(self, rotor);
        angle.jet.value = value.bare;
        angle
    }

    /// Σ factor · angle over `over`, whole turns put together before they are multiplied: where turns cancel, many are as good as none.
    pub fn sum_of_angles(&self, terms: &[(f64, Rotor)], over: f64) -> Moving<'a> {
        let (mut turns, mut rest) = (self.g.zero(), self.g.zero());
        let mut sum = self.still(self.g.zero());
        for (factor, rotor) in terms {
            match self.layout.angles.iter().position(|angle| angle.rotor == *rotor) {
                Some(index) => {
                    let at = self.layout.turns(index);
                    turns += *factor * self.g.on(self.symbols.q[at]);
                    rest += *factor * self.g.on(self.symbols.q[at + 1]);
                }
                None => rest += *factor * self.angle(*rotor).value(),
            }
            sum = sum + (*factor / over) * self.kinematics().rotor_rate(self, *rotor);
        }
        sum.jet.value = ((TAU * turns + rest) / over).bare;
        sum
    }

    /// The entries of q that count whole turns of angles.
    fn turns(&self) -> Vec<Node> {
        (0..self.layout.angles.len()).map(|angle| self.symbols.q[self.layout.turns(angle)]).collect()
    }

    pub fn coordinate(&self, coordinate: &Coordinate) -> Moving<'a> {
        if let Some(parameter) = self.along {
            return parameter.clone();
        }
        match coordinate {
            Coordinate::Angle(rotor) => self.angle(*rotor),
            Coordinate::Travel(joint, which) => self.kinematics().travel(self, *joint, *which),
            Coordinate::Position(place, axis) => self.kinematics().world(self, place)[*axis].clone(),
            Coordinate::Turn(body, axis) => self.kinematics().omega(*body, *axis),
            Coordinate::Mode(body, mode, _) => self
                .kinematics()
                .mode(body.0, usize::from(*mode))
                .unwrap_or_else(|| self.still(self.g.zero())),
            Coordinate::Deviation(body, axis) => {
                let mut stated = self.mechanism.orientations.iter();
                match stated.find(|start| start.body == *body) {
                    Some(start) => {
                        let quaternion = [0, 1, 2, 3].map(|k| self.value(&start.quaternion[k]).bare);
                        self.kinematics().deviation(*body, self.g.on(quaternion))[*axis].clone()
                    }
                    None => self.still(self.g.zero()),
                }
            }
            Coordinate::Closing(joint, form) => match conditions::row_of(self, *joint, form) {
                Some(row) => self.moving_by(row.jet),
                None => self.still(self.g.zero()),
            },
            Coordinate::Distance(a, b) => self.square(a, b).sqrt(),
            Coordinate::Square(a, b) => self.square(a, b),
            Coordinate::Way(ends, direction) => self.kinematics().way(self, &ends[0], direction, &ends[1]),
            Coordinate::Direction(of, axis) => self.kinematics().direction(self, &of.0, &of.1)[*axis].clone(),
        }
    }

    /// The value of a coordinate.
    fn measure(&self, coordinate: &Coordinate) -> Scalar<'a> {
        let Some(Known(known)) = self.known else { return self.coordinate(coordinate).value() };
        if let Some((_, value)) = known.borrow().iter().find(|(it, _)| it == coordinate) {
            return self.g.on(*value);
        }
        let value = self.coordinate(coordinate).value();
        known.borrow_mut().push((coordinate.clone(), value.bare));
        value
    }

    /// Δ·Δ.
    fn square(&self, a: &Place, b: &Place) -> Moving<'a> {
        let delta = self.kinematics().between(self, a, b);
        let squares: Vec<Moving> = delta.iter().map(|d| d * d).collect();
        let (first, rest) = squares.split_at(1);
        rest.iter().fold(first[0].clone(), |sum, square| sum + square)
    }

    fn quantity(&self, quantity: &Quantity) -> Scalar<'a> {
        let total = |total: Option<&Node>| total.map_or_else(|| self.g.zero(), |total| self.g.on(*total));
        match quantity {
            Quantity::Coordinate(coordinate) => self.measure(coordinate),
            Quantity::Rate(coordinate) => self.coordinate(coordinate).rate(),
            Quantity::Power(load) => total(self.totals.powers.get(load.0)),
            Quantity::DriverPower(driver) => total(self.totals.driver_powers.get(driver.0)),
            Quantity::DriverEffort(driver) => total(self.totals.efforts.get(driver.0)),
            Quantity::LoadEffort(load) => loads::effort(self, &self.mechanism.loads[load.0]),
            Quantity::OfTeeth(load, part) => {
                loads::teeth::of_teeth(self, &self.mechanism.loads[load.0], *part)
            }
            Quantity::Pressing(load) => friction::pressed(self, &self.mechanism.loads[load.0]),
            Quantity::Sliding { contact, which, axis } => {
                friction::sliding(self, &self.mechanism.loads[contact.0], *which, *axis)
            }
            Quantity::ConstraintEffort(constraint) => total(self.totals.constraint_efforts.get(constraint.0)),
            Quantity::Reaction(joint, part) => self.reaction(*joint, *part),
            Quantity::KineticEnergy => total(self.totals.kinetic.as_ref()),
            Quantity::PotentialEnergy => total(self.totals.potential.as_ref()),
            Quantity::Energy => total(self.totals.kinetic.as_ref()) + total(self.totals.potential.as_ref()),
        }
    }

    /// A part of what a joint exerts.
    fn reaction(&self, joint: JointId, part: ReactionPart) -> Scalar<'a> {
        let Some(wrench) = self.totals.reactions.get(joint.0) else { return self.g.zero() };
        let entries = self.g.all(wrench);
        let (force, torque) = entries.split_at(self.mechanism.space.dimensions());
        match part {
            ReactionPart::Force(axis) => force[axis],
            ReactionPart::Normal => {
                let joint = &self.mechanism.joints[joint.0];
                let [x, y] = self.plane().normal(self, joint).parts();
                x * force[0] + y * force[1]
            }
            ReactionPart::Size => force
                .iter()
                .map(|x| *x * *x)
                .reduce(|sum, square| sum + square)
                .map_or(self.g.zero(), Scalar::sqrt),
            // −f·Δ/L, f on the second place.
            ReactionPart::Tension => {
                let joint = &self.mechanism.joints[joint.0];
                let between = self.kinematics().between(self, &joint.first, &joint.second);
                let work = force.iter().zip(&between).map(|(force, delta)| *force * delta.value());
                -(self.g.sum(work) / self.value(joint.scalar(0)))
            }
            // f·n, f on the second place.
            ReactionPart::Pressing => {
                let [x, y] = plane::joints::out_of_curve(self, joint).parts();
                x * force[0] + y * force[1]
            }
            // In the plane there is one.
            ReactionPart::Torque(axis) => torque[axis.min(torque.len() - 1)],
        }
    }

    fn mask(&self, condition: &Condition) -> Scalar<'a> {
        match condition {
            Condition::Compare(comparison, a, b) => {
                let (a, b) = (self.value(a), self.value(b));
                match comparison {
                    Comparison::Less => a.compare(Compare::Less, b),
                    Comparison::LessEqual => a.compare(Compare::LessEqual, b),
                    Comparison::Greater => b.compare(Compare::Less, a),
                    Comparison::GreaterEqual => b.compare(Compare::LessEqual, a),
                    Comparison::Equal => a.compare(Compare::Equal, b),
                    Comparison::NotEqual => !a.compare(Compare::Equal, b),
                }
            }
            Condition::And(a, b) => self.mask(a) & self.mask(b),
            Condition::Or(a, b) => self.mask(a) | self.mask(b),
            Condition::Not(a) => !self.mask(a),
        }
    }
}

fn unary(function: Function1) -> Option<Unary> {
    Some(match function {
        Function1::Neg => return None,
        Function1::Sqrt => Unary::Sqrt,
        Function1::Abs => Unary::Abs,
        Function1::Sign => Unary::Sign,
        Function1::Sin => Unary::Sin,
        Function1::Cos => Unary::Cos,
        Function1::Tan => Unary::Tan,
        Function1::Asin => Unary::Asin,
        Function1::Acos => Unary::Acos,
        Function1::Exp => Unary::Exp,
        Function1::Ln => Unary::Ln,
        Function1::Log10 => Unary::Log10,
        Function1::Sinh => Unary::Sinh,
        Function1::Cosh => Unary::Cosh,
        Function1::Tanh => Unary::Tanh,
        Function1::Floor => Unary::Floor,
    })
}

/// x to a constant exponent: products for integers, a root for halves, exp(n ln x) for the rest.
pub fn power(x: Scalar, exponent: f64) -> Scalar {
    if exponent.fract() == 0.0 && exponent.abs() <= 64.0 {
        return x.power(exponent as i32);
    }
    if (2.0 * exponent).fract() == 0.0 && exponent.abs() <= 64.0 {
        return x.sqrt().power((2.0 * exponent) as i32);
    }
    let logarithm = x.unary(Unary::Ln);
    (exponent * logarithm).unary(Unary::Exp)
}
