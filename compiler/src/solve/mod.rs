//! The linear solve, written out: accelerations and multipliers as nodes of the same graph.
//!
//! AFTER THIS POINT there is no linear system left, only expressions.

pub mod elimination;
mod friction;
mod further;
mod lu;
mod null_space;
mod partition;
mod stabilised;
mod stored;
mod symmetric;
pub mod table;

use crate::equations::space::articulated;
use crate::equations::{Equations, Kinematics, Row};
use crate::order::{self, Order, Pattern, Strategy};
use crate::symbolic::{Counts, Node, Scalar, Sheet, all_bare};
use elimination::{Entries, Factor, Kind};
use stabilised::{stabilised, stabilised_by_estimate};
use std::collections::{BTreeMap, BTreeSet};
use symmetric::Symmetric;

pub use further::{Further, cheapest};
pub use null_space::{NullSpace, null_space};
pub use partition::{Partition, Pivot};
pub use stabilised::Damping;
pub use stored::{Stored, store};

/// v̇ and λ, and the smallest relative pivot met on the way.
#[derive(Clone, Debug)]
pub struct Solution {
    pub acceleration: Vec<Node>,
    pub lambda: Vec<Node>,
    pub pivot: Node,
    /// Of each force that presses surfaces together, what the iteration for it begins with, what is open there, and what it leaves open, N; not emitted.
    pub left: Vec<[Node; 3]>,
}

impl Solution {
    /// All of it.
    pub fn nodes(&self) -> Vec<Node> {
        self.acceleration.iter().chain(&self.lambda).copied().chain([self.pivot]).collect()
    }
}

/// Both default formulations, and how they were eliminated.
#[derive(Clone, Debug)]
pub struct Solved {
    pub index1: Solution,
    pub baumgarte: Solution,
    /// What rows ask with Baumgarte's terms: of the accelerations, or of what these are shifted to.
    pub asked: Vec<Node>,
    pub order: Order,
    /// The values that the factorisation of K computed: pivots and columns of L.
    pub factored: Vec<Node>,
    /// Operations of the default acceleration function.
    pub counts: Counts,
    /// Rows added to M, see [`Massless`].
    pub massless: Massless,
    /// The sizes that pivots of rows are divided by, expressions of the parameters.
    pub row_scales: Vec<Node>,
    /// The outputs, which may name drivers' efforts or powers, or reactions, with v̇ and λ of the plain solution.
    pub outputs: Vec<Node>,
    /// What is held after events, likewise.
    pub assignments: Vec<Node>,
    /// The powers of loads, some of which follow from reactions, likewise.
    pub powers: Vec<Node>,
}

/// Velocities that carry no mass of their own. M is then singular, though positive definite on the admissible
/// velocities; with ρ Dᵀ D of the rows that hold those velocities added to M, and ρ Dᵀ γ to Q (ρ: one for each row), the solution is
/// the same to the last digit in exact arithmetic, because D v̇ = γ, and every pivot is regular.
/// (García de Jalón & Bayo, Kinematic and Dynamic Simulation of Multibody Systems, section 5.1.4: the matrix of the
/// penalty method, here without its approximation.)
#[derive(Clone, Debug, Default)]
pub struct Massless {
    pub velocities: BTreeSet<usize>,
    /// The rows that hold them, each with its ρ.
    pub rows: BTreeMap<usize, f64>,
}

/// Counts the operations of a function with these outputs.
type Counting = dyn Fn(&Equations, &[Node]) -> Counts;

/// Mechanisms of at most so many unknowns are eliminated in every order and counted; larger ones in the one that is
/// cheapest by structure, because writing out an elimination takes time.
const COUNTED: usize = 60;

/// Eliminations of so many operations by structure are written out and counted, whatever the others take.
const LIKELY: usize = 500;

/// Open trees of so many velocities are also solved by articulated bodies and counted. Two balls in a row take 147 operations that
/// way against 199, five 814 against 1849; seven hinges 662 against 573, ten 1109 against 1151, sixteen 2003 against 2944.
const LONG_TREE: usize = 6;

