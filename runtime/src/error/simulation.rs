//! Errors of simulations.

use super::{AssemblyError, SettingError};
use crate::integrator::Rejections;
use crate::mechanism::Row;
use core::error::Error;
use core::fmt::{self, Display, Formatter};

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
    /// Contacts whose gates are held opened and closed more often in one step than is allowed.
    Chatter {
        /// The contact that did so last.
        contact: &'static str,
        /// The time at which it did, s. The simulation stands at the beginning of the step.
        time: f64,
        /// How often gates may open or close in a step.
        most: u32,
    },
    /// Events of the definition occurred more often in one step, or at one time, than is allowed.
    EventWithoutEnd {
        /// The event that did so last.
        event: &'static str,
        /// The time at which it did, s. The simulation stands at the beginning of the step.
        time: f64,
        /// How often events may occur in a step, ticks at their own times aside.
        most: u32,
    },
    /// The speed that an event lets jump is held by joints or drivers, or two that jump at one time hold each other.
    NoJump {
        /// The event.
        event: &'static str,
        /// The time at which it occurred, s.
        time: f64,
    },
    /// A rigid contact is inside another body: at a start, or because its parts crossed each other in less than a step.
    Inside {
        /// The contact.
        contact: &'static str,
        /// The time at which it was seen, s.
        time: f64,
        /// Its depth, m or rad.
        depth: f64,
    },
    /// More rigid contacts that know of each other touch at once than impulses are sought for.
    Crowded {
        /// The first of them that is too many.
        contact: &'static str,
        /// The time at which they touch, s.
        time: f64,
        /// How many may touch at once.
        most: u32,
    },
    /// No impulses or forces of rigid contacts part what touches: joints or drivers hold it there, or dry friction that presses harder by
    /// itself than it lets go (Painlevé).
    NoImpact {
        /// The first of the contacts.
        contact: &'static str,
        /// The time at which they touch, s.
        time: f64,
    },
    /// Dry friction in joints has no forces with which each of them sticks or slides: it presses harder by itself than it lets go
    /// (Painlevé), or is lost in a singular position.
    Locked {
        /// The first of the frictions.
        friction: &'static str,
        /// The time, s: that of the beginning of the step in which they are sought.
        time: f64,
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

impl SimulationError {
    /// The joint, constraint, driver, contact or event that the error is about.
    pub fn joint(&self) -> Option<&'static str> {
        match self {
            SimulationError::Breakdown { row, .. }
            | SimulationError::Inconsistent { row, .. }
            | SimulationError::Unresolved { row, .. }
            | SimulationError::LeftConstraints { row, .. }
            | SimulationError::Projection { error: AssemblyError::NoConvergence { row, .. }, .. } => {
                Some(row.of)
            }
            SimulationError::EventWithoutEnd { event, .. } | SimulationError::NoJump { event, .. } => {
                Some(event)
            }
            SimulationError::Locked { friction, .. } => Some(friction),
            SimulationError::Chatter { contact, .. }
            | SimulationError::Inside { contact, .. }
            | SimulationError::Crowded { contact, .. }
            | SimulationError::NoImpact { contact, .. } => Some(contact),
            _ => None,
        }
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
            SimulationError::Chatter { contact, time, most } => write!(
                f,
                "`{contact}` opens and closes without end at t = {time} s: contacts did so more than {most} times in one step; take a smaller \
                 step, give the contact a force that grows from zero with its depth, or write `options {{ contact = live; }}`"
            ),
            SimulationError::EventWithoutEnd { event, time, most } => write!(
                f,
                "the event `{event}` occurs without end at t = {time} s: events did so more than {most} times in one step; set the levels of \
                 events that undo each other apart, or take a smaller step"
            ),
            SimulationError::NoJump { event, time } => write!(
                f,
                "the speed that `{event}` lets jump at t = {time} s cannot: joints or drivers hold it, or others that jump with it; let \
                 another speed jump"
            ),
            SimulationError::Inside { contact, time, depth } => write!(
                f,
                "the rigid `{contact}` is {depth:.1e} m (or rad) inside at t = {time} s: begin where it is open or just touches, or take steps \
                 in which nothing crosses it"
            ),
            SimulationError::Crowded { contact, time, most } => write!(
                f,
                "with `{contact}` more than {most} rigid contacts touch at t = {time} s, and impulses are sought for {most}: give some of them a \
                 law of their depth, such as `kelvin_voigt`"
            ),
            SimulationError::NoImpact { contact, time } => write!(
                f,
                "no impulse parts the rigid `{contact}` and what touches with it at t = {time} s, and no force holds it: joints or drivers hold \
                 them against each other, or its dry friction jams; leave one of them out, lower that, or give `{contact}` a law of its depth, \
                 such as `kelvin_voigt`"
            ),
            SimulationError::Locked { friction, time } => write!(
                f,
                "near t = {time} s no forces go with the dry friction `{friction}` and what rubs with it, whether they stick or slide: friction that \
                 presses harder by itself than it lets go jams, so lower its coefficients or radii"
            ),
            SimulationError::Unresolved { time, row, reciprocal_condition, before, after } => write!(
                f,
                "the step from t = {time} s cannot be resolved beside a singular position: {row} depends on the other rows there \
                 (reciprocal condition {reciprocal_condition:.1e}), and the kinetic energy would go from {before:.3e} J to \
                 {after:.3e} J, for which no load or driver accounts; take a smaller step, start further from that position, or \
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
