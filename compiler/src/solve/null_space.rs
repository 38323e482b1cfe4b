//! The equations in independent velocities, written out: D = L U in the order that was chosen for it, a basis R of its null space,
//! and (Rᵀ M R) z̈ = Rᵀ (Q − M S γ).
//!
//! U has a unit diagonal (Crout), so that a right-hand side costs one product for each entry of L and of U. Which velocities are
//! dependent is fixed here; where their pivots degrade the runtime chooses others, by tables.

use super::elimination::{self, Entries, Kind};
use super::order::{self, Pattern};
use super::stored::frontier;
use crate::check::assemble::{Partition, Pivot};
use crate::equations::Equations;
use crate::symbolic::{Class, Graph, Node, Unary};
use std::collections::{BTreeMap, BTreeSet};

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
    NullSpace { kept, partition_pivot: lu.pivot, dependent, velocity, acceleration, lambda, pivot }
}

/// D = L U by blocks.
struct Lu {
    steps: Vec<Step>,
    is_dependent: Vec<bool>,
    /// The square of the smallest pivot, relative to its rows at the start.
    pivot: Node,
}

/// A pivot: one entry of D, or the square block of two or three rows and their velocities, with its inverse. Entries of such a
/// block vanish one by one where the mechanism is regular, as a rod turns past an axis; its determinant does not.
struct Step {
    rows: Vec<usize>,
    velocities: Vec<usize>,
    /// The inverse of the block: `inverse[velocity][row]`.
    inverse: Vec<Vec<Node>>,
    /// Columns of U beside the unit block.
    upper: Vec<(usize, Vec<Node>)>,
    /// Rows of L below the block.
    lower: Vec<(usize, Vec<Node>)>,
}

fn factor(g: &mut Graph, mut rows: Vec<Sparse>, velocities: usize, partition: &Partition) -> Lu {
    let mut is_dependent = vec![false; velocities];
    let mut left: Vec<usize> = partition.pivots().map(|pivot| pivot.row).collect();
    let (mut steps, mut watched) = (Vec::new(), Vec::new());
    for block in &partition.blocks {
        let mut block = block.clone();
        while !block.is_empty() {
            let taken = next(&mut block, &rows);
            left.retain(|other| taken.iter().all(|pivot| pivot.row != *other));
            taken.iter().for_each(|pivot| is_dependent[pivot.velocity] = true);
            let step = eliminate(g, &mut rows, &left, &taken, &mut watched);
            steps.push(step);
        }
    }
    let one = g.constant(1.0);
    let worst = watched.into_iter().fold(one, |worst, ratio| {
        let squared = g.mul(ratio, ratio);
        g.max(worst, squared)
    });
    Lu { steps, is_dependent, pivot: g.unary(Unary::Reciprocal, worst) }
}

/// What of a block is taken next: an entry that is alone in its row or column of the block, a factor of the determinant; else all.
fn next(block: &mut Vec<Pivot>, rows: &[Sparse]) -> Vec<Pivot> {
    let has = |row: usize, velocity: usize| rows[row].contains_key(&velocity);
    for (at, row) in block.iter().enumerate() {
        for (other, column) in block.iter().enumerate().filter(|(_, column)| has(row.row, column.velocity)) {
            let in_row = block.iter().filter(|pivot| has(row.row, pivot.velocity)).count();
            let in_column = block.iter().filter(|pivot| has(pivot.row, column.velocity)).count();
            if in_row > 1 && in_column > 1 {
                continue;
            }
            // What is left keeps its rows and velocities, paired anew.
            let alone = Pivot { velocity: column.velocity, size: column.size, ..*row };
            let (velocity, size) = (row.velocity, row.size);
            (block[other].velocity, block[other].size) = (velocity, size);
            block.remove(at);
            return vec![alone];
        }
    }
    std::mem::take(block)
}

/// Takes a block of pivots out of the rows that are left.
fn eliminate(
    g: &mut Graph,
    rows: &mut [Sparse],
    left: &[usize],
    pivots: &[Pivot],
    watched: &mut Vec<Node>,
) -> Step {
    let velocities: Vec<usize> = pivots.iter().map(|pivot| pivot.velocity).collect();
    let zero = g.constant(0.0);
    let take = |row: &mut Sparse| -> Option<Vec<Node>> {
        let entries: Vec<Option<Node>> = velocities.iter().map(|velocity| row.remove(velocity)).collect();
        let some = entries.iter().any(Option::is_some);
        some.then(|| entries.into_iter().map(|entry| entry.unwrap_or(zero)).collect())
    };
    let mut own: Vec<Sparse> = pivots.iter().map(|pivot| std::mem::take(&mut rows[pivot.row])).collect();
    let square: Vec<Vec<Node>> =
        own.iter_mut().map(|row| take(row).unwrap_or_else(|| vec![zero; pivots.len()])).collect();
    let (determinant, inverse) = invert(g, &square);
    if g.value(determinant).is_none() {
        let size = g.constant(pivots.iter().map(|pivot| pivot.size).product());
        let reciprocal = g.unary(Unary::Reciprocal, determinant);
        watched.push(g.mul(reciprocal, size));
    }
    let columns: BTreeSet<usize> = own.iter().flat_map(|row| row.keys().copied()).collect();
    let upper: Vec<(usize, Vec<Node>)> = columns
        .into_iter()
        .map(|column| {
            let entries: Vec<Node> =
                own.iter().map(|row| row.get(&column).copied().unwrap_or(zero)).collect();
            (column, inverse.iter().map(|row| product(g, row, &entries)).collect())
        })
        .collect();
    let mut lower = Vec::new();
    for other in left {
        let Some(below) = take(&mut rows[*other]) else { continue };
        for (column, entries) in &upper {
            let taken = product(g, &below, entries);
            let entry = rows[*other].get(column).copied().unwrap_or(zero);
            let updated = g.sub(entry, taken);
            if g.value(updated) == Some(0.0) {
                rows[*other].remove(column);
            } else {
                rows[*other].insert(*column, updated);
            }
        }
        lower.push((*other, below));
    }
    Step { rows: pivots.iter().map(|pivot| pivot.row).collect(), velocities, inverse, upper, lower }
}

