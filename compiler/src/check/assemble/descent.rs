//! Least squares with side conditions on the group of positions: min ½ Σ (soft residual)² where all hard ones are zero.
//!
//! Levenberg's and Marquardt's method: a step is the least of ½ μ |δ|² + ½ Σ (J_i δ + r_i)² / c_i, with a compliance c of one
//! for soft residuals and next to nothing for hard ones, which is the saddle point of [μ 1, Jᵀ; J, −C]. That matrix is
//! quasi-definite: it can be factored in any order, and rows that repeat others, exactly or nearly, do no harm (Vanderbei,
//! Symmetric quasidefinite matrices, 1995). μ is the curvature that the linear picture lacks, as the last step has shown it,
//! so that the method converges fast where the sum becomes zero and also where it does not. Closing loops, going along them
//! towards the guesses, and finding the least gap are this with different residuals as soft ones.

use super::point::{Ancestry, Point, retract};
use crate::equations::{Equations, Jet};
use crate::solve::table::{Numeric, Table};
use std::f64::consts::TAU;

/// One residual, divided by what counts as one.
#[derive(Clone)]
pub struct Residual {
    pub jet: Jet,
    pub target: f64,
    /// Compared on the circle.
    pub angular: bool,
    pub size: f64,
    /// L of a distance, whose row is (Δ·Δ − L²)/2, for the residual |Δ| − L in metres.
    pub length: Option<f64>,
}

/// The role of a residual in one descent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    Soft,
    Hard,
    Absent,
}

/// Where a descent ended.
#[derive(Clone, Debug)]
pub struct Rest {
    pub q: Vec<f64>,
    /// ½ Σ (soft residual)².
    pub cost: f64,
}

/// The residuals, set up once for all descents.
pub struct Descent<'a> {
    equations: &'a Equations,
    residuals: Vec<Residual>,
    ancestry: Ancestry,
    table: Table,
    /// Steps that may still be taken.
    pub steps: usize,
}

/// Residuals and their derivatives at one position.
struct Linear {
    residuals: Vec<f64>,
    entries: Vec<(usize, usize, f64)>,
}

/// For a descent whose position matters, and not only its sum.
pub const TO_THE_END: f64 = 0.0;
/// A step that takes less than this part of the sum away does not end at zero.
pub const HOPELESS: f64 = 1e-3;
/// Steps of one descent.
const ITERATIONS: usize = 60;
/// The largest turn of a step, rad: beyond, the linear picture means nothing.
const LARGEST_TURN: f64 = 0.7;
const FIRST_DAMPING: f64 = 1e-3;
/// Below, damping makes no difference to the step, and rows that repeat others would be taken for rounding.
const LEAST_DAMPING: f64 = 1e-9;
const MOST_DAMPING: f64 = 1e8;
/// Compliance of hard residuals.
const STIFF: f64 = 1e-16;
/// Sums below this are zero: residuals of 1e-15.
const ZERO: f64 = 1e-30;
/// Half the sum of squares of hard residuals that are met: as well as can be, and well enough where rounding allows no better.
const MET: f64 = 1e-28;
const MET_ROUGHLY: f64 = 1e-22;
/// Steps below this are too short for sums to tell whether they were good.
const SHORT: f64 = 1e-5;
/// Steps below this that bring the sum no further down are rounding.
const ROUNDING: f64 = 1e-8;
const STANDS: f64 = 1e-12;

impl<'a> Descent<'a> {
    pub fn new(equations: &'a Equations, residuals: Vec<Residual>, steps: usize) -> Self {
        let n = equations.symbols.v.len();
        let nodes = residuals.iter().flat_map(|own| own.jet.columns.values().copied().chain([own.jet.value]));
        let ancestry = Ancestry::of(equations, nodes.collect::<Vec<_>>());
        let entry = |(at, own): (usize, &Residual)| {
            own.jet.columns.keys().map(move |column| (n + at, *column)).collect::<Vec<_>>()
        };
        let table = Table::new(n, residuals.len(), residuals.iter().enumerate().flat_map(entry));
        Descent { equations, residuals, ancestry, table, steps }
    }

    /// The least sum near `q`, until a step takes no more than the part `least` of it away; `None` where hard residuals cannot be
    /// met from there, or something has no value.
    pub fn descend(&mut self, point: &mut Point, q: Vec<f64>, roles: &[Role], least: f64) -> Option<Rest> {
        let mut here = self.restored(point, q, roles)?;
        let mut damping = FIRST_DAMPING;
        let mut last = f64::INFINITY;
        for _ in 0..ITERATIONS {
            if here.rest.cost < ZERO || self.steps == 0 {
                break;
            }
            self.steps -= 1;
            let step = self.step(&here.linear, roles, damping);
            let size = largest(&step);
            if !size.is_finite() {
                return None;
            }
            if size < STANDS {
                break;
            }
            let expected = here.rest.cost - self.cost_after(&here.linear, roles, &step);
            let there = self.restored(point, retract(self.equations, &here.rest.q, &step), roles);
            // Near the end sums differ by rounding only; steps that grow shorter are good ones.
            let settles = size < SHORT && size < 0.5 * last;
            match there {
                Some(there) if there.rest.cost < here.rest.cost || settles => {
                    let square: f64 = step.iter().map(|x| x * x).sum();
                    let lacking = 2.0 * (expected - (here.rest.cost - there.rest.cost)) / square;
                    if size > SHORT {
                        damping = lacking.clamp(0.1 * damping, 10.0 * damping).max(LEAST_DAMPING);
                    }
                    let taken = here.rest.cost - there.rest.cost;
                    (here, last) = (there, size);
                    if taken.max(expected) < least * here.rest.cost {
                        break;
                    }
                }
                _ if size < ROUNDING || damping > MOST_DAMPING => break,
                _ => damping *= 8.0,
            }
        }
        Some(here.rest)
    }

