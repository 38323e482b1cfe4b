//! The usual case: states, and their derivatives by the parameters, at given times.

use crate::settings::first_not_finite;
use crate::{Derivatives, Error, Exact, Problem, StateOf};
use diffsol::{NalgebraLU, NalgebraVec, OdeEquations, OdeSolverMethod, OdeSolverStopReason, Vector as _};
use linkwright::{Assemble, Derivative, Mechanism, SimulationError, Tangent};

/// A solver of `diffsol`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Method {
    /// Backward differences of order 1 to 5, for stiff motions.
    Bdf,
    /// Trapezoidal rule and BDF2 in one step, order 2: a singly diagonally implicit method for stiff motions.
    TrBdf2,
    /// ESDIRK of order 3 with 4 stages, for stiff motions.
    Esdirk34,
    /// Tsitouras' explicit Runge–Kutta method of order 5(4).
    Tsit45,
}

/// The derivative of a state by one parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sensitivity<V, Z = ()> {
    /// Of the positions, as an increment q ⊕ δ: one entry for each velocity.
    pub q: V,
    /// Of the velocities.
    pub v: V,
    /// Of the internal states.
    pub z: Z,
}

/// The states of a problem at `times` (s), ascending from the start on.
///
/// # Errors
/// [`Error::Time`]; [`Error::TooManySteps`]; [`Error::Mechanism`] where the solver stopped because the equations have no
/// solution, else [`Error::Solver`].
pub fn solve<M, S, D>(
    problem: &Problem<'_, M, S, D>,
    method: Method,
    times: &[f64],
) -> Result<Vec<StateOf<M>>, Error>
where
    M: Assemble<f64>,
    S: Fn(f64, &StateOf<M>) -> M::Inputs,
    D: Derivatives<M>,
{
    type Lu = NalgebraLU<f64>;
    let equations = problem.eqn();
    let (mut states, later) = begin(problem, times)?;
    if later.is_empty() {
        return Ok(states);
    }
    let show = |y: &NalgebraVec<f64>, _: Option<&NalgebraVec<f64>>, time| {
        states.push(finite(equations.model(), time, equations.state_of(time, &y.clone_as_vec()))?);
        Ok(())
    };
    let march = March { times: later, most_steps: equations.most_steps, show };
    let marched = || match method {
        Method::Bdf => march.of(problem.bdf::<Lu>()?),
        Method::TrBdf2 => march.of(problem.tr_bdf2::<Lu>()?),
        Method::Esdirk34 => march.of(problem.esdirk34::<Lu>()?),
        Method::Tsit45 => march.of(problem.tsit45()?),
    };
    marched().map_err(|error| reason(problem, error))?;
    Ok(states)
}

/// As [`solve`], with the derivatives of each state by each parameter, in the order of
/// [`Tangent::Parameters`].
///
/// # Errors
/// As [`solve`].
#[allow(clippy::type_complexity)]
pub fn sensitivities<M, S>(
    problem: &Problem<'_, M, S, Exact>,
    method: Method,
    times: &[f64],
) -> Result<(Vec<StateOf<M>>, Vec<Vec<Sensitivity<M::V, M::Z>>>), Error>
where
    M: Tangent<f64>,
    S: Fn(f64, &StateOf<M>) -> M::Inputs,
{
    type Lu = NalgebraLU<f64>;
    let equations = problem.eqn();
    let parameters = Exact::parameters(equations.model());
    if parameters == 0 {
        let states = solve(problem, method, times)?;
        let none = vec![Vec::new(); states.len()];
        return Ok((states, none));
    }
    let (mut states, later) = begin(problem, times)?;
    let mut derivatives = vec![equations.start_sensitivities(); states.len()];
    if later.is_empty() {
        return Ok((states, derivatives));
    }
    let show = |y: &NalgebraVec<f64>, motions: Option<&NalgebraVec<f64>>, time| {
        let y = y.clone_as_vec();
        states.push(finite(equations.model(), time, equations.state_of(time, &y))?);
        // One lane for each parameter.
        let motions = motions.map_or(Vec::new(), |motions| motions.clone_as_vec());
        let of = |motion| {
            let Derivative { v: q, a: v, z } = equations.increment(&y, motion);
            Sensitivity { q, v, z }
        };
        derivatives.push(motions.chunks_exact(y.len()).map(of).collect());
        Ok(())
    };
    let march = March { times: later, most_steps: equations.most_steps, show };
    let marched = || match method {
        Method::Bdf => march.of(problem.bdf_sens::<Lu>()?),
        Method::TrBdf2 => march.of(problem.tr_bdf2_sens::<Lu>()?),
        Method::Esdirk34 => march.of(problem.esdirk34_sens::<Lu>()?),
        Method::Tsit45 => march.of(problem.tsit45_sens()?),
    };
    marched().map_err(|error| reason(problem, error))?;
    Ok((states, derivatives))
}

