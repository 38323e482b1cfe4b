//! The equations at one state, by interpreting their graph.

use super::{Assembly, quaternion};
use crate::equations::{Equations, Jet};
use crate::model::Mechanism;
use crate::symbolic::{Node, Op, evaluate_reachable};

/// Values of the symbols, and of the nodes asked for.
pub struct Point<'a> {
    pub equations: &'a Equations,
    symbols: Vec<f64>,
    values: Vec<f64>,
    /// What memories hold.
    memories: Vec<f64>,
}

/// Nodes to be evaluated together, operands first.
pub struct Ancestry(Vec<Node>);

impl Ancestry {
    pub fn of(equations: &Equations, nodes: impl IntoIterator<Item = Node>) -> Self {
        Ancestry(equations.graph.read().reachable(nodes))
    }

    /// Value, columns and drift of jets.
    pub fn of_jets<'j>(equations: &Equations, jets: impl IntoIterator<Item = &'j Jet>) -> Self {
        let nodes = jets.into_iter().flat_map(|jet| {
            jet.columns.values().copied().chain([jet.value, jet.drift, jet.bias]).collect::<Vec<_>>()
        });
        Ancestry::of(equations, nodes)
    }
}

impl<'a> Point<'a> {
    /// All symbols zero.
    pub fn new(equations: &'a Equations) -> Self {
        let symbols = vec![0.0; equations.graph.read().symbol_count()];
        Point { equations, symbols, values: Vec::new(), memories: Vec::new() }
    }

    /// Parameters at their defaults, the phases of couplings, and memories as they start; the rest zero.
    pub fn at_defaults(mechanism: &Mechanism, equations: &'a Equations, phases: &[f64]) -> Self {
        let mut point = Point::new(equations);
        point.set(&equations.symbols.parameters, &mechanism.defaults());
        point.set(&equations.symbols.phases, phases);
        point.memories = mechanism.memories.iter().map(|memory| memory.start).collect();
        let behind = equations.symbols.gates.len() - point.memories.len();
        let memories = point.memories.clone();
        point.set(&equations.symbols.gates[behind..], &memories);
        point
    }

    /// The start of a mechanism at time zero, inputs zero.
    pub fn at_start(mechanism: &Mechanism, equations: &'a Equations, assembly: &Assembly) -> Self {
        let mut point = Point::at_defaults(mechanism, equations, &assembly.phases);
        point.set_q(&assembly.q);
        point.set_v(&assembly.v);
        point.set(&equations.symbols.internal, &mechanism.internal_starts());
        point.hold();
        point
    }

    /// The gates that are held as they are at this state.
    pub fn gates(&mut self) -> Vec<f64> {
        let equations = self.equations;
        if equations.guards.is_empty() {
            return Vec::new();
        }
        self.evaluate(&Ancestry::of(equations, equations.guards.iter().flatten().copied()));
        let guards = equations.guards.iter();
        let mut gates: Vec<f64> = guards.map(|guard| live(guard.map(|node| self.get(node)))).collect();
        // What is remembered depends on no guard.
        let first = gates.len() - self.memories.len();
        gates[first..].copy_from_slice(&self.memories);
        gates
    }

    /// Takes them so.
    pub fn hold(&mut self) {
        let gates = self.gates();
        let equations = self.equations;
        self.set(&equations.symbols.gates, &gates);
    }

    pub fn set(&mut self, nodes: &[Node], values: &[f64]) {
        for (node, value) in nodes.iter().zip(values) {
            if let Op::Symbol(symbol) = self.equations.graph.read().op(*node) {
                self.symbols[symbol as usize] = *value;
            }
        }
    }

    pub fn set_q(&mut self, q: &[f64]) {
        let equations = self.equations;
        self.set(&equations.symbols.q, q);
    }

    pub fn set_v(&mut self, v: &[f64]) {
        let equations = self.equations;
        self.set(&equations.symbols.v, v);
    }

    pub fn evaluate(&mut self, ancestry: &Ancestry) {
        evaluate_reachable(&self.equations.graph.read(), &ancestry.0, &self.symbols, &mut self.values);
    }

    /// Value of a node that the last evaluations reached.
    pub fn get(&self, node: Node) -> f64 {
        self.values[node.index()]
    }
}

/// The gate of a contact by its gap and the force of its law: 1 where surfaces are in one another and press, else 0.
pub fn live([gap, force]: [f64; 2]) -> f64 {
    if gap < 0.0 && force > 0.0 { 1.0 } else { 0.0 }
}

/// Moves q by an increment in the space of velocities: lengths add, pairs turn by the angle, quaternions by the
/// exponential of the triple, multi-turn angles grow by their rates.
pub fn retract(equations: &Equations, q: &[f64], increment: &[f64]) -> Vec<f64> {
    let layout = &equations.layout;
    let mut moved = q.to_vec();
    let linear = layout.linear.len();
    for (value, step) in moved.iter_mut().zip(&increment[..linear]) {
        *value += step;
    }
    for r in 0..layout.rotations.len() {
        let at = layout.pair(r);
        let (c, s) = (libm::cos(increment[linear + r]), libm::sin(increment[linear + r]));
        let (x, y) = (q[at] * c - q[at + 1] * s, q[at + 1] * c + q[at] * s);
        let length = (x * x + y * y).sqrt();
        (moved[at], moved[at + 1]) = (x / length, y / length);
    }
    for b in 0..layout.quaternions.len() {
        let (at, omega) = (layout.quaternion(b), layout.omega(b));
        let turned =
            quaternion::turn([0, 1, 2, 3].map(|k| q[at + k]), [0, 1, 2].map(|k| increment[omega + k]));
        moved[at..at + 4].copy_from_slice(&turned);
    }
    for (a, angle) in layout.angles.iter().enumerate() {
        let at = layout.turns(a);
        let step: f64 = angle.rate.iter().map(|(index, weight)| weight * increment[*index]).sum();
        let sum = moved[at + 1] + step;
        let whole = (sum / std::f64::consts::TAU).round();
        moved[at] += whole;
        moved[at + 1] = sum - whole * std::f64::consts::TAU;
    }
    moved
}