/// Determinant and inverse of a matrix of one, two or three rows, by cofactors.
fn invert(g: &mut Graph, a: &[Vec<Node>]) -> (Node, Vec<Vec<Node>>) {
    let size = a.len();
    let cofactor = |g: &mut Graph, row: usize, column: usize| match size {
        1 => g.constant(1.0),
        2 => {
            let entry = a[1 - row][1 - column];
            if row == column { entry } else { g.neg(entry) }
        }
        _ => {
            // Cyclic, so that the sign is that of the determinant.
            let ((r, s), (c, d)) = (((row + 1) % 3, (row + 2) % 3), ((column + 1) % 3, (column + 2) % 3));
            let (plus, minus) = (g.mul(a[r][c], a[s][d]), g.mul(a[r][d], a[s][c]));
            g.sub(plus, minus)
        }
    };
    let cofactors: Vec<Vec<Node>> =
        (0..size).map(|row| (0..size).map(|column| cofactor(g, row, column)).collect()).collect();
    let determinant = product(g, &a[0], &cofactors[0]);
    let reciprocal = g.unary(Unary::Reciprocal, determinant);
    let transposed = |velocity: usize| -> Vec<Node> { cofactors.iter().map(|row| row[velocity]).collect() };
    let inverse = (0..size)
        .map(|velocity| {
            transposed(velocity).into_iter().map(|cofactor| g.mul(cofactor, reciprocal)).collect()
        })
        .collect();
    (determinant, inverse)
}

/// Σ aᵢ bᵢ.
fn product(g: &mut Graph, a: &[Node], b: &[Node]) -> Node {
    let terms: Vec<Node> = a.iter().zip(b).map(|(a, b)| g.mul(*a, *b)).collect();
    g.sum(terms)
}

fn pick(values: &[Node], places: &[usize]) -> Vec<Node> {
    places.iter().map(|place| values[*place]).collect()
}

impl Lu {
    /// `v` with its dependent entries such that D v = `rows`.
    fn dependent(&self, g: &mut Graph, rows: &[Node], v: &[Node]) -> Vec<Node> {
        let (mut y, mut v) = (rows.to_vec(), v.to_vec());
        for step in &self.steps {
            let given = pick(&y, &step.rows);
            // From here on y has, at the rows of a step, what belongs to its velocities.
            let own: Vec<Node> = step.inverse.iter().map(|row| product(g, row, &given)).collect();
            for (row, value) in step.rows.iter().zip(&own) {
                y[*row] = *value;
            }
            for (other, below) in &step.lower {
                let taken = product(g, below, &own);
                y[*other] = g.sub(y[*other], taken);
            }
        }
        for step in self.steps.iter().rev() {
            for (k, velocity) in step.velocities.iter().enumerate() {
                let mut rest = y[step.rows[k]];
                for (column, entries) in &step.upper {
                    let term = g.mul(entries[k], v[*column]);
                    rest = g.sub(rest, term);
                }
                v[*velocity] = rest;
            }
        }
        v
    }

    /// The column of R that belongs to an independent velocity: 1 there, dependent entries with D R = 0.
    fn column(&self, g: &mut Graph, independent: usize) -> Sparse {
        let mut column = Sparse::from([(independent, g.constant(1.0))]);
        for step in self.steps.iter().rev() {
            for (k, velocity) in step.velocities.iter().enumerate() {
                let mut rest = g.constant(0.0);
                for (other, entries) in &step.upper {
                    let Some(known) = column.get(other) else { continue };
                    let term = g.mul(entries[k], *known);
                    rest = g.sub(rest, term);
                }
                if g.value(rest) != Some(0.0) {
                    column.insert(*velocity, rest);
                }
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
        let in_upper: usize = self.steps.iter().map(|step| step.upper.len() * step.rows.len()).sum();
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
            let own = pick(&forces, &step.velocities);
            for (column, entries) in step.upper.iter().filter(|(column, _)| self.is_dependent[*column]) {
                let taken = product(g, entries, &own);
                forces[*column] = g.sub(forces[*column], taken);
            }
        }
        for step in self.steps.iter().rev() {
            let mut rest = pick(&forces, &step.velocities);
            for (other, below) in &step.lower {
                for (rest, entry) in rest.iter_mut().zip(below) {
                    let taken = g.mul(*entry, lambda[*other]);
                    *rest = g.sub(*rest, taken);
                }
            }
            for (k, row) in step.rows.iter().enumerate() {
                let column: Vec<Node> = step.inverse.iter().map(|inverse| inverse[k]).collect();
                lambda[*row] = product(g, &column, &rest);
            }
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
