//! Constraint rows that repeat what others fix, not only at the start but all along the motion.
//!
//! Judged at a few positions near the start that the joints admit: a rank that is lost at all of them is redundancy; one
//! that is lost at the start alone is a singular position, and one from which every way leads back to the start moves only
//! infinitesimally; what to say of those is left to the caller. Of the left null space of D with
//! an orthonormal basis N, |N_i|² says how much row i takes part in the repetition (1: it vanishes; 0: it has nothing to
//! do with it). The row that takes part most at the position where it takes part least can be left out for longest.

use super::point::{Ancestry, Point, retract};
use super::position::Problem;
use crate::equations::{Dropped, Equations};
use crate::model::{JointId, Mechanism};
use crate::solve::table::Numeric;
use std::collections::BTreeSet;

/// What `redundant = drop` leaves out.
#[derive(Clone, Debug, Default)]
pub struct Redundancy {
    pub dropped: Vec<Dropped>,
    /// Joints whose reactions are not unique.
    pub shared: Vec<JointId>,
    pub nearby: Vec<Vec<f64>>,
}

/// What was found.
#[derive(Default)]
pub struct Finding {
    /// Rows that repeat others at all positions, indices into [`Equations::rows`].
    pub repeated: Vec<usize>,
    /// What `redundant = drop` or `keep` makes of them.
    pub redundancy: Redundancy,
    /// Positions nearby.
    pub beyond: Vec<Vec<f64>>,
    /// The start has directions of motion, but none leads away from it.
    pub shaky: bool,
    /// Rank is lost at all positions, and not only by rows of joints: couplings contradict or repeat each other.
    pub coupled: bool,
}

/// Rows that take part less than this are not blamed.
const TAKES_PART: f64 = 1e-6;
/// A pivot of normalised rows below this is rounding.
const VANISHED: f64 = 1e-9;
const POSITIONS: usize = 5;
/// A position this near to the start, in parts of the step that was tried, is the start again.
const RETURNED: f64 = 1e-3;

/// Judges the rows of joints and constraints, given that some are dependent at `q`.
pub fn find(mechanism: &Mechanism, point: &mut Point, problem: &Problem, q: &[f64]) -> Finding {
    let equations = point.equations;
    let Nearby { found: beyond, back, open } = positions(mechanism, point, problem, q);
    let nearby = if beyond.is_empty() { vec![q.to_vec()] } else { beyond.clone() };
    let rows: Vec<usize> = (0..equations.rows.len() - mechanism.drivers.len()).collect();
    let spaces: Vec<Vec<Vec<f64>>> = nearby.iter().map(|q| left_null_space(point, &rows, q)).collect();
    let deficiency = spaces.iter().map(Vec::len).min().unwrap_or(0);
    // Rank is lost and no way leads on: neither one that was tried, nor rows that repeat others exactly.
    if beyond.is_empty() && !open && (back || deficiency == 0) {
        return Finding { shaky: true, ..Finding::default() };
    }
    let droppable = |row: usize| equations.rows[row].joint.is_some();
    let chosen = if deficiency > 0 { choose(point, &rows, &nearby, droppable) } else { None };
    let Some(repeated) = chosen else {
        return Finding { beyond, coupled: deficiency > 0, ..Finding::default() };
    };
    let shared = joints_that_share(mechanism, equations, &rows, &spaces);
    let dropped = repeated.iter().filter_map(|row| {
        let row = &equations.rows[*row];
        Some(Dropped { joint: row.joint?, what: row.what })
    });
    let redundancy = Redundancy { dropped: dropped.collect(), shared, nearby };
    Finding { repeated, redundancy, beyond, shaky: false, coupled: false }
}

