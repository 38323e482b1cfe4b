//! Curves of periodic motions over p, through folds.
//!
//! ```text
//! y = (x/swing, p/p₀),   r(y) = 0,   t·(y − y_predicted) = 0        t: the tangent, ∂r/∂y t = 0
//! ```
//! Pseudo-arclength after Keller, *Numerical solution of bifurcation and nonlinear eigenvalue problems* (1977); Seydel, *Practical Bifurcation and
//! Stability Analysis* (2010), 4. ∂r/∂x is exact. ∂r/∂p is a central difference of two periods: any parameter may move anything, constraints included,
//! and the column steers the iteration only; motions, multipliers and, to second order, folds do not depend on it.

use crate::coordinates::{difference, evenly, numbers, state};
use crate::cycle::Cycle;
use crate::error::PeriodicError;
use crate::flow::flow;
use crate::motion::{PeriodicMotion, STALLED, Trial};
use linkwright::{AssembleExt, StateOf, Tangent};
use nalgebra::{DMatrix, DVector};
use std::ops::RangeInclusive;

/// The part of p by which ∂r/∂p is found.
const ASIDE: f64 = 1e-6;
/// Iterations of one point.
const ITERATIONS: u32 = 10;
/// Iterations after which the next step is shorter, and up to which it is longer.
const MANY: u32 = 6;
const FEW: u32 = 3;
/// The least step, of the first.
const LEAST: f64 = 1e-6;
/// Trials for one fold.
const TRIALS: u32 = 40;
/// A tangent whose part along p is this small belongs to a fold.
const UPRIGHT: f64 = 1e-9;

/// How a branch is followed.
#[derive(Clone, Debug)]
pub struct Along {
    /// It ends where p leaves this range.
    pub within: RangeInclusive<f64>,
    /// Towards larger p at first, or smaller.
    pub upwards: bool,
    /// The first step along the curve, with p and each coordinate's swing at the first motion as units.
    pub step: f64,
    /// The largest.
    pub longest: f64,
    /// Motions at most.
    pub most: usize,
}

impl Along {
    /// Within a range, from a motion in it, by steps that suit themselves.
    pub fn new(within: RangeInclusive<f64>) -> Self {
        Along { within, upwards: true, step: 0.01, longest: 0.2, most: 2000 }
    }

    /// Towards smaller p at first.
    #[must_use]
    pub fn downwards(self) -> Self {
        Along { upwards: false, ..self }
    }
}

/// Motions along a curve.
pub struct Branch<M: Tangent<f64>> {
    /// In order, folds not among them.
    pub motions: Vec<PeriodicMotion<M>>,
    /// Where the curve turns back in p: a multiplier is one.
    pub folds: Vec<PeriodicMotion<M>>,
    /// Why it ended.
    pub end: End,
}

/// Why a branch ended.
#[derive(Clone, Debug, PartialEq)]
pub enum End {
    /// p left the range.
    Left,
    /// As many motions as were wanted.
    Most,
    /// No further motion was found, however short the step.
    Lost(PeriodicError),
}

