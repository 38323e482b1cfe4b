//! All errors of this crate and their texts.
//!
//! Each message has three parts: what is wrong, the numbers, what to do. Numbers are `f64` whatever the scalar, so
//! that one error type serves all; names are those of the mechanism's definition. Where errors arise is elsewhere.

use crate::integrator::Rejections;
use crate::mechanism::{Assemble, Row, name_row};
use crate::real::Real;
use crate::vector::Vector;
use core::error::Error;
use core::fmt::{self, Display, Formatter};

/// Why no consistent position, velocity or acceleration was found.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum AssemblyError {
    /// The iteration ended away from the constraints.
    NoConvergence {
        /// The row that is violated most; for a held quantity `what` is `"held"`.
        row: Row,
        /// Its residual, m, rad or the row's own unit.
        residual: f64,
        /// Iterations made.
        iterations: u32,
    },
    /// A row depends on the others at this position: a dead centre, a redundant joint or contradicting conditions.
    RankDeficient {
        /// The row, or the velocity, at which the factorisation broke down.
        row: Row,
        /// The relative pivot found there.
        pivot: f64,
    },
    /// A residual became infinite or NaN.
    NonFinite {
        /// The row in which it was seen first.
        row: Row,
    },
    /// An angle constraint ended half a turn away from where it should be.
    Flipped {
        /// The row sin Δθ = 0 whose cosine is negative.
        row: Row,
    },
    /// A number that was given is infinite or NaN.
    GivenNotFinite {
        /// The coordinate, velocity or held quantity; `"time"`.
        what: &'static str,
    },
    /// An orientation of the given position has no direction.
    NoOrientation {
        /// The name of its first entry.
        what: &'static str,
        /// The length of the pair or quaternion.
        length: f64,
    },
    /// The number of given values is not the number of coordinates.
    WrongLength {
        /// How many are needed.
        needed: usize,
        /// How many were given.
        given: usize,
    },
    /// A condition's index is out of range.
    NoSuchCondition {
        /// The index.
        index: usize,
        /// How many conditions the mechanism has.
        count: usize,
    },
}

/// A parameter of a formulation that makes no sense.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SettingError {
    /// The parameter.
    pub what: &'static str,
    /// The value it was given.
    pub value: f64,
    /// What it must be.
    pub must_be: &'static str,
}