/// Solves for v̇ and λ, without stabilisation and with Baumgarte's:
/// D v̇ = γ − 2α (D v − ν) − β² Φ.
/// `count`: what the default acceleration function takes.
pub fn solve(
    equations: Equations,
    massless: Massless,
    row_scales: Vec<Node>,
    count: &Counting,
) -> (Equations, Solved) {
    let system = System::of(&equations, massless, row_scales);
    let pattern = Pattern::new(system.velocities, system.columns.len(), system.entries.keys().copied());
    let mut best: Option<Candidate> = None;
    if let Some((candidate, solved)) = by_articulated_bodies(&equations, &pattern, count) {
        if solved.order.operations > solved.counts.total() {
            return (candidate, solved);
        }
        best = Some((solved.counts.score(), candidate, solved));
    }
    if best.is_none() && !is_small(&equations) {
        let order = system.without_prescribed(order::best(&pattern));
        let solved = counted(&equations, &system, order, None, count);
        return (equations, solved);
    }
    // The structure does not see what constants save, so the small ones are written out and counted. Each on a graph of its own: what
    // loses leaves nothing behind.
    let written = |order: Order, damping: Damping| {
        let candidate = equations.clone();
        let solved = counted(&candidate, &system, order, Some(damping), count);
        (solved.counts.score(), candidate, solved)
    };
    let mut tried: Vec<Vec<usize>> = Vec::new();
    let orders = order::STRATEGIES.map(|strategy| order::order(&pattern, strategy));
    let least = orders.iter().map(|order| order.operations).min().unwrap_or(0);
    for order in orders {
        // An order that is far behind by structure is not written out to be counted.
        let hopeless = order.operations > LIKELY && 4 * order.operations > 5 * least;
        let order = system.without_prescribed(order);
        if hopeless || tried.contains(&order.sequence) {
            continue;
        }
        tried.push(order.sequence.clone());
        best = Some(less(best, written(order, Damping::InRows)));
    }
    let mut best =
        best.unwrap_or_else(|| written(system.without_prescribed(order::best(&pattern)), Damping::InRows));
    if !equations.rows.is_empty() {
        let shifted = written(best.2.order.clone(), Damping::ByShift);
        best = less(Some(best), shifted);
    }
    let (_, candidate, solved) = best;
    (candidate, solved)
}

/// A score, and what it was counted of.
type Candidate = (usize, Equations, Solved);

/// The one that takes less.
fn less(best: Option<Candidate>, other: Candidate) -> Candidate {
    match best {
        Some(best) if best.0 <= other.0 => best,
        _ => other,
    }
}

/// Whether all ways are written out and counted.
fn is_small(equations: &Equations) -> bool {
    equations.layout.velocities() + equations.rows.len() <= COUNTED
}

/// Operations of the elimination by its structure, which knows nothing of constants: an estimate made in no time.
pub fn structural_operations(equations: &Equations) -> usize {
    let n = equations.layout.velocities();
    let rows = equations.rows.iter().enumerate();
    let rows = rows.flat_map(|(row, r)| r.jet.columns.keys().map(move |column| (n + row, *column)));
    let pattern = Pattern::new(n, equations.rows.len(), equations.mass.keys().copied().chain(rows));
    order::order(&pattern, order::Strategy::MinimumDegree).operations
}

/// Entries below a diagonal, by row and column.
pub type Positions = BTreeSet<(usize, usize)>;

