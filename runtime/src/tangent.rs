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
use crate::vector::Vector;
use core::fmt::Debug;

/// The derivatives of the equations of motion, evaluated in the scalars `R`.
///
/// Notation as in [`Mechanism`](crate::mechanism::Mechanism): n_v velocities, m rows, n_u inputs, n_p parameters, n_y outputs,
/// f degrees of freedom, with the coordinates of [`states`](Tangent::states). `a` and `lambda` are any accelerations and multipliers;
/// they need not solve anything. Every function writes all stored entries of its result, allocates nothing and never fails.
/// There are no derivatives by internal states: what has such states has no tangent.
/// Where a law has a kink (min, max, |x|, a choice) the derivative is that of the branch taken.
#[diagnostic::on_unimplemented(
    message = "the derivatives of `{Self}` are not emitted",
    label = "this needs its tangent",
    note = "add `options {{ emit = (tangent); }}` to the definition of the mechanism"
)]
pub trait Tangent<R: Real>: Assemble<R, Z = (), Inputs: Fields<R>, Outputs: Fields<R>> {
    /// Indices into [`conditions`](Assemble::conditions): the coordinates z of linearised motions, one for each degree of
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
    /// Entries of the derivatives by parameters, (n_v + 3m + n_y) × n_p: rows of r, D a − γ, D v − ν, Φ, outputs.
    fn parameter_pattern(&self) -> &[(u16, u16)];
    /// Entries of the outputs' derivatives, n_y × (2n_v + n_u + m): columns of q, v, u, λ.
    fn output_pattern(&self) -> &[(u16, u16)];
    /// Entries of ∂(ż, z̈)/∂(q, v), 2f × 2n_v.
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
    /// The stored entries of the derivatives by parameters.
    type ParameterTangent: Vector<R>;
    /// The stored entries of the outputs' derivatives.
    type OutputTangent: Vector<R>;
    /// The stored entries of ∂(ż, z̈)/∂(q, v).
    type CoordinateTangent: Vector<R>;

    /// `[R; 2f·2f]`, A of ẋ = A x + B u, row by row.
    type StateMatrix: Vector<R>;
    /// `[R; 2f·n_u]`, B.
    type InputMatrix: Vector<R>;
    /// `[R; n_y·2f]`, C of y = C x + D u.
    type OutputMatrix: Vector<R>;
    /// `[R; n_y·n_u]`, D.
    type Feedthrough: Vector<R>;
    /// `[R; n_v + m]`.
    type Unknowns: Vector<R>;
    /// `[R; (n_v + m)²]`, \[∂r/∂q, Dᵀ; D, 0\], row by row.
    type Bordered: Vector<R>;
    /// `[u16; n_v + m]`, an order of those unknowns.
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
    /// The derivatives of r, D a − γ, D v − ν, Φ and, at given λ, the outputs by the parameters. The phases of gears and racks
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
    /// The derivatives of the outputs by q, v, u and λ; by the last only of those that name drivers' efforts or powers.
    fn output_tangent(
        &self,
        time: R,
        state: &StateOf<Self, R>,
        u: &Self::Inputs,
        lambda: &Self::Lambda,
        output: &mut Self::OutputTangent,
    );
    /// ∂(ż, z̈)/∂(q, v) of the coordinates z at given a. The block ∂ż/∂v = ∂z̈/∂a is B, with ż = B v.
    fn coordinate_tangent(
        &self,
        time: R,
        q: &Self::Q,
        v: &Self::V,
        a: &Self::V,
        coordinate: &mut Self::CoordinateTangent,
    );

    /// n_v + m.
    #[doc(hidden)]
    #[inline]
    fn unknown_count(&self) -> usize {
        self.velocity_count() + self.row_count()
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
