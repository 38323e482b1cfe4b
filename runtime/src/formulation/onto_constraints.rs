//! Newton's iteration that brings positions to the constraints, whatever decides in which direction.

use super::Settled;
use crate::error::AssemblyError;
use crate::layout::retract;
use crate::mechanism::Assemble;
use crate::real::Real;
use crate::vector::Vector;

/// When the iteration ends.
pub(super) struct Bounds<R> {
    /// max |Φ| at which positions are good, m, rad or the row's own unit.
    pub tolerance: R,
    /// The most iterations made.
    pub iterations: u32,
}

/// The solution that one iteration asks for.
pub(super) enum Ask {
    /// δ with D δ = −Φ by the factor at hand.
    Step,
    /// The factor at this position: the one at hand is no longer good.
    Factor,
}

/// q ← q ⊕ δ with D δ = −Φ(q), by simplified Newton's iteration (one factor for as long as steps shrink tenfold: Hairer, Wanner,
/// *Solving Ordinary Differential Equations II*, IV.8), until max |Φ| is below the tolerance or δ is rounding.
///
/// `act` gives δ (shape n_v, m and rad) for `Ask::Step` and Φ, and factors at the position for `Ask::Factor`.
pub(super) fn onto_constraints<R: Real, M: Assemble<R>>(
    model: &M,
    time: R,
    q: &mut M::Q,
    bounds: &Bounds<R>,
    mut act: impl FnMut(Ask, &M::Q, &M::Lambda) -> M::V,
) -> Result<Settled<R>, AssemblyError> {
    let mut settled = Settled { iterations: 0, moved: R::ZERO };
    let mut phi = model.zero_lambda();
    let mut last = R::ZERO;
    loop {
        model.constraints(time, q, &mut phi);
        if phi.first_not_finite().is_some() {
            return Err(AssemblyError::worst(model, &phi, settled.iterations));
        }
        if phi.max_abs() <= bounds.tolerance {
            return Ok(settled);
        }
        if settled.iterations == bounds.iterations {
            return Err(AssemblyError::worst(model, &phi, settled.iterations));
        }
        let delta = act(Ask::Step, q, &phi);
        let moved = delta.max_abs();
        // Rounding alone moves the state back and forth by this.
        if settled.iterations > 0 && moved <= R::from_f64(16.0) * R::EPSILON * (R::ONE + q.max_abs()) {
            return Ok(settled);
        }
        let from = q.clone();
        retract(model.layout(), &from, &delta, q);
        settled.iterations += 1;
        settled.moved = settled.moved.max(moved);
        if settled.iterations > 1 && moved > R::from_f64(0.1) * last {
            act(Ask::Factor, q, &phi);
        }
        last = moved;
    }
}