/// The pattern of L below its diagonal, rows and columns in the order of elimination: entries of K, and what fills in.
pub fn factor_pattern(equations: &Equations, solved: &Solved) -> (Positions, Positions) {
    let n = equations.layout.velocities();
    let is_active = |row: &usize| !equations.idle.contains(row);
    let rows = (0..equations.rows.len()).filter(is_active);
    let of_rows =
        rows.flat_map(|row| equations.rows[row].jet.columns.keys().map(move |column| (n + row, *column)));
    let squares = solved.massless.rows.keys().flat_map(|row| {
        let columns = &equations.rows[*row].jet.columns;
        columns.keys().flat_map(|i| columns.keys().map(move |j| (*i, *j)))
    });
    let own: BTreeSet<(usize, usize)> = equations
        .mass
        .keys()
        .copied()
        .chain(of_rows)
        .chain(squares)
        .flat_map(|(i, j)| [(i, j), (j, i)])
        .collect();
    let mut pattern = Pattern::new(n, equations.rows.len(), own.iter().copied());
    // Prescribed velocities and their rows are no part of it.
    let sequence = &solved.order.sequence;
    let place: BTreeMap<usize, usize> =
        sequence.iter().enumerate().map(|(at, unknown)| (*unknown, at)).collect();
    let (mut entries, mut fill) = (BTreeSet::new(), BTreeSet::new());
    for unknown in (0..n + equations.rows.len()).filter(|unknown| !place.contains_key(unknown)) {
        pattern.remove(unknown);
    }
    for (column, pivot) in sequence.iter().enumerate() {
        for unknown in pattern.eliminate(*pivot) {
            let set = if own.contains(&(unknown, *pivot)) { &mut entries } else { &mut fill };
            set.insert((place[&unknown], column));
        }
    }
    (entries, fill)
}

/// K and what its right-hand sides need.
struct System {
    velocities: usize,
    columns: Vec<BTreeMap<usize, Node>>,
    /// Without the prescribed velocities and their rows.
    entries: Entries,
    prescribed: Vec<Prescribed>,
    /// Rows without a part in the solution.
    idle: BTreeSet<usize>,
    massless: Massless,
    /// The sizes that pivots of rows are divided by.
    scales: Vec<Node>,
}

/// A velocity that one row gives on its own, d v̇ = γ with a constant d ≠ 0: a driver's. Nothing has to be eliminated, and
/// nothing is lost: by elimination its error would be that of a reaction divided by an inertia, however small that is.
struct Prescribed {
    velocity: usize,
    row: usize,
    inverse: Node,
    /// The other entries of the velocity's column of K.
    column: Vec<(usize, Node)>,
    own: Option<Node>,
}

impl System {
    fn of(equations: &Equations, massless: Massless, scales: Vec<Node>) -> Self {
        let velocities = equations.symbols.v.len();
        let columns: Vec<BTreeMap<usize, Node>> =
            equations.rows.iter().map(|row| row.jet.columns.clone()).collect();
        let idle = equations.idle.clone();
        let mut entries: Entries = equations.mass.clone();
        let g = equations.graph.sheet();
        for (row, rho) in &massless.rows {
            add_square(&mut entries, &columns[*row], g.number(*rho));
        }
        for (row, columns) in columns.iter().enumerate().filter(|(row, _)| !idle.contains(row)) {
            entries.extend(columns.iter().map(|(velocity, column)| ((velocities + row, *velocity), *column)));
        }
        let prescribed = prescribed(g, velocities, &columns, &idle, &mut entries);
        System { velocities, columns, entries, prescribed, idle, massless, scales }
    }

    /// The unknowns that are left, in order.
    fn without_prescribed(&self, mut order: Order) -> Order {
        let known = |unknown: &usize| {
            if unknown.checked_sub(self.velocities).is_some_and(|row| self.idle.contains(&row)) {
                return true;
            }
            self.prescribed.iter().any(|p| *unknown == p.velocity || *unknown == self.velocities + p.row)
        };
        order.sequence.retain(|unknown| !known(unknown));
        order
    }
}

/// Takes the prescribed velocities and their rows out of the system.
fn prescribed(
    g: Sheet,
    velocities: usize,
    columns: &[BTreeMap<usize, Node>],
    idle: &BTreeSet<usize>,
    entries: &mut Entries,
) -> Vec<Prescribed> {
    let mut found: Vec<Prescribed> = Vec::new();
    for (row, columns) in columns.iter().enumerate().filter(|(row, _)| !idle.contains(row)) {
        let (1, Some((velocity, d))) = (columns.len(), columns.first_key_value()) else { continue };
        let d = g.on(*d);
        let constant = d.value().is_some_and(|d| d != 0.0);
        if constant && found.iter().all(|known| known.velocity != *velocity) {
            let (inverse, column) = (d.reciprocal().bare, Vec::new());
            found.push(Prescribed { velocity: *velocity, row, inverse, column, own: None });
        }
    }
    for prescribed in &mut found {
        let (velocity, own_row) = (prescribed.velocity, velocities + prescribed.row);
        for ((i, j), entry) in entries.iter() {
            let other = match (*i == velocity, *j == velocity) {
                (true, true) => {
                    prescribed.own = Some(*entry);
                    continue;
                }
                (true, false) => *j,
                (false, true) => *i,
                (false, false) => continue,
            };
            if other != own_row {
                prescribed.column.push((other, *entry));
            }
        }
    }
    let gone = |unknown: usize| {
        found.iter().any(|known| unknown == known.velocity || unknown == velocities + known.row)
    };
    entries.retain(|(i, j), _| !gone(*i) && !gone(*j));
    found
}