impl<M: Tangent<f64>> Cycle<'_, M> {
    /// The motions that hang together with one, as p changes.
    ///
    /// # Errors
    /// [`NoStep`](PeriodicError::NoStep), or no tangent at the first motion. What stops the curve later is in [`Branch::end`].
    pub fn branch(&self, from: &PeriodicMotion<M>, along: &Along) -> Result<Branch<M>, PeriodicError> {
        let step = along.step;
        if !(step > 0.0 && along.longest >= step && step.is_finite()) {
            return Err(PeriodicError::NoStep { step });
        }
        let units = Units::of(from);
        let mut upwards = DVector::zeros(units.x.len() + 1);
        upwards[units.x.len()] = if along.upwards { 1.0 } else { -1.0 };
        let mut here = self.point(from.clone(), &units, &upwards)?;
        let mut branch = Branch { motions: vec![from.clone()], folds: Vec::new(), end: End::Most };
        let mut step = step;
        while branch.motions.len() < along.most {
            let (next, iterations) = match self.next(&here, &units, step) {
                Ok(found) => found,
                Err(error) => {
                    step *= 0.5;
                    if step < LEAST * along.step {
                        branch.end = End::Lost(error);
                        return Ok(branch);
                    }
                    continue;
                }
            };
            if here.slope() * next.slope() < 0.0 {
                branch.folds.extend(self.fold(&here, &next, &units, step));
            }
            branch.motions.push(next.motion.clone());
            let value = next.motion.value;
            here = next;
            if !along.within.contains(&value) {
                branch.end = End::Left;
                return Ok(branch);
            }
            if iterations >= MANY {
                step *= 0.6;
            } else if iterations <= FEW {
                step = (1.3 * step).min(along.longest);
            }
        }
        Ok(branch)
    }

    /// A motion with its tangent, on the side of `before`.
    fn point(
        &self,
        motion: PeriodicMotion<M>,
        units: &Units,
        before: &DVector<f64>,
    ) -> Result<Point<M>, PeriodicError> {
        let by_value = self.by_value(&motion.state, motion.value)?;
        let tangent = units.tangent(&motion.monodromy, &by_value, before);
        let value = motion.value;
        let tangent = tangent.ok_or(PeriodicError::NotClosed { value, residual: 0.0, iterations: 0 })?;
        Ok(Point { motion, by_value, tangent })
    }

    /// The point a step further, and the iterations that it took.
    fn next(&self, here: &Point<M>, units: &Units, step: f64) -> Result<(Point<M>, u32), PeriodicError> {
        let predicted = &here.tangent * step;
        let mut moved = predicted.clone();
        let mut before = f64::INFINITY;
        for iteration in 1..=ITERATIONS {
            let (trial, value) = self.displaced(here, units, &moved)?;
            let off = here.tangent.dot(&(&moved - &predicted));
            let stalled = trial.off() < STALLED && trial.off() > 0.25 * before;
            before = trial.off();
            if (trial.closed() || stalled) && off.abs() <= 1e-10 * step {
                let motion = trial.into_motion(value);
                return Ok((self.point(motion, units, &here.tangent)?, iteration));
            }
            let lost = trial.not_closed(value, iteration);
            // The column by p changes little within a step.
            let correction =
                units.solve(trial.derivative(), &here.by_value, &here.tangent, &trial.residual, -off);
            let correction = correction.ok_or_else(|| lost.clone())?;
            moved += correction;
            if iteration == ITERATIONS || (&moved - &predicted).norm() > step {
                return Err(lost);
            }
        }
        Err(PeriodicError::NoStep { step })
    }

    /// A trial at y displaced from a point.
    fn displaced(
        &self,
        here: &Point<M>,
        units: &Units,
        moved: &DVector<f64>,
    ) -> Result<(Trial<M>, f64), PeriodicError> {
        let size = units.x.len();
        let value = here.motion.value + units.value * moved[size];
        let model = self.model(value)?;
        let x = &here.motion.start
            + moved.rows(0, size).component_mul(&units.x)
            + self.faster(&model, here.motion.value, value)?;
        let state = state(&model, 0.0, &here.motion.state, &x)?;
        Ok((self.begin(&model, value, state)?, value))
    }

    /// Where between two points the tangent is upright: by the chord of its part along p, kept within (Illinois).
    fn fold(&self, from: &Point<M>, to: &Point<M>, units: &Units, step: f64) -> Option<PeriodicMotion<M>> {
        let (mut low, mut high) = ((0.0, from.slope()), (step, to.slope()));
        let mut best: Option<Point<M>> = None;
        let mut kept = 0;
        for _ in 0..TRIALS {
            let middle = (low.0 * high.1 - high.0 * low.1) / (high.1 - low.1);
            let (found, _) = self.next(from, units, middle).ok()?;
            let slope = found.slope();
            if best.as_ref().is_none_or(|best| slope.abs() < best.slope().abs()) {
                best = Some(found);
            }
            if slope.abs() < UPRIGHT || high.0 - low.0 < 1e-12 * step {
                break;
            }
            let side = if slope * low.1 > 0.0 { 1 } else { -1 };
            if side == 1 {
                low = (middle, slope);
                high.1 *= if kept == 1 { 0.5 } else { 1.0 };
            } else {
                high = (middle, slope);
                low.1 *= if kept == -1 { 0.5 } else { 1.0 };
            }
            kept = side;
        }
        best.map(|best| best.motion)
    }

    /// How the mean rates of what goes on change with p: they are no part of a swing.
    fn faster(&self, model: &M, from: f64, to: f64) -> Result<DVector<f64>, PeriodicError> {
        let [before, after] = [self.period(from)?, self.period(to)?];
        Ok(evenly(self, model, after) - evenly(self, model, before))
    }

    /// ∂r/∂p at one beginning of the cycle, what goes on faster with it.
    fn by_value(&self, from: &StateOf<M>, value: f64) -> Result<DVector<f64>, PeriodicError> {
        let aside = ASIDE * value.abs().max(f64::MIN_POSITIVE.sqrt());
        let ends = |value: f64, at: f64| -> Result<_, PeriodicError> {
            let model = self.model(at)?;
            let mut from = from.clone();
            if !self.turns.is_empty() {
                let x = numbers(&model, 0.0, &from) + self.faster(&model, value, at)?;
                from = state(&model, 0.0, &from, &x)?;
            } else if model.row_count() > 0 {
                from = model.project(0.0, &from).map_err(PeriodicError::Assembly)?;
            }
            let [begin, end] = [numbers(&model, 0.0, &from), flow(self, &model, at, &from, false)?.x];
            Ok((model, begin, end))
        };
        let (_, less, less_end) = ends(value, value - aside)?;
        let (model, more, more_end) = ends(value, value + aside)?;
        let begin = difference(self, &model, [&more, &less], 0.0);
        let end = difference(self, &model, [&more_end, &less_end], 0.0);
        Ok((end - begin) / (2.0 * aside))
    }
}

