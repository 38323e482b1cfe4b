//! Formulations that differ in the terms that bring the motion back to the constraints, and in nothing else.

use super::{Baumgarte, LagrangeIndex1};
use crate::real::Real;

/// A formulation whose accelerations are those of K (v̇, λ) = (Q, γ − 2α (D v − ν) − β² Φ) and that leaves states alone: what [`step_map`](crate::step_map)
/// differentiates and [`WithMultipliers`](super::WithMultipliers) solves.
#[diagnostic::on_unimplemented(
    message = "steps under `{Self}` are not differentiated",
    label = "take `Baumgarte` or `LagrangeIndex1`",
    note = "an integrator alone, such as `Rk4`, has Baumgarte's terms"
)]
pub trait Stabilisation<R: Real> {
    /// α and β, 1/s; none where there are no such terms.
    fn terms(&self) -> Option<Baumgarte<R>>;
}

impl<R: Real> Stabilisation<R> for Baumgarte<R> {
    #[inline(always)]
    fn terms(&self) -> Option<Baumgarte<R>> {
        Some(*self)
    }
}

impl<R: Real> Stabilisation<R> for LagrangeIndex1 {
    #[inline(always)]
    fn terms(&self) -> Option<Baumgarte<R>> {
        None
    }
}
