//! Errors of linearisation, equilibria and inputs for accelerations.

use super::AssemblyError;
use crate::mechanism::Row;
use core::error::Error;
use core::fmt::{self, Display, Formatter};

/// Why a mechanism could not be linearised, brought to rest or driven.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum LinearisationError {
    /// The constraints lost rank: a dead centre or a redundant joint.
    Breakdown {
        /// The time, s.
        time: f64,
        /// The relative pivot found.
        pivot: f64,
        /// The constraint row that depends on the others.
        row: Row,
    },
    /// The mass matrix is singular in a direction that no constraint holds.
    SingularMass {
        /// The time, s.
        time: f64,
        /// The relative pivot found.
        pivot: f64,
        /// The velocity without inertia.
        velocity: &'static str,
    },
    /// A force, a residual or an acceleration is infinite or NaN.
    NonFinite {
        /// The time, s.
        time: f64,
        /// The velocity, or what the row belongs to.
        what: &'static str,
    },
    /// The independent coordinates do not move the whole, or the position is none.
    Assembly(AssemblyError),
    /// There are not as many coordinates as degrees of freedom.
    Incomplete {
        /// Degrees of freedom.
        needed: usize,
        /// Coordinates.
        given: usize,
    },
    /// At a position that the search for an equilibrium came to, nothing decides about a coordinate or a multiplier.
    Indifferent {
        /// The time, s.
        time: f64,
        /// The coordinate, by the name of its velocity (`what` is then `"coordinate"`), or the row.
        row: Row,
        /// The relative pivot found.
        pivot: f64,
        /// Iterations made before.
        iterations: u32,
    },
    /// Contacts are rigid: derivatives of the motion do not follow them.
    Rigid {
        /// The first of them.
        contact: &'static str,
    },
    /// Joints stick by dry friction, and derivatives do not follow what sticks and slides yet.
    Sticks {
        /// The first of the frictions.
        friction: &'static str,
    },
    /// The search for an equilibrium ended away from one.
    NoEquilibrium {
        /// The time, s.
        time: f64,
        /// The coordinate whose force is not balanced, by the name of its velocity, or the row that is violated most.
        row: Row,
        /// That force, N or N·m, or the row's residual.
        residual: f64,
        /// Iterations made.
        iterations: u32,
    },
    /// There is no input of that name.
    NoSuchInput {
        /// The name.
        name: &'static str,
        /// Those that there are.
        inputs: &'static [&'static str],
    },
    /// The accelerations do not satisfy the constraints.
    Inconsistent {
        /// The first row that they violate.
        row: Row,
        /// γ − D a of it.
        residual: f64,
    },
    /// The actuators cannot give the accelerations.
    Unactuated {
        /// The independent coordinate that lacks force.
        coordinate: &'static str,
        /// The force that is missing along it, N or N·m.
        missing: f64,
        /// How many actuators were named.
        actuators: usize,
    },
    /// Inputs that were to enter the loads linearly do not.
    Curved {
        /// The velocity along which the forces miss.
        coordinate: &'static str,
        /// By how much, N or N·m.
        missing: f64,
    },
    /// There is no coordinate of that name.
    NoSuchCoordinate {
        /// The name.
        name: &'static str,
    },
    /// A matrix is not square, or the one beside it has another number of rows.
    WrongShape {
        /// Entries of the first.
        a: usize,
        /// Entries of the second.
        b: usize,
    },
    /// An angle whose turns are counted follows the orientation of a body in space: a step moves it by the integral of its rate, the
    /// derivatives of the forces know it as a function of that orientation.
    CountedOrientation {
        /// The entry of the positions, by its name.
        angle: &'static str,
    },
    /// Inputs that enter the loads with curvature were not found.
    NoActuation {
        /// What the last iteration still changed, in the inputs' unit.
        left: f64,
        /// Iterations made.
        iterations: u32,
    },
}

