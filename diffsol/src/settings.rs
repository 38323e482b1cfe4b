//! From a model and a start to a problem: what can be set, and the checks.

use crate::coordinates::first_not_unit;
use crate::{Derivatives, Differences, Equations, Error, Exact, StateOf};
use diffsol::{NalgebraMat, OdeBuilder, OdeSolverProblem};
use linkwright::{
    Assemble, Baumgarte, Mechanism, Residual, Row, SettingError, SimulationError, Tangent, Vector,
};

/// A mechanism as `diffsol` solves it.
pub type Problem<'m, M, S, D> = OdeSolverProblem<Equations<'m, M, S, D>>;

/// A start further off the constraints than this, relative to its coordinates, or with an orientation whose squared length
/// is further from one, is a mistake and not rounding; as in `linkwright::Simulation`.
const INCONSISTENT: f64 = 1e-6;

/// Tolerances and stabilisation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Error per step relative to each entry of y, and to each of its derivatives by a parameter where these are solved.
    pub relative: f64,
    /// Error per step of each entry of y, m, rad, m/s, rad/s, and of each of its derivatives, the same per unit of the
    /// parameter.
    pub absolute: f64,
    /// More steps than these [`solve`](crate::solve) and [`sensitivities`](crate::sensitivities) do not take in one run.
    pub most_steps: usize,
    /// Stabilisation of the constraints; both coefficients zero: index 1.
    pub baumgarte: Baumgarte<f64>,
    /// κ, 1/s: the rate at which an orientation's length returns to one. Nothing but the length depends on it.
    pub length_rate: f64,
    /// Whether a start off the constraints is taken. Orientations must have length one all the same.
    pub accept_inconsistent_start: bool,
}

impl Default for Settings {
    /// Relative 10⁻⁸, absolute 10⁻¹⁰, a million steps, Baumgarte's coefficients 10/s, κ = 1/s.
    fn default() -> Self {
        Settings {
            relative: 1e-8,
            absolute: 1e-10,
            most_steps: 1_000_000,
            baumgarte: Baumgarte { alpha: 10.0, beta: 10.0 },
            length_rate: 1.0,
            accept_inconsistent_start: false,
        }
    }
}

impl Settings {
    fn check(&self) -> Result<(), SettingError> {
        for (what, value) in
            [("the relative tolerance", self.relative), ("the absolute tolerance", self.absolute)]
        {
            check(what, value, value > 0.0, "positive and finite")?;
        }
        for (what, value) in [
            ("Baumgarte's alpha", self.baumgarte.alpha),
            ("Baumgarte's beta", self.baumgarte.beta),
            ("the rate of lengths", self.length_rate),
        ] {
            check(what, value, value >= 0.0, "zero or positive, and finite (1/s)")?;
        }
        Ok(())
    }
}

fn check(what: &'static str, value: f64, holds: bool, must_be: &'static str) -> Result<(), SettingError> {
    if holds && value.is_finite() { Ok(()) } else { Err(SettingError { what, value, must_be }) }
}

/// The motion of `model` from `state` at `time` (s), its Jacobian by differences.
///
/// `inputs` gives the inputs at a time and state; `|_, _| ()` for a mechanism without. A solver may ask for them in any order,
/// also beyond the end.
///
/// # Errors
/// [`Error::StartTime`]; [`Error::RigidContact`]; [`Error::Memory`]; [`Error::Mechanism`] with `Setting`, `NonFinite`, `NotNormalised`, `Inconsistent` or `Breakdown`.
pub fn problem<'m, M, S>(
    model: &'m M,
    time: f64,
    state: &StateOf<M>,
    inputs: S,
    settings: &Settings,
) -> Result<Problem<'m, M, S, Differences>, Error>
where
    M: Assemble<f64>,
    S: Fn(f64, &StateOf<M>) -> M::Inputs,
{
    build(model, time, state, inputs, settings)
}

