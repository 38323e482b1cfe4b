//! Expressions of the user after lowering: SI units, names resolved, dimensions checked.

use super::tables::LookUp;
use super::{
    BodyId, ConstraintId, DriverId, InputId, JointId, LoadId, MemoryId, ParameterId, Place, Rotor, StateId,
    Vector,
};
use crate::forms::{Measures, RowForm};
use crate::units::Dimension;

/// A scalar expression in SI units.
#[derive(Clone, Debug, PartialEq)]
pub enum Expr {
    Number(f64),
    Parameter(ParameterId),
    Input(InputId),
    State(StateId),
    /// What was last set; constant between events.
    Memory(MemoryId),
    /// Of a contact and one of its gaps: 1 while it acts, else 0; held over a step.
    Gate(LoadId, usize),
    /// s.
    Time,
    Quantity(Quantity),
    Unary(Function1, Box<Expr>),
    Binary(Function2, Box<Expr>, Box<Expr>),
    /// Base to a constant exponent.
    Power(Box<Expr>, f64),
    /// `if(condition, then, otherwise)`; both sides are evaluated.
    If(Box<Condition>, Box<Expr>, Box<Expr>),
    /// The time derivative of an expression of positions and time.
    Rate(Box<Expr>),
    /// A table or its slope.
    Table(Box<LookUp>),
}

impl Expr {
    /// Calls `found` with the expression and all that it is made of.
    pub fn visit<'e>(&'e self, found: &mut dyn FnMut(&'e Expr)) {
        found(self);
        match self {
            Expr::Number(_)
            | Expr::Parameter(_)
            | Expr::Input(_)
            | Expr::State(_)
            | Expr::Memory(_)
            | Expr::Gate(..)
            | Expr::Time
            | Expr::Quantity(_) => {}
            Expr::Unary(_, x) | Expr::Power(x, _) | Expr::Rate(x) => x.visit(found),
            Expr::Binary(_, x, y) => [x, y].into_iter().for_each(|operand| operand.visit(found)),
            Expr::Table(look_up) => look_up.arguments.iter().for_each(|operand| operand.visit(found)),
            Expr::If(condition, x, y) => {
                condition.visit(found);
                [x, y].into_iter().for_each(|operand| operand.visit(found));
            }
        }
    }

    /// Whether it changes with time or the motion.
    pub fn moves(&self) -> bool {
        let mut moves = false;
        self.visit(&mut |part| moves |= matches!(part, Expr::Time | Expr::Quantity(_) | Expr::Rate(_)));
        moves
    }

    /// Whether it names inputs, states or memories, whose rates it does not know.
    pub fn is_given(&self) -> bool {
        let mut given = false;
        self.visit(&mut |part| given |= matches!(part, Expr::Input(_) | Expr::State(_) | Expr::Memory(_)));
        given
    }

    /// Whether anything beside parameters changes it.
    pub fn varies(&self) -> bool {
        self.is_given() || self.moves()
    }

    /// Calls `found` with every quantity in it.
    pub fn quantities<'e>(&'e self, found: &mut dyn FnMut(&'e Quantity)) {
        self.visit(&mut |expr| {
            if let Expr::Quantity(quantity) = expr {
                found(quantity);
            }
        });
    }
}

impl Condition {
    /// Whether time or the motion changes what is compared.
    pub fn moves(&self) -> bool {
        let mut moves = false;
        self.visit(&mut |part| moves |= matches!(part, Expr::Time | Expr::Quantity(_) | Expr::Rate(_)));
        moves
    }

    fn visit<'e>(&'e self, found: &mut dyn FnMut(&'e Expr)) {
        match self {
            Condition::Compare(_, x, y) => [x, y].into_iter().for_each(|operand| operand.visit(found)),
            Condition::And(a, b) | Condition::Or(a, b) => [a, b].into_iter().for_each(|it| it.visit(found)),
            Condition::Not(a) => a.visit(found),
        }
    }
}

