//! The usual case: states, and their derivatives by the parameters, at given times.

use crate::{Derivatives, Error, Exact, Problem, StateOf};
use diffsol::{
    DiffsolError, MatrixCommon, NalgebraLU, NalgebraMat, OdeSolverMethod, SensitivitiesOdeSolverMethod,
};
use linkwright::{Assemble, Mechanism, SimulationError, Tangent, Vector};

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
pub struct Sensitivity<V> {
    /// Of the positions, as an increment q ⊕ δ: one entry for each velocity.
    pub q: V,
    /// Of the velocities.
    pub v: V,
}

/// The states of a problem at `times` (s), ascending from the start on.
///
/// # Errors
/// [`Error::Time`]; [`Error::Mechanism`] where the solver stopped because the equations have no solution, else
/// [`Error::Solver`].
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
    let solved = || -> Result<_, DiffsolError> {
        let (matrix, _) = match method {
            Method::Bdf => problem.bdf::<Lu>()?.solve_dense(later)?,
            Method::TrBdf2 => problem.tr_bdf2::<Lu>()?.solve_dense(later)?,
            Method::Esdirk34 => problem.esdirk34::<Lu>()?.solve_dense(later)?,
            Method::Tsit45 => problem.tsit45()?.solve_dense(later)?,
        };
        Ok(matrix)
    };
    let matrix = solved().map_err(|error| reason(problem, error))?;
    for (index, &time) in later.iter().enumerate() {
        let state = equations.state_of(&column(&matrix, index));
        states.push(finite::<M>(time, state)?);
    }
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
) -> Result<(Vec<StateOf<M>>, Vec<Vec<Sensitivity<M::V>>>), Error>
where
    M: Tangent<f64>,
    S: Fn(f64, &StateOf<M>) -> M::Inputs,
{
    type Lu = NalgebraLU<f64>;
    let equations = problem.eqn();
    let parameters = <Exact as Derivatives<M>>::PARAMETERS;
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
    let solved = || -> Result<_, DiffsolError> {
        let (matrix, columns, _) = match method {
            Method::Bdf => problem.bdf_sens::<Lu>()?.solve_dense_sensitivities(later)?,
            Method::TrBdf2 => problem.tr_bdf2_sens::<Lu>()?.solve_dense_sensitivities(later)?,
            Method::Esdirk34 => problem.esdirk34_sens::<Lu>()?.solve_dense_sensitivities(later)?,
            Method::Tsit45 => problem.tsit45_sens()?.solve_dense_sensitivities(later)?,
        };
        Ok((matrix, columns))
    };
    let (matrix, by_parameter) = solved().map_err(|error| reason(problem, error))?;
    for (index, &time) in later.iter().enumerate() {
        let y = column(&matrix, index);
        states.push(finite::<M>(time, equations.state_of(&y))?);
        let of = |motions: &NalgebraMat<f64>| {
            let (q, v) = equations.increments(&y, &column(motions, index));
            Sensitivity { q, v }
        };
        derivatives.push(by_parameter.iter().map(of).collect());
    }
    Ok((states, derivatives))
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
    Ok((vec![*equations.start(); at_start], &times[at_start..]))
}

/// What the equations say of a solver's error.
fn reason<M, S, D>(problem: &Problem<'_, M, S, D>, error: DiffsolError) -> Error
where
    M: Assemble<f64>,
    S: Fn(f64, &StateOf<M>) -> M::Inputs,
    D: Derivatives<M>,
{
    problem.eqn().failure().map_or(Error::Solver(error), Error::Mechanism)
}

/// Written numbers are numbers.
fn finite<M: Mechanism<f64>>(time: f64, state: StateOf<M>) -> Result<StateOf<M>, SimulationError> {
    let position = state.q.first_not_finite().map(|entry| M::POSITION_NAMES[entry]);
    match position.or(state.v.first_not_finite().map(|entry| M::VELOCITY_NAMES[entry])) {
        Some(what) => Err(SimulationError::NonFinite { time, what }),
        None => Ok(state),
    }
}

fn column(matrix: &NalgebraMat<f64>, index: usize) -> Vec<f64> {
    (0..matrix.nrows()).map(|row| matrix[(row, index)]).collect()
}
