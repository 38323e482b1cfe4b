//! Which coordinates: as the definition says, or those whose default acceleration function takes fewer operations.

use crate::check::{
    self,
    assemble::{self, Assembly},
};
use crate::diagnostics::Diagnostics;
use crate::equations::{self, Equations, Omitted, SpanningTree, space};
use crate::model::{Coordinates, Mechanism, Space};
use crate::order::Strategy;
use crate::schedule::{Counts, count_outputs};
use crate::solve::{self, Solved};

/// One set of coordinates, solved.
pub struct Candidate {
    pub equations: Equations,
    pub assembly: Assembly,
    pub solved: Solved,
}

/// Which coordinates were taken, and why.
#[derive(Clone, Debug)]
pub struct Choice {
    pub coordinates: Coordinates,
    pub strategy: Strategy,
    /// Default acceleration function in these coordinates.
    pub counts: Counts,
    /// The other set, if the compiler had the choice.
    pub rejected: Option<Rejected>,
}

/// What is known of the coordinates that were not taken.
#[derive(Clone, Copy, Debug)]
pub enum Rejected {
    Counted(Counts),
    /// Their elimination alone, by its structure, takes so many operations: far more than all that the others need.
    Estimated(usize),
    /// They do not have all that the dynamics use.
    Impossible,
}

/// Solves in the coordinates asked for, or in both and takes the cheaper. `tree` is assembled already.
pub fn choose(
    mechanism: &Mechanism,
    tree: Equations,
    assembly: Assembly,
    asked: Coordinates,
    errors: &mut Diagnostics,
) -> Option<(Candidate, Choice)> {
    let possible = check::absolute_is_possible(mechanism);
    if let (Coordinates::Absolute, Err((joint, message))) = (asked, &possible) {
        errors.error(mechanism.joints[joint.0].name.span, message.clone());
        return None;
    }
    if asked == Coordinates::Absolute {
        let absolute = absolute(mechanism, &tree, &assembly, errors)?;
        let (candidate, counts) = solved(mechanism, absolute.0, absolute.1, errors)?;
        return Some(taken(Coordinates::Absolute, candidate, counts, None));
    }
    if asked == Coordinates::Tree || possible.is_err() {
        let (candidate, counts) = solved(mechanism, tree, assembly, errors)?;
        let rejected = (asked == Coordinates::Auto).then_some(Rejected::Impossible);
        return Some(taken(Coordinates::Tree, candidate, counts, rejected));
    }
    if mechanism.space == Space::Spatial {
        return choose_in_space(mechanism, tree, assembly, errors);
    }
    let (absolute, state) = absolute(mechanism, &tree, &assembly, errors)?;
    let (estimate, of_tree) = (solve::structural_operations(&absolute), solve::structural_operations(&tree));
    if of_tree > 4 * estimate {
        // Long chains: the mass matrix of a tree is full, and writing out its elimination would take minutes.
        let (candidate, counts) = solved(mechanism, absolute, state, errors)?;
        return Some(taken(Coordinates::Absolute, candidate, counts, Some(Rejected::Estimated(of_tree))));
    }
    let (tree, counts) = solved(mechanism, tree, assembly, errors)?;
    if estimate > 2 * counts.total() {
        return Some(taken(Coordinates::Tree, tree, counts, Some(Rejected::Estimated(estimate))));
    }
    let (absolute, others) = solved(mechanism, absolute, state, errors)?;
    Some(if others.score() < counts.score() {
        taken(Coordinates::Absolute, absolute, others, Some(Rejected::Counted(counts)))
    } else {
        taken(Coordinates::Tree, tree, counts, Some(Rejected::Counted(others)))
    })
}