#[derive(Clone, Debug, PartialEq)]
pub enum Condition {
    Compare(Comparison, Expr, Expr),
    And(Box<Condition>, Box<Condition>),
    Or(Box<Condition>, Box<Condition>),
    Not(Box<Condition>),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Comparison {
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    Equal,
    NotEqual,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Function1 {
    Neg,
    Sqrt,
    Abs,
    Sign,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Exp,
    Ln,
    Log10,
    Sinh,
    Cosh,
    Tanh,
    /// Not written by users: part of `wrap`.
    Floor,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Function2 {
    Add,
    Sub,
    Mul,
    Div,
    Min,
    Max,
    Atan2,
}

/// A kinematic or dynamic quantity of the mechanism.
#[derive(Clone, Debug, PartialEq)]
pub enum Quantity {
    Coordinate(Coordinate),
    Rate(Coordinate),
    /// W, of a load.
    Power(LoadId),
    /// W, of a driver's torque or force; only in outputs.
    DriverPower(DriverId),
    /// N m or N, the effort of a driver; only in outputs.
    DriverEffort(DriverId),
    /// What a load exerts that has a name for it: a resistance, a tension; in outputs and rates of states.
    LoadEffort(LoadId),
    /// What a load between teeth is beside its force; in outputs and rates of states.
    OfTeeth(LoadId, OfTeeth),
    /// N, the force that presses the surfaces of a friction together; in outputs and rates of states.
    Pressing(LoadId),
    /// m/s, of the surfaces of a contact: along an axis of the world, or 0 where there is one. Of one of its gaps, else of the deepest.
    Sliding {
        contact: LoadId,
        which: Option<usize>,
        axis: usize,
    },
    /// What an equation exerts along its left side, against its right one; in outputs and rates of states.
    ConstraintEffort(ConstraintId),
    /// What a joint exerts on the body of its second place; in outputs and rates of states.
    Reaction(JointId, ReactionPart),
    /// J.
    KineticEnergy,
    /// J.
    PotentialEnergy,
    /// J, the sum of both.
    Energy,
}

/// A part of the reaction of a joint: of the force at the second place and of the torque about it, on the body there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReactionPart {
    /// Along world x (0), y (1) or z (2), N.
    Force(usize),
    /// In the plane along the normal of the joint's axis, which is the axis turned by a right angle, N.
    Normal,
    /// The length of the force, N.
    Size,
    /// Of a joint that keeps a distance, what pulls its places together, N.
    Tension,
    /// Of a joint on a curve, what presses its places apart, N.
    Pressing,
    /// About world x (0), y (1) or z (2), in the plane about the last, N m.
    Torque(usize),
}

impl ReactionPart {
    /// What it measures.
    pub fn dimension(self) -> Dimension {
        match self {
            Self::Force(_) | Self::Normal | Self::Size | Self::Tension | Self::Pressing => Dimension::FORCE,
            Self::Torque(_) => Dimension::TORQUE,
        }
    }
}

/// A quantity of a load between teeth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OfTeeth {
    /// u, m.
    Deflection,
    /// τ less whole pitches, 1.
    Phase,
    /// Pairs of teeth in contact, 1.
    Pairs,
    /// k, N/m.
    Stiffness,
}

impl OfTeeth {
    pub const ALL: [(&'static str, OfTeeth); 4] = [
        ("deflection", Self::Deflection),
        ("phase", Self::Phase),
        ("pairs", Self::Pairs),
        ("stiffness", Self::Stiffness),
    ];

    pub fn dimension(self) -> Dimension {
        match self {
            Self::Deflection => Dimension::LENGTH,
            Self::Phase | Self::Pairs => Dimension::ONE,
            Self::Stiffness => Dimension::STIFFNESS,
        }
    }
}

/// A measure of the position.
#[derive(Clone, Debug, PartialEq)]
pub enum Coordinate {
    /// rad, multi-turn where laws use it.
    Angle(Rotor),
    /// m; which of the joint's travels.
    Travel(JointId, usize),
    /// World x (0), y (1) or z (2) of a place, m.
    Position(Box<Place>, usize),
    /// m.
    Distance(Box<Place>, Box<Place>),
    /// u·(p₂ − p₁) from one place to another, u in the axes of the first and of parameters only, m.
    Way(Box<[Place; 2]>, Box<Vector>),
    /// |p₂ − p₁|², m².
    Square(Box<Place>, Box<Place>),
    /// World x (0), y (1) or z (2) of a direction in the axes of a place.
    Direction(Box<(Place, Vector)>, usize),
    /// The turn of a body in space about its own x (0), y (1) or z (2): a quasi-coordinate, of which there is nothing but the rate
    /// ω, rad/s.
    Turn(BodyId, usize),
    /// How far a body in space is from the orientation that `start` states: a component of the axis of the turn between them times
    /// its sine.
    Deviation(BodyId, usize),
    /// A mode of a body, and whether it is an angle: m, of a beam in torsion rad.
    Mode(BodyId, u8, bool),
    /// A row of a joint that yields: m, or a direction.
    Closing(JointId, &'static RowForm),
}

impl Coordinate {
    /// The places that it is of.
    pub fn places(&self) -> impl Iterator<Item = &Place> {
        let (first, second) = match self {
            Self::Position(place, _) => (Some(&**place), None),
            Self::Direction(of, _) => (Some(&of.0), None),
            Self::Distance(first, second) | Self::Square(first, second) => (Some(&**first), Some(&**second)),
            Self::Way(ends, _) => (Some(&ends[0]), Some(&ends[1])),
            Self::Angle(_)
            | Self::Travel(..)
            | Self::Turn(..)
            | Self::Deviation(..)
            | Self::Mode(..)
            | Self::Closing(..) => (None, None),
        };
        first.into_iter().chain(second)
    }

