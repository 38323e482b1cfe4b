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
/// seldom fall on it, so three values in a row are taken as a parabola, and its vertex is what was passed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Passage<R> {
    /// (time, value), the latest last.
    known: [Option<(R, R)>; 2],
}

impl<R: Real> Passage<R> {
    pub fn new() -> Self {
        Passage { known: [None; 2] }
    }

    /// Whether nothing was taken yet.
    pub fn is_new(&self) -> bool {
        self.known[1].is_none()
    }

    /// Takes the value at a time; gives time and value of the minimum passed since the last but one, if it cannot be told from
    /// a singular position.
    pub fn see(&mut self, time: R, value: R) -> Option<(R, R)> {
        let passed = match self.known {
            [Some(first), Some(second)] => vertex(first, second, (time, value)),
            _ => None,
        };
        self.known = [self.known[1], Some((time, value))];
        passed
    }
}

/// The least value of the parabola through three points, if it lies between them and is nearly zero.
fn vertex<R: Real>((t0, r0): (R, R), (t1, r1): (R, R), (t2, r2): (R, R)) -> Option<(R, R)> {
    // A minimum, and no point of it nearly zero by itself: that is seen without a parabola.
    if !(r1 <= r0 && r1 < r2 && r1 >= R::NEAR_SINGULAR) {
        return None;
    }
    let (slope, next) = ((r1 - r0) / (t1 - t0), (r2 - r1) / (t2 - t1));
    let curvature = (next - slope) / (t2 - t0);
    // r = r1 + b (t − t1) + curvature (t − t1)²
    let b = slope + curvature * (t1 - t0);
    let half = R::from_f64(0.5);
    let time = t1 - half * b / curvature;
    let least = r1 - R::from_f64(0.25) * b * b / curvature;
    let uncertain = R::from_f64(UNCERTAIN) * r0.max(r2);
    (least <= R::NEAR_SINGULAR + uncertain).then(|| (time, least.max(R::ZERO)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn passed(step: f64, offset: f64, value: impl Fn(f64) -> f64) -> Option<(f64, f64)> {
        let mut passage = Passage::new();
        (-4..5).find_map(|k| {
            let time = f64::from(k) * step + offset;
            passage.see(time, value(time))
        })
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

    #[test]
    fn a_minimum_that_is_not_zero_is_not() {
        for offset in [0.0, 0.3, 0.5, 0.8] {
            assert_eq!(passed(0.05, 0.05 * offset, |t| 3e-4 + t.sin().powi(2)), None);
            assert_eq!(passed(0.05, 0.05 * offset, |t| 0.5 + 0.1 * t), None);
        }
    }
}