/// In space absolute coordinates have many rows, which cost as much again as their elimination: they are not derived where
/// the elimination alone takes more than all that the tree needs.
fn choose_in_space(
    mechanism: &Mechanism,
    tree: Equations,
    assembly: Assembly,
    errors: &mut Diagnostics,
) -> Option<(Candidate, Choice)> {
    let estimate = space::absolute_operations(mechanism);
    let of_tree = solve::structural_operations(&tree);
    let (known, known_assembly) = (tree.clone(), assembly.clone());
    // Long chains that close have a full mass matrix in tree coordinates; open ones need none.
    if of_tree > 4 * estimate && !tree.rows.is_empty() {
        let (absolute, state) = absolute(mechanism, &known, &known_assembly, errors)?;
        let (candidate, counts) = solved(mechanism, absolute, state, errors)?;
        return Some(taken(Coordinates::Absolute, candidate, counts, Some(Rejected::Estimated(of_tree))));
    }
    let (tree, counts) = solved(mechanism, tree, assembly, errors)?;
    if estimate > counts.total() {
        return Some(taken(Coordinates::Tree, tree, counts, Some(Rejected::Estimated(estimate))));
    }
    let (absolute, state) = absolute(mechanism, &known, &known_assembly, errors)?;
    let (absolute, others) = solved(mechanism, absolute, state, errors)?;
    Some(if others.score() < counts.score() {
        taken(Coordinates::Absolute, absolute, others, Some(Rejected::Counted(counts)))
    } else {
        taken(Coordinates::Tree, tree, counts, Some(Rejected::Counted(others)))
    })
}

fn absolute(
    mechanism: &Mechanism,
    tree: &Equations,
    assembly: &Assembly,
    errors: &mut Diagnostics,
) -> Option<(Equations, Assembly)> {
    let absolute = equations::derive(mechanism, SpanningTree::absolute(mechanism), &Omitted::default());
    let state = assemble::carry_over(mechanism, tree, assembly, &absolute);
    if assembly.omitted.is_empty() {
        return Some((absolute, state));
    }
    let state = assemble::drop_redundant(mechanism, &absolute, state, errors);
    if !errors.is_empty() {
        return None;
    }
    let tree = SpanningTree::absolute(mechanism);
    Some((equations::without_redundant(mechanism, tree, absolute, &state.omitted), state))
}

fn solved(
    mechanism: &Mechanism,
    equations: Equations,
    assembly: Assembly,
    errors: &mut Diagnostics,
) -> Option<(Candidate, Counts)> {
    let massless = assemble::massless(mechanism, &equations, &assembly, errors);
    if !errors.is_empty() {
        return None;
    }
    let scales = assemble::row_scales(mechanism, &equations, &assembly, &massless);
    let (equations, solved) = solve::solve(equations, massless, scales, &count_outputs);
    let counts = solved.counts;
    Some((Candidate { equations, assembly, solved }, counts))
}

fn taken(
    coordinates: Coordinates,
    candidate: Candidate,
    counts: Counts,
    rejected: Option<Rejected>,
) -> (Candidate, Choice) {
    let strategy = candidate.solved.order.strategy;
    (candidate, Choice { coordinates, strategy, counts, rejected })
}

impl Choice {
    /// What was chosen and why, for the documentation.
    pub fn explanation(&self) -> String {
        let (own, rival) = match self.coordinates {
            Coordinates::Absolute => ("absolute", "tree"),
            _ => ("tree", "absolute"),
        };
        let order = match self.strategy {
            Strategy::MinimumDegree => "elimination order: minimum degree",
            Strategy::MinimumFill => "elimination order: minimum fill",
            Strategy::Schur => "elimination order: all velocities first (Schur complement)",
            Strategy::ArticulatedBodies => "solved by articulated bodies",
        };
        let (operations, depth) = (self.counts.total(), self.counts.depth);
        let why = match &self.rejected {
            None => format!("as asked: {operations} operations, depth {depth}"),
            Some(Rejected::Impossible) => format!(
                "{operations} operations, depth {depth}; {rival} coordinates do not have all that it needs"
            ),
            Some(Rejected::Counted(other)) => format!(
                "chosen by count: {operations} operations, depth {depth}, against {} and {} in {rival} coordinates",
                other.total(),
                other.depth
            ),
            Some(Rejected::Estimated(elimination)) => format!(
                "chosen by count: {operations} operations, depth {depth}, against about {elimination} for the \
                 elimination alone in {rival} coordinates"
            ),
        };
        format!("In {own} coordinates ({why}); {order}.")
    }
}
