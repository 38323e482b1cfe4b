//! The choice of the step: the norm of the error, the controller, the first step.

use crate::clock::least_step;
use crate::layout::Layout;
use crate::real::Real;
use crate::state::State;
use crate::vector::Vector;

/// Safety factor on every new size.
const SAFETY: f64 = 0.9;
/// The exponent of the error before in the controller: β.
const BETA: f64 = 0.04;
/// The exponent of the present error, 1/5 − 3β/4: 1/5 of an estimate of order 5.
const ALPHA: f64 = 0.2 - 0.75 * BETA;
/// The least and the largest factor of a new size.
const FACTORS: [f64; 2] = [0.2, 10.0];
/// The error before is taken to be at least this.
pub(super) const LEAST_ERROR: f64 = 1e-4;
/// The factor of the size after a stage that broke down.
pub(super) const AFTER_BREAKDOWN: f64 = 0.25;

/// The largest step where none is given, s: longer than a run, and finite.
pub(super) const LARGEST_STEP: f64 = 1e6;
/// The most trials of one step. The first size that is tried is the one proposed; a jump in the forces takes some thirty trials.
pub(super) const MOST_TRIALS: u32 = 100;
/// The most steps of a run, if not said otherwise.
pub(super) const MOST_STEPS: u64 = 1_000_000;
/// Times below this, s, are taken to be this by the least step.
const LEAST_TIME: f64 = 1e-6;
/// The largest of the least steps, s, as long as the clock does not ask for more.
const LARGEST_LEAST: f64 = 1e-6;

/// The least step at a time, if not said otherwise, s: four roundings of the time, which is taken to be at least 1 µs; at most 1 µs.
pub(super) fn least_size<R: Real>(time: R) -> R {
    let roundings = R::from_f64(4.0) * R::EPSILON * time.abs().max(R::from_f64(LEAST_TIME));
    // In this order a NaN is left behind.
    least_step(time).max(roundings.min(R::from_f64(LARGEST_LEAST)))
}

/// xᵖ for x ≥ 0.
fn power<R: Real>(x: R, p: f64) -> R {
    (x.ln() * R::from_f64(p)).exp()
}

/// The factor of the size after an accepted step: 0.9 err⁻ᵅ err₋₁ᵝ, between its bounds and after a rejection at most 1.
///
/// The PI controller of Gustafsson, *Control theoretic techniques for stepsize selection in explicit Runge–Kutta methods*,
/// ACM Trans. Math. Softw. 17 (1991), with the coefficients of Hairer, Nørsett, Wanner's DOPRI5 (II.4; IV.2 of the second
/// volume).
pub(super) fn after_acceptance<R: Real>(error: R, before: R, rejected: bool) -> R {
    let [least, largest] = FACTORS.map(R::from_f64);
    let factor = R::from_f64(SAFETY) * power(before, BETA) / power(error, ALPHA);
    // err = 0 gives an infinite factor.
    let most = if rejected { R::ONE } else { largest };
    factor.max(least).min(most)
}

/// The factor of the size after a rejection for the error: 0.9 err⁻ᵅ, at least 1/5.
pub(super) fn after_rejection<R: Real>(error: R) -> R {
    (R::from_f64(SAFETY) / power(error, ALPHA)).max(R::from_f64(FACTORS[0])).min(R::from_f64(SAFETY))
}

/// The sizes that errors are divided by: sc = absolute + relative · size, for increments, velocities and internal states;
/// what is absolute is taken in units of the scale of an internal state.
pub(super) struct Scale<V, Z> {
    positions: V,
    velocities: V,
    internal: Z,
}

impl<V, Z> Scale<V, Z> {
    /// With the sizes of the larger of two states.
    pub fn new<R: Real, Q: Vector<R>, G>(
        tolerances: (R, R),
        layout: &Layout<'_>,
        internal_scales: &[f64],
        a: &State<Q, V, Z, G>,
        b: &State<Q, V, Z, G>,
    ) -> Self
    where
        V: Vector<R>,
        Z: Vector<R>,
    {
        Scale {
            positions: scaled(tolerances, &[], &sizes(layout, &a.q), &sizes(layout, &b.q)),
            velocities: scaled(tolerances, &[], &a.v, &b.v),
            internal: scaled(tolerances, internal_scales, &a.z, &b.z),
        }
    }

    /// √(Σ (xᵢ/scᵢ)²/(2n_v + n_z)) of an increment and the changes of velocities and internal states.
    pub fn norm<R: Real>(&self, du: &V, dv: &V, dz: &Z) -> R
    where
        V: Vector<R>,
        Z: Vector<R>,
    {
        let squares = sum(du, &self.positions) + sum(dv, &self.velocities) + sum(dz, &self.internal);
        let count = (2 * dv.as_slice().len() + dz.as_slice().len()).max(1) as f64;
        (squares / R::from_f64(count)).sqrt()
    }
}

