//! What an output does in a period: extremes, mean, root mean square, and for how long it is within bounds.

use crate::cycle::{Cycle, output};
use crate::error::PeriodicError;
use crate::flow::{At, observe};
use crate::motion::PeriodicMotion;
use linkwright::{Fields, Tangent, Vector};
use std::ops::RangeInclusive;

/// An output over a period, SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measure {
    /// The largest value.
    pub largest: f64,
    /// The least.
    pub least: f64,
    /// The mean over time.
    pub mean: f64,
    /// The root of the mean square about the mean.
    pub rms: f64,
}

impl<M: Tangent<f64>> Cycle<'_, M> {
    /// What an output does in a periodic motion: integrals by Simpson's rule from switch to switch, extremes by parabolas.
    ///
    /// # Errors
    /// [`NoSuchOutput`](PeriodicError::NoSuchOutput).
    pub fn measure(&self, motion: &PeriodicMotion<M>, name: &'static str) -> Result<Measure, PeriodicError> {
        let pieces = self.pieces(motion, name)?;
        let integral = |of: &dyn Fn(f64) -> f64| {
            let sum = pieces.iter().map(|(h, [a, b, c])| h / 6.0 * (of(*a) + 4.0 * of(*b) + of(*c)));
            sum.sum::<f64>() / motion.period
        };
        let mean = integral(&|value| value);
        let rms = integral(&|value| (value - mean) * (value - mean)).sqrt();
        let extreme = |sign: f64| {
            let turned = pieces.iter().map(|(_, values)| peak(values.map(|value| sign * value)));
            sign * turned.fold(f64::NEG_INFINITY, f64::max)
        };
        Ok(Measure { largest: extreme(1.0), least: extreme(-1.0), mean, rms })
    }

    /// The share of the period in which an output is within bounds (SI).
    ///
    /// # Errors
    /// As [`measure`](Cycle::measure).
    pub fn share_within(
        &self,
        motion: &PeriodicMotion<M>,
        name: &'static str,
        bounds: RangeInclusive<f64>,
    ) -> Result<f64, PeriodicError> {
        let pieces = self.pieces(motion, name)?;
        // Between two values the output goes straight.
        let within = |a: f64, b: f64| {
            let [low, high] = [a.min(b), a.max(b)];
            let inside = high.min(*bounds.end()) - low.max(*bounds.start());
            if high > low { (inside / (high - low)).max(0.0) } else { f64::from(bounds.contains(&a)) }
        };
        let share = |(h, [a, b, c]): &(f64, [f64; 3])| 0.5 * h * (within(*a, *b) + within(*b, *c));
        Ok(pieces.iter().map(share).sum::<f64>() / motion.period)
    }

    /// An output at the times (s) of a period, from its beginning to its end.
    ///
    /// # Errors
    /// As [`measure`](Cycle::measure).
    pub fn course(
        &self,
        motion: &PeriodicMotion<M>,
        name: &'static str,
    ) -> Result<Vec<(f64, f64)>, PeriodicError> {
        let mut time = 0.0;
        let mut points = Vec::new();
        for (h, [a, b, c]) in self.pieces(motion, name)? {
            points.extend([(time, a), (time + 0.5 * h, b), (time + h, c)]);
            time += h;
        }
        Ok(points)
    }

    /// Pieces without a switch within: their lengths, and the output at begin, middle and end.
    fn pieces(
        &self,
        motion: &PeriodicMotion<M>,
        name: &'static str,
    ) -> Result<Vec<(f64, [f64; 3])>, PeriodicError> {
        let model = self.model(motion.value)?;
        let index = output(&model, name)?;
        let mut pieces = Vec::new();
        let mut see = |ends: [&At<M>; 3]| {
            let values = ends.map(|at| {
                let inputs = self.inputs_at(motion.value, at.time);
                model.outputs(at.time, &at.state, &inputs).to_array().as_slice()[index]
            });
            pieces.push((ends[2].time - ends[0].time, values));
        };
        observe(self, &model, motion.value, &motion.state, &mut see)?;
        Ok(pieces)
    }
}

/// The largest value of the parabola through three, between them.
fn peak([a, b, c]: [f64; 3]) -> f64 {
    let (slope, bend) = (0.5 * (c - a), a - 2.0 * b + c);
    let ends = a.max(b).max(c);
    if bend < 0.0 && slope.abs() < -bend { ends.max(b - 0.5 * slope * slope / bend) } else { ends }
}