/// Why a simulation could not be advanced. The simulation keeps its last good state.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum SimulationError {
    /// No step size was given.
    StepMissing,
    /// The step size is zero, negative, infinite or NaN.
    Step {
        /// The step size, s.
        step: f64,
    },
    /// The end is before the present time, infinite or NaN.
    End {
        /// The present time, s.
        time: f64,
        /// The end that was asked for, s.
        end: f64,
    },
    /// The start does not satisfy the constraints.
    Inconsistent {
        /// The time of the start, s.
        time: f64,
        /// The row that is violated most.
        row: Row,
        /// max |Φ|, m, rad or the row's own unit.
        position: f64,
        /// max |D v − ν|.
        velocity: f64,
    },
    /// An orientation of the start is not of length 1.
    NotNormalised {
        /// The time of the start, s.
        time: f64,
        /// The name of its first entry.
        what: &'static str,
        /// The length of the pair or quaternion.
        length: f64,
    },
    /// A parameter of the formulation makes no sense.
    Setting(SettingError),
    /// The constraints lost rank: a dead centre or a redundant joint.
    Breakdown {
        /// The time of the stage in which it happened, s.
        time: f64,
        /// The relative pivot found there.
        pivot: f64,
        /// The constraint row that depends on the others.
        row: Row,
    },
    /// The mass matrix is singular in a direction that no constraint holds.
    SingularMass {
        /// The time of the stage in which it happened, s.
        time: f64,
        /// The relative pivot found there.
        pivot: f64,
        /// The velocity without inertia.
        velocity: &'static str,
    },
    /// The state at the end of a step could not be brought to the constraints.
    Projection {
        /// The time at the end of the step, s.
        time: f64,
        /// Why.
        error: AssemblyError,
    },
    /// No step was small enough for the tolerances.
    StepUnderflow {
        /// The time at its beginning, s.
        time: f64,
        /// The last size tried, s.
        step: f64,
        /// Why sizes were given up.
        rejections: Rejections,
    },
    /// The iteration of an implicit method did not converge.
    NoConvergence {
        /// The time at the beginning of the step, s.
        time: f64,
        /// Iterations made.
        iterations: u32,
        /// What the last of them changed, relative to what may remain.
        residual: f64,
    },
    /// A state was asked for outside the last step.
    NotCovered {
        /// The time that was asked for, s.
        time: f64,
        /// The beginning of the last step, s.
        from: f64,
        /// Its end, the present time, s.
        to: f64,
    },
    /// An event is of an output that the mechanism does not have.
    NoSuchOutput {
        /// The name that was given.
        name: &'static str,
        /// The outputs there are.
        known: &'static [&'static str],
        /// The one that is spelled most like it.
        nearest: Option<&'static str>,
    },
    /// A coordinate, velocity or acceleration became infinite or NaN.
    NonFinite {
        /// The time of the stage in which it was seen first, s.
        time: f64,
        /// The coordinate's name.
        what: &'static str,
    },
    /// The time at which the simulation starts is infinite or NaN, or a step or a duration leads beyond the largest number.
    TimeNotFinite {
        /// That time, s.
        time: f64,
    },
    /// A step, or a duration, is so short beside the time that the clock would stand: below 2⁻²⁰ of the distance of
    /// neighbouring times.
    TimeStands {
        /// The time, or that of the end of the run, s.
        time: f64,
        /// The step, s.
        step: f64,
        /// The least that is possible at that time, s.
        least: f64,
    },
    /// A run would take more steps or samples than are allowed.
    TooMany {
        /// `"steps"` or `"samples"`.
        what: &'static str,
        /// How many.
        count: f64,
        /// How many are allowed.
        most: f64,
    },
    /// A method that chooses its steps took as many as a run may have, and is not at its end. The run can be gone on with.
    TooManySteps {
        /// The time at which the simulation stands, s.
        time: f64,
        /// The end that was asked for, s.
        end: f64,
        /// The steps taken.
        steps: u64,
    },
    /// An event lies in a step, and was not found in as many trials as are allowed.
    EventNotLocated {
        /// The time at the beginning of the step, at which the simulation stands, s.
        time: f64,
        /// How far the time of the event is known, s.
        width: f64,
        /// The trials made.
        trials: u32,
    },
    /// A step near a singular position ended with more kinetic energy than loads, drivers and springs can have brought, or with
    /// less than they can have taken.
    Unresolved {
        /// The time at its beginning, s.
        time: f64,
        /// The row that depends on the others.
        row: Row,
        /// The estimate of the reciprocal condition of D M⁻¹ Dᵀ.
        reciprocal_condition: f64,
        /// The kinetic energy at its beginning, J.
        before: f64,
        /// The kinetic energy at its end, J, for which loads and drivers do not account.
        after: f64,
    },
    /// The state at the end of a step has nothing to do with the constraints any more.
    LeftConstraints {
        /// The time at the end of the step, s.
        time: f64,
        /// The row that is off.
        row: Row,
        /// Its residual: Φ in m, rad or the row's own unit, or where velocities are off D v − ν.
        residual: f64,
        /// Time (s) and row of the position nearest to a singular one, if one was passed.
        singular: Option<(f64, Row)>,
    },
}

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
    /// Inputs that enter the loads with curvature were not found.
    NoActuation {
        /// What the last iteration still changed, in the inputs' unit.
        left: f64,
        /// Iterations made.
        iterations: u32,
    },
}

impl AssemblyError {
    /// The iteration ended with these residuals.
    #[cold]
    pub(crate) fn worst<R: Real, M: Assemble<R>>(phi: &M::Lambda, iterations: u32) -> Self {
        let worst = phi.as_slice().iter().enumerate().fold((0, R::ZERO), |(at, largest), (row, entry)| {
            if entry.abs() <= largest { (at, largest) } else { (row, entry.abs()) }
        });
        let row = name_row::<R, M>(Some(worst.0));
        AssemblyError::NoConvergence { row, residual: worst.1.to_f64(), iterations }
    }
}

