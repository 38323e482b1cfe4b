//! Small motions carried through the stages of a step: the chain rule of each explicit method, on the group of positions.
//!
//! A small motion of positions is an increment δ in the turned axes, as everywhere: (q ⊕ δ). Of q′ = q ⊕ u with both moving
//!
//! ```text
//! linear, pair    δ′ = δ + δu
//! quaternion      δ′ = e^{−û} δ + dexp₋ᵤ δu = δ + dexp₋ᵤ (δu − u × δ),   dexp₋ᵤ = Σ (−û)ᵏ/(k+1)!
//! ```
//! and of k = v + ½ u × v + ¹⁄₁₂ u × (u × v), which is what the stages of [`Rk4`] compute, δk is the derivative of these three terms.

use crate::integrator::{ExplicitTrapezoidal, FixedStep, Rk4, SemiImplicitEuler};
use crate::layout::{Layout, cross, inverse_differential};
use crate::linearisation::Linearisation;
use crate::real::Real;
use crate::state::{Derivative, DerivativeOf, StateOf};
use crate::tangent::Tangent;
use crate::vector::Vector;

/// A small motion of a state.
#[doc(hidden)]
#[derive(Clone, Debug)]
pub struct Motion<V, Z> {
    /// δ of q ⊕ δ.
    pub(super) q: V,
    /// δv.
    pub(super) v: V,
    /// δz.
    pub(super) z: Z,
}

type MotionOf<R, M> = Motion<<M as crate::Variables<R>>::V, <M as crate::Variables<R>>::Z>;

/// The derivatives at the stages of one step, in their order.
#[doc(hidden)]
pub struct Tape<'m, R: Real, M: Tangent<R>> {
    h: R,
    stages: [Option<Linearisation<'m, R, M>>; 4],
}

impl<'m, R: Real, M: Tangent<R>> Tape<'m, R, M> {
    pub(super) fn new(h: R) -> Self {
        Tape { h, stages: [const { None }; 4] }
    }

    pub(super) fn record(&mut self, here: Linearisation<'m, R, M>) {
        if let Some(place) = self.stages.iter_mut().find(|place| place.is_none()) {
            *place = Some(here);
        }
    }

    /// v̇ at the beginning.
    pub(super) fn acceleration(&self) -> Option<&M::V> {
        self.stage(0).map(Linearisation::acceleration)
    }

    fn stage(&self, index: usize) -> Option<&Linearisation<'m, R, M>> {
        self.stages.get(index).and_then(Option::as_ref)
    }

    /// δv, δv̇ and δż of a stage, where its state moves and an input changes by one.
    fn slope(&self, index: usize, motion: &MotionOf<R, M>, input: Option<usize>) -> DerivativeOf<M, R> {
        let Motion { q, v, z } = motion;
        let Some(here) = self.stage(index) else {
            return Derivative { v: v.clone(), a: v.clone(), z: z.clone() };
        };
        let response = here.along_state(q, v, z);
        let mut rates = here.internal_rates(q, v, z, &response);
        let mut a = response.acceleration;
        if let Some(input) = input {
            let by = here.by_input(input);
            rates.axpy(R::ONE, &here.internal_rates_by_input(input, &by));
            a.axpy(R::ONE, &by.acceleration);
        }
        Derivative { v: v.clone(), a, z: rates }
    }

    /// The state of a stage, that of the first where there is none.
    fn state(&self, index: usize) -> Option<&StateOf<M, R>> {
        self.stage(index).map(Linearisation::state)
    }

    fn layout(&self) -> Option<&Layout<'_>> {
        self.stage(0).map(|here| here.model().layout())
    }
}

/// A method of fixed steps whose step is differentiated by [`step_map`](super::step_map).
#[diagnostic::on_unimplemented(
    message = "steps of `{Self}` are not differentiated",
    label = "take `SemiImplicitEuler`, `ExplicitTrapezoidal` or `Rk4`"
)]
pub trait StepTangent<R: Real>: FixedStep<R> {
    /// What becomes of a small motion of the beginning, and of an input that changes by one, at the end of the step.
    #[doc(hidden)]
    fn follow<M: Tangent<R>>(
        &self,
        tape: &Tape<'_, R, M>,
        begin: &Motion<M::V, M::Z>,
        input: Option<usize>,
    ) -> Motion<M::V, M::Z>;
}

impl<R: Real> StepTangent<R> for SemiImplicitEuler {
    /// u = h v₁ with v₁ = v₀ + h a.
    fn follow<M: Tangent<R>>(
        &self,
        tape: &Tape<'_, R, M>,
        begin: &Motion<M::V, M::Z>,
        input: Option<usize>,
    ) -> Motion<M::V, M::Z> {
        let (Some(layout), Some(first)) = (tape.layout(), tape.stage(0)) else { return begin.clone() };
        let (h, slope) = (tape.h, tape.slope(0, begin, input));
        let (v, dv) = (first.state().v.plus(h, first.acceleration()), begin.v.plus(h, &slope.a));
        let q = turned(layout, &begin.q, &v.scaled(h), &dv.scaled(h));
        Motion { q, v: dv, z: begin.z.plus(h, &slope.z) }
    }
}

