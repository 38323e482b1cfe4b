//! A mechanism as linearisation sees it: derivatives of its equations, exact and sparse.
//!
//! The compiler emits one implementation per definition that says `options { emit = (tangent); }`. What is made of them,
//! derivatives of the solution, state matrices and equilibria, is `linearisation` and `equilibrium.rs`.
//!
//! # Derivatives by positions
//! Positions are no vector space. A derivative "by q" is along the increments of [`retract`](crate::layout::retract),
//! ∂f/∂q·δ = d f(q ⊕ ε δ)/dε at ε = 0, so it has one column for each velocity, not for each entry of q: for a length per m, for
//! an orientation per rad about the axis of its rate.

use crate::fields::Fields;
use crate::mechanism::Assemble;
use crate::real::Real;
use crate::state::StateOf;
use crate::vector::{Vector, at, put};
use core::fmt::Debug;

/// The most linear solutions for a response with friction.
const MOST_SOLUTIONS: usize = 200;

/// The derivatives of the equations of motion, evaluated in the scalars `R`.
///
/// Notation as in [`Mechanism`](crate::mechanism::Mechanism): n_v velocities, n_z internal states z, m rows, n_u inputs, n_p
/// parameters, n_y outputs, f degrees of freedom, with the coordinates s of [`states`](Tangent::states). `a` and `lambda` are any accelerations and multipliers;
/// they need not solve anything. Every function writes all stored entries of its result, allocates nothing and never fails.
/// Where a law has a kink (min, max, |x|, a choice) the derivative is that of the branch taken.
#[diagnostic::on_unimplemented(
    message = "the derivatives of `{Self}` are not emitted",
    label = "this needs its tangent",
    note = "add `options {{ emit = (tangent); }}` to the definition of the mechanism"
)]
pub trait Tangent<R: Real>: Assemble<R, Inputs: Fields<R>, Outputs: Fields<R>> {
    /// Indices into [`conditions`](Assemble::conditions): the coordinates s of linearised motions, one for each degree of
    /// freedom. They are those of [`independent`](Assemble::independent) and, where these do not suffice because bodies turn on
    /// balls, components of ω: no three numbers are the coordinates of such an orientation.
    fn states(&self) -> &[u16];
    /// (row, column) of each stored entry of ∂r/∂q, n_v × n_v, row by row; so the patterns below.
    fn stiffness_pattern(&self) -> &[(u16, u16)];
    /// Entries of ∂r/∂v, n_v × n_v.
    fn damping_pattern(&self) -> &[(u16, u16)];
    /// Entries of ∂(D a − γ)/∂q, m × n_v.
    fn row_stiffness_pattern(&self) -> &[(u16, u16)];
    /// Entries of ∂(D a − γ)/∂v, m × n_v.
    fn row_damping_pattern(&self) -> &[(u16, u16)];
    /// Entries of ∂(D v − ν)/∂q, m × n_v.
    fn rate_pattern(&self) -> &[(u16, u16)];
    /// Entries of ∂r/∂u, n_v × n_u.
    fn input_pattern(&self) -> &[(u16, u16)];
    /// Entries of ∂r/∂z, n_v × n_z.
    #[inline]
    fn internal_pattern(&self) -> &[(u16, u16)] {
        &[]
    }
    /// Entries of ∂(−Q_f)/∂(u, λ, z, a), n_v × (n_u + m + n_z + n_v).
    #[inline]
    fn friction_pattern(&self) -> &[(u16, u16)] {
        &[]
    }
    /// Entries of the derivatives by parameters, (n_v + 3m + n_y + 2n_z) × n_p: rows of r, D a − γ, D v − ν, Φ, outputs, ż,
    /// and z at the start.
    fn parameter_pattern(&self) -> &[(u16, u16)];
    /// Entries of the outputs' derivatives, n_y × (3n_v + n_u + m + n_z): columns of q, v, u, λ, z, a.
    fn output_pattern(&self) -> &[(u16, u16)];
    /// Entries of the derivatives of ż, n_z rows with the same columns.
    #[inline]
    fn internal_rate_pattern(&self) -> &[(u16, u16)] {
        &[]
    }
    /// Entries of ∂(ṡ, s̈)/∂(q, v), 2f × 2n_v.
    fn coordinate_pattern(&self) -> &[(u16, u16)];

