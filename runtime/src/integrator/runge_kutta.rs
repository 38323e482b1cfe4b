//! Explicit Runge–Kutta methods on the group of positions: a table of coefficients each, and one way to move by all of them.
//!
//! Every stage starts from the step's own beginning: q_i = q ⊕ u_i, u_i = h Σ a_ij k_j, where k_j is the rate of u that belongs to
//! the stage's velocities, k_j = dexp⁻¹(u_j) v_j ([`inverse_differential`]); the result is q ⊕ h Σ b_j k_j (Munthe-Kaas, *High
//! order Runge–Kutta methods on manifolds*, 1999; Hairer, Lubich, Wanner, *Geometric Numerical Integration*, IV.8). Without the
//! correction rotations in space would be followed to order 2. Rotations of the plane commute, so there k_j = v_j. Counted angles
//! have rates linear in v and take Σ a_ij v_j. Velocities and internal states are vectors and take Σ a_ij v̇_j and Σ a_ij ż_j.
//!
//! Stages are inlined where programs are optimised. In others each step would hold them as often as it has stages, which a build would wait for.

use super::Dynamics;
use crate::layout::{Layout, inverse_differential, retract_counting, retract_once};
use crate::real::Real;
use crate::state::{Derivative, State, StateOf, Variables};
use crate::vector::{Vector, at};
use core::array::from_fn;

/// The coefficients of a method with S stages, of which the first is at the step's beginning.
pub(super) struct Tableau<const S: usize> {
    /// a_ij, one row for each stage; a_i1 = c_i − Σ of the others.
    pub a: [[f64; S]; S],
    /// b_j, the weights of the step itself, with Σ b_j = 1.
    pub b: [f64; S],
    /// c_i, where in the step the stages are.
    pub c: [f64; S],
}

/// A change of the state as a whole, seen from the beginning of a step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Increment<V, Z> {
    /// u of q ⊕ u.
    pub u: V,
    /// ∫v dt, where counted angles need it beside u: both are the same where no quaternion turns.
    pub integral: Option<V>,
    /// The change of v.
    pub v: V,
    /// The change of z.
    pub z: Z,
}

impl<V, Z> Increment<V, Z> {
    /// `c·self + d·other`.
    #[inline]
    pub fn and<R: Real>(&self, c: R, d: R, other: &Self) -> Self
    where
        V: Vector<R>,
        Z: Vector<R>,
    {
        let integral = match (&self.integral, &other.integral) {
            (Some(own), Some(other)) => Some(own.scaled(c).plus(d, other)),
            _ => None,
        };
        let (u, v) = (self.u.scaled(c).plus(d, &other.u), self.v.scaled(c).plus(d, &other.v));
        Increment { u, integral, v, z: self.z.scaled(c).plus(d, &other.z) }
    }

    /// The state that lies this increment from `begin`.
    #[inline]
    pub fn from<R: Real, Q: Vector<R>, G: Clone>(
        &self,
        layout: &Layout<'_>,
        begin: &State<Q, V, Z, G>,
    ) -> State<Q, V, Z, G>
    where
        V: Vector<R>,
        Z: Vector<R>,
    {
        let mut q = Q::zeros(begin.q.as_slice().len());
        retract_counting(layout, &begin.q, &self.u, self.integral(), &mut q);
        self.with(q, begin)
    }

