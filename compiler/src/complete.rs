//! A mechanism with every expression that a function computes, all on one graph.

use crate::equations::{Conditions, Equations, Tangents};
use crate::solve::{Further, Solved};

/// Every expression that a function computes.
#[derive(Clone, Debug)]
pub struct Complete {
    pub equations: Equations,
    /// Of `start`, and for the independent coordinates.
    pub conditions: Conditions,
    pub solved: Solved,
    pub further: Further,
    /// Derivatives, where they are asked for.
    pub tangents: Option<Tangents>,
}