/// As [`problem`], with the exact Jacobian and the derivatives by the parameters, of a mechanism that emits its tangent.
///
/// # Errors
/// As [`problem`].
pub fn exact_problem<'m, M, S>(
    model: &'m M,
    time: f64,
    state: &StateOf<M>,
    inputs: S,
    settings: &Settings,
) -> Result<Problem<'m, M, S, Exact>, Error>
where
    M: Tangent<f64>,
    S: Fn(f64, &StateOf<M>) -> M::Inputs,
{
    build(model, time, state, inputs, settings)
}

fn build<'m, M, S, D>(
    model: &'m M,
    time: f64,
    state: &StateOf<M>,
    inputs: S,
    settings: &Settings,
) -> Result<Problem<'m, M, S, D>, Error>
where
    M: Assemble<f64>,
    S: Fn(f64, &StateOf<M>) -> M::Inputs,
    D: Derivatives<M>,
{
    settings.check().map_err(SimulationError::Setting)?;
    if !time.is_finite() {
        return Err(Error::StartTime { time });
    }
    if let (true, Some(contact)) = (model.is_rigid(), model.gate_names().first().copied()) {
        return Err(Error::RigidContact { contact });
    }
    if let Some(&memory) = model.memory_names().first() {
        return Err(Error::Memory { memory });
    }
    check_numbers(model, time, state)?;
    if !settings.accept_inconsistent_start {
        check_constraints(model, time, state)?;
    }
    let equations = Equations::new(model, time, state.clone(), inputs, settings);
    equations.acceleration(time, state);
    if let Some(failure) = equations.failure() {
        return Err(Error::Mechanism(failure));
    }
    let problem = OdeBuilder::<NalgebraMat<f64>>::new()
        .t0(time)
        .rtol(settings.relative)
        .atol([settings.absolute])
        .sens_rtol(settings.relative)
        .sens_atol([settings.absolute])
        .p(vec![0.0; D::parameters(model)])
        .build_from_eqn(equations)?;
    Ok(problem)
}

/// All entries are finite, all orientations of length one.
fn check_numbers<M: Mechanism<f64>>(model: &M, time: f64, state: &StateOf<M>) -> Result<(), SimulationError> {
    if let Some(what) = first_not_finite(model, state) {
        return Err(SimulationError::NonFinite { time, what });
    }
    match first_not_unit(model.layout(), state.q.as_slice(), INCONSISTENT) {
        Some((first, length)) => {
            Err(SimulationError::NotNormalised { time, what: model.position_names()[first], length })
        }
        None => Ok(()),
    }
}

/// The name of the first entry of a state that is infinite or NaN.
pub(crate) fn first_not_finite<M: Mechanism<f64>>(model: &M, state: &StateOf<M>) -> Option<&'static str> {
    let position = state.q.first_not_finite().map(|entry| model.position_names()[entry]);
    let velocity = state.v.first_not_finite().map(|entry| model.velocity_names()[entry]);
    let internal = state.z.first_not_finite().map(|entry| model.internal_names()[entry]);
    position.or(velocity).or(internal)
}

/// Positions satisfy the constraints to [`INCONSISTENT`] of the size of the coordinates, velocities to the root of that.
fn check_constraints<M: Mechanism<f64>>(
    model: &M,
    time: f64,
    state: &StateOf<M>,
) -> Result<(), SimulationError> {
    let Residual { position, velocity, .. } = Residual::of(model, time, state);
    let plain = state.q.as_slice().len() - 2 * model.layout().angles.len();
    let size = state.q.as_slice()[..plain].iter().fold(1.0_f64, |largest, x| largest.max(x.abs()));
    let fast = INCONSISTENT.sqrt() * size * (1.0 + state.v.max_abs());
    // Written so that a NaN fails.
    if position <= INCONSISTENT * size * size && velocity <= fast {
        return Ok(());
    }
    let mut phi = model.zero_lambda();
    model.constraints(time, &state.q, &mut phi);
    let worst = phi.as_slice().iter().zip(model.rows()).max_by(|a, b| a.0.abs().total_cmp(&b.0.abs()));
    let row = worst.map_or(Row { of: model.name(), what: "constraints" }, |(_, row)| *row);
    Err(SimulationError::Inconsistent { time, row, position, velocity })
}
