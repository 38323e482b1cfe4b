//! Derivatives of the equations, exact: of r = M a + Dᵀ λ − Q, of the rows, of the independent coordinates and of the outputs.
//!
//! Positions are no vector space, so derivatives by them are along increments δ of the velocities' kind, q ⊕ δ at δ = 0:
//!
//! ```text
//! linear      ∂q = δ
//! pair        ∂c = −s δ, ∂s = c δ
//! quaternion  ∂q = ½ q ⊗ (0, δ), δ in the turned axes
//! multi-turn  ∂remainder = Σ weight·δ[index]
//! ```
//! a and λ are given, not solved for: what they are by the equations of motion is differentiated at run time, implicitly.

use super::coordinates::{Layout, Symbols};
use super::{Equations, Jet};
use crate::symbolic::{Gradient, Graph, Node};
use std::collections::BTreeMap;

/// A sparse matrix, row by row.
pub type Matrix = Vec<Gradient>;

/// What `options { emit = (tangent) }` asks for.
#[derive(Clone, Debug)]
pub struct Tangents {
    /// r = M a + Dᵀ λ − Q.
    pub residual: Vec<Node>,
    /// ∂r/∂q, ∂r/∂v and ∂r/∂u.
    pub stiffness: Matrix,
    pub damping: Matrix,
    pub input: Matrix,
    /// ∂(D a − γ)/∂q and ∂(D a − γ)/∂v.
    pub row_stiffness: Matrix,
    pub row_damping: Matrix,
    /// ∂(D v − ν)/∂q.
    pub rate: Matrix,
    /// By the parameters: of r, then D a − γ, D v − ν, Φ, then the outputs.
    pub parameter: Matrix,
    /// Of the outputs, with λ as given, by q, then v, u, λ.
    pub output: Matrix,
    /// Of ż, then z̈, of the coordinates `states` by q, then v.
    pub coordinate: Matrix,
    /// Indices into the conditions: the independent coordinates, completed to one for each degree of freedom.
    pub states: Vec<usize>,
}

impl Tangents {
    /// Derives all of them.
    pub fn new(equations: &mut Equations, states: Vec<usize>) -> Self {
        let residual = residual(equations);
        let Equations { graph: g, symbols, layout, rows, conditions, unsolved_outputs: outputs, .. } =
            equations;
        let n = layout.velocities();
        let Symbols { v, inputs, lambda, parameters, acceleration: a, .. } = &*symbols;

        let along = Seed::of(g).positions(g, layout, &symbols.q);
        let state = along.then(v);
        let all = state.then(inputs).then(lambda);

        let by_state = g.differentiate(&residual, &all.gradients);
        let [stiffness, damping, input, _] = split(&by_state, [n, n, inputs.len(), lambda.len()]);

        let accelerations: Vec<Node> = rows.iter().map(|row| row.jet.acceleration(g, a)).collect();
        let rates: Vec<Node> = rows.iter().map(|row| row.jet.rate(g, v)).collect();
        let [row_stiffness, row_damping] = split(&g.differentiate(&accelerations, &state.gradients), [n, n]);
        let rate = g.differentiate(&rates, &along.gradients);

        let values = rows.iter().map(|row| row.jet.value);
        let designed: Vec<Node> = residual.iter().chain(&accelerations).chain(&rates).copied().collect();
        let designed: Vec<Node> = designed.into_iter().chain(values).chain(outputs.iter().copied()).collect();
        let by_parameters = Seed::of(g).then(parameters);
        let parameter = g.differentiate(&designed, &by_parameters.gradients);
        let output = g.differentiate(outputs, &all.gradients);

        let jets: Vec<&Jet> = states.iter().map(|index| &conditions[*index].jet).collect();
        let mut motion: Vec<Node> = jets.iter().map(|jet| jet.rate(g, v)).collect();
        motion.extend(jets.iter().map(|jet| jet.acceleration(g, a)).collect::<Vec<_>>());
        let coordinate = g.differentiate(&motion, &state.gradients);
        Tangents {
            residual,
            stiffness,
            damping,
            input,
            row_stiffness,
            row_damping,
            rate,
            parameter,
            output,
            coordinate,
            states,
        }
    }
}

