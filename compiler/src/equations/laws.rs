//! The user's expressions on the graph: as values, and as jets where their time derivatives are needed.

use super::coordinates::{Layout, Symbols};
use super::jet::Jet;
use super::kinematics::Kinematics;
use super::plane;
use crate::model::{Comparison, Condition, Expr, Function1, Function2, Mechanism, Quantity, Rotor, Vector};
use crate::symbolic::{Compare, Graph, Node, Unary};

/// What expressions may refer to.
#[derive(Clone, Copy)]
pub struct Laws<'a> {
    pub mechanism: &'a Mechanism,
    pub symbols: &'a Symbols,
    pub layout: &'a Layout,
    kinematics: &'a Kinematics,
    totals: &'a Totals,
}

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
}

static NO_LAYOUT: Layout =
    Layout { linear: Vec::new(), rotations: Vec::new(), quaternions: Vec::new(), angles: Vec::new() };
static NO_PLANE: plane::Kinematics =
    plane::Kinematics { frames: Vec::new(), velocities: Vec::new(), bodies: Vec::new() };
static NO_KINEMATICS: Kinematics =
    Kinematics::Plane(plane::Kinematics { frames: Vec::new(), velocities: Vec::new(), bodies: Vec::new() });
static NO_TOTALS: Totals = Totals {
    kinetic: None,
    potential: None,
    powers: Vec::new(),
    efforts: Vec::new(),
    driver_powers: Vec::new(),
};

impl<'a> Laws<'a> {
    /// For expressions of parameters and time.
    pub fn constant(mechanism: &'a Mechanism, symbols: &'a Symbols) -> Self {
        Laws { mechanism, symbols, layout: &NO_LAYOUT, kinematics: &NO_KINEMATICS, totals: &NO_TOTALS }
    }

    /// For expressions of the motion.
    pub fn moving(
        mechanism: &'a Mechanism,
        symbols: &'a Symbols,
        layout: &'a Layout,
        kinematics: &'a Kinematics,
    ) -> Self {
        Laws { mechanism, symbols, layout, kinematics, totals: &NO_TOTALS }
    }

    /// For outputs, which may also name energies, powers and drivers' efforts.
    pub fn with_totals(self, totals: &'a Totals) -> Self {
        Laws { totals, ..self }
    }

