//! Fixed (bracket): p₁ = p₂ and E₁ = E₂.

use super::{Elementary, Ends};
use crate::equations::JointRow;
use crate::symbolic::Graph;

pub fn motions() -> Vec<Elementary> {
    Vec::new()
}

pub fn rows(g: &mut Graph, ends: &Ends) -> Vec<JointRow> {
    let mut rows = ends.together(g);
    rows.extend(ends.parallel(g));
    rows.push(ends.unturned(g));
    rows
}