/// The solution of a long tree in space that has no constraints.
fn by_articulated_bodies(
    equations: &Equations,
    pattern: &Pattern,
    count: &Counting,
) -> Option<(Equations, Solved)> {
    let Kinematics::Space(kinematics) = &equations.kinematics else { return None };
    let open = equations.rows.is_empty() && equations.friction.is_none() && pattern.velocities >= LONG_TREE;
    if !open || !articulated::applies(kinematics) {
        return None;
    }
    let candidate = equations.clone();
    let (distributions, forces) = (&equations.distributions, &equations.forces);
    let kinematics = candidate.graph.sheet().on(kinematics);
    let acceleration = all_bare(&articulated::accelerations(kinematics, distributions, forces));
    let solution = Solution { acceleration, lambda: Vec::new(), pivot: candidate.one, left: Vec::new() };
    let outputs = solved(&candidate, &solution, &candidate.outputs);
    let assignments = solved(&candidate, &solution, &candidate.assignments);
    let powers = candidate.powers.clone();
    let order = order::order(pattern, Strategy::MinimumDegree);
    let mut solved = Solved {
        index1: solution.clone(),
        baumgarte: solution,
        asked: Vec::new(),
        order: Order { strategy: Strategy::ArticulatedBodies, ..order },
        factored: Vec::new(),
        counts: Counts::default(),
        massless: Massless::default(),
        row_scales: Vec::new(),
        outputs,
        assignments,
        powers,
    };
    solved.counts = count(&candidate, &solved.baumgarte.nodes());
    Some((candidate, solved))
}

fn counted(
    equations: &Equations,
    system: &System,
    order: Order,
    damping: Option<Damping>,
    count: &Counting,
) -> Solved {
    let solved = eliminate(equations, system, order, damping);
    Solved { counts: count(equations, &solved.baumgarte.nodes()), ..solved }
}

/// Without the counts.
fn eliminate(equations: &Equations, system: &System, order: Order, damping: Option<Damping>) -> Solved {
    let System { velocities, columns, entries, massless, scales, .. } = system;
    let g = equations.graph.sheet();
    let watch_velocities = !massless.rows.is_empty();
    let kind = Kind { velocities: *velocities, watch_velocities, scales, compliance: None };
    let factor = elimination::factor(g, entries, &order, &kind);

    let plain: Vec<Node> = equations.rows.iter().map(|row| row.jet.bias).collect();
    let mass = Symmetric::new(g, *velocities, &equations.mass);
    let asked = match damping {
        Some(damping) => stabilised(equations, damping, &[]),
        None => stabilised_by_estimate(equations, 2 * velocities + mass.entries()),
    };
    let linear = |forces: Vec<Scalar<'_>>, minus_gamma: &[Node], shift: &[Scalar<'_>]| {
        // M w + Dᵀ λ = Q + M shift, and v̇ = w − shift.
        let against: Vec<Scalar> = shift.iter().map(|x| -*x).collect();
        let mut right = mass.taken_from(&forces, &against);
        for (row, rho) in &massless.rows {
            let weighted = *rho * g.on(minus_gamma[*row]);
            for (velocity, column) in &columns[*row] {
                right[*velocity] -= *column * weighted;
            }
        }
        right.extend(g.all(minus_gamma));
        let mut solution = solution(g, &factor, system, right);
        for (own, shift) in solution.acceleration.iter_mut().zip(shift) {
            *own = (g.on(*own) - *shift).bare;
        }
        solution
    };
    let (still, none) = (vec![equations.zero; equations.rows.len()], vec![g.zero(); *velocities]);
    let columns = friction::columns(g, &equations.friction, *velocities);
    let columns: Vec<Solution> = columns.into_iter().map(|column| linear(column, &still, &none)).collect();
    let with = |minus_gamma: &[Node], shift: &[Scalar<'_>]| {
        friction::rubbed(g, equations, linear(g.all(&equations.forces), minus_gamma, shift), &columns)
    };
    let (index1, baumgarte) = (with(&plain, &none), with(&asked.rows, &g.all(&asked.shift)));
    let outputs = solved(equations, &index1, &equations.outputs);
    let assignments = solved(equations, &index1, &equations.assignments);
    let powers = match equations.friction.is_none() {
        true => equations.powers.clone(),
        false => solved(equations, &index1, &equations.powers),
    };
    Solved {
        index1,
        baumgarte,
        asked: asked.rows,
        order,
        factored: factor.nodes(),
        counts: Counts::default(),
        massless: massless.clone(),
        row_scales: scales.clone(),
        outputs,
        assignments,
        powers,
    }
}