    /// The stored entries of ∂r/∂q.
    type Stiffness: Vector<R>;
    /// The stored entries of ∂r/∂v.
    type Damping: Vector<R>;
    /// The stored entries of ∂(D a − γ)/∂q.
    type RowStiffness: Vector<R>;
    /// The stored entries of ∂(D a − γ)/∂v.
    type RowDamping: Vector<R>;
    /// The stored entries of ∂(D v − ν)/∂q.
    type RateTangent: Vector<R>;
    /// The stored entries of ∂r/∂u.
    type InputTangent: Vector<R>;
    /// The stored entries of ∂r/∂z; `()` where there are no internal states.
    type InternalTangent: Vector<R>;
    /// The stored entries of ∂(−Q_f)/∂(u, λ, z, a); `()` where nothing rubs by reactions.
    type FrictionTangent: Vector<R>;
    /// The stored entries of the derivatives by parameters.
    type ParameterTangent: Vector<R>;
    /// The stored entries of the outputs' derivatives.
    type OutputTangent: Vector<R>;
    /// The stored entries of the derivatives of ż; `()` where there are no internal states.
    type InternalRateTangent: Vector<R>;
    /// The stored entries of ∂(ṡ, s̈)/∂(q, v).
    type CoordinateTangent: Vector<R>;

    /// `[R; n_x·n_x]`, A of ẋ = A x + B u, row by row, n_x = 2f + n_z.
    type StateMatrix: Vector<R>;
    /// `[R; n_x·n_u]`, B.
    type InputMatrix: Vector<R>;
    /// `[R; n_y·n_x]`, C of y = C x + D u.
    type OutputMatrix: Vector<R>;
    /// `[R; n_y·n_u]`, D.
    type Feedthrough: Vector<R>;
    /// `[R; n_v + m + n_z]`.
    type Unknowns: Vector<R>;
    /// `[R; (n_v + m + n_z)²]`, \[∂r/∂q, Dᵀ; D, 0\] and the rows and columns of z, row by row.
    type Bordered: Vector<R>;
    /// `[u16; n_v + m + n_z]`, an order of those unknowns.
    type Order: Clone + Debug + AsRef<[u16]> + AsMut<[u16]>;
    /// The parameters, p.
    type Parameters: Fields<R>;