/// A run to the last of some times. `diffsol`'s own panics where rounding puts the last of its steps before the end, and takes
/// any number of steps.
struct March<'t, F> {
    times: &'t [f64],
    most_steps: usize,
    show: F,
}

impl<F> March<'_, F>
where
    F: FnMut(&NalgebraVec<f64>, Option<&NalgebraVec<f64>>, f64) -> Result<(), Error>,
{
    fn of<'p, E, S>(mut self, mut solver: S) -> Result<(), Error>
    where
        E: OdeEquations<T = f64, V = NalgebraVec<f64>> + 'p,
        S: OdeSolverMethod<'p, E>,
    {
        let mut pending = self.times;
        let Some(&end) = pending.last() else { return Ok(()) };
        solver.set_stop_time(end)?;
        for _ in 0..self.most_steps {
            let ended = matches!(solver.step()?, OdeSolverStopReason::TstopReached);
            let now = solver.state().t;
            while let [time, rest @ ..] = pending
                && (ended || *time <= now)
            {
                let at = time.min(now);
                let y = solver.interpolate(at)?;
                let motions =
                    if solver.state().s.is_empty() { None } else { Some(solver.interpolate_sens(at)?) };
                (self.show)(&y, motions.as_ref(), *time)?;
                pending = rest;
            }
            if ended {
                return Ok(());
            }
        }
        Err(Error::TooManySteps { time: solver.state().t, steps: self.most_steps })
    }
}

/// The states at those of the times that are the start's, and the later times.
fn begin<'t, M, S, D>(
    problem: &Problem<'_, M, S, D>,
    times: &'t [f64],
) -> Result<(Vec<StateOf<M>>, &'t [f64]), Error>
where
    M: Assemble<f64>,
    S: Fn(f64, &StateOf<M>) -> M::Inputs,
    D: Derivatives<M>,
{
    let equations = problem.eqn();
    let mut before = equations.start_time();
    for (index, &time) in times.iter().enumerate() {
        // Written so that a NaN fails.
        if !(time >= before && time.is_finite()) {
            return Err(Error::Time { index, time });
        }
        before = time;
    }
    equations.forget_failure();
    let at_start = times.iter().take_while(|&&time| time == equations.start_time()).count();
    Ok((vec![equations.start().clone(); at_start], &times[at_start..]))
}

/// What the equations say where a solver gave up.
fn reason<M, S, D>(problem: &Problem<'_, M, S, D>, error: Error) -> Error
where
    M: Assemble<f64>,
    S: Fn(f64, &StateOf<M>) -> M::Inputs,
    D: Derivatives<M>,
{
    match (problem.eqn().failure(), error) {
        (Some(failure), Error::Solver(_)) => Error::Mechanism(failure),
        (_, error) => error,
    }
}

/// Written numbers are numbers.
fn finite<M: Mechanism<f64>>(model: &M, time: f64, state: StateOf<M>) -> Result<StateOf<M>, SimulationError> {
    match first_not_finite(model, &state) {
        Some(what) => Err(SimulationError::NonFinite { time, what }),
        None => Ok(state),
    }
}
