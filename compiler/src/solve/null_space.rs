//! The equations in independent velocities, written out: D = L U in the order that was chosen for it, a basis R of its null space,
//! and (Rᵀ M R) z̈ = Rᵀ (Q − M S γ).
//!
//! Which velocities are dependent is fixed here; where their pivots degrade the runtime chooses others, by tables.

use super::elimination::{self, Entries, Kind};
use super::lu::{self, Lu};
use super::order::{self, Pattern};
use super::stored::{frontier, symbols};
use crate::check::assemble::Partition;
use crate::equations::Equations;
use crate::symbolic::{Graph, Node};
use std::collections::BTreeMap;

/// A sparse vector by its entries that are not zero.
pub(super) type Sparse = BTreeMap<usize, Node>;

/// What `options { emit = (null_space) }` asks for.
#[derive(Clone, Debug)]
pub struct NullSpace {
    /// What is kept of D = L U.
    pub kept: Vec<Node>,
    /// The square of the smallest pivot, relative to the size of its row.
    pub partition_pivot: Node,
    /// Velocities with D v = rows, in symbols for what is kept, for the rows, and for v, whose independent entries count.
    pub dependent: Vec<Node>,
    /// v̇ and λ, and the smallest pivot.
    pub acceleration: Vec<Node>,
    pub lambda: Vec<Node>,
    pub pivot: Node,
}

/// Writes out, with the n_v velocities split into dependent ones (D_d, m × m) and f = n_v − m independent ones, R (n_v × f) with
/// D R = 0 and 1 at the independent velocities, and S γ the accelerations with D S γ = γ and 0 there:
///
/// ```text
/// (Rᵀ M R) z̈ = Rᵀ (Q − M S γ),    v̇ = R z̈ + S γ,    D_dᵀ λ = (Q − M v̇)_d
/// ```
/// v̇ in m/s² and rad/s², λ in N or N m. `massless`: M alone is singular, so that the pivots of Rᵀ M R are watched.
/// Source: García de Jalón, Bayo, *Kinematic and Dynamic Simulation of Multibody Systems*, 5.2.3.
pub fn null_space(equations: &mut Equations, partition: &Partition, massless: bool) -> NullSpace {
    let velocities = equations.layout.velocities();
    let rows = equations.rows.iter().map(|row| row.jet.columns.clone()).collect();
    let lu = lu::factor(&mut equations.graph, rows, velocities, partition);
    let (kept, dependent) = stored(equations, &lu);
    let g = &mut equations.graph;
    // R, a column for each independent velocity.
    let independent: Vec<usize> = (0..velocities).filter(|velocity| !lu.is_dependent[*velocity]).collect();
    let basis: Vec<Sparse> = independent.iter().map(|velocity| lu.column(g, *velocity)).collect();

    // (Rᵀ M R) z̈ = Rᵀ (Q − M S γ)
    let mass = Symmetric::new(velocities, &equations.mass);
    let none = zeros(g, velocities);
    let bias = lu.dependent(g, &equations.gamma, &none);
    let loads = without(g, &equations.forces, &mass, &bias);
    let loads = sparse(g, &loads);
    let right: Vec<Node> = basis.iter().map(|column| dot(g, column, &loads)).collect();
    let reduced = reduced(g, &mass, &basis);
    let order = order::best(&Pattern::new(independent.len(), 0, reduced.keys().copied()));
    let kind =
        Kind { velocities: independent.len(), watch_velocities: massless, scales: &[], compliance: None };
    let factor = elimination::factor(g, &reduced, &order, &kind);

    // v̇ = R z̈ + S γ, D_dᵀ λ = (Q − M v̇)_d
    let mut z = none;
    for (velocity, rate) in independent.iter().zip(factor.solve(g, &right)) {
        z[*velocity] = rate;
    }
    let acceleration = lu.combine(g, &basis, &equations.gamma, &independent, &z);
    let rest = without(g, &equations.forces, &mass, &acceleration);
    let lambda = zeros(g, equations.rows.len());
    let lambda = lu.multipliers(g, rest, lambda);
    let pivot = g.min(lu.pivot, factor.pivot);
    NullSpace { kept, partition_pivot: lu.pivot, dependent, acceleration, lambda, pivot }
}

/// What is kept of D = L U, and the velocities with D v = rows in symbols for it.
fn stored(equations: &mut Equations, lu: &Lu) -> (Vec<Node>, Vec<Node>) {
    let g = &mut equations.graph;
    if equations.symbols.given_rows.is_empty() {
        equations.symbols.given_rows = symbols(g, "row", equations.rows.len());
    }
    let (rows, v) = (&equations.symbols.given_rows, &equations.symbols.v);
    let dependent = lu.dependent(g, rows, v);
    let kept = frontier(g, &dependent, &rows.iter().chain(v).copied().collect());
    let stand_ins = symbols(g, "lu", kept.len());
    let replaced = kept.iter().copied().zip(stand_ins.iter().copied()).collect();
    let dependent = g.substitute(&dependent, &replaced);
    equations.symbols.lu = stand_ins;
    (kept, dependent)
}

/// Rᵀ M R, the lower triangle.
fn reduced(g: &mut Graph, mass: &Symmetric, basis: &[Sparse]) -> Entries {
    let products: Vec<Sparse> = basis.iter().map(|column| mass.times(g, column)).collect();
    let mut entries = Entries::new();
    for (a, column) in basis.iter().enumerate() {
        for (b, product) in products.iter().enumerate().take(a + 1) {
            let entry = dot(g, column, product);
            if g.value(entry) != Some(0.0) {
                entries.insert((a, b), entry);
            }
        }
    }
    entries
}

/// M by rows, both triangles.
struct Symmetric(Vec<Vec<(usize, Node)>>);

impl Symmetric {
    fn new(size: usize, lower: &Entries) -> Self {
        let mut rows = vec![Vec::new(); size];
        for ((i, j), entry) in lower {
            rows[*i].push((*j, *entry));
            if i != j {
                rows[*j].push((*i, *entry));
            }
        }
        Symmetric(rows)
    }

    fn times(&self, g: &mut Graph, x: &Sparse) -> Sparse {
        let mut product = Sparse::new();
        for (j, value) in x {
            for (i, entry) in &self.0[*j] {
                let term = g.mul(*entry, *value);
                let sum = product.get(i).copied().map_or(term, |sum| g.add(sum, term));
                product.insert(*i, sum);
            }
        }
        product
    }
}

pub(super) fn zeros(g: &mut Graph, size: usize) -> Vec<Node> {
    vec![g.constant(0.0); size]
}

fn sparse(g: &Graph, entries: &[Node]) -> Sparse {
    let live = entries.iter().copied().enumerate().filter(|(_, entry)| g.value(*entry) != Some(0.0));
    live.collect()
}

fn dot(g: &mut Graph, a: &Sparse, b: &Sparse) -> Node {
    let terms: Vec<Node> =
        a.iter().filter_map(|(at, x)| b.get(at).map(|y| (*x, *y))).map(|(x, y)| g.mul(x, y)).collect();
    g.sum(terms)
}

/// Q − M a.
fn without(g: &mut Graph, forces: &[Node], mass: &Symmetric, a: &[Node]) -> Vec<Node> {
    let a = sparse(g, a);
    let product = mass.times(g, &a);
    let entry = |(at, x): (usize, &Node)| product.get(&at).map_or(*x, |y| g.sub(*x, *y));
    forces.iter().enumerate().map(entry).collect()
}
