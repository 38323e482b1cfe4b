//! Constraint rows that repeat what others fix, not only at the start but all along the motion.
//!
//! Judged at a few positions near the start that the joints admit: a rank that is lost at all of them is redundancy; one
//! that is lost at the start alone is a singular position, and one from which every way leads back to the start moves only
//! infinitesimally; what to say of those is left to the caller. Which rows are left out is decided along the whole motion
//! (`along`), for each group of rows that repeat each other by itself, by the left null space of D there (`charts`).

use super::along::{self, Walk};
use super::charts::{self, Charts};
use super::messages;
use super::point::{Ancestry, Point, retract};
use super::position::Problem;
use crate::diagnostics::Diagnostics;
use crate::equations::{Equations, Omitted, RowOfJoint, Sized, Switch};
use crate::model::{JointId, Mechanism};
use crate::solve::table::Numeric;
use std::collections::BTreeSet;

/// Orthonormal vectors.
pub type Basis = Vec<Vec<f64>>;

/// The rows that `redundant = drop` leaves out.
#[derive(Clone, Debug, Default)]
pub struct Redundancy {
    /// Rows that repeat others.
    pub dropped: Vec<RowOfJoint>,
    /// Which rows are left out where.
    pub omitted: Omitted,
    /// Joints whose reactions are not unique.
    pub shared: Vec<JointId>,
    /// Positions along the motion, the first `near` of them near the start.
    pub along: Vec<Vec<f64>>,
    pub near: usize,
}

/// The redundancy that was found.
#[derive(Default)]
pub struct Finding {
    /// Rows that repeat others at all positions, indices into [`Equations::rows`].
    pub repeated: Vec<usize>,
    /// The rows that `redundant = drop` or `keep` leaves out or makes idle.
    pub redundancy: Redundancy,
    /// Positions nearby.
    pub beyond: Vec<Vec<f64>>,
    /// The start has directions of motion, but none leads away from it.
    pub shaky: bool,
    /// Rank is lost at all positions, and not only by rows of joints: couplings contradict or repeat each other.
    pub coupled: bool,
    /// A joint whose rows repeat others so that no choice of them serves all along the motion.
    pub without_choice: Option<JointId>,
}

/// Rows that take part less than this are not blamed.
pub const TAKES_PART: f64 = 1e-6;
/// A pivot of normalised rows below this is rounding.
const VANISHED: f64 = 1e-8;
/// A pivot above this is far from a singular position.
const REGULAR: f64 = 0.02;
const POSITIONS: usize = 5;
/// A position this near to the start, in parts of the step that was tried, is the start again.
const RETURNED: f64 = 1e-3;

/// Judges the rows of joints and constraints, given that some are dependent at `q`.
pub fn find(mechanism: &Mechanism, point: &mut Point, problem: &Problem, q: &[f64]) -> Finding {
    let equations = point.equations;
    let Nearby { found: beyond, back, open } = positions(mechanism, point, problem, q);
    let near = if beyond.is_empty() { vec![q.to_vec()] } else { beyond.clone() };
    let rows: Vec<usize> = (0..equations.rows.len() - mechanism.drivers.len()).collect();
    let deficiency = Repetition::of(point, &rows, &near).spaces.iter().map(Vec::len).min().unwrap_or(0);
    // Rank is lost and no way leads on: neither one that was tried, nor rows that repeat others exactly.
    if beyond.is_empty() && !open && (back || deficiency == 0) {
        return Finding { shaky: true, ..Finding::default() };
    }
    if deficiency == 0 {
        return Finding { beyond, ..Finding::default() };
    }
    let count = near.len();
    let mut along = near;
    if !beyond.is_empty() {
        along.extend(along::positions(point, &problem.joints_only(mechanism), q, Walk::around()));
    }
    match redundancy(mechanism, point, &rows, along, count) {
        Some(Choice { repeated, redundancy, without }) => {
            Finding { repeated, redundancy, beyond, without_choice: without, ..Finding::default() }
        }
        None => Finding { beyond, coupled: true, ..Finding::default() },
    }
}

/// The rows of absolute coordinates to leave out, at positions along the motion; the joint whose rows leave no choice that holds.
pub fn of_absolute(
    mechanism: &Mechanism,
    point: &mut Point,
    along: &[Vec<f64>],
    near: usize,
) -> Result<Redundancy, Option<JointId>> {
    let rows: Vec<usize> = (0..point.equations.rows.len() - mechanism.drivers.len()).collect();
    match redundancy(mechanism, point, &rows, along.to_vec(), near) {
        Some(Choice { redundancy, without: None, .. }) => Ok(redundancy),
        Some(Choice { without, .. }) => Err(without),
        None => Err(None),
    }
}

/// The rows that are left out.
struct Choice {
    repeated: Vec<usize>,
    redundancy: Redundancy,
    without: Option<JointId>,
}