/// The rows of absolute coordinates to leave out, at positions that the tree has shown to be redundant.
pub fn of_absolute(
    mechanism: &Mechanism,
    equations: &Equations,
    point: &mut Point,
    nearby: &[Vec<f64>],
) -> Redundancy {
    let rows: Vec<usize> = (0..equations.rows.len() - mechanism.drivers.len()).collect();
    let spaces: Vec<Vec<Vec<f64>>> = nearby.iter().map(|q| left_null_space(point, &rows, q)).collect();
    let droppable = |row: usize| equations.rows[row].joint.is_some();
    let dropped = choose(point, &rows, nearby, droppable).unwrap_or_default();
    let shared = joints_that_share(mechanism, equations, &rows, &spaces);
    let dropped = dropped.into_iter().filter_map(|row| {
        let row = &equations.rows[row];
        Some(Dropped { joint: row.joint?, what: row.what })
    });
    Redundancy { dropped: dropped.collect(), shared, nearby: nearby.to_vec() }
}

/// Rows to leave out, one after the other, until the rest is independent at all positions.
fn choose(
    point: &mut Point,
    rows: &[usize],
    nearby: &[Vec<f64>],
    droppable: impl Fn(usize) -> bool,
) -> Option<Vec<usize>> {
    let mut left = rows.to_vec();
    let mut dropped = Vec::new();
    loop {
        let spaces: Vec<Vec<Vec<f64>>> = nearby.iter().map(|q| left_null_space(point, &left, q)).collect();
        if spaces.iter().map(Vec::len).min().unwrap_or(0) == 0 {
            break;
        }
        let share = |at: usize| {
            let shares = spaces.iter().map(|space| space.iter().map(|w| w[at] * w[at]).sum::<f64>());
            shares.fold(f64::INFINITY, f64::min)
        };
        let mut best: Option<(f64, usize)> = None;
        for at in (0..left.len()).filter(|at| droppable(left[*at])) {
            let share = share(at);
            // Rounding must not decide between rows that share alike.
            if share > TAKES_PART && best.is_none_or(|(known, _)| share > known + 1e-9) {
                best = Some((share, at));
            }
        }
        dropped.push(left.remove(best?.1));
    }
    (!dropped.is_empty()).then_some(dropped)
}

/// The joints whose rows take part, and those of the tree on the loops that they close: a force that the loop holds against
/// itself runs through all of them.
fn joints_that_share(
    mechanism: &Mechanism,
    equations: &Equations,
    rows: &[usize],
    spaces: &[Vec<Vec<f64>>],
) -> Vec<JointId> {
    let tree = &equations.tree;
    let mut joints: BTreeSet<JointId> = BTreeSet::new();
    for (at, row) in rows.iter().enumerate() {
        let takes_part = spaces.iter().flatten().any(|w| w[at] * w[at] > TAKES_PART);
        let (true, Some(id)) = (takes_part, equations.rows[*row].joint) else { continue };
        joints.extend(tree.around(mechanism, id));
    }
    joints.into_iter().collect()
}

/// Positions a short way from `q`, drivers removed.
pub fn nearby(mechanism: &Mechanism, point: &mut Point, problem: &Problem, q: &[f64]) -> Vec<Vec<f64>> {
    positions(mechanism, point, problem, q).found
}

/// Where velocities that the joints admit lead.
#[derive(Default)]
struct Nearby {
    /// Positions a short way from the start.
    found: Vec<Vec<f64>>,
    /// Some way led back to the start.
    back: bool,
    /// Some way was not followed to a position.
    open: bool,
}

/// Follows a few velocities that the joints admit.
fn positions(mechanism: &Mechanism, point: &mut Point, problem: &Problem, q: &[f64]) -> Nearby {
    let equations = point.equations;
    let joints = problem.joints_only(mechanism);
    let n = equations.symbols.v.len();
    let mut nearby = Nearby::default();
    for number in 1..=POSITIONS {
        // Any direction, different for each.
        let wish: Vec<f64> = (0..n).map(|k| libm::sin((number * (3 * k + 2)) as f64)).collect();
        let step = joints.admissible(point, q, &wish);
        let largest = step.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
        if largest < 1e-6 {
            continue;
        }
        let length = 0.05 + 0.04 * number as f64;
        let step: Vec<f64> = step.iter().map(|x| x * length / largest).collect();
        let attempt = joints.solve(point, retract(equations, q, &step));
        let moved = attempt.q.iter().zip(q).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
        match attempt.closed {
            true if moved > RETURNED * length => nearby.found.push(attempt.q),
            true => nearby.back = true,
            false => nearby.open = true,
        }
    }
    nearby
}