    /// The same for a stage, from which nothing moves on.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn stage<R: Real, Q: Vector<R>, G: Clone>(
        &self,
        layout: &Layout<'_>,
        begin: &State<Q, V, Z, G>,
    ) -> State<Q, V, Z, G>
    where
        V: Vector<R>,
        Z: Vector<R>,
    {
        let mut q = Q::zeros(begin.q.as_slice().len());
        retract_once(layout, &begin.q, &self.u, self.integral(), &mut q);
        self.with(q, begin)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn integral(&self) -> &V {
        self.integral.as_ref().unwrap_or(&self.u)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn with<R: Real, Q: Vector<R>, G: Clone>(&self, q: Q, begin: &State<Q, V, Z, G>) -> State<Q, V, Z, G>
    where
        V: Vector<R>,
        Z: Vector<R>,
    {
        let (v, z) = (begin.v.plus(R::ONE, &self.v), begin.z.plus(R::ONE, &self.z));
        State { q, v, z, gates: begin.gates.clone() }
    }
}

/// The slopes of a step as far as they are known.
pub(super) struct Slopes<V, Z, const S: usize> {
    /// v, v̇ and ż at the stages.
    at: [Derivative<V, Z>; S],
    /// k of the stages after the first, where quaternions turn.
    turned: [Option<V>; S],
}

impl<V, Z, const S: usize> Slopes<V, Z, S> {
    /// Those of a step that begins with this derivative.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn new<R: Real>(first: Derivative<V, Z>) -> Self
    where
        V: Vector<R>,
        Z: Vector<R>,
    {
        let (n, internal) = (first.v.as_slice().len(), first.z.as_slice().len());
        let zero = || Derivative { v: V::zeros(n), a: V::zeros(n), z: Z::zeros(internal) };
        let mut slopes = Slopes { at: from_fn(|_| zero()), turned: [const { None }; S] };
        slopes.at[0] = first;
        slopes
    }

    /// The derivative at the last stage.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn last(&self) -> &Derivative<V, Z> {
        &self.at[S - 1]
    }

    /// k of a stage.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn k(&self, layout: &Layout<'_>, stage: usize) -> &V {
        match &self.turned[stage] {
            Some(turned) if layout.quaternions > 0 => turned,
            _ => &self.at[stage].v,
        }
    }

    /// h (c k₁ + Σ w_j (k_j − k₁)).
    // Inlined where the weights are constants, which leaves the sums alone.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn increment<R: Real>(&self, layout: &Layout<'_>, h: R, c: f64, weights: &[f64; S]) -> Increment<V, Z>
    where
        V: Vector<R>,
        Z: Vector<R>,
    {
        let factors = (h, R::from_f64(c));
        let at = &self.at;
        let counts = layout.quaternions > 0 && !layout.angles.is_empty();
        Increment {
            u: sum(factors, weights, |stage| self.k(layout, stage)),
            integral: counts.then(|| sum(factors, weights, |stage| &at[stage].v)),
            v: sum(factors, weights, |stage| &at[stage].a),
            z: sum(factors, weights, |stage| &at[stage].z),
        }
    }

    /// h k of a stage.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn single<R: Real>(&self, layout: &Layout<'_>, h: R, stage: usize) -> Increment<V, Z>
    where
        V: Vector<R>,
        Z: Vector<R>,
    {
        let mut weights = [0.0; S];
        weights[stage] = 1.0;
        self.increment(layout, h, 1.0, &weights)
    }

    /// Evaluates stage `i` of a step of size `h` from `begin`, counted from zero, the stages before being known; none if it broke
    /// down. Gives the increment to it.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn stage<R: Real, X: Variables<R, V = V, Z = Z>, D: Dynamics<R, Variables = X>>(
        &mut self,
        tableau: &Tableau<S>,
        i: usize,
        dynamics: &mut D,
        over: (R, R),
        begin: &StateOf<X, R>,
    ) -> Option<Increment<V, Z>>
    where
        V: Vector<R>,
        Z: Vector<R>,
    {
        let layout = dynamics.variables().layout();
        let increment = self.increment(layout, over.1, tableau.c[i], &tableau.a[i]);
        let state = increment.stage(layout, begin);
        self.evaluate(tableau.c[i], i, dynamics, over, &increment, state)?;
        Some(increment)
    }

    /// As [`stage`](Slopes::stage) of a state from which the motion goes on, which is shown before the equations correct it.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn stage_seen<R: Real, X: Variables<R, V = V, Z = Z>, D: Dynamics<R, Variables = X>>(
        &mut self,
        tableau: &Tableau<S>,
        i: usize,
        dynamics: &mut D,
        over: (R, R),
        begin: &StateOf<X, R>,
        see: impl FnOnce(&StateOf<X, R>),
    ) -> Option<Increment<V, Z>>
    where
        V: Vector<R>,
        Z: Vector<R>,
    {
        let layout = dynamics.variables().layout();
        let increment = self.increment(layout, over.1, tableau.c[i], &tableau.a[i]);
        let state = increment.from(layout, begin);
        see(&state);
        self.evaluate(tableau.c[i], i, dynamics, over, &increment, state)?;
        Some(increment)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn evaluate<R: Real, X: Variables<R, V = V, Z = Z>, D: Dynamics<R, Variables = X>>(
        &mut self,
        c: f64,
        i: usize,
        dynamics: &mut D,
        (time, h): (R, R),
        increment: &Increment<V, Z>,
        mut state: StateOf<X, R>,
    ) -> Option<()>
    where
        V: Vector<R>,
        Z: Vector<R>,
    {
        let derivative = dynamics.derivative(time + R::from_f64(c) * h, &mut state);
        if dynamics.broke_down() {
            return None;
        }
        let layout = dynamics.variables().layout();
        if layout.quaternions > 0 {
            self.turned[i] = Some(inverse_differential(layout, &increment.u, &derivative.v));
        }
        self.at[i] = derivative;
        Some(())
    }
}