/// What names efforts, powers or reactions takes v̇ and λ of the plain solution.
fn solved(equations: &Equations, solution: &Solution, of: &[Node]) -> Vec<Node> {
    let solved = solution.acceleration.iter().chain(&solution.lambda).copied();
    equations.graph.sheet().graph().substitute(of, &equations.results().zip(solved).collect())
}

/// Rows that are components of one vector, numbered alike.
pub fn groups(rows: &[Row]) -> Vec<Option<usize>> {
    let whole = |row: &Row| row.form.part_of;
    let same = |a: &Row, b: &Row| a.origin == b.origin && whole(a).is_some() && whole(a) == whole(b);
    let mut groups = Vec::new();
    for (number, group) in rows.chunk_by(same).enumerate() {
        groups.extend(vec![(group.len() > 1).then_some(number); group.len()]);
    }
    groups
}

/// v̇ and λ for [Q; −γ].
fn solution<'g>(g: Sheet<'g>, factor: &Factor, system: &System, mut right: Vec<Scalar<'g>>) -> Solution {
    let n = system.velocities;
    let mut known = Vec::new();
    for prescribed in &system.prescribed {
        known.push(-(right[n + prescribed.row] * prescribed.inverse));
    }
    let forces: Vec<Scalar> = system.prescribed.iter().map(|prescribed| right[prescribed.velocity]).collect();
    for (prescribed, value) in system.prescribed.iter().zip(&known) {
        for (other, entry) in &prescribed.column {
            let product = *entry * *value;
            if *other < n {
                right[*other] -= product;
            } else {
                right[*other] += product;
            }
        }
    }
    let mut x = factor.solve(g, &right);
    for (prescribed, value) in system.prescribed.iter().zip(&known) {
        x[prescribed.velocity] = *value;
    }
    for (prescribed, force) in system.prescribed.iter().zip(forces) {
        let own = prescribed.own.map(|entry| (prescribed.velocity, entry));
        let entries = prescribed.column.iter().copied().chain(own);
        let rest = entries.fold(force, |rest, (other, entry)| rest - entry * x[other]);
        x[n + prescribed.row] = rest * prescribed.inverse;
    }
    let mut lambda = all_bare(&x.split_off(n));
    for row in &system.idle {
        lambda[*row] = g.zero().bare;
    }
    Solution { acceleration: all_bare(&x), lambda, pivot: factor.pivot, left: Vec::new() }
}

/// entries += ρ dᵀ d.
fn add_square(entries: &mut Entries, row: &BTreeMap<usize, Node>, rho: Scalar) {
    let zero = rho.g.zero().bare;
    for (i, a) in row {
        let weighted = rho * *a;
        for (j, b) in row.range(..=i) {
            let product = weighted * *b;
            let own = entries.entry((*i, *j)).or_insert(zero);
            *own = (*own + product).bare;
        }
    }
}
