//! Internal states that begin where they rest: ż = 0 by Newton's method, all else at the start.

use super::assemble::{Ancestry, Assembly, Point};
use super::elimination::eliminated;
use super::messages;
use crate::diagnostics::Diagnostics;
use crate::equations::Equations;
use crate::model::{Expr, InternalState, Mechanism};
use crate::solve::Solved;

/// Steps of Newton's method.
const MOST: usize = 60;
/// A step of this part of a state's size is the last.
const SETTLED: f64 = 1e-12;
/// Differences are taken across this part of it.
const ACROSS: f64 = 1e-6;
/// States grow that leave where they are faster than so, 1/s.
const UNSTABLE: f64 = 1e3;

/// Rates of all internal states at the start, by interpreting the solved equations.
struct Rates<'a> {
    point: Point<'a>,
    solution: Ancestry,
    rates: Ancestry,
    solved: &'a Solved,
    /// Their sizes, where no state is larger.
    scales: Vec<f64>,
}

impl<'a> Rates<'a> {
    fn new(mechanism: &Mechanism, equations: &'a Equations, solved: &'a Solved, assembly: &Assembly) -> Self {
        let mut point = Point::at_defaults(mechanism, equations, &assembly.phases);
        point.set_q(&assembly.q);
        point.set_v(&assembly.v);
        let results = solved.index1.acceleration.iter().chain(&solved.index1.lambda);
        Rates {
            point,
            solution: Ancestry::of(equations, results.copied()),
            rates: Ancestry::of(equations, equations.internal_rates.iter().copied()),
            solved,
            scales: mechanism.states.iter().map(|state| state.scale.unwrap_or(1.0)).collect(),
        }
    }

    fn at(&mut self, z: &[f64]) -> Vec<f64> {
        let (equations, index1) = (self.point.equations, &self.solved.index1);
        self.point.set(&equations.symbols.internal, z);
        self.point.hold();
        self.point.evaluate(&self.solution);
        let acceleration: Vec<f64> = index1.acceleration.iter().map(|node| self.point.get(*node)).collect();
        let lambda: Vec<f64> = index1.lambda.iter().map(|node| self.point.get(*node)).collect();
        self.point.set(&equations.symbols.acceleration, &acceleration);
        self.point.set(&equations.symbols.lambda, &lambda);
        self.point.evaluate(&self.rates);
        equations.internal_rates.iter().map(|node| self.point.get(*node)).collect()
    }

    /// The derivatives of all rates by one state.
    fn column(&mut self, z: &[f64], by: usize) -> Vec<f64> {
        let step = ACROSS * self.size(z, by);
        let mut moved = |sign: f64| {
            let mut z = z.to_vec();
            z[by] += sign * step;
            self.at(&z)
        };
        let (ahead, behind) = (moved(1.0), moved(-1.0));
        ahead.iter().zip(behind).map(|(ahead, behind)| (ahead - behind) / (2.0 * step)).collect()
    }

    fn size(&self, z: &[f64], of: usize) -> f64 {
        z[of].abs().max(self.scales[of])
    }
}

/// The states with what they begin at: those that `start` wants to rest found so, the others as they are declared; nothing after an
/// error.
pub fn steady(
    mechanism: &Mechanism,
    equations: &Equations,
    solved: &Solved,
    assembly: &Assembly,
    errors: &mut Diagnostics,
) -> Option<Vec<InternalState>> {
    let mut states = mechanism.states.clone();
    if mechanism.steady.is_empty() {
        return Some(states);
    }
    let mut z = mechanism.internal_starts();
    let own: Vec<usize> = mechanism.steady.iter().map(|(state, _)| *state).collect();
    let mut rates = Rates::new(mechanism, equations, solved, assembly);
    let mut steps = vec![0.0; own.len()];
    for _ in 0..MOST {
        let residual = rates.at(&z);
        let columns: Vec<Vec<f64>> = own.iter().map(|by| rates.column(&z, *by)).collect();
        // Rows by their rates, columns by sizes.
        let row = |of: &usize| -> Vec<f64> {
            let entries = columns.iter().zip(&own).map(|(column, by)| column[*of] * rates.size(&z, *by));
            entries.chain([-residual[*of]]).collect()
        };
        steps = match eliminated(own.iter().map(row).collect()) {
            Ok(steps) => steps,
            Err(at) => {
                let (state, region) = mechanism.steady[at];
                let name = &states[state].name.text;
                errors.error(region, messages::never_steady(name, z[state], residual[state]));
                return None;
            }
        };
        for (by, step) in own.iter().zip(&steps) {
            z[*by] += step * rates.size(&z, *by);
        }
        if steps.iter().all(|step| step.abs() <= SETTLED) {
            for state in own {
                states[state].start = Expr::Number(z[state]);
            }
            return Some(states);
        }
    }
    let residual = rates.at(&z);
    let moving = mechanism.steady.iter().zip(steps).filter(|(_, step)| step.abs() > SETTLED);
    for ((state, region), _) in moving {
        let name = &states[*state].name.text;
        errors.error(*region, messages::not_settled(name, MOST, z[*state], residual[*state]));
    }
    None
}

/// The states that leave where they start by themselves, with the time in which they grow e-fold.
pub fn unstable<'m>(
    mechanism: &'m Mechanism,
    equations: &Equations,
    solved: &Solved,
    assembly: &Assembly,
) -> Vec<(&'m InternalState, f64)> {
    if mechanism.states.is_empty() {
        return Vec::new();
    }
    let z = mechanism.internal_starts();
    let mut rates = Rates::new(mechanism, equations, solved, assembly);
    let growth = mechanism.states.iter().enumerate().map(|(at, state)| (state, rates.column(&z, at)[at]));
    growth.filter(|(_, growth)| *growth > UNSTABLE).map(|(state, growth)| (state, 1.0 / growth)).collect()
}