/// A motion on a curve.
struct Point<M: Tangent<f64>> {
    motion: PeriodicMotion<M>,
    by_value: DVector<f64>,
    /// Of length one in y.
    tangent: DVector<f64>,
}

impl<M: Tangent<f64>> Point<M> {
    /// The tangent's part along p.
    fn slope(&self) -> f64 {
        self.tangent[self.tangent.len() - 1]
    }
}

/// What x and p are measured by.
struct Units {
    x: DVector<f64>,
    value: f64,
}

impl Units {
    fn of<M: Tangent<f64>>(motion: &PeriodicMotion<M>) -> Self {
        let x = motion.swing.map(|swing| if swing > 0.0 { swing } else { 1.0 });
        let value = if motion.value == 0.0 { 1.0 } else { motion.value.abs() };
        Units { x, value }
    }

    /// δy of ∂r/∂y δy = −r, t·δy = along.
    fn solve(
        &self,
        monodromy: &DMatrix<f64>,
        by_value: &DVector<f64>,
        tangent: &DVector<f64>,
        residual: &DVector<f64>,
        along: f64,
    ) -> Option<DVector<f64>> {
        let size = self.x.len();
        let mut right = DVector::zeros(size + 1);
        right.rows_mut(0, size).copy_from(&(-residual).component_div(&self.x));
        right[size] = along;
        self.bordered(monodromy, by_value, tangent).lu().solve(&right)
    }

    /// The tangent on the side of the one before.
    fn tangent(
        &self,
        monodromy: &DMatrix<f64>,
        by_value: &DVector<f64>,
        before: &DVector<f64>,
    ) -> Option<DVector<f64>> {
        let mut right = DVector::zeros(self.x.len() + 1);
        right[self.x.len()] = 1.0;
        let tangent = self.bordered(monodromy, by_value, before).lu().solve(&right)?;
        Some(tangent.normalize())
    }

    /// [∂r/∂x, ∂r/∂p; tᵀ] in these units.
    fn bordered(
        &self,
        monodromy: &DMatrix<f64>,
        by_value: &DVector<f64>,
        last: &DVector<f64>,
    ) -> DMatrix<f64> {
        let size = self.x.len();
        DMatrix::from_fn(size + 1, size + 1, |row, column| match (row == size, column == size) {
            (true, _) => last[column],
            (false, true) => by_value[row] * self.value / self.x[row],
            (false, false) => {
                let unit = if row == column { 1.0 } else { 0.0 };
                (monodromy[(row, column)] - unit) * self.x[column] / self.x[row]
            }
        })
    }
}