impl SimulationError {
    /// The joint, constraint or driver that the error is about.
    pub fn joint(&self) -> Option<&'static str> {
        match self {
            SimulationError::Breakdown { row, .. }
            | SimulationError::Inconsistent { row, .. }
            | SimulationError::Unresolved { row, .. }
            | SimulationError::LeftConstraints { row, .. }
            | SimulationError::Projection { error: AssemblyError::NoConvergence { row, .. }, .. } => {
                Some(row.of)
            }
            _ => None,
        }
    }
}

impl Display for Row {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "`{}` ({})", self.of, self.what)
    }
}

impl Display for AssemblyError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            AssemblyError::NoConvergence { row, residual, iterations } => write!(
                f,
                "the mechanism cannot be assembled: {row} is still off by {residual:.3e} after {iterations} \
                 iterations; start from a nearer position, or check that lengths and held values can be reached"
            ),
            AssemblyError::RankDeficient { row, pivot } => write!(
                f,
                "{row} depends on the other rows at this position: relative pivot {pivot:.1e}; move away from the \
                 dead centre, hold another coordinate, or remove the redundant joint"
            ),
            AssemblyError::NonFinite { row } => write!(
                f,
                "the residual of {row} is infinite or NaN; check the parameters, the time and the start position"
            ),
            AssemblyError::Flipped { row } => write!(
                f,
                "{row} was assembled half a turn away from its angle; start from a position that has the bodies \
                 about the right way round"
            ),
            AssemblyError::GivenNotFinite { what } => {
                write!(f, "`{what}` was given as infinite or NaN; give a finite number")
            }
            AssemblyError::NoOrientation { what, length } => write!(
                f,
                "the orientation that begins with `{what}` is of length {length:e} and so points nowhere; give a pair \
                 (cos, sin) or a quaternion (w, x, y, z) of about length 1, such as (1, 0) or (1, 0, 0, 0)"
            ),
            AssemblyError::WrongLength { needed, given } => write!(
                f,
                "{given} motions were given for {needed} independent coordinates; give one for each, in the order of \
                 INDEPENDENT"
            ),
            AssemblyError::NoSuchCondition { index, count } => write!(
                f,
                "there is no condition {index} among the {count} of this mechanism; use indices into CONDITIONS"
            ),
        }
    }
}

impl Display for SettingError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "{} is {}; it must be {}", self.what, self.value, self.must_be)
    }
}

