//! Fixed (bracket): p₁ = p₂ and E₁ = E₂.

use super::{Elementary, Ends};
use crate::equations::JointRow;

pub fn motions() -> Vec<Elementary> {
    Vec::new()
}

pub fn rows(ends: &Ends) -> Vec<JointRow> {
    let mut rows = ends.together();
    rows.extend(ends.parallel());
    rows.push(ends.unturned());
    rows
}
