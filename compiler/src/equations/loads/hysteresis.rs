//! What loads share that resist a way by internal states.

use super::{LoadTerms, along};
use crate::equations::jet::Moving;
use crate::equations::laws::Laws;
use crate::model::Load;
use crate::symbolic::Scalar;

/// What a load says of its internal states.
#[derive(Debug)]
pub struct Inner {
    /// ż, in their order.
    pub rates: for<'g> fn(&Laws<'g>, &Load) -> Vec<Scalar<'g>>,
}

/// x, with its rate.
pub fn way<'g>(laws: &Laws<'g>, load: &Load) -> Moving<'g> {
    laws.jet(load.expression())
}

/// −F along x.
pub fn terms<'g>(laws: &Laws<'g>, load: &Load, resistance: Scalar<'g>) -> LoadTerms<'g> {
    along(&way(laws, load), -resistance)
}
