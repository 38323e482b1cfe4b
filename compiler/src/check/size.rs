//! Whether the elimination is of a size to write out: judged by structure, before anything is assembled or eliminated.
//!
//! Counts of parts bound the definition, not the work: 200 rods that 120 equations tie together are fewer than the limits and a
//! hundred times the operations of a chain of as many. What counts is how much of K = [M Dᵀ; D 0] fills in.

use super::messages::{self, Oversize};
use crate::diagnostics::Diagnostics;
use crate::equations::{self, Attachment, Equations, Omitted, SpanningTree, space};
use crate::model::{Coordinates, Frame, Mechanism, Space};
use crate::solve::structural_operations;

/// Operations of one elimination, by structure. It is written out with several right-hand sides and read by rustc: at this size a
/// build takes most of a minute and about a gigabyte, and both grow in proportion.
pub const MOST_OPERATIONS: usize = 300_000;

/// Bodies on all ways to the ground, counted together: M of the tree has an entry for each two that hang on one another, and the
/// equations are put together in these coordinates whichever are taken in the end. A chain of 256 has 32 896.
const MOST_ON_WAYS: usize = 40_000;

/// Refuses bodies of which too many hang on one another, before any equation is written.
pub fn ways(mechanism: &Mechanism, tree: &SpanningTree, errors: &mut Diagnostics) {
    let mut depths = vec![0; mechanism.bodies.len()];
    let mut deepest = None;
    for Attachment { body, joint } in &tree.attachments {
        let parent = match joint {
            Some((_, Frame::Body(parent))) => depths[parent.0],
            _ => 0,
        };
        depths[body.0] = parent + 1;
        if deepest.is_none_or(|(_, depth)| depth <= parent) {
            deepest = Some((*body, parent + 1));
        }
    }
    let on_ways: usize = depths.iter().sum();
    if let (Some((body, depth)), true) = (deepest, on_ways > MOST_ON_WAYS) {
        let name = &mechanism.bodies[body.0].name;
        errors.error(name.span, messages::long_ways(&name.text, depth, on_ways, MOST_ON_WAYS));
    }
}

/// Refuses what neither set of coordinates that may be taken can bear. `tree`: the equations in tree coordinates.
pub fn size(mechanism: &Mechanism, tree: &Equations, asked: Coordinates, errors: &mut Diagnostics) {
    // Open trees in space are solved by articulated bodies, in proportion to their number.
    let open = mechanism.space == Space::Spatial && tree.rows.is_empty();
    let of_tree = if open { 0 } else { structural_operations(tree) };
    // Absolute coordinates that do not have the parameter of a curve are refused where coordinates are chosen.
    let only_tree = mechanism.bound_to_a_tree().is_some();
    if of_tree <= MOST_OPERATIONS && (asked != Coordinates::Absolute || only_tree) {
        return;
    }
    let of_absolute = in_absolute(mechanism);
    if of_absolute <= MOST_OPERATIONS && asked != Coordinates::Tree {
        return;
    }
    let taken = match asked {
        Coordinates::Tree => of_tree,
        Coordinates::Absolute => of_absolute,
        Coordinates::Auto => of_tree.min(of_absolute),
    };
    let other = match asked {
        Coordinates::Tree if of_absolute <= MOST_OPERATIONS => Some(("absolute", of_absolute)),
        Coordinates::Absolute if of_tree <= MOST_OPERATIONS && !open => Some(("tree", of_tree)),
        _ => None,
    };
    let oversize = Oversize {
        velocities: tree.layout.velocities(),
        rows: tree.rows.len(),
        mass: tree.mass.len(),
        operations: taken,
        most: MOST_OPERATIONS,
        densest: densest(tree),
        other,
    };
    errors.error(mechanism.name.span, messages::oversize(&mechanism.name.text, &oversize));
}

/// The operations of the elimination in absolute coordinates; in space without their equations, which would be work in
/// itself.
fn in_absolute(mechanism: &Mechanism) -> usize {
    match mechanism.space {
        _ if mechanism.bound_to_a_tree().is_some() => usize::MAX,
        Space::Planar => structural_operations(&equations::derive(
            mechanism,
            SpanningTree::absolute(mechanism),
            &Omitted::default(),
        )),
        Space::Spatial => space::absolute_operations(mechanism),
    }
}

/// Whose rows have the most velocities, and how many; the first of equals.
fn densest(equations: &Equations) -> Vec<(String, usize)> {
    let mut found: Vec<(String, usize)> = Vec::new();
    for row in &equations.rows {
        let count = row.jet.columns.len();
        match found.last_mut() {
            Some((of, most)) if *of == row.of => *most = count.max(*most),
            _ => found.push((row.of.clone(), count)),
        }
    }
    found.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
    found
}
