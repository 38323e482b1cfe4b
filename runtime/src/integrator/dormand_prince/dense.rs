//! The continuous extension of a step, in the algebra.

use super::tableau::DENSE;
use crate::integrator::runge_kutta::{Increment, Slopes};
use crate::layout::Layout;
use crate::real::Real;
use crate::state::State;
use crate::vector::Vector;

/// The last step: the state it began with, and the increment from there along it, a polynomial in θ ∈ \[0, 1\]:
/// θ (y + θ' (r₃ + θ (r₄ + θ' r₅))), θ' = 1 − θ.
///
/// With the slopes k₁ and k₇ at the ends, r₃ = h k₁ − y, r₄ = y − h k₇ − r₃, r₅ = h Σ d_i k_i (Hairer, Nørsett, Wanner,
/// *Solving Ordinary Differential Equations I*, II.6): values and slopes at both ends are those of the step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Segment<R, S, V, Z> {
    size: R,
    begin: S,
    y: Increment<V, Z>,
    r3: Increment<V, Z>,
    r4: Increment<V, Z>,
    r5: Increment<V, Z>,
}

impl<R: Real, S, V: Vector<R>, Z: Vector<R>> Segment<R, S, V, Z> {
    /// From the increment over the step and its slopes.
    pub fn new(layout: &Layout<'_>, h: R, begin: S, y: Increment<V, Z>, slopes: &Slopes<V, Z, 7>) -> Self {
        let r3 = slopes.single(layout, h, 0).and(R::ONE, -R::ONE, &y);
        let r4 = y.and(R::ONE, -R::ONE, &slopes.single(layout, h, 6)).and(R::ONE, -R::ONE, &r3);
        let r5 = slopes.increment(layout, h, 0.0, &DENSE);
        Segment { size: h, begin, y, r3, r4, r5 }
    }

    pub fn size(&self) -> R {
        self.size
    }
}

impl<R: Real, Q: Vector<R>, V: Vector<R>, Z: Vector<R>, G: Clone> Segment<R, State<Q, V, Z, G>, V, Z> {
    /// The state at θ = `elapsed`/h.
    pub fn at(&self, layout: &Layout<'_>, elapsed: R) -> State<Q, V, Z, G> {
        let part = elapsed / self.size;
        let rest = R::ONE - part;
        let inner = self.r4.and(R::ONE, rest, &self.r5);
        let inner = self.r3.and(R::ONE, part, &inner);
        self.y.and(part, part * rest, &inner).from(layout, &self.begin)
    }
}
