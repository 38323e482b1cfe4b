//! The equations in independent velocities, written out: D = L U in the order that was chosen for it, a basis R of its null space,
//! and (Rᵀ M R) z̈ = Rᵀ (Q − M S γ).
//!
//! U has a unit diagonal (Crout), so that a right-hand side costs one product for each entry of L and of U. Which velocities are
//! dependent is fixed here; where their pivots degrade the runtime chooses others, by tables.

use super::elimination::{self, Entries, Kind};
use super::order::{self, Pattern};
use super::stored::{frontier, not_nan};
use crate::check::assemble::Partition;
use crate::equations::Equations;
use crate::symbolic::{Class, Graph, Node, Unary};
use std::collections::BTreeMap;

/// A sparse vector by its entries that are not zero.
type Sparse = BTreeMap<usize, Node>;

/// What `options { emit = (null_space) }` asks for.
#[derive(Clone, Debug)]
pub struct NullSpace {
    /// What is kept of D = L U.
    pub kept: Vec<Node>,
    /// The square of the smallest pivot, relative to its row at the start.
    pub partition_pivot: Node,
    /// Velocities with D v = rows, in symbols for what is kept, for the rows, and for v, whose independent entries count.
    pub dependent: Vec<Node>,
    /// The velocities that satisfy D v = ν, v̇ and λ, and the smallest pivot.
    pub velocity: Vec<Node>,
    pub acceleration: Vec<Node>,
    pub lambda: Vec<Node>,
    pub pivot: Node,
}

/// Writes it out.
pub fn null_space(equations: &mut Equations, partition: &Partition, massless: bool) -> NullSpace {
    let (n, m) = (equations.layout.velocities(), equations.rows.len());
    let rows: Vec<Sparse> = equations.rows.iter().map(|row| row.jet.columns.clone()).collect();
    let g = &mut equations.graph;
    let lu = factor(g, rows, n, partition);
    let zeros = vec![g.constant(0.0); m];

    // Right-hand sides as symbols.
    if equations.symbols.given_rows.is_empty() {
        let symbol = |row| g.symbol(format!("row_{row}"), Class::Input);
        equations.symbols.given_rows = (0..m).map(symbol).collect();
    }
    let (given, v) = (equations.symbols.given_rows.clone(), equations.symbols.v.clone());
    let dependent = lu.dependent(g, &given, &v);
    let late = given.iter().chain(&v).copied().collect();
    let kept = frontier(g, &dependent, &late);
    let stand_ins: Vec<Node> =
        (0..kept.len()).map(|index| g.symbol(format!("lu_{index}"), Class::Input)).collect();
    let replaced = kept.iter().copied().zip(stand_ins.iter().copied()).collect();
    let dependent = g.substitute(&dependent, &replaced);
    equations.symbols.lu = stand_ins;

    // R, a column for each independent velocity.
    let independent: Vec<usize> = (0..n).filter(|velocity| !lu.is_dependent[*velocity]).collect();
    let basis: Vec<Sparse> = independent.iter().map(|velocity| lu.column(g, *velocity)).collect();
    // v = R ż + S ν, and with it Q and γ.
    let velocity = lu.combine(g, &basis, &equations.nu, &independent, &v);
    let replaced = v.iter().copied().zip(velocity.iter().copied()).filter(|(own, new)| own != new).collect();
    let forces = g.substitute(&equations.forces, &replaced);
    let gamma = g.substitute(&equations.gamma, &replaced);

    // (Rᵀ M R) z̈ = Rᵀ (Q − M S γ)
    let mass = Symmetric::new(n, &equations.mass);
    let products: Vec<Sparse> = basis.iter().map(|column| mass.times(g, column)).collect();
    let mut reduced = Entries::new();
    for (a, column) in basis.iter().enumerate() {
        for (b, product) in products.iter().enumerate().take(a + 1) {
            if let Some(entry) = dot(g, column, product) {
                reduced.insert((a, b), entry);
            }
        }
    }
    let mut bias = zeros_of(g, n);
    bias = lu.dependent(g, &gamma, &bias);
    let loads = without(g, &forces, &mass, &bias);
    let loads = sparse(g, &loads);
    let right: Vec<Node> =
        basis.iter().map(|column| dot(g, column, &loads).unwrap_or_else(|| g.constant(0.0))).collect();
    let order = order::best(&Pattern::new(independent.len(), 0, reduced.keys().copied()));
    let kind =
        Kind { velocities: independent.len(), watch_velocities: massless, groups: &[], compliance: None };
    let factor = elimination::factor(g, &reduced, &order, &kind);
    let rates = factor.solve(g, &right);

    // v̇ = R z̈ + S γ, D_dᵀ λ = (Q − M v̇)_d
    let mut z = zeros_of(g, n);
    for (velocity, rate) in independent.iter().zip(&rates) {
        z[*velocity] = *rate;
    }
    let acceleration = lu.combine(g, &basis, &gamma, &independent, &z);
    let rest = without(g, &forces, &mass, &acceleration);
    let lambda = lu.multipliers(g, rest, zeros);
    let pivot = g.min(lu.pivot, factor.pivot);
    let (pivot, partition_pivot) = (not_nan(g, pivot), not_nan(g, lu.pivot));
    NullSpace { kept, partition_pivot, dependent, velocity, acceleration, lambda, pivot }
}

