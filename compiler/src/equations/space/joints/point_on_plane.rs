//! Point on plane: Δ across z₁.

use super::{Elementary, Ends};
use crate::equations::JointRow;

/// Never carries a body: it leaves five freedoms, and a free body has six.
pub fn motions() -> Vec<Elementary> {
    Vec::new()
}

pub fn rows(ends: &Ends) -> Vec<JointRow> {
    vec![ends.on_plane()]
}