/// sc of the larger of two values of each entry.
fn scaled<R: Real, T: Vector<R>>((absolute, relative): (R, R), units: &[f64], x: &T, y: &T) -> T {
    let mut scale = x.clone();
    let units = units.iter().map(|&unit| R::from_f64(unit)).chain(core::iter::repeat(R::ONE));
    for ((scale, y), unit) in scale.as_mut_slice().iter_mut().zip(y.as_slice()).zip(units) {
        *scale = relative.mul_add(scale.abs().max(y.abs()), absolute * unit);
    }
    scale
}

/// Σ (xᵢ/scᵢ)².
fn sum<R: Real, T: Vector<R>>(values: &T, scale: &T) -> R {
    values.as_slice().iter().zip(scale.as_slice()).fold(R::ZERO, |sum, (&value, &scale)| {
        let part = value / scale;
        part.mul_add(part, sum)
    })
}

/// The size of each coordinate that an increment moves: of a linear one its value, of an orientation 1.
pub(super) fn sizes<R: Real, Q: Vector<R>, V: Vector<R>>(layout: &Layout<'_>, q: &Q) -> V {
    let mut sizes = V::zeros(layout.velocities());
    for (i, size) in sizes.as_mut_slice().iter_mut().enumerate() {
        *size = if i < layout.linear { q.as_slice()[i] } else { R::ONE };
    }
    sizes
}

/// The size at which an explicit Euler step is tried, from the norms of y and ẏ.
pub(super) fn euler_size<R: Real>(d0: R, d1: R) -> R {
    let small = R::from_f64(1e-5);
    if d0 < small || d1 < small { R::from_f64(1e-6) } else { R::from_f64(0.01) * d0 / d1 }
}

/// The size of the first step, from that of the Euler step, ‖ẏ‖ and ‖Δẏ‖/h₀ over it: h⁵ max(d₁, d₂) = 0.01.
pub(super) fn first_size<R: Real>(h0: R, d1: R, d2: R) -> R {
    let largest = d1.max(d2);
    let h1 = if largest <= R::from_f64(1e-15) {
        R::from_f64(1e-6).max(R::from_f64(1e-3) * h0)
    } else {
        power(R::from_f64(0.01) / largest, 0.2)
    };
    h1.min(R::from_f64(100.0) * h0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn factors_stay_between_their_bounds() {
        assert_eq!(after_acceptance(0.0, 1e-4, false), 10.0);
        assert_eq!(after_acceptance(1e-9, 1e-4, true), 1.0);
        assert!((after_acceptance(1.0, 1.0, false) - 0.9).abs() < 1e-15);
        // A growing error shortens the step more than a steady one.
        assert!(after_acceptance(0.5, 0.1, false) < after_acceptance(0.5, 0.5, false));
        assert_eq!(after_rejection(1e30), 0.2);
        assert!(after_rejection(1.0 + 1e-12) <= 0.9 && after_rejection(f64::MAX) >= 0.2);
    }

    #[test]
    fn the_least_step_is_four_roundings() {
        assert_eq!(least_size(1.0), 4.0 * f64::EPSILON);
        assert_eq!(least_size(-100.0), 400.0 * f64::EPSILON);
        assert!(least_size(0.0) > 0.0 && least_size(0.0) < 1e-20 && least_size(f64::NAN) == least_size(0.0));
        // After a day in single precision times are 8 ms apart.
        assert_eq!((least_size(1e12), least_size(86_400.0_f32)), (1e-6, 1e-6));
        assert!(least_size(1e9_f32) > 5e-5);
    }

    #[test]
    fn orientations_are_measured_by_one() {
        let layout = Layout { linear: 1, rotations: 1, quaternions: 0, angles: &[] };
        let a = State::new([-3.0, 1.0, 0.0], [0.0, 2.0]);
        let b = State::new([1.0, 0.0, 1.0], [4.0, 1.0]);
        let scale = Scale::new((0.5, 0.1), &layout, &[], &a, &b);
        assert!((scale.positions[0] - 0.8).abs() < 1e-15 && (scale.positions[1] - 0.6).abs() < 1e-15);
        assert!((scale.velocities[0] - 0.9).abs() < 1e-15 && (scale.velocities[1] - 0.7).abs() < 1e-15);
        let norm = scale.norm(&[1.6, 0.0], &[0.0, 0.0], &());
        assert!((norm - 1.0).abs() < 1e-15, "{norm}");
    }

    #[test]
    fn internal_states_have_scales_of_their_own() {
        let layout = Layout { linear: 0, rotations: 0, quaternions: 0, angles: &[] };
        let rest = State { q: [0.0; 0], v: [0.0; 0], z: [0.0, 0.0], gates: () };
        // The second has none, and so 1 of its unit.
        let scale = Scale::new((1e-3, 0.0), &layout, &[1e-6], &rest, &rest);
        let norm: f64 = scale.norm(&[], &[], &[1e-9, 1e-3]);
        assert!((norm - 1.0).abs() < 1e-12, "{norm}");
    }
}
