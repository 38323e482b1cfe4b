//! Derivatives of the equations, exact: of r = M a + Dᵀ λ − Q, of the rows, of the independent coordinates, of the rates of internal
//! states and of the outputs.
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
use super::{Condition, Equations, Jet};
use crate::symbolic::{Gradient, Node, Scalar, Sheet, all_bare};
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
    /// ∂r/∂z of the internal states.
    pub internal: Matrix,
    /// ∂(−Q_f)/∂(u, λ, z, a) of friction by reactions, which `input` and `internal` leave out.
    pub friction: Matrix,
    /// By the parameters: of r, then D a − γ, D v − ν, Φ, then the outputs, ż, and z at the start.
    pub parameter: Matrix,
    /// Of the outputs, with a and λ as given, by q, then v, u, λ, z, a.
    pub output: Matrix,
    /// Of ż of the internal states, likewise.
    pub internal_rate: Matrix,
    /// Of ṡ, then s̈, of the coordinates `states` by q, then v.
    pub coordinate: Matrix,
    /// Indices into the conditions: the independent coordinates, completed to one for each degree of freedom.
    pub states: Vec<usize>,
}

impl Tangents {
    /// Derives all of them.
    pub fn new(equations: &Equations, conditions: &[Condition], states: Vec<usize>) -> Self {
        let g = equations.graph.sheet();
        let residual = residual(g, equations);
        let Equations { symbols, layout, rows, outputs, .. } = equations;
        let n = layout.velocities();
        let Symbols { v, inputs, internal: z, lambda, parameters, acceleration: a, .. } = symbols;

        let along = Seed::of(g).positions(g, layout, &symbols.q);
        let state = along.then(v);
        let all = state.then(inputs).then(lambda).then(z);
        let differentiate = |of: &[Node], seed: &Seed| g.differentiate(of, &seed.gradients);

        let by_state = differentiate(&residual, &all);
        let [stiffness, damping, mut input, _, mut internal] =
            split(&by_state, [n, n, inputs.len(), lambda.len(), z.len()]);
        let mut friction = Matrix::new();
        if !equations.friction.is_none() {
            // What functions of the state alone may say is said without friction, which takes λ and a.
            let without = add_multipliers(g, equations, g.all(&equations.inverse));
            let by_state = differentiate(&without, &Seed::of(g).then(inputs).then(z));
            [input, internal] = split(&by_state, [inputs.len(), z.len()]);
            let rubbing: Vec<Node> =
                equations.friction.forces.iter().map(|force| (-g.on(*force)).bare).collect();
            friction = differentiate(&rubbing, &Seed::of(g).then(inputs).then(lambda).then(z).then(a));
        }

        let accelerations: Vec<Node> = rows.iter().map(|row| row.jet.acceleration(g, a).bare).collect();
        let rates: Vec<Node> = rows.iter().map(|row| row.jet.rate(g, v).bare).collect();
        let [row_stiffness, row_damping] = split(&differentiate(&accelerations, &state), [n, n]);
        let rate = differentiate(&rates, &along);

        let values = rows.iter().map(|row| row.jet.value);
        let designed: Vec<Node> = residual.iter().chain(&accelerations).chain(&rates).copied().collect();
        let designed = designed.into_iter().chain(values).chain(outputs.iter().copied());
        let designed: Vec<Node> = designed
            .chain(equations.internal_rates.iter().chain(&equations.internal_starts).copied())
            .collect();
        let parameter = differentiate(&designed, &Seed::of(g).then(parameters));
        let with_results = all.then(a);
        let output = differentiate(outputs, &with_results);
        let internal_rate = differentiate(&equations.internal_rates, &with_results);

        let jets: Vec<&Jet> = states.iter().map(|index| &conditions[*index].jet).collect();
        let mut motion: Vec<Node> = jets.iter().map(|jet| jet.rate(g, v).bare).collect();
        motion.extend(jets.iter().map(|jet| jet.acceleration(g, a).bare));
        let coordinate = differentiate(&motion, &state);
        Tangents {
            residual,
            stiffness,
            damping,
            input,
            row_stiffness,
            row_damping,
            rate,
            internal,
            friction,
            parameter,
            output,
            internal_rate,
            coordinate,
            states,
        }
    }
}