    pub fn kinematics(&self) -> &'a Kinematics {
        self.kinematics
    }

    /// The kinematics of a planar mechanism.
    pub fn plane(&self) -> &'a plane::Kinematics {
        match self.kinematics {
            Kinematics::Plane(plane) => plane,
            Kinematics::Space(_) => &NO_PLANE,
        }
    }

    pub fn value(&self, g: &mut Graph, expr: &Expr) -> Node {
        match expr {
            Expr::Number(value) => g.constant(*value),
            Expr::Parameter(parameter) => self.symbols.parameters[parameter.0],
            Expr::Input(input) => self.symbols.inputs[input.0],
            Expr::Time => self.symbols.time,
            Expr::Quantity(quantity) => self.quantity_value(g, quantity),
            Expr::Unary(function, a) => {
                let a = self.value(g, a);
                match unary(*function) {
                    None => g.neg(a),
                    Some(function) => g.unary(function, a),
                }
            }
            Expr::Binary(function, a, b) => {
                let (a, b) = (self.value(g, a), self.value(g, b));
                match function {
                    Function2::Add => g.add(a, b),
                    Function2::Sub => g.sub(a, b),
                    Function2::Mul => g.mul(a, b),
                    Function2::Div => g.div(a, b),
                    Function2::Min => g.min(a, b),
                    Function2::Max => g.max(a, b),
                    Function2::Atan2 => g.atan2(a, b),
                }
            }
            Expr::Power(base, exponent) => {
                let base = self.value(g, base);
                power(g, base, *exponent)
            }
            Expr::If(condition, then, otherwise) => {
                let mask = self.mask(g, condition);
                let (then, otherwise) = (self.value(g, then), self.value(g, otherwise));
                g.select(mask, then, otherwise)
            }
        }
    }

    pub fn vector(&self, g: &mut Graph, vector: &Vector) -> [Node; 3] {
        [self.value(g, &vector[0]), self.value(g, &vector[1]), self.value(g, &vector[2])]
    }

    /// The components in the plane.
    pub fn pair_of(&self, g: &mut Graph, vector: &Vector) -> [Node; 2] {
        [self.value(g, &vector[0]), self.value(g, &vector[1])]
    }

    /// (cos, sin) of an angle that does not move.
    pub fn pair(&self, g: &mut Graph, angle: &Expr) -> [Node; 2] {
        let angle = self.value(g, angle);
        [g.unary(Unary::Cos, angle), g.unary(Unary::Sin, angle)]
    }

    pub fn jet(&self, g: &mut Graph, expr: &Expr) -> Jet {
        let v = self.kinematics.velocities();
        match expr {
            Expr::Number(_) | Expr::Parameter(_) | Expr::Input(_) => {
                let value = self.value(g, expr);
                Jet::constant(g, value)
            }
            Expr::Time => Jet::time(g, self.symbols.time),
            Expr::Quantity(quantity) => self.quantity(g, quantity),
            Expr::Unary(function, a) => {
                let a = self.jet(g, a);
                match unary(*function) {
                    None => a.neg(g),
                    Some(function) => a.unary(g, function, v),
                }
            }
            Expr::Binary(function, a, b) => {
                let (a, b) = (self.jet(g, a), self.jet(g, b));
                match function {
                    Function2::Add => a.add(g, &b),
                    Function2::Sub => a.sub(g, &b),
                    Function2::Mul => a.mul(g, &b, v),
                    Function2::Div => a.div(g, &b, v),
                    Function2::Min => a.minimum(g, &b),
                    Function2::Max => a.maximum(g, &b),
                    Function2::Atan2 => a.atan2(g, &b, v),
                }
            }
            Expr::Power(base, exponent) => {
                // (xⁿ)′ = n xⁿ⁻¹
                let x = self.jet(g, base);
                let (n, m) = (g.constant(*exponent), g.constant(*exponent - 1.0));
                let value = power(g, x.value, *exponent);
                let first = power(g, x.value, *exponent - 1.0);
                let first = g.mul(n, first);
                let second = power(g, x.value, *exponent - 2.0);
                let second = g.mul(m, second);
                let second = g.mul(n, second);
                x.chain(g, value, first, second, v)
            }
            Expr::If(condition, then, otherwise) => {
                let mask = self.mask(g, condition);
                let (then, otherwise) = (self.jet(g, then), self.jet(g, otherwise));
                Jet::select(g, mask, &then, &otherwise)
            }
        }
    }

    /// A place of the ground in world axes, as a function of time.
    pub fn ground(&self, g: &mut Graph, at: &Vector) -> [Jet; 3] {
        [self.jet(g, &at[0]), self.jet(g, &at[1]), self.jet(g, &at[2])]
    }

    /// Whether the dynamics count a rotor's turns.
    pub fn is_counted(&self, rotor: Rotor) -> bool {
        self.layout.angles.iter().any(|angle| angle.rotor == rotor)
    }

    /// Angle of a rotor: the multi-turn coordinate if the dynamics carry one, else atan2 in (−π, π].
    pub fn angle(&self, g: &mut Graph, rotor: Rotor) -> Jet {
        let value = match self.layout.angles.iter().position(|angle| angle.rotor == rotor) {
            Some(index) => {
                let at = self.layout.turns(index);
                let turn = g.constant(std::f64::consts::TAU);
                let whole = g.mul(turn, self.symbols.q[at]);
                g.add(whole, self.symbols.q[at + 1])
            }
            None => {
                let [cosine, sine] = self.kinematics.rotor_pair(g, self, rotor);
                g.atan2(sine, cosine)
            }
        };
        Jet { value, ..self.kinematics.rotor_rate(g, self, rotor) }
    }

    pub fn quantity(&self, g: &mut Graph, quantity: &Quantity) -> Jet {
        match quantity {
            Quantity::BodyAngle(body) => self.angle(g, Rotor::Body(*body)),
            Quantity::JointAngle(joint, which) => self.angle(g, Rotor::Joint(*joint, *which)),
            Quantity::JointTravel(joint, which) => self.kinematics.travel(g, self, *joint, *which),
            Quantity::Position(place, axis) => self.kinematics.world(g, self, place)[*axis].clone(),
            Quantity::BodyOmega(body, axis) => self.kinematics.omega(g, *body, *axis),
            Quantity::Distance(a, b) => {
                let v = self.kinematics.velocities();
                let delta = self.kinematics.between(g, self, a, b);
                let squares: Vec<Jet> = delta.iter().map(|jet| jet.mul(g, jet, v)).collect();
                let (first, rest) = squares.split_at(1);
                let sum = rest.iter().fold(first[0].clone(), |sum, square| sum.add(g, square));
                sum.unary(g, Unary::Sqrt, v)
            }
            _ => {
                let value = self.quantity_value(g, quantity);
                Jet::constant(g, value)
            }
        }
    }

    fn quantity_value(&self, g: &mut Graph, quantity: &Quantity) -> Node {
        let v = self.kinematics.velocities();
        let zero = g.constant(0.0);
        match quantity {
            Quantity::BodyRate(body) => self.quantity(g, &Quantity::BodyAngle(*body)).rate(g, v),
            Quantity::BodyOmega(body, axis) => self.kinematics.omega(g, *body, *axis).rate(g, v),
            Quantity::JointRate(joint, which) => {
                self.quantity(g, &Quantity::JointAngle(*joint, *which)).rate(g, v)
            }
            Quantity::JointSpeed(joint, which) => {
                self.quantity(g, &Quantity::JointTravel(*joint, *which)).rate(g, v)
            }
            Quantity::Velocity(place, axis) => {
                self.quantity(g, &Quantity::Position(place.clone(), *axis)).rate(g, v)
            }
            Quantity::Power(load) => self.totals.powers.get(load.0).copied().unwrap_or(zero),
            Quantity::DriverPower(driver) => self.totals.driver_powers.get(driver.0).copied().unwrap_or(zero),
            Quantity::DriverEffort(driver) => self.totals.efforts.get(driver.0).copied().unwrap_or(zero),
            Quantity::KineticEnergy => self.totals.kinetic.unwrap_or(zero),
            Quantity::PotentialEnergy => self.totals.potential.unwrap_or(zero),
            Quantity::Energy => {
                let kinetic = self.totals.kinetic.unwrap_or(zero);
                g.add(kinetic, self.totals.potential.unwrap_or(zero))
            }
            _ => self.quantity(g, quantity).value,
        }
    }

    fn mask(&self, g: &mut Graph, condition: &Condition) -> Node {
        match condition {
            Condition::Compare(comparison, a, b) => {
                let (a, b) = (self.value(g, a), self.value(g, b));
                match comparison {
                    Comparison::Less => g.compare(Compare::Less, a, b),
                    Comparison::LessEqual => g.compare(Compare::LessEqual, a, b),
                    Comparison::Greater => g.compare(Compare::Less, b, a),
                    Comparison::GreaterEqual => g.compare(Compare::LessEqual, b, a),
                    Comparison::Equal => g.compare(Compare::Equal, a, b),
                    Comparison::NotEqual => {
                        let equal = g.compare(Compare::Equal, a, b);
                        g.not(equal)
                    }
                }
            }
            Condition::And(a, b) => {
                let (a, b) = (self.mask(g, a), self.mask(g, b));
                g.and(a, b)
            }
            Condition::Or(a, b) => {
                let (a, b) = (self.mask(g, a), self.mask(g, b));
                g.or(a, b)
            }
            Condition::Not(a) => {
                let a = self.mask(g, a);
                g.not(a)
            }
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
    })
}

/// x to a constant exponent: products for integers, a root for halves, exp(n ln x) for the rest.
fn power(g: &mut Graph, x: Node, exponent: f64) -> Node {
    if exponent.fract() == 0.0 && exponent.abs() <= 64.0 {
        return g.power(x, exponent as i32);
    }
    if (2.0 * exponent).fract() == 0.0 && exponent.abs() <= 64.0 {
        let root = g.unary(Unary::Sqrt, x);
        return g.power(root, (2.0 * exponent) as i32);
    }
    let logarithm = g.unary(Unary::Ln, x);
    let exponent = g.constant(exponent);
    let product = g.mul(exponent, logarithm);
    g.unary(Unary::Exp, product)
}
