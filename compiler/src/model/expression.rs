//! Expressions of the user after lowering: SI units, names resolved, dimensions checked.

use super::{BodyId, DriverId, InputId, JointId, LoadId, ParameterId, Place};

/// A scalar expression in SI units.
#[derive(Clone, Debug)]
pub enum Expr {
    Number(f64),
    Parameter(ParameterId),
    Input(InputId),
    /// s.
    Time,
    Quantity(Quantity),
    Unary(Function1, Box<Expr>),
    Binary(Function2, Box<Expr>, Box<Expr>),
    /// Base to a constant exponent.
    Power(Box<Expr>, f64),
    /// `if(condition, then, otherwise)`; both sides are evaluated.
    If(Box<Condition>, Box<Expr>, Box<Expr>),
}

#[derive(Clone, Debug)]
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

/// A kinematic or dynamic quantity of the mechanism, by name.
#[derive(Clone, Debug)]
pub enum Quantity {
    /// rad, multi-turn where laws use it.
    BodyAngle(BodyId),
    /// rad/s.
    BodyRate(BodyId),
    /// ω of a body in space about its x (0), y (1) or z (2), rad/s.
    BodyOmega(BodyId, usize),
    /// rad; which of the joint's angles.
    JointAngle(JointId, usize),
    /// rad/s.
    JointRate(JointId, usize),
    /// m; which of the joint's travels.
    JointTravel(JointId, usize),
    /// m/s.
    JointSpeed(JointId, usize),
    /// World x (0), y (1) or z (2) of a place, m.
    Position(Box<Place>, usize),
    /// World x (0), y (1) or z (2) component of a place's velocity, m/s.
    Velocity(Box<Place>, usize),
    /// m.
    Distance(Box<Place>, Box<Place>),
    /// W, of a load.
    Power(LoadId),
    /// W, of a driver's torque or force; only in outputs.
    DriverPower(DriverId),
    /// N m or N, the effort of a driver; only in outputs.
    DriverEffort(DriverId),
    /// J.
    KineticEnergy,
    /// J.
    PotentialEnergy,
    /// J, the sum of both.
    Energy,
}

impl Quantity {
    /// Whether it is the rate of a position.
    pub fn is_rate(&self) -> bool {
        matches!(
            self,
            Self::BodyRate(_)
                | Self::BodyOmega(..)
                | Self::JointRate(..)
                | Self::JointSpeed(..)
                | Self::Velocity(..)
        )
    }
}
