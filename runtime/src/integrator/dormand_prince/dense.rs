//! The continuous extension of a step, in the algebra.

use super::increment;
use super::tableau::DENSE;
use crate::layout::{Layout, retract_counting};
use crate::real::Real;
use crate::state::State;
use crate::vector::Vector;

/// A polynomial in θ ∈ [0, 1] for an increment: θ (y + θ' (r₃ + θ (r₄ + θ' r₅))), θ' = 1 − θ.
///
/// With the slopes k₁ and k₇ at the ends, r₃ = h k₁ − y, r₄ = y − h k₇ − r₃, r₅ = h Σ d_i k_i (Hairer, Nørsett, Wanner,
/// *Solving Ordinary Differential Equations I*, II.6): values and slopes at both ends are those of the step.
#[derive(Clone, Copy, Debug)]
struct Polynomial<V> {
    y: V,
    r3: V,
    r4: V,
    r5: V,
}

impl<V> Polynomial<V> {
    /// From the increment over the step, k₁, and k_i − k₁ of the later stages.
    fn new<R: Real>(h: R, y: V, first: &V, others: &[V; 6]) -> Self
    where
        V: Vector<R>,
    {
        let r3 = first.scaled(h).plus(-R::ONE, &y);
        // h k₇ = h (k₇ − k₁) + h k₁
        let r4 = r3.scaled(R::from_f64(-2.0)).plus(-h, &others[5]);
        Polynomial { y, r3, r4, r5: increment(h, R::ZERO, first, others, &DENSE[1..]) }
    }

    fn at<R: Real>(&self, part: R) -> V
    where
        V: Vector<R>,
    {
        let rest = R::ONE - part;
        let inner = self.r4.plus(rest, &self.r5);
        let inner = self.r3.plus(part, &inner);
        self.y.plus(rest, &inner).scaled(part)
    }
}

/// The slopes of a step: k₁, and k_i − k₁ of the stages 2 to 7.
pub(super) struct Slopes<V> {
    pub first: V,
    pub others: [V; 6],
}

/// The last step: the state it began with, and u, ∫v dt and v − v₀ along it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Segment<R, Q, V> {
    size: R,
    begin: State<Q, V>,
    positions: Polynomial<V>,
    integral: Polynomial<V>,
    velocities: Polynomial<V>,
}

impl<R: Real, Q: Vector<R>, V: Vector<R>> Segment<R, Q, V> {
    /// From the increments over the step and the slopes of u, ∫v dt and v.
    pub fn new(size: R, begin: &State<Q, V>, [u, integral, dv]: [V; 3], [k, v, a]: [&Slopes<V>; 3]) -> Self {
        let polynomial = |y: V, slopes: &Slopes<V>| Polynomial::new(size, y, &slopes.first, &slopes.others);
        Segment {
            size,
            begin: *begin,
            positions: polynomial(u, k),
            integral: polynomial(integral, v),
            velocities: polynomial(dv, a),
        }
    }

    pub fn size(&self) -> R {
        self.size
    }

    /// q₀ ⊕ u(θ) and v(θ), θ = `elapsed`/h.
    pub fn at(&self, layout: &Layout, elapsed: R) -> State<Q, V> {
        let part = elapsed / self.size;
        let mut q = Q::zero();
        let (u, integral) = (self.positions.at(part), self.integral.at(part));
        retract_counting(layout, &self.begin.q, &u, &integral, &mut q);
        State { q, v: self.begin.v.plus(R::ONE, &self.velocities.at(part)) }
    }
}