/// Chooses among the rows; `None` where not only rows of joints repeat.
fn redundancy(
    mechanism: &Mechanism,
    point: &mut Point,
    rows: &[usize],
    along: Vec<Vec<f64>>,
    near: usize,
) -> Option<Choice> {
    let equations = point.equations;
    let repetition = Repetition::of(point, rows, &along);
    let droppable = |at: usize| equations.rows[rows[at]].joint().is_some();
    let sized = |at: usize| {
        let row = &equations.rows[rows[at]];
        row.of_joint().map(|row| Sized { row, size: repetition.sizes[at] })
    };
    let (mut repeated, mut omitted, mut without) = (Vec::new(), Omitted::default(), None);
    let all_singular = !repetition.regular.contains(&true);
    let counts = |at: &usize| all_singular || repetition.regular[*at];
    let near = (0..near).filter(counts).count();
    for component in components(&repetition.spaces, rows.len()) {
        let regular = (0..along.len()).filter(counts);
        let spaces: Vec<Basis> = regular.map(|at| restricted(&repetition.spaces[at], &component)).collect();
        // A row that repeats others at some positions only is not redundant.
        if spaces.iter().any(Vec::is_empty) {
            continue;
        }
        let charts = charts::choose(&spaces, near, component.len(), |at| droppable(component[at]))?;
        repeated.extend(charts.sets[0].iter().map(|at| rows[component[*at]]));
        if !charts.hold() {
            without = charts.sets[0].first().and_then(|at| equations.rows[rows[component[*at]]].joint());
        }
        leave_out(&mut omitted, &charts, |at| sized(component[at]), component.len());
    }
    if repeated.is_empty() {
        return None;
    }
    omitted.columns = repetition.columns.clone();
    let shared = joints_that_share(mechanism, equations, rows, &repetition.spaces);
    let dropped = repeated.iter().filter_map(|row| equations.rows[*row].of_joint()).collect();
    let redundancy = Redundancy { dropped, omitted, shared, along, near };
    Some(Choice { repeated, redundancy, without })
}

/// One set for good, or slots for several.
fn leave_out(omitted: &mut Omitted, charts: &Charts, sized: impl Fn(usize) -> Option<Sized>, rows: usize) {
    let in_all = |at: &usize| charts.sets.iter().all(|set| set.contains(at));
    let in_some = |at: &usize| charts.sets.iter().any(|set| set.contains(at));
    omitted.dropped.extend((0..rows).filter(in_all).filter_map(&sized).map(|sized| sized.row));
    if charts.sets.len() == 1 {
        return;
    }
    let slots = |taken: bool| {
        let of = |set: &Vec<usize>| -> Vec<usize> {
            (0..rows).filter(|at| in_some(at) && !in_all(at) && set.contains(at) != taken).collect()
        };
        let first = of(&charts.sets[0]);
        let aligned = charts.sets.iter().map(|set| {
            let own = of(set);
            let mut new =
                own.iter().copied().filter(|at| !first.contains(at)).collect::<Vec<_>>().into_iter();
            // A row in a slot of the first chart stays there.
            let slot = |at: &usize| if own.contains(at) { Some(*at) } else { new.next() };
            first.iter().filter_map(slot).filter_map(&sized).collect::<Vec<_>>()
        });
        aligned.collect::<Vec<_>>()
    };
    let (taken, idle) = (slots(true), slots(false));
    let common = (0..rows).filter(|at| !in_some(at)).filter_map(&sized).collect();
    omitted.switches.push(Switch { common, taken, idle });
}

/// Groups of rows that repeat each other, apart from all others.
fn components(spaces: &[Basis], rows: usize) -> Vec<Vec<usize>> {
    let mut group: Vec<usize> = (0..rows).collect();
    for space in spaces {
        for i in 0..rows {
            for j in 0..i {
                let shared: f64 = space.iter().map(|w| w[i] * w[j]).sum();
                if shared.abs() > TAKES_PART && group[i] != group[j] {
                    let (from, to) = (group[i].max(group[j]), group[i].min(group[j]));
                    group.iter_mut().filter(|own| **own == from).for_each(|own| *own = to);
                }
            }
        }
    }
    let takes_part = |row: usize| {
        spaces.iter().any(|space| space.iter().map(|w| w[row] * w[row]).sum::<f64>() > TAKES_PART)
    };
    let of =
        |first: usize| (0..rows).filter(|row| group[*row] == first && takes_part(*row)).collect::<Vec<_>>();
    (0..rows).map(of).filter(|component| !component.is_empty()).collect()
}

