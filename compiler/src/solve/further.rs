//! What the definition asks to be emitted beyond the accelerations: K(c), the equations in independent velocities.

use super::{NullSpace, Partition, Solved, Stored, null_space, store};
use crate::equations::Equations;
use crate::model::Emit;
use crate::symbolic::Node;

/// What is asked for beyond the accelerations.
#[derive(Clone, Debug, Default)]
pub struct Further {
    /// K(c).
    pub stored: Option<Stored>,
    /// Whether it is emitted together with the right-hand sides of the penalty formulation too.
    pub emits_system: bool,
    /// The equations in independent velocities.
    pub null_space: Option<NullSpace>,
}

impl Further {
    pub fn of(equations: &Equations, solved: &Solved, emit: &Emit, partition: &Partition) -> Self {
        let asked = emit.penalty || emit.projection;
        let stored = asked.then(|| store(equations, &solved.massless, &solved.row_scales));
        let rows = stored.as_ref().map(|stored| stored.given.rows.as_slice());
        let massless = !solved.massless.rows.is_empty();
        let null_space = emit.null_space.then(|| null_space(equations, partition, massless, rows));
        Further { stored, emits_system: emit.penalty, null_space }
    }

    /// Symbols for right-hand sides of K(c).
    pub fn given_forces(&self) -> &[Node] {
        self.stored.as_ref().map_or(&[], |stored| &stored.given.forces)
    }

    /// Symbols for right-hand sides of rows.
    pub fn given_rows(&self) -> &[Node] {
        let of_stored = self.stored.as_ref().map(|stored| stored.given.rows.as_slice());
        of_stored.or(self.null_space.as_ref().map(|written| written.given_rows.as_slice())).unwrap_or(&[])
    }

    /// Symbols for what is kept of K(c).
    pub fn kept(&self) -> &[Node] {
        self.stored.as_ref().map_or(&[], |stored| &stored.given.kept)
    }

    /// Symbols for what is kept of D = L U.
    pub fn lu(&self) -> &[Node] {
        self.null_space.as_ref().map_or(&[], |written| &written.stand_ins)
    }
}
