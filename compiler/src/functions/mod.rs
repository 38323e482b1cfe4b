//! The functions of a mechanism: one table of signatures, [`FUNCTIONS`], which optimising, scheduling, counting, interpreting,
//! the self-check, emission and the page read. How a signature is spelled in a language is the business of `emit`.
//!
//! ```text
//! acceleration    (constants, time, q, v, u)    →    a_out: velocities,    lambda_out: rows,    value: the smallest pivot
//!                  arguments                         groups of results: the name, the shape, the expressions
//! ```
//! No offset is written anywhere: a group has as many results as it has expressions, and [`Signature::split`] parts a
//! flat list of results by groups. Entries of a list that have fields, such as the motion of a body, are parted by
//! [`Kind::split`].

mod argument;
mod shape;
mod signature;
mod table;

pub use argument::{ARGUMENTS, Argument, Given};
pub use shape::{
    CONDITION_JACOBIAN, DERIVATIVES, Field, JACOBIAN, Kind, MASS, MOTION, REACTION, Record, Shape, Sparse,
};
pub use signature::{Group, Interface, Signature, Way};
pub use table::FUNCTIONS;

use crate::complete::Complete;
use crate::solve::Solution;
use crate::symbolic::Node;

/// The functions of a mechanism, in the order of [`FUNCTIONS`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Function {
    MassMatrix,
    Constraints,
    ConstraintJacobian,
    Nu,
    Gamma,
    Forces,
    FrictionForces,
    KineticEnergy,
    PotentialEnergy,
    Acceleration,
    AccelerationBaumgarte,
    NullSpace,
    NullSpaceBaumgarte,
    Outputs,
    InternalRates,
    Guards,
    Assignments,
    Strikes,
    Grips,
    Bounds,
    InverseDynamics,
    Powers,
    DriverEfforts,
    Motions,
    Reactions,
    RowCosines,
    ConditionResidual,
    ConditionCosines,
    ConditionJacobian,
    ConditionBias,
    ConditionDrift,
    StartTargets,
    StartInternal,
    Masses,
    RowScales,
    Factor,
    System,
    Solve,
    FactorJacobian,
    DependentVelocities,
    Residual,
    Tangent,
    RowTangent,
    RateTangent,
    InputTangent,
    InternalTangent,
    FrictionTangent,
    ParameterTangent,
    OutputTangent,
    InternalRateTangent,
    CoordinateTangent,
    /// Last: it computes what all others asked for.
    Prepare,
}

impl Function {
    /// Every function; those that a mechanism does not emit compute nothing.
    pub const ALL: [Function; FUNCTIONS.len()] = {
        let mut all = [Function::Prepare; FUNCTIONS.len()];
        let mut index = 0;
        while index < all.len() {
            all[index] = FUNCTIONS[index].function;
            assert!(all[index] as usize == index, "the table and the functions are in one order");
            index += 1;
        }
        all
    };

    /// The functions that give v̇ and λ, by the way in which they are solved: as they are, and with Baumgarte's terms.
    pub const SOLUTIONS: [[Function; 2]; 2] = [
        [Function::Acceleration, Function::AccelerationBaumgarte],
        [Function::NullSpace, Function::NullSpaceBaumgarte],
    ];

    /// Its pair of [`Function::SOLUTIONS`]; none if it does not give v̇ and λ.
    pub fn pair(self) -> Option<usize> {
        Function::SOLUTIONS.iter().position(|pair| pair.contains(&self))
    }

    /// Whether it gives v̇ and λ with Baumgarte's terms.
    pub fn is_stabilised(self) -> bool {
        Function::SOLUTIONS.iter().any(|[_, stabilised]| *stabilised == self)
    }

    /// Its entry of the table.
    pub fn signature(self) -> &'static Signature {
        &FUNCTIONS[self as usize]
    }

    /// Name of the emitted function.
    pub fn name(self) -> &'static str {
        self.signature().name
    }
}

/// What a function computes, in the order of its outputs.
pub fn outputs(complete: &Complete, function: Function) -> Vec<Node> {
    function.signature().outputs(complete)
}

/// What a function of [`Function::SOLUTIONS`] gives, and what its factorisation computes.
pub fn solution(complete: &Complete, function: Function) -> Option<(&Solution, &[Node])> {
    let Complete { solved, further, .. } = complete;
    let led = further.null_space.as_ref();
    match function {
        Function::Acceleration => Some((&solved.index1, &solved.factored)),
        Function::AccelerationBaumgarte => Some((&solved.baumgarte, &solved.factored)),
        Function::NullSpace => led.map(|led| (&led.plain, led.factored.as_slice())),
        Function::NullSpaceBaumgarte => led.map(|led| (&led.stabilised, led.factored.as_slice())),
        _ => None,
    }
}

/// What rows ask of the accelerations that a function of [`Function::SOLUTIONS`] gives with Baumgarte's terms.
pub fn asked(complete: &Complete, function: Function) -> Option<&[Node]> {
    let Complete { solved, further, .. } = complete;
    match function {
        Function::AccelerationBaumgarte => Some(&solved.asked),
        Function::NullSpaceBaumgarte => further.null_space.as_ref().map(|led| led.asked.as_slice()),
        _ => None,
    }
}