/// r = M a + Dᵀ λ − Q in symbols for a and λ.
fn residual(equations: &mut Equations) -> Vec<Node> {
    let Equations { graph: g, symbols, rows, inverse, .. } = equations;
    let mut residual = inverse.clone();
    for (row, lambda) in rows.iter().zip(&symbols.lambda) {
        for (velocity, column) in &row.jet.columns {
            let force = g.mul(*column, *lambda);
            residual[*velocity] = g.add(residual[*velocity], force);
        }
    }
    residual
}

/// Of each symbol its derivatives by direction.
struct Seed {
    gradients: BTreeMap<Node, Gradient>,
    directions: usize,
    one: Node,
}

impl Seed {
    /// Everything held.
    fn of(g: &mut Graph) -> Self {
        Seed { gradients: BTreeMap::new(), directions: 0, one: g.constant(1.0) }
    }

    /// One more direction for each of these symbols.
    fn then(&self, symbols: &[Node]) -> Self {
        let own = |(k, symbol): (usize, &Node)| (*symbol, Gradient::from([(self.directions + k, self.one)]));
        let mut gradients = self.gradients.clone();
        gradients.extend(symbols.iter().enumerate().map(own));
        Seed { gradients, directions: self.directions + symbols.len(), one: self.one }
    }

    /// A direction for each velocity: the positions' increments of its kind.
    fn positions(mut self, g: &mut Graph, layout: &Layout, q: &[Node]) -> Self {
        let mut moves = |symbol: Node, direction: usize, derivative: Node| {
            self.gradients.entry(symbol).or_default().insert(direction, derivative);
        };
        for (index, symbol) in q.iter().enumerate().take(layout.linear.len()) {
            moves(*symbol, index, self.one);
        }
        for r in 0..layout.rotations.len() {
            let [c, s] = [q[layout.pair(r)], q[layout.pair(r) + 1]];
            let direction = layout.linear.len() + r;
            let minus = g.neg(s);
            moves(c, direction, minus);
            moves(s, direction, c);
        }
        let half = g.constant(0.5);
        for b in 0..layout.quaternions.len() {
            let first = layout.quaternion(b);
            let turned = std::array::from_fn(|k| g.mul(half, q[first + k]));
            for (axis, column) in quaternion_columns(g, turned).into_iter().enumerate() {
                for (k, derivative) in column.into_iter().enumerate() {
                    moves(q[first + k], layout.omega(b) + axis, derivative);
                }
            }
        }
        for (a, angle) in layout.angles.iter().enumerate() {
            for (velocity, weight) in &angle.rate {
                let weight = g.constant(*weight);
                moves(q[layout.turns(a) + 1], *velocity, weight);
            }
        }
        Seed { directions: layout.velocities(), ..self }
    }
}

/// q ⊗ (0, e) for the three axes e.
fn quaternion_columns(g: &mut Graph, [w, x, y, z]: [Node; 4]) -> [[Node; 4]; 3] {
    let [mx, my, mz] = [x, y, z].map(|entry| g.neg(entry));
    [[mx, w, z, my], [my, mz, w, x], [mz, y, mx, w]]
}

/// Blocks of columns of these widths, side by side.
fn split<const N: usize>(matrix: &Matrix, widths: [usize; N]) -> [Matrix; N] {
    let mut first = 0;
    widths.map(|width| {
        let block = |row: &Gradient| -> Gradient {
            row.range(first..first + width).map(|(column, entry)| (column - first, *entry)).collect()
        };
        let blocks = matrix.iter().map(block).collect();
        first += width;
        blocks
    })
}
