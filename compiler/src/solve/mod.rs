//! The linear solve, written out: accelerations and multipliers as nodes of the same graph.
//!
//! AFTER THIS POINT there is no linear system left, only expressions.

pub mod elimination;
pub mod order;
pub mod table;

use crate::equations::Equations;
use crate::symbolic::{Graph, Node};
use elimination::{Entries, Factor};
use order::{Order, Pattern};
use std::collections::{BTreeMap, BTreeSet};

/// v̇ and λ, and the smallest relative pivot met on the way.
#[derive(Clone, Debug)]
pub struct Solution {
    pub acceleration: Vec<Node>,
    pub lambda: Vec<Node>,
    pub pivot: Node,
}

/// Both default formulations, and how they were eliminated.
#[derive(Clone, Debug)]
pub struct Solved {
    pub index1: Solution,
    pub baumgarte: Solution,
    pub order: Order,
    /// Rows added to M, see [`Massless`].
    pub massless: Massless,
}

/// Velocities that carry no mass of their own. M is then singular, though positive definite on the admissible
/// velocities; with ρ Dᵀ D of the rows that hold those velocities added to M, and ρ Dᵀ γ to Q, the solution is
/// the same to the last digit in exact arithmetic, because D v̇ = γ, and every pivot is regular.
/// (García de Jalón & Bayo, Kinematic and Dynamic Simulation of Multibody Systems, section 5.1.4: the matrix of the
/// penalty method, here without its approximation.)
#[derive(Clone, Debug, Default)]
pub struct Massless {
    pub velocities: BTreeSet<usize>,
    pub rows: BTreeSet<usize>,
    /// ρ.
    pub weight: f64,
}

/// Solves for v̇ and λ, without stabilisation and with Baumgarte's:
/// D v̇ = γ − 2α (D v − ν) − β² Φ.
pub fn solve(equations: &mut Equations, massless: Massless) -> Solved {
    let n = equations.symbols.v.len();
    let columns: Vec<BTreeMap<usize, Node>> =
        equations.rows.iter().map(|row| row.jet.columns.clone()).collect();
    let g = &mut equations.graph;
    let rho = g.constant(massless.weight);

    let mut entries: Entries = equations.mass.clone();
    for row in &massless.rows {
        add_square(g, &mut entries, &columns[*row], rho);
    }
    for (row, columns) in columns.iter().enumerate() {
        entries.extend(columns.iter().map(|(velocity, column)| ((n + row, *velocity), *column)));
    }
    let pattern = Pattern::new(n, columns.len(), entries.keys().copied());
    let order = order::best(&pattern);
    let factor = elimination::factor(g, &entries, n, &order, !massless.rows.is_empty());

    let gamma = equations.gamma.clone();
    let stabilised: Vec<Node> = {
        let (two_alpha, beta_squared) = (equations.symbols.two_alpha, equations.symbols.beta_squared);
        let mut stabilised = Vec::new();
        for (row, gamma) in equations.rows.iter().zip(&gamma) {
            let rate = row.jet.rate(g, &equations.symbols.v);
            let damping = g.mul(two_alpha, rate);
            let stiffness = g.mul(beta_squared, row.jet.value);
            let sum = g.sub(*gamma, damping);
            stabilised.push(g.sub(sum, stiffness));
        }
        stabilised
    };
    let mut with = |gamma: &[Node]| {
        let mut rhs = equations.forces.clone();
        for row in &massless.rows {
            let weighted = g.mul(rho, gamma[*row]);
            for (velocity, column) in &columns[*row] {
                let term = g.mul(*column, weighted);
                rhs[*velocity] = g.add(rhs[*velocity], term);
            }
        }
        rhs.extend(gamma);
        solution(g, &factor, &rhs, n)
    };
    let (index1, baumgarte) = (with(&gamma), with(&stabilised));
    // Outputs that name drivers' efforts or powers take the multipliers of the plain solution.
    let solved = equations.symbols.lambda.iter().copied().zip(index1.lambda.iter().copied()).collect();
    equations.outputs = equations.graph.substitute(&equations.outputs, &solved);
    Solved { index1, baumgarte, order, massless }
}

fn solution(g: &mut Graph, factor: &Factor, rhs: &[Node], n: usize) -> Solution {
    let mut acceleration = factor.solve(g, rhs);
    let lambda = acceleration.split_off(n);
    Solution { acceleration, lambda, pivot: factor.pivot }
}

/// entries += ρ dᵀ d.
fn add_square(g: &mut Graph, entries: &mut Entries, row: &BTreeMap<usize, Node>, rho: Node) {
    let zero = g.constant(0.0);
    for (i, a) in row {
        let weighted = g.mul(rho, *a);
        for (j, b) in row.range(..=i) {
            let product = g.mul(weighted, *b);
            let own = entries.get(&(*i, *j)).copied().unwrap_or(zero);
            entries.insert((*i, *j), g.add(own, product));
        }
    }
}