/// ∂s/∂p and ∂ṡ/∂p of the coordinates of these conditions, where q and v are held: by how much a coordinate is off when a parameter
/// moves the places that it is between. What is emitted has none of them.
pub fn coordinates_by_parameters(equations: &Equations, conditions: &[&Condition]) -> [Matrix; 2] {
    let g = equations.graph.sheet();
    let seed = Seed::of(g).then(&equations.symbols.parameters);
    let values: Vec<Node> = conditions.iter().map(|condition| condition.jet.value).collect();
    let rate = |condition: &&Condition| condition.jet.rate(g, &equations.symbols.v).bare;
    let rates: Vec<Node> = conditions.iter().map(rate).collect();
    [values, rates].map(|of| g.differentiate(&of, &seed.gradients))
}

/// r = M a + Dᵀ λ − Q − Q_f in symbols for a and λ.
fn residual(g: Sheet, equations: &Equations) -> Vec<Node> {
    let mut residual = g.all(&equations.inverse);
    for (residual, friction) in residual.iter_mut().zip(&equations.friction.forces) {
        *residual -= *friction;
    }
    add_multipliers(g, equations, residual)
}

/// + Dᵀ λ.
fn add_multipliers<'g>(g: Sheet<'g>, equations: &Equations, mut to: Vec<Scalar<'g>>) -> Vec<Node> {
    for (row, lambda) in equations.rows.iter().zip(&equations.symbols.lambda) {
        for (velocity, column) in &row.jet.columns {
            to[*velocity] += g.on(*column) * *lambda;
        }
    }
    all_bare(&to)
}

/// Of each symbol its derivatives by direction.
struct Seed {
    gradients: BTreeMap<Node, Gradient>,
    directions: usize,
    one: Node,
}

impl Seed {
    /// Everything held.
    fn of(g: Sheet) -> Self {
        Seed { gradients: BTreeMap::new(), directions: 0, one: g.one().bare }
    }

    /// One more direction for each of these symbols.
    fn then(&self, symbols: &[Node]) -> Self {
        let own = |(k, symbol): (usize, &Node)| (*symbol, Gradient::from([(self.directions + k, self.one)]));
        let mut gradients = self.gradients.clone();
        gradients.extend(symbols.iter().enumerate().map(own));
        Seed { gradients, directions: self.directions + symbols.len(), one: self.one }
    }

    /// A direction for each velocity: the positions' increments of its kind.
    fn positions(mut self, g: Sheet, layout: &Layout, q: &[Node]) -> Self {
        let mut moves = |symbol: Node, direction: usize, derivative: Node| {
            self.gradients.entry(symbol).or_default().insert(direction, derivative);
        };
        for (index, symbol) in q.iter().enumerate().take(layout.linear.len()) {
            moves(*symbol, index, self.one);
        }
        for r in 0..layout.rotations.len() {
            let [c, s] = [q[layout.pair(r)], q[layout.pair(r) + 1]];
            let direction = layout.linear.len() + r;
            moves(c, direction, (-g.on(s)).bare);
            moves(s, direction, c);
        }
        for b in 0..layout.quaternions.len() {
            let first = layout.quaternion(b);
            let half = [0, 1, 2, 3].map(|k| 0.5 * g.on(q[first + k]));
            for (axis, column) in quaternion_columns(half).into_iter().enumerate() {
                for (k, derivative) in column.into_iter().enumerate() {
                    moves(q[first + k], layout.omega(b) + axis, derivative.bare);
                }
            }
        }
        for (a, angle) in layout.angles.iter().enumerate() {
            for (velocity, weight) in &angle.rate {
                moves(q[layout.turns(a) + 1], *velocity, g.number(*weight).bare);
            }
        }
        Seed { directions: layout.velocities(), ..self }
    }
}

/// q ⊗ (0, e) for the three axes e.
fn quaternion_columns<'g>([w, x, y, z]: [Scalar<'g>; 4]) -> [[Scalar<'g>; 4]; 3] {
    let [mx, my, mz] = [-x, -y, -z];
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
