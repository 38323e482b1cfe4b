//! Which velocities depend on the others, and in which order they follow. How they are chosen is left to `check::assemble`.

/// D factored at the start: which velocity each row gives, in an order in which little fills in.
#[derive(Clone, Debug, Default)]
pub struct Partition {
    /// In order of elimination: one list for each joint's vector of rows, or row by itself.
    pub blocks: Vec<Vec<Pivot>>,
    /// One over the largest entry of each column of D, to a power of two: entries are compared after multiplication by it, because
    /// columns have different units.
    pub scales: Vec<f64>,
    /// The largest scaled entry of each row along the motion: what its pivot is measured by.
    pub row_sizes: Vec<f64>,
    /// Operations of the elimination, by structure.
    pub operations: usize,
}

/// A row and its dependent velocity.
#[derive(Clone, Copy, Debug)]
pub struct Pivot {
    pub row: usize,
    pub velocity: usize,
}

impl Partition {
    /// All pivots, in order.
    pub fn pivots(&self) -> impl Iterator<Item = &Pivot> {
        self.blocks.iter().flatten()
    }
}