/// D = L U.
struct Lu {
    steps: Vec<Step>,
    is_dependent: Vec<bool>,
    /// The square of the smallest pivot, relative to its row at the start.
    pivot: Node,
}

struct Step {
    row: usize,
    velocity: usize,
    /// One over the pivot.
    inverse: Node,
    /// The row of U beside its 1.
    upper: Vec<(usize, Node)>,
    /// The column of L below the pivot.
    lower: Vec<(usize, Node)>,
}

fn factor(g: &mut Graph, mut rows: Vec<Sparse>, velocities: usize, partition: &Partition) -> Lu {
    let one = g.constant(1.0);
    let mut is_dependent = vec![false; velocities];
    let mut left: Vec<usize> = partition.pivots.iter().map(|pivot| pivot.row).collect();
    let (mut steps, mut worst): (Vec<Step>, Option<Node>) = (Vec::new(), None);
    for chosen in &partition.pivots {
        let (row, velocity) = (chosen.row, chosen.velocity);
        is_dependent[velocity] = true;
        left.retain(|other| *other != row);
        let mut entries = std::mem::take(&mut rows[row]);
        let pivot = entries.remove(&velocity).unwrap_or_else(|| g.constant(0.0));
        let inverse = g.unary(Unary::Reciprocal, pivot);
        if g.value(pivot).is_none() {
            let size = g.constant(chosen.size);
            let ratio = g.mul(inverse, size);
            let squared = g.mul(ratio, ratio);
            worst = Some(worst.map_or(squared, |worst| g.max(worst, squared)));
        }
        let upper: Vec<(usize, Node)> =
            entries.into_iter().map(|(column, entry)| (column, g.mul(entry, inverse))).collect();
        let mut lower = Vec::new();
        for other in &left {
            let Some(below) = rows[*other].remove(&velocity) else { continue };
            for (column, entry) in &upper {
                let product = g.mul(below, *entry);
                let zero = g.constant(0.0);
                let own = rows[*other].get(column).copied().unwrap_or(zero);
                let updated = g.sub(own, product);
                rows[*other].insert(*column, updated);
            }
            lower.push((*other, below));
        }
        steps.push(Step { row, velocity, inverse, upper, lower });
    }
    let pivot = worst.map_or(one, |worst| {
        let worst = g.max(worst, one);
        g.unary(Unary::Reciprocal, worst)
    });
    Lu { steps, is_dependent, pivot }
}