/// The part of a space in the rows of a component, as a basis: vectors of different components are orthogonal.
fn restricted(space: &Basis, component: &[usize]) -> Basis {
    // Columns of the projection onto the space, of which as many are independent as the component repeats.
    let columns = component.iter().map(|j| -> Vec<f64> {
        component.iter().map(|i| space.iter().map(|w| w[*i] * w[*j]).sum()).collect()
    });
    let mut columns: Vec<Vec<f64>> = columns.collect();
    let mut basis: Basis = Vec::new();
    loop {
        let square = |column: &Vec<f64>| column.iter().map(|x| x * x).sum::<f64>();
        let longest = (0..columns.len()).max_by(|a, b| square(&columns[*a]).total_cmp(&square(&columns[*b])));
        let Some(longest) = longest.filter(|at| square(&columns[*at]) > TAKES_PART * TAKES_PART) else {
            break;
        };
        let length = square(&columns[longest]).sqrt();
        let unit: Vec<f64> = columns[longest].iter().map(|x| x / length).collect();
        for column in &mut columns {
            let along: f64 = column.iter().zip(&unit).map(|(a, b)| a * b).sum();
            column.iter_mut().zip(&unit).for_each(|(x, u)| *x -= along * u);
        }
        basis.push(unit);
        if basis.len() == component.len() {
            break;
        }
    }
    orthonormal(basis)
}

/// The rows of a joint repeat others, but no choice of them serves all along the motion.
pub fn report_no_choice(mechanism: &Mechanism, joint: Option<JointId>, errors: &mut Diagnostics) {
    let joint = joint.map(|joint| &mechanism.joints[joint.0].name);
    let (name, span) =
        joint.map_or((&mechanism.name.text, mechanism.name.span), |name| (&name.text, name.span));
    errors.error(span, messages::no_choice(name));
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
        let (true, Some(id)) = (takes_part, equations.rows[*row].joint()) else { continue };
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

/// The left null spaces of the rows at some positions.
struct Repetition {
    /// An orthonormal basis of the w with wᵀ D = 0 at each of them, rows of D brought to one size that is the same at all.
    spaces: Vec<Basis>,
    /// Whether the rows that do not repeat are far from losing rank at each position, where no choice helps.
    regular: Vec<bool>,
    /// The sizes of the rows, powers of two.
    sizes: Vec<f64>,
    /// One over the largest entry of each column, a power of two.
    columns: Vec<f64>,
}

impl Repetition {
    fn of(point: &mut Point, rows: &[usize], positions: &[Vec<f64>]) -> Self {
        let equations = point.equations;
        let jets: Vec<_> = rows.iter().map(|row| &equations.rows[*row].jet).collect();
        let ancestry = Ancestry::of_jets(equations, jets.iter().copied());
        let n = equations.symbols.v.len();
        let mut found: Vec<Vec<Vec<f64>>> = Vec::new();
        for q in positions {
            point.set_q(q);
            point.evaluate(&ancestry);
            let dense = |jet: &&crate::equations::Jet| {
                let mut row = vec![0.0; n];
                jet.columns.iter().for_each(|(column, node)| row[*column] = point.get(*node));
                row
            };
            found.push(jets.iter().map(dense).collect());
        }
        let power = |size: f64| if size > 0.0 { libm::exp2(libm::round(libm::log2(size))) } else { 1.0 };
        let length = |row: &Vec<f64>| row.iter().map(|x| x * x).sum::<f64>().sqrt();
        let most = |of: &dyn Fn(&Vec<Vec<f64>>) -> f64| found.iter().map(of).fold(0.0_f64, f64::max);
        let sizes: Vec<f64> = (0..rows.len()).map(|at| power(most(&|d| length(&d[at])))).collect();
        let entries = |column: usize| {
            move |d: &Vec<Vec<f64>>| d.iter().map(|row| row[column].abs()).fold(0.0, f64::max)
        };
        let columns = (0..n).map(|column| 1.0 / power(most(&entries(column)))).collect();
        for d in &mut found {
            for (row, size) in d.iter_mut().zip(&sizes) {
                row.iter_mut().for_each(|x| *x /= size);
            }
        }
        let judged = found.into_iter().map(left_null_space);
        let (spaces, pivots): (Vec<Basis>, Vec<f64>) = judged.unzip();
        let regular = pivots.into_iter().map(|pivot| pivot > REGULAR).collect();
        Repetition { spaces, regular, sizes, columns }
    }
}

/// An orthonormal basis of the w with wᵀ D = 0, and the smallest pivot of the rest.
fn left_null_space(mut d: Vec<Vec<f64>>) -> (Basis, f64) {
    let m = d.len();
    // Elimination with complete pivoting, of D beside the unit matrix.
    let mut combination: Vec<Vec<f64>> =
        (0..m).map(|i| (0..m).map(|j| if i == j { 1.0 } else { 0.0 }).collect()).collect();
    let (mut rank, mut smallest) = (0, 1.0_f64);
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
        smallest = smallest.min(size);
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
    (orthonormal(combination.split_off(rank)), smallest)
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