/// An orthonormal basis of the w with wᵀ D = 0, rows of D brought to length one.
fn left_null_space(point: &mut Point, rows: &[usize], q: &[f64]) -> Vec<Vec<f64>> {
    let equations = point.equations;
    let jets: Vec<_> = rows.iter().map(|row| &equations.rows[*row].jet).collect();
    point.set_q(q);
    point.evaluate(&Ancestry::of_jets(equations, jets.iter().copied()));
    let (n, m) = (equations.symbols.v.len(), rows.len());
    let mut d = vec![vec![0.0; n]; m];
    for (row, jet) in d.iter_mut().zip(&jets) {
        for (column, node) in &jet.columns {
            row[*column] = point.get(*node);
        }
        let length = row.iter().map(|x| x * x).sum::<f64>().sqrt();
        if length > 0.0 {
            row.iter_mut().for_each(|x| *x /= length);
        }
    }
    // Elimination with complete pivoting, of D beside the unit matrix.
    let mut combination: Vec<Vec<f64>> =
        (0..m).map(|i| (0..m).map(|j| if i == j { 1.0 } else { 0.0 }).collect()).collect();
    let mut rank = 0;
    while rank < m {
        let mut pivot = (0.0_f64, rank, 0);
        for (i, row) in d.iter().enumerate().skip(rank) {
            for (j, x) in row.iter().enumerate() {
                if x.abs() > pivot.0 {
                    pivot = (x.abs(), i, j);
                }
            }
        }
        let (size, i, j) = pivot;
        if size < VANISHED {
            break;
        }
        d.swap(rank, i);
        combination.swap(rank, i);
        let (pivot, pivot_combination) = (d[rank].clone(), combination[rank].clone());
        let subtract = |row: &mut [f64], factor: f64, other: &[f64]| {
            row.iter_mut().zip(other).for_each(|(x, y)| *x -= factor * y);
        };
        for below in rank + 1..m {
            let factor = d[below][j] / pivot[j];
            if factor != 0.0 {
                subtract(&mut d[below], factor, &pivot);
                subtract(&mut combination[below], factor, &pivot_combination);
            }
        }
        rank += 1;
    }
    orthonormal(combination.split_off(rank))
}

/// Gram–Schmidt, twice, which is enough.
fn orthonormal(vectors: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    let mut basis: Vec<Vec<f64>> = Vec::new();
    for mut vector in vectors {
        for _ in 0..2 {
            for known in &basis {
                let along: f64 = known.iter().zip(&vector).map(|(a, b)| a * b).sum();
                vector.iter_mut().zip(known).for_each(|(x, k)| *x -= along * k);
            }
            let length = vector.iter().map(|x| x * x).sum::<f64>().sqrt();
            vector.iter_mut().for_each(|x| *x /= length);
        }
        basis.push(vector);
    }
    basis
}

impl Problem<'_> {
    /// The velocities nearest to `wish` that the rows admit: [1 Dᵀ; D 0] [v; μ] = [wish; 0].
    fn admissible(&self, point: &mut Point, q: &[f64], wish: &[f64]) -> Vec<f64> {
        let (entries, mut rhs) = self.unit_system(point, q);
        rhs[..wish.len()].copy_from_slice(wish);
        rhs[wish.len()..].iter_mut().for_each(|x| *x = 0.0);
        let mut solution = Numeric::factor(self.table(), entries).solve(&rhs);
        solution.truncate(wish.len());
        solution
    }
}