    /// One name for each parameter, in the order of [`Fields`].
    fn parameter_names(&self) -> &[&'static str];
    /// An order to be written.
    fn order(&self) -> Self::Order;
    /// r(t, q, v, u, a, λ) = M a + Dᵀ λ − Q, shape n_v, N and N·m: zero along motions.
    #[allow(clippy::too_many_arguments)]
    fn residual(
        &self,
        time: R,
        state: &StateOf<Self, R>,
        u: &Self::Inputs,
        a: &Self::V,
        lambda: &Self::Lambda,
        residual: &mut Self::V,
    );
    /// ∂r/∂q (N/m, N·m/rad, …) and ∂r/∂v at given a and λ.
    #[allow(clippy::too_many_arguments)]
    fn tangent(
        &self,
        time: R,
        state: &StateOf<Self, R>,
        u: &Self::Inputs,
        a: &Self::V,
        lambda: &Self::Lambda,
        stiffness: &mut Self::Stiffness,
        damping: &mut Self::Damping,
    );
    /// ∂(D a − γ)/∂q and ∂(D a − γ)/∂v at given a.
    #[allow(clippy::too_many_arguments)]
    fn row_tangent(
        &self,
        time: R,
        q: &Self::Q,
        v: &Self::V,
        a: &Self::V,
        stiffness: &mut Self::RowStiffness,
        damping: &mut Self::RowDamping,
    );
    /// ∂(D v − ν)/∂q at given v.
    fn rate_tangent(&self, time: R, q: &Self::Q, v: &Self::V, rate: &mut Self::RateTangent);
    /// ∂r/∂u = −∂Q/∂u.
    fn input_tangent(
        &self,
        time: R,
        state: &StateOf<Self, R>,
        u: &Self::Inputs,
        input: &mut Self::InputTangent,
    );
    /// ∂r/∂z = −∂Q/∂z of the internal states.
    #[inline]
    fn internal_tangent(
        &self,
        time: R,
        state: &StateOf<Self, R>,
        u: &Self::Inputs,
        internal: &mut Self::InternalTangent,
    ) {
        let _ = (time, state, u, internal);
    }
    /// ∂(−Q_f)/∂(u, λ, z, a) of friction by reactions, which [`input_tangent`](Tangent::input_tangent) and
    /// [`internal_tangent`](Tangent::internal_tangent) leave out; ∂r/∂q and ∂r/∂v have it.
    #[inline]
    #[allow(clippy::too_many_arguments)]
    fn friction_tangent(
        &self,
        time: R,
        state: &StateOf<Self, R>,
        u: &Self::Inputs,
        a: &Self::V,
        lambda: &Self::Lambda,
        friction: &mut Self::FrictionTangent,
    ) {
        let _ = (time, state, u, a, lambda, friction);
    }
    /// a and λ of M a + Dᵀ λ + ∂(−Q_f)/∂(λ, a) (λ, a) = `forces`, D a = `rows`, with the factor of K(0) in `store`: one solution after the
    /// other, each with the friction of the one before.
    #[doc(hidden)]
    fn solve_rubbing(
        &self,
        store: &Self::Store,
        friction: &Self::FrictionTangent,
        forces: &Self::V,
        rows: &Self::Lambda,
        a: &mut Self::V,
        lambda: &mut Self::Lambda,
    ) {
        self.solve(store, forces, rows, a, lambda);
        if !self.rubs() {
            return;
        }
        let first = self.input_names().len();
        let [internal, own] =
            [self.row_count(), self.row_count() + self.internal_count()].map(|it| first + it);
        for _ in 0..MOST_SOLUTIONS {
            let mut rest = forces.clone();
            for (&entry, &(row, column)) in friction.as_slice().iter().zip(self.friction_pattern()) {
                let (row, column) = (usize::from(row), usize::from(column));
                let by = if (first..internal).contains(&column) {
                    at(lambda.as_slice(), column - first)
                } else if column >= own {
                    at(a.as_slice(), column - own)
                } else {
                    continue;
                };
                let left = at(rest.as_slice(), row) - entry * by;
                put(rest.as_mut_slice(), row, left);
            }
            let before = a.clone();
            self.solve(store, &rest, rows, a, lambda);
            let change = a.plus(-R::ONE, &before).max_abs();
            // Written so that a NaN ends it.
            if !R::any(change.greater(R::from_f64(4.0) * R::EPSILON * a.max_abs())) {
                break;
            }
        }
    }
    /// The derivatives of r, D a − γ, D v − ν, Φ and, at given a and λ, the outputs, ż, and z at the start by the parameters. The phases of gears and racks
    /// that take them from the start are held, and so is the position, though another start would be assembled. A value that depends on
    /// parameters alone is computed when they are set: a parameter at which it has an infinite slope, as √p at 0, is refused there.
    #[allow(clippy::too_many_arguments)]
    fn parameter_tangent(
        &self,
        time: R,
        state: &StateOf<Self, R>,
        u: &Self::Inputs,
        a: &Self::V,
        lambda: &Self::Lambda,
        parameter: &mut Self::ParameterTangent,
    );
    /// The derivatives of the outputs by q, v, u, λ, z and a; by λ and a only of those that name results.
    #[allow(clippy::too_many_arguments)]
    fn output_tangent(
        &self,
        time: R,
        state: &StateOf<Self, R>,
        u: &Self::Inputs,
        a: &Self::V,
        lambda: &Self::Lambda,
        output: &mut Self::OutputTangent,
    );
    /// The derivatives of ż of the internal states by q, v, u, λ, z and a.
    #[inline]
    #[allow(clippy::too_many_arguments)]
    fn internal_rate_tangent(
        &self,
        time: R,
        state: &StateOf<Self, R>,
        u: &Self::Inputs,
        a: &Self::V,
        lambda: &Self::Lambda,
        rates: &mut Self::InternalRateTangent,
    ) {
        let _ = (time, state, u, a, lambda, rates);
    }
    /// ∂(ṡ, s̈)/∂(q, v) of the coordinates s at given a. The block ∂ṡ/∂v = ∂s̈/∂a is B, with ṡ = B v.
    fn coordinate_tangent(
        &self,
        time: R,
        q: &Self::Q,
        v: &Self::V,
        a: &Self::V,
        coordinate: &mut Self::CoordinateTangent,
    );

    /// n_v + m + n_z.
    #[doc(hidden)]
    #[inline]
    fn unknown_count(&self) -> usize {
        self.velocity_count() + self.row_count() + self.internal_count()
    }
    /// Zeros for the entries of [`Stiffness`](Tangent::Stiffness).
    #[inline]
    fn zero_stiffness(&self) -> Self::Stiffness {
        Vector::zeros(self.stiffness_pattern().len())
    }
    /// Zeros for the entries of [`Damping`](Tangent::Damping).
    #[inline]
    fn zero_damping(&self) -> Self::Damping {
        Vector::zeros(self.damping_pattern().len())
    }
    /// Zeros for the entries of [`RowStiffness`](Tangent::RowStiffness).
    #[inline]
    fn zero_row_stiffness(&self) -> Self::RowStiffness {
        Vector::zeros(self.row_stiffness_pattern().len())
    }
    /// Zeros for the entries of [`RowDamping`](Tangent::RowDamping).
    #[inline]
    fn zero_row_damping(&self) -> Self::RowDamping {
        Vector::zeros(self.row_damping_pattern().len())
    }
    /// Zeros for the entries of [`RateTangent`](Tangent::RateTangent).
    #[inline]
    fn zero_rate_tangent(&self) -> Self::RateTangent {
        Vector::zeros(self.rate_pattern().len())
    }
    /// Zeros for the entries of [`InputTangent`](Tangent::InputTangent).
    #[inline]
    fn zero_input_tangent(&self) -> Self::InputTangent {
        Vector::zeros(self.input_pattern().len())
    }
    /// Zeros for the entries of [`InternalTangent`](Tangent::InternalTangent).
    #[inline]
    fn zero_internal_tangent(&self) -> Self::InternalTangent {
        Vector::zeros(self.internal_pattern().len())
    }
    /// Zeros for the entries of [`InternalRateTangent`](Tangent::InternalRateTangent).
    #[inline]
    fn zero_internal_rate_tangent(&self) -> Self::InternalRateTangent {
        Vector::zeros(self.internal_rate_pattern().len())
    }
    /// Zeros for the entries of [`FrictionTangent`](Tangent::FrictionTangent).
    #[inline]
    fn zero_friction_tangent(&self) -> Self::FrictionTangent {
        Vector::zeros(self.friction_pattern().len())
    }
    /// Zeros for the entries of [`ParameterTangent`](Tangent::ParameterTangent).
    #[inline]
    fn zero_parameter_tangent(&self) -> Self::ParameterTangent {
        Vector::zeros(self.parameter_pattern().len())
    }
    /// Zeros for the entries of [`OutputTangent`](Tangent::OutputTangent).
    #[inline]
    fn zero_output_tangent(&self) -> Self::OutputTangent {
        Vector::zeros(self.output_pattern().len())
    }
    /// Zeros for the entries of [`CoordinateTangent`](Tangent::CoordinateTangent).
    #[inline]
    fn zero_coordinate_tangent(&self) -> Self::CoordinateTangent {
        Vector::zeros(self.coordinate_pattern().len())
    }
    #[doc(hidden)]
    #[inline]
    fn zero_unknowns(&self) -> Self::Unknowns {
        Vector::zeros(self.unknown_count())
    }
    #[doc(hidden)]
    #[inline]
    fn zero_bordered(&self) -> Self::Bordered {
        Vector::zeros(self.unknown_count() * self.unknown_count())
    }
}