/// h (c k₁ + Σ w_j (k_j − k₁)): written about k₁, so that equal slopes give a uniform motion to the bit; h c k_j where that slope has
/// all the weight.
#[cfg_attr(not(debug_assertions), inline(always))]
fn sum<'s, R: Real, T: Vector<R>, const S: usize>(
    (h, c): (R, R),
    weights: &[f64; S],
    k: impl Fn(usize) -> &'s T,
) -> T {
    if let Some(only) = the_only(c, weights) {
        return k(only).scaled(c * h);
    }
    let mut sum = k(0).clone();
    for (entry, value) in sum.as_mut_slice().iter_mut().enumerate() {
        let first = *value;
        *value = c * first;
        // Counted, because a loop over an iterator is not unrolled, and then the weights are looked up.
        #[allow(clippy::needless_range_loop)]
        for stage in 1..S {
            if weights[stage] != 0.0 {
                let off = at(k(stage).as_slice(), entry) - first;
                *value = R::from_f64(weights[stage]).mul_add(off, *value);
            }
        }
        *value = *value * h;
    }
    sum
}

/// The slope that has all the weight, if one has.
#[cfg_attr(not(debug_assertions), inline(always))]
fn the_only<R: Real, const S: usize>(c: R, weights: &[f64; S]) -> Option<usize> {
    let mut found = None;
    for (stage, &weight) in weights.iter().enumerate() {
        match (weight != 0.0, found) {
            (true, Some(_)) => return None,
            (true, None) => found = Some((stage, weight)),
            (false, _) => {}
        }
    }
    found.filter(|(_, weight)| R::from_f64(*weight) == c).map(|(stage, _)| stage)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::integrator::dormand_prince::DORMAND_PRINCE;
    use crate::integrator::rk4::CLASSICAL;

    fn rows_sum_to_their_nodes<const S: usize>(tableau: &Tableau<S>) {
        for (row, c) in tableau.a.iter().zip(tableau.c).chain([(&tableau.b, 1.0)]) {
            assert!((row.iter().sum::<f64>() - c).abs() < 1e-14, "{c}");
        }
        for (i, row) in tableau.a.iter().enumerate() {
            assert!(row[i..].iter().all(|&a| a == 0.0), "stage {i} depends on later ones");
        }
    }

    #[test]
    fn tables_are_explicit_and_consistent() {
        rows_sum_to_their_nodes(&CLASSICAL);
        rows_sum_to_their_nodes(&DORMAND_PRINCE);
    }
}