impl Display for SimulationError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            SimulationError::StepMissing => {
                write!(f, "no step size was given; add `.step(seconds)` where the simulation is built")
            }
            SimulationError::Step { step } => {
                write!(f, "the step size is {step} s; give a positive, finite number of seconds")
            }
            SimulationError::End { time, end } => write!(
                f,
                "the simulation stands at {time} s and cannot run to {end} s; give a finite end that is not earlier"
            ),
            SimulationError::Inconsistent { time, row, position, velocity } => write!(
                f,
                "the start is not consistent at t = {time} s: {row} is off by {position:.3e}, velocities by \
                 {velocity:.3e}; make it so with `model.assemble(&state)` or `model.project(time, &state)`, or write \
                 `.accept_inconsistent_start()`"
            ),
            SimulationError::NotNormalised { time, what, length } => write!(
                f,
                "the orientation that begins with `{what}` is of length {length} at t = {time} s, not 1; divide its \
                 entries by that length, or let `model.project(time, &state)` do it"
            ),
            SimulationError::Setting(error) => error.fmt(f),
            SimulationError::Breakdown { time, pivot, row } => write!(
                f,
                "the constraints lost rank at {row}, t = {time} s: relative pivot {pivot:.1e}; the mechanism is at a \
                 dead centre or the joint is redundant: start elsewhere, or give the motion enough energy to pass"
            ),
            SimulationError::SingularMass { time, pivot, velocity } => write!(
                f,
                "nothing with mass resists `{velocity}` at t = {time} s: relative pivot {pivot:.1e}; give the body a \
                 mass and an inertia, or constrain it"
            ),
            SimulationError::Projection { time, error } => {
                write!(f, "the step to t = {time} s ended off the constraints: {error}")
            }
            SimulationError::StepUnderflow { time, step, rejections } => write!(
                f,
                "no step from t = {time} s is small enough: {step:.1e} s was given up last, after {} trials for the \
                 estimated error, {} for convergence and {} at stages that were singular or not finite; loosen the tolerances, \
                 look for a jump in forces or a singular position there, or allow smaller steps by `.least_step(seconds)`",
                rejections.error, rejections.convergence, rejections.breakdown
            ),
            SimulationError::NoConvergence { time, iterations, residual } => write!(
                f,
                "the step from t = {time} s did not converge: after {iterations} iterations the last changed the solution \
                 by {residual:.1e} of what may remain; take a smaller step or allow more iterations"
            ),
            SimulationError::NotCovered { time, from, to } => write!(
                f,
                "the state at {time} s is not known: the last step went from {from} s to {to} s; ask within it, or run to that \
                 time"
            ),
            SimulationError::NoSuchOutput { name, known, nearest } => {
                write!(f, "the mechanism has no output `{name}` to watch; ")?;
                if let Some(nearest) = nearest {
                    write!(f, "perhaps `{nearest}` is meant; ")?;
                }
                if known.is_empty() {
                    return write!(f, "it has none: add `output {name} [unit] = …;` to its definition");
                }
                write!(f, "its outputs are ")?;
                for (i, output) in known.iter().enumerate() {
                    write!(f, "{}`{output}`", if i == 0 { "" } else { ", " })?;
                }
                Ok(())
            }
            SimulationError::NonFinite { time, what } => write!(
                f,
                "`{what}` became infinite or NaN at t = {time} s; check inputs and parameters, or take a smaller step"
            ),
            SimulationError::TimeNotFinite { time } => write!(
                f,
                "the time would be {time:?} s; give `.start_time(seconds)` a finite number, and steps and durations that lead to one"
            ),
            SimulationError::TimeStands { time, step, least } => write!(
                f,
                "time stands: at t = {time:?} s neighbouring times are so far apart that {step:?} s is nothing beside them; take steps \
                 and durations of at least {least:.1e} s, or count time from a later origin by `.start_time(seconds)`"
            ),
            SimulationError::TooMany { what, count, most } => write!(
                f,
                "the run would take {count:.1e} {what}, more than {most:.1e}; take a nearer end, or {}",
                if *what == "samples" { "a longer interval" } else { "longer steps" }
            ),
            SimulationError::TooManySteps { time, end, steps } => write!(
                f,
                "{steps} steps led no farther than t = {time:?} s on the way to {end:?} s; run again to go on from there, allow more by \
                 `.most_steps(count)`, loosen the tolerances, or take an implicit method if forces are stiff"
            ),
            SimulationError::EventNotLocated { time, width, trials } => write!(
                f,
                "an event lies in the step from t = {time} s, but {trials} trials located it no better than {width:.1e} s; \
                 give it a larger tolerance, or the integrator looser tolerances"
            ),
            SimulationError::Unresolved { time, row, reciprocal_condition, before, after } => write!(
                f,
                "the step from t = {time} s cannot be resolved beside a singular position: {row} depends on the other rows there \
                 (reciprocal condition {reciprocal_condition:.1e}), and the kinetic energy would go from {before:.3e} J to \
                 {after:.3e} J, for which no load or driver accounts; start further from that position, take a smaller step, or \
                 pass it with `Projected::after(NullSpace)`"
            ),
            SimulationError::LeftConstraints { time, row, residual, singular } => {
                write!(f, "the step to t = {time} s left the constraints: {row} is off by {residual:.3e}")?;
                if let Some((time, row)) = singular {
                    write!(f, ", after the singular position of {row} near t = {time} s")?;
                }
                write!(
                    f,
                    "; take a smaller step, or a formulation that keeps to the constraints, such as `Projected::after(NullSpace)`"
                )
            }
        }
    }
}

impl Display for LinearisationError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            LinearisationError::Breakdown { time, pivot, row } => write!(
                f,
                "the constraints lose rank at {row}, t = {time} s: relative pivot {pivot:.1e}; the mechanism is at a dead \
                 centre or the joint is redundant: linearise elsewhere"
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
impl Error for AssemblyError {}
impl Error for SettingError {}
impl Error for SimulationError {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        match self {
            SimulationError::Setting(error) => Some(error),
            SimulationError::Projection { error, .. } => Some(error),
            _ => None,
        }
    }
}

impl From<SettingError> for SimulationError {
    fn from(error: SettingError) -> Self {
        SimulationError::Setting(error)
    }
}