    /// The residuals at `q`, times their sizes.
    pub fn amounts(&self, point: &mut Point, q: &[f64]) -> Vec<f64> {
        let linear = self.linearise(point, q);
        linear.residuals.iter().zip(&self.residuals).map(|(value, own)| value * own.size).collect()
    }

    /// `q` moved until the hard residuals are met.
    fn restored(&mut self, point: &mut Point, q: Vec<f64>, roles: &[Role]) -> Option<Here> {
        let hard = |role: &Role| if *role == Role::Hard { Role::Soft } else { Role::Absent };
        let held: Vec<Role> = roles.iter().map(hard).collect();
        let linear = self.linearise(point, &q);
        let here = match self.cost(&linear, &held) {
            met if met < MET => Here { rest: Rest { q, cost: 0.0 }, linear },
            _ => {
                let rest =
                    self.descend(point, q, &held, TO_THE_END).filter(|rest| rest.cost < MET_ROUGHLY)?;
                let linear = self.linearise(point, &rest.q);
                Here { rest, linear }
            }
        };
        let cost = self.cost(&here.linear, roles);
        cost.is_finite().then_some(Here { rest: Rest { cost, ..here.rest }, ..here })
    }

    fn linearise(&self, point: &mut Point, q: &[f64]) -> Linear {
        let n = self.equations.symbols.v.len();
        point.set_q(q);
        point.evaluate(&self.ancestry);
        let mut linear = Linear { residuals: Vec::with_capacity(self.residuals.len()), entries: Vec::new() };
        for (at, own) in self.residuals.iter().enumerate() {
            let mut value = point.get(own.jet.value) - own.target;
            if own.angular {
                value -= TAU * (value / TAU).round();
            }
            let mut size = own.size;
            if let Some(length) = own.length {
                let apart = (2.0 * value + length * length).max(0.0).sqrt();
                value = apart - length;
                // Where the places coincide every direction is as good.
                let slope = apart.max(1e-6 * length);
                size *= slope;
                value *= slope;
            }
            linear.residuals.push(value / size);
            linear.entries.extend(
                own.jet.columns.iter().map(|(column, node)| (n + at, *column, point.get(*node) / size)),
            );
        }
        linear
    }

    fn step(&self, linear: &Linear, roles: &[Role], damping: f64) -> Vec<f64> {
        let n = self.equations.symbols.v.len();
        let present = |row: &usize| roles[row - n] != Role::Absent;
        let mut entries: Vec<(usize, usize, f64)> = (0..n).map(|k| (k, k, damping)).collect();
        entries.extend(linear.entries.iter().filter(|(row, ..)| present(row)));
        let mut rhs = vec![0.0; n + roles.len()];
        for (at, role) in roles.iter().enumerate() {
            let compliance = if *role == Role::Hard { STIFF } else { 1.0 };
            entries.push((n + at, n + at, -compliance));
            if *role != Role::Absent {
                rhs[n + at] = -linear.residuals[at];
            }
        }
        let mut step = Numeric::factor(&self.table, entries).solve(&rhs);
        step.truncate(n);
        let first = self.equations.layout.linear.len();
        let turn = largest(&step[first..]);
        if turn > LARGEST_TURN {
            step.iter_mut().for_each(|x| *x *= LARGEST_TURN / turn);
        }
        step
    }

    fn cost(&self, linear: &Linear, roles: &[Role]) -> f64 {
        let soft = linear.residuals.iter().zip(roles).filter(|(_, role)| **role == Role::Soft);
        0.5 * soft.map(|(value, _)| value * value).sum::<f64>()
    }

    /// The sum that the linear picture expects.
    fn cost_after(&self, linear: &Linear, roles: &[Role], step: &[f64]) -> f64 {
        let n = self.equations.symbols.v.len();
        let mut moved = linear.residuals.clone();
        for (row, column, value) in &linear.entries {
            moved[row - n] += value * step[*column];
        }
        self.cost(&Linear { residuals: moved, entries: Vec::new() }, roles)
    }
}

struct Here {
    rest: Rest,
    linear: Linear,
}

fn largest(step: &[f64]) -> f64 {
    step.iter().fold(0.0_f64, |largest, x| if x.is_nan() { f64::INFINITY } else { largest.max(x.abs()) })
}