impl Lu {
    /// `v` with its dependent entries such that D v = `rows`.
    fn dependent(&self, g: &mut Graph, rows: &[Node], v: &[Node]) -> Vec<Node> {
        let mut y = rows.to_vec();
        for step in &self.steps {
            y[step.row] = g.mul(y[step.row], step.inverse);
            for (other, below) in &step.lower {
                let product = g.mul(*below, y[step.row]);
                y[*other] = g.sub(y[*other], product);
            }
        }
        let mut v = v.to_vec();
        for step in self.steps.iter().rev() {
            let mut rest = y[step.row];
            for (column, entry) in &step.upper {
                let product = g.mul(*entry, v[*column]);
                rest = g.sub(rest, product);
            }
            v[step.velocity] = rest;
        }
        v
    }

    /// The column of R that belongs to an independent velocity: 1 there, dependent entries with D R = 0.
    fn column(&self, g: &mut Graph, independent: usize) -> Sparse {
        let mut column = Sparse::from([(independent, g.constant(1.0))]);
        for step in self.steps.iter().rev() {
            let mut rest: Option<Node> = None;
            for (other, entry) in &step.upper {
                let Some(known) = column.get(other) else { continue };
                let product = g.mul(*entry, *known);
                rest = Some(match rest {
                    Some(rest) => g.sub(rest, product),
                    None => g.neg(product),
                });
            }
            if let Some(entry) = rest.filter(|entry| g.value(*entry) != Some(0.0)) {
                column.insert(step.velocity, entry);
            }
        }
        column
    }

    /// R z + S rows, by R or by U, whichever has fewer entries; the independent entries of `z` count.
    fn combine(
        &self,
        g: &mut Graph,
        basis: &[Sparse],
        rows: &[Node],
        independent: &[usize],
        z: &[Node],
    ) -> Vec<Node> {
        let in_basis: usize = basis.iter().map(|column| column.len() - 1).sum();
        let in_upper: usize = self.steps.iter().map(|step| step.upper.len()).sum();
        if in_upper < in_basis {
            return self.dependent(g, rows, z);
        }
        let none = zeros_of(g, z.len());
        let mut sum = self.dependent(g, rows, &none);
        for (velocity, column) in independent.iter().zip(basis) {
            for (at, entry) in column {
                let product = g.mul(*entry, z[*velocity]);
                sum[*at] = g.add(sum[*at], product);
            }
        }
        sum
    }

    /// λ of D_dᵀ λ = `forces` in the dependent velocities: Uᵀ, then Lᵀ.
    fn multipliers(&self, g: &mut Graph, mut forces: Vec<Node>, mut lambda: Vec<Node>) -> Vec<Node> {
        for step in &self.steps {
            for (column, entry) in step.upper.iter().filter(|(column, _)| self.is_dependent[*column]) {
                let product = g.mul(*entry, forces[step.velocity]);
                forces[*column] = g.sub(forces[*column], product);
            }
        }
        for step in self.steps.iter().rev() {
            let mut rest = forces[step.velocity];
            for (other, below) in &step.lower {
                let product = g.mul(*below, lambda[*other]);
                rest = g.sub(rest, product);
            }
            lambda[step.row] = g.mul(rest, step.inverse);
        }
        lambda
    }
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

fn zeros_of(g: &mut Graph, size: usize) -> Vec<Node> {
    vec![g.constant(0.0); size]
}

fn sparse(g: &Graph, entries: &[Node]) -> Sparse {
    let live = entries.iter().copied().enumerate().filter(|(_, entry)| g.value(*entry) != Some(0.0));
    live.collect()
}

fn dot(g: &mut Graph, a: &Sparse, b: &Sparse) -> Option<Node> {
    let mut sum: Option<Node> = None;
    for (at, x) in a {
        let Some(y) = b.get(at) else { continue };
        let product = g.mul(*x, *y);
        sum = Some(sum.map_or(product, |sum| g.add(sum, product)));
    }
    sum
}

/// Q − M a.
fn without(g: &mut Graph, forces: &[Node], mass: &Symmetric, a: &[Node]) -> Vec<Node> {
    let a = sparse(g, a);
    let product = mass.times(g, &a);
    let entry = |(at, x): (usize, &Node)| product.get(&at).map_or(*x, |y| g.sub(*x, *y));
    forces.iter().enumerate().map(entry).collect()
}