impl Display for LinearisationError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            LinearisationError::Breakdown { time, pivot, row } => write!(
                f,
                "the constraints lose rank at {row}, t = {time} s: relative pivot {pivot:.1e}; the mechanism is at a dead \
                 centre or the joint is redundant: linearise elsewhere"
            ),
            LinearisationError::Rigid { contact } => write!(
                f,
                "`{contact}` is rigid, and derivatives of a motion do not follow rigid contacts yet: give it a law of its depth, such as \
                 `kelvin_voigt`"
            ),
            LinearisationError::Sticks { friction } => write!(
                f,
                "`{friction}` sticks, and derivatives of a motion do not follow dry friction in joints yet, whose forces jump: write `coulomb`, \
                 `lugre` or `asperity` in place of `dry`"
            ),
            LinearisationError::SingularMass { time, pivot, velocity } => write!(
                f,
                "nothing with mass resists `{velocity}` at t = {time} s: relative pivot {pivot:.1e}; give the body a \
                 mass and an inertia, or constrain it"
            ),
            LinearisationError::NonFinite { time, what } => write!(
                f,
                "`{what}` has an infinite force, residual or acceleration, or NaN, at t = {time} s; check the state, the \
                 inputs and the parameters"
            ),
            LinearisationError::Assembly(error) => error.fmt(f),
            LinearisationError::Incomplete { needed, given } => write!(
                f,
                "{given} coordinates are known for {needed} degrees of freedom; name the missing ones in `options {{ \
                 independent = (…); }}`"
            ),
            LinearisationError::Indifferent { time, row, pivot, iterations } => write!(
                f,
                "no force decides about {row} at t = {time} s: relative pivot {pivot:.1e} after {iterations} iterations; \
                 give it a spring or weight, hold it by a driver, start from another position, or remove a redundant joint"
            ),
            LinearisationError::NoEquilibrium { time, row, residual, iterations } => write!(
                f,
                "no equilibrium was found at t = {time} s: {row} is still off by {residual:.3e} after {iterations} \
                 iterations; start from a nearer position, or check that the loads can balance"
            ),
            LinearisationError::NoSuchInput { name, inputs } => {
                write!(f, "there is no input `{name}`; name some of")?;
                inputs.iter().try_for_each(|input| write!(f, " `{input}`"))
            }
            LinearisationError::Inconsistent { row, residual } => write!(
                f,
                "the accelerations violate {row} by {residual:.3e}; take those of `model.kinematics(…)`, which satisfy the \
                 constraints"
            ),
            LinearisationError::Unactuated { coordinate, missing, actuators } => write!(
                f,
                "the {actuators} actuators named cannot give these accelerations: `{coordinate}` lacks {missing:.3e} (N or \
                 N m); name an input that acts along it"
            ),
            LinearisationError::Curved { coordinate, missing } => write!(
                f,
                "the inputs named enter the loads with curvature: along `{coordinate}` they miss {missing:.3e} (N or N m); give the \
                 definition `options {{ emit = (tangent); }}` and take `linearisation::actuation`, which iterates"
            ),
            LinearisationError::NoSuchCoordinate { name } => write!(
                f,
                "there is no coordinate `{name}` that can be held; `model.conditions()` lists those there are, and \
                 `options {{ independent = ({name}); }}` adds it if a joint has it"
            ),
            LinearisationError::WrongShape { a, b } => write!(
                f,
                "matrices of {a} and {b} entries are no A and B of one system: n·n and n·n_u are needed; take those of \
                 `Linearisation::state_space`"
            ),
            LinearisationError::CountedOrientation { angle } => write!(
                f,
                "`{angle}` counts the turns of a body that is turned in space as a whole, and a step has no exact derivative \
                 by it; write `options {{ coordinates = tree; }}`, where the joint's own angle turns the body"
            ),
            LinearisationError::NoActuation { left, iterations } => write!(
                f,
                "the inputs were not found: after {iterations} iterations the last still changed them by {left:.1e}; they \
                 enter the loads with too much curvature for these accelerations"
            ),
        }
    }
}

impl Error for LinearisationError {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        match self {
            LinearisationError::Assembly(error) => Some(error),
            _ => None,
        }
    }
}