    /// The direction of an axis of a frame.
    pub fn along(axis: usize) -> Vector {
        [0, 1, 2].map(|k| Expr::Number(if k == axis { 1.0 } else { 0.0 }))
    }

    /// Whether it has a value, and not a rate alone.
    pub fn has_value(&self) -> bool {
        !matches!(self, Self::Turn(..))
    }

    /// Of its value.
    pub fn dimension(&self) -> Dimension {
        match self {
            Self::Angle(_) | Self::Turn(..) | Self::Deviation(..) => Dimension::ANGLE,
            Self::Travel(..) | Self::Position(..) | Self::Distance(..) | Self::Way(..) => Dimension::LENGTH,
            Self::Mode(_, _, is_angle) => of_mode(*is_angle),
            Self::Square(..) => Dimension::LENGTH.times(Dimension::LENGTH),
            Self::Direction(..) => Dimension::ONE,
            Self::Closing(_, row) if row.measures == Measures::Direction => Dimension::ANGLE,
            Self::Closing(..) => Dimension::LENGTH,
        }
    }

    /// Of its rate.
    pub fn rate_dimension(&self) -> Dimension {
        match self {
            Self::Angle(_) | Self::Turn(..) | Self::Deviation(..) => Dimension::ANGULAR_RATE,
            Self::Travel(..) | Self::Position(..) | Self::Distance(..) | Self::Way(..) => Dimension::SPEED,
            Self::Mode(_, _, is_angle) => of_mode(*is_angle).over(Dimension::TIME),
            Self::Square(..) => Dimension::LENGTH.times(Dimension::SPEED),
            Self::Direction(..) => Dimension::ONE.over(Dimension::TIME),
            Self::Closing(..) => self.dimension().over(Dimension::TIME),
        }
    }
}

/// Of the coordinate of a mode.
fn of_mode(is_angle: bool) -> Dimension {
    if is_angle { Dimension::ANGLE } else { Dimension::LENGTH }
}