impl<R: Real> StepTangent<R> for ExplicitTrapezoidal {
    /// Twice u = h/2 (v₀ + v), with v = v₀ + h a₀ and with v = v₀ + h/2 (a₀ + a*).
    fn follow<M: Tangent<R>>(
        &self,
        tape: &Tape<'_, R, M>,
        begin: &Motion<M::V, M::Z>,
        input: Option<usize>,
    ) -> Motion<M::V, M::Z> {
        let (Some(layout), Some(first), Some(last)) = (tape.layout(), tape.stage(0), tape.stage(1)) else {
            return begin.clone();
        };
        let (h, half) = (tape.h, tape.h * R::from_f64(0.5));
        let v = &first.state().v;
        let after = |a: &M::V, dv: M::V, dz: M::Z| {
            let u = v.plus(R::ONE, a).plus(R::ONE, v).scaled(half);
            let du = dv.plus(R::ONE, &begin.v).scaled(half);
            Motion { q: turned(layout, &begin.q, &u, &du), v: dv, z: dz }
        };
        let (a0, a1) = (first.acceleration(), last.acceleration());
        let slope = tape.slope(0, begin, input);
        let predicted = after(&a0.scaled(h), begin.v.plus(h, &slope.a), begin.z.plus(h, &slope.z));
        let end = tape.slope(1, &predicted, input);
        let (a, z) = (slope.a.plus(R::ONE, &end.a), slope.z.plus(R::ONE, &end.z));
        after(&a0.plus(R::ONE, a1).scaled(half), begin.v.plus(half, &a), begin.z.plus(half, &z))
    }
}

impl<R: Real> StepTangent<R> for Rk4 {
    /// u_i = c h k_{i−1}, then u = h/6 (k₁ + 2 k₂ + 2 k₃ + k₄).
    fn follow<M: Tangent<R>>(
        &self,
        tape: &Tape<'_, R, M>,
        begin: &Motion<M::V, M::Z>,
        input: Option<usize>,
    ) -> Motion<M::V, M::Z> {
        let (Some(layout), Some(first)) = (tape.layout(), tape.state(0)) else { return begin.clone() };
        let (h, sixth) = (tape.h, R::from_f64(1.0 / 6.0));
        let mut slope = tape.slope(0, begin, input);
        let (mut k, mut dk) = (first.v.clone(), begin.v.clone());
        let (mut sum, mut all) =
            (k.scaled(sixth), Derivative { v: dk.clone(), ..slope.clone() }.scaled(sixth));
        for (index, (c, weight)) in [(0.5, 2.0), (0.5, 2.0), (1.0, 1.0)].into_iter().enumerate() {
            let (step, weight) = (h * R::from_f64(c), sixth * R::from_f64(weight));
            let (u, du) = (k.scaled(step), dk.scaled(step));
            let q = turned(layout, &begin.q, &u, &du);
            let motion = Motion { q, v: begin.v.plus(step, &slope.a), z: begin.z.plus(step, &slope.z) };
            slope = tape.slope(index + 1, &motion, input);
            let v = tape.state(index + 1).map_or(&first.v, |state| &state.v);
            k = inverse_differential(layout, &u, v);
            dk = inverse_differential_turned(layout, (&u, &du), (v, &motion.v));
            sum.axpy(weight, &k);
            all = all.plus(weight, &Derivative { v: dk.clone(), ..slope.clone() });
        }
        let q = turned(layout, &begin.q, &sum.scaled(h), &all.v.scaled(h));
        Motion { q, v: begin.v.plus(h, &all.a), z: begin.z.plus(h, &all.z) }
    }
}

/// δ′ of q ⊕ u.
fn turned<R: Real, V: Vector<R>>(layout: &Layout<'_>, delta: &V, u: &V, du: &V) -> V {
    let mut sum = delta.plus(R::ONE, du);
    for_each_quaternion(layout, &mut sum, [delta, u, du], |[delta, u, du]| {
        let once = cross(u, delta);
        let x = [0, 1, 2].map(|i| du[i] - once[i]);
        let moved = differential(u, x);
        [0, 1, 2].map(|i| delta[i] + moved[i])
    });
    sum
}

/// δk of k = dexp⁻¹(u) v as [`inverse_differential`] computes it.
fn inverse_differential_turned<R: Real, V: Vector<R>>(
    layout: &Layout<'_>,
    (u, du): (&V, &V),
    (v, dv): (&V, &V),
) -> V {
    let mut rate = dv.clone();
    let (half, twelfth) = (R::from_f64(0.5), R::from_f64(1.0 / 12.0));
    for_each_quaternion(layout, &mut rate, [u, du, v, dv], |[u, du, v, dv]| {
        let (moved, turned) = (cross(du, v), cross(u, dv));
        let first = [0, 1, 2].map(|i| moved[i] + turned[i]);
        let (second, third) = (cross(du, cross(u, v)), cross(u, first));
        [0, 1, 2].map(|i| dv[i] + half * first[i] + twelfth * (second[i] + third[i]))
    });
    rate
}

/// dexp₋ᵤ x, by Horner's scheme; twenty-four terms are exact to rounding for turns up to 2 rad.
fn differential<R: Real>(u: [R; 3], x: [R; 3]) -> [R; 3] {
    let mut value = x;
    for divisor in (2..=24_u8).rev() {
        let (turned, scale) = (cross(u, value), R::ONE / R::from_f64(divisor.into()));
        value = [0, 1, 2].map(|i| x[i] - scale * turned[i]);
    }
    value
}

/// Writes each quaternion's three entries from those of the others.
fn for_each_quaternion<R: Real, V: Vector<R>, const K: usize>(
    layout: &Layout<'_>,
    to: &mut V,
    from: [&V; K],
    of: impl Fn([[R; 3]; K]) -> [R; 3],
) {
    let first = layout.linear + layout.rotations;
    let triples = to.as_mut_slice().get_mut(first..).unwrap_or_default().as_chunks_mut::<3>().0;
    for (index, to) in triples.iter_mut().enumerate() {
        *to = of(from.map(|all| {
            let own = all.as_slice().get(first..).unwrap_or_default().as_chunks::<3>().0;
            own.get(index).copied().unwrap_or([R::ZERO; 3])
        }));
    }
}
