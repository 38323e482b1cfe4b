//! Positions near which the constraints lose rank, also those that lie between two steps.

use crate::mechanism::Row;
use crate::real::Real;

/// A position near which the constraints lose rank: a change point, a dead centre of a mechanism with several degrees of
/// freedom, a flat parallelogram. There the motion is hardly determined, and which branch is taken may be a matter of
/// rounding.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearSingular<R = f64> {
    /// The time, s.
    pub time: R,
    /// The row that depends on the others.
    pub row: Row,
    /// The estimate of the reciprocal condition of D M⁻¹ Dᵀ, at a stage or between two steps.
    pub reciprocal_condition: R,
}

/// The part of the largest of three values that their parabola's vertex is taken to be off by: along an angle ε the
/// condition goes like sin² ε, a parabola but for ε²/3.
const UNCERTAIN: f64 = 0.01;

/// The reciprocal condition at the last steps.
///
/// At a singular position that the motion passes it has a minimum of zero, and goes like the square of the distance. Steps
/// seldom fall on it, so three values in a row are taken as a parabola, and its vertex is what was passed. Times are kept as
/// distances in steps: differences of the clock's readings would be rounded, in `f32` to nothing after a day.
#[derive(Clone, Copy, Debug)]
pub(super) struct Passage<R> {
    /// (how long after the value before, value), the latest last.
    known: [Option<(R, R)>; 2],
    /// Where the latest value was taken, from the beginning of the present step, s: not above zero.
    latest: R,
    /// The pivot of D in the step before, squared.
    pivot: R,
}

/// D whose pivots have squares above this, relative to their rows, is far from losing rank where they change slowly.
const FAR: f64 = 1e-2;

/// A square that becomes less than this part of itself in a step may be zero two steps further.
const NEARS: f64 = 4.0 / 9.0;

impl<R: Real> Passage<R> {
    pub fn new() -> Self {
        Passage { known: [None; 2], latest: R::ZERO, pivot: R::ZERO }
    }

    /// Whether the smallest pivot of D in a step, squared, is far from zero at the pace of the last step.
    pub fn is_far(&mut self, pivot: R) -> bool {
        let nears = pivot.less(R::from_f64(NEARS) * self.pivot);
        self.pivot = pivot;
        R::any(pivot.greater_equal(R::from_f64(FAR))) && !R::any(nears)
    }

    /// What was taken is no longer near.
    pub fn forget(&mut self) {
        *self = Passage { pivot: self.pivot, ..Passage::new() };
    }

    /// Whether nothing was taken yet.
    pub fn is_new(&self) -> bool {
        self.known[1].is_none()
    }

    /// Takes the value at a time from the beginning of the present step; gives time, from there too, and value of the minimum passed
    /// since the last but one, if it cannot be told from a singular position.
    pub fn see(&mut self, into: R, value: R) -> Option<(R, R)> {
        let after = into - self.latest;
        let passed = match self.known {
            [Some((_, first)), Some((between, second))] => vertex((between, after), [first, second, value]),
            _ => None,
        };
        let passed = passed.map(|(since, least)| (self.latest + since, least));
        self.known = [self.known[1], Some((after, value))];
        self.latest = into;
        passed
    }

    /// The present step, of this size, is at its end.
    pub fn end_step(&mut self, size: R) {
        self.latest = self.latest - size;
    }
}

/// The least value of the parabola through three values that are `before` and `after` apart, if it lies between them and is nearly
/// zero: when, counted from the second, and the value.
fn vertex<R: Real>((before, after): (R, R), [r0, r1, r2]: [R; 3]) -> Option<(R, R)> {
    // A minimum, and no point of it nearly zero by itself: that is seen without a parabola.
    if !(r1 <= r0 && r1 < r2 && r1 >= R::NEAR_SINGULAR) {
        return None;
    }
    let (slope, next) = ((r1 - r0) / before, (r2 - r1) / after);
    let curvature = (next - slope) / (before + after);
    // r = r1 + b t + curvature t²
    let b = slope + curvature * before;
    let half = R::from_f64(0.5);
    let time = -(half * b / curvature);
    let least = r1 - R::from_f64(0.25) * b * b / curvature;
    let uncertain = R::from_f64(UNCERTAIN) * r0.max(r2);
    (least <= R::NEAR_SINGULAR + uncertain).then(|| (time, least.max(R::ZERO)))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By values at the beginning of steps, then by values at their end.
    fn passed(step: f64, offset: f64, value: impl Fn(f64) -> f64) -> Option<(f64, f64)> {
        let [begin, end] = [0.0, step].map(|into| {
            let mut passage = Passage::new();
            (-5..5).find_map(|k| {
                let time = f64::from(k) * step + offset;
                let passed = passage.see(into, value(time + into));
                passage.end_step(step);
                passed.map(|(into, least)| (time + into, least))
            })
        });
        match (begin, end) {
            (Some(begin), Some(end)) => assert!((begin.0 - end.0).abs() < 1e-12, "{begin:?} {end:?}"),
            _ => assert_eq!(begin, end),
        }
        begin
    }

    #[test]
    fn a_zero_between_steps_is_seen() {
        for step in [0.01, 0.05, 0.1] {
            for offset in [0.2, 0.4, 0.5, 0.7, 0.85] {
                let (time, value) = passed(step, offset * step, |t| t.sin().powi(2)).expect("it was passed");
                assert!(
                    time.abs() < 0.1 * step && value < 1e-2 * step * step,
                    "{step} {offset}: {time} {value}"
                );
            }
        }
    }

    /// Steps that get longer, as those of a method that chooses them.
    #[test]
    fn steps_need_not_be_of_one_size() {
        for first in [0.03, 0.05, 0.08] {
            let (mut passage, mut time, mut size) = (Passage::new(), -1.0_f64, first);
            let found = loop {
                let passed = passage.see(0.0, time.sin().powi(2));
                if let Some((into, least)) = passed {
                    break (time + into, least);
                }
                passage.end_step(size);
                time += size;
                assert!(time < 1.0, "{first}: nothing was seen");
                size *= 1.1;
            };
            assert!(found.0.abs() < 0.1 * size && found.1 < 1e-2 * size * size, "{first}: {found:?}");
        }
    }

    #[test]
    fn a_minimum_that_is_not_zero_is_not() {
        for offset in [0.0, 0.3, 0.5, 0.8] {
            assert_eq!(passed(0.05, 0.05 * offset, |t| 3e-4 + t.sin().powi(2)), None);
            assert_eq!(passed(0.05, 0.05 * offset, |t| 0.5 + 0.1 * t), None);
        }
    }
}
