//! Numbers of operations.

/// Operations by kind; a fused multiply-add is one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Additions, subtractions and negations.
    pub additions: usize,
    pub multiplications: usize,
    pub fused_multiply_adds: usize,
    /// Divisions and reciprocals.
    pub divisions: usize,
    pub square_roots: usize,
    /// min, max, abs, sign, comparisons, logic and selections.
    pub choices: usize,
    /// sin, cos, exp and the like, of the user's laws.
    pub transcendentals: usize,
    /// Longest chain of dependent operations.
    pub depth: usize,
}

impl Counts {
    /// All operations, each counted once.
    pub fn total(&self) -> usize {
        self.additions
            + self.multiplications
            + self.fused_multiply_adds
            + self.divisions
            + self.square_roots
            + self.choices
            + self.transcendentals
    }

    /// The score that choices between formulations minimise: work, and a share for the depth that keeps a wide processor waiting.
    pub fn score(&self) -> usize {
        4 * self.total() + self.depth
    }
}
