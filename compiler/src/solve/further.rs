//! What is written out beside the accelerations by multipliers: K(c), the equations in independent velocities.

use super::{Damping, NullSpace, Partition, Solved, Stored, is_small, null_space, store};
use crate::equations::Equations;
use crate::model::{Options, SolvedBy};
use crate::symbolic::{Counts, Node};

/// What there is beyond the accelerations by multipliers.
#[derive(Clone, Debug, Default)]
pub struct Further {
    /// K(c).
    pub stored: Option<Stored>,
    /// Whether it is emitted together with the right-hand sides of the penalty formulation too.
    pub emits_system: bool,
    /// Which velocities are dependent, and how they are eliminated.
    pub partition: Partition,
    /// The equations in independent velocities.
    pub null_space: Option<NullSpace>,
    /// Whether they are asked before the multipliers, because they take fewer operations or are asked for.
    pub leads: bool,
    /// Whether the factors of D are emitted.
    pub emits_factors: bool,
    /// Operations of the accelerations by multipliers and by independent velocities, with Baumgarte's terms, where both were counted.
    pub compared: Option<[Counts; 2]>,
}

/// Independent velocities lead where they take a twentieth less than multipliers.
const LESS: (usize, usize) = (19, 20);

/// Independent velocities that take at least so many times the operations of multipliers are not written out to be counted.
const HOPELESS: usize = 2;

/// The equations in independent velocities in one way, on a graph of their own.
pub struct Independent {
    pub partition: Partition,
    pub equations: Equations,
    pub written: NullSpace,
    /// Operations with Baumgarte's terms.
    pub counts: Counts,
}

/// Those of the partitions, with Baumgarte's first term in each way, that take fewest operations, by `count`; of large mechanisms the first, in one way. `rows`:
/// symbols for right-hand sides of rows, if there are some. `most`: what takes more is not written.
pub fn cheapest(
    equations: &Equations,
    partitions: &[Partition],
    massless: bool,
    rows: Option<&[Node]>,
    most: usize,
    count: &dyn Fn(&Equations, &[Node]) -> Counts,
) -> Option<Independent> {
    let in_one_way = |partition: &Partition, damping: Option<Damping>| {
        let candidate = equations.clone();
        let written = null_space(&candidate, partition, massless, rows, damping, most)?;
        let counts = count(&candidate, &written.stabilised.nodes());
        Some(Independent { partition: partition.clone(), equations: candidate, written, counts })
    };
    if !is_small(equations) {
        return in_one_way(&partitions[0], None);
    }
    let dampings = [Damping::InRows, Damping::ByShift, Damping::ByShiftOfDependent];
    let ways = partitions.iter().flat_map(|partition| dampings.map(|damping| (partition, Some(damping))));
    ways.filter_map(|(partition, damping)| in_one_way(partition, damping))
        .min_by_key(|way| way.counts.score())
}

impl Further {
    /// `partitions`: ways to eliminate the dependent velocities, of which small mechanisms take the cheapest and others the first. `count`: what a
    /// function with these outputs takes. What is not taken leaves nothing behind in the equations.
    pub fn of(
        equations: &mut Equations,
        solved: &Solved,
        options: &Options,
        partitions: &[Partition],
        count: &dyn Fn(&Equations, &[Node]) -> Counts,
    ) -> Self {
        let emit = options.emit;
        let asked = emit.penalty || emit.projection;
        let stored = asked.then(|| store(equations, &solved.massless, &solved.row_scales));
        let rows = stored.as_ref().map(|stored| stored.given.rows.as_slice());
        let massless = !solved.massless.rows.is_empty();
        let may_lead = !equations.rows.is_empty() && options.solution != SolvedBy::Multipliers;
        let mut further = Further {
            partition: partitions[0].clone(),
            emits_system: emit.penalty,
            emits_factors: emit.null_space,
            ..Further::default()
        };
        if may_lead || emit.null_space {
            let is_asked = emit.null_space || options.solution == SolvedBy::Independent;
            let most = if is_asked { usize::MAX } else { HOPELESS * solved.counts.total() };
            let best = cheapest(equations, partitions, massless, rows, most, count);
            let Some(Independent { partition, equations: candidate, written, counts: own }) = best else {
                return Further { stored, ..further };
            };
            further.partition = partition;
            if may_lead {
                further.compared = Some([solved.counts, own]);
                let is_less = LESS.1 * own.score() <= LESS.0 * solved.counts.score();
                further.leads = options.solution == SolvedBy::Independent || is_less;
            }
            if further.leads || emit.null_space {
                *equations = candidate;
                further.null_space = Some(written);
            }
        }
        Further { stored, ..further }
    }

    /// Which unknowns are solved for first, and why, for the documentation; nothing where there was nothing to choose.
    pub fn explanation(&self) -> Option<String> {
        let [multipliers, independent] = self.compared?;
        let said = |own: Counts, by: &str, other: Counts, of: &str| {
            let [(operations, depth), (others, other_depth)] = [own, other].map(|c| (c.total(), c.depth));
            format!(
                "Accelerations by {by} ({operations} operations, depth {depth}, against {others} and {other_depth} by {of})"
            )
        };
        let names = ["multipliers", "independent velocities"];
        Some(if self.leads {
            said(independent, names[1], multipliers, names[0])
                + ", by multipliers where their pivots are small."
        } else {
            said(multipliers, names[0], independent, names[1]) + "."
        })
    }

    /// Symbols for right-hand sides of K(c).
    pub fn given_forces(&self) -> &[Node] {
        self.stored.as_ref().map_or(&[], |stored| &stored.given.forces)
    }

    /// Symbols for right-hand sides of rows.
    pub fn given_rows(&self) -> &[Node] {
        let of_stored = self.stored.as_ref().map(|stored| stored.given.rows.as_slice());
        of_stored.or(self.factors().map(|written| written.given_rows.as_slice())).unwrap_or(&[])
    }

    /// Symbols for what is kept of K(c).
    pub fn kept(&self) -> &[Node] {
        self.stored.as_ref().map_or(&[], |stored| &stored.given.kept)
    }

    /// Symbols for what is kept of D = L U.
    pub fn lu(&self) -> &[Node] {
        self.factors().map_or(&[], |written| &written.stand_ins)
    }

    /// Where the factors of D are emitted.
    fn factors(&self) -> Option<&NullSpace> {
        self.null_space.as_ref().filter(|_| self.emits_factors)
    }
}
