//! A wrong sign cannot ship: every sign of the derived graph is flipped and every term dropped, one at a time, and the
//! recorded reference must notice each.

use super::recorded::{Record, record};
use super::{SETS, compiled, models};
use linkwright_compiler::Compiled;
use linkwright_compiler::schedule::{Function, Inputs, Source, outputs, sources};
use linkwright_compiler::symbolic::{Node, Op, evaluate_with};
use std::collections::BTreeMap;

/// The models mutated: loops with general bodies; slots, slides and loads; time, springs and particles.
const MODELS: [&str; 3] = ["general_four_bar", "quick_return", "car_axis"];

/// Functions that the reference judges.
const JUDGED: [Function; 15] = [
    Function::MassMatrix,
    Function::Constraints,
    Function::ConstraintJacobian,
    Function::Nu,
    Function::Gamma,
    Function::Forces,
    Function::KineticEnergy,
    Function::PotentialEnergy,
    Function::Powers,
    Function::Acceleration,
    Function::AccelerationBaumgarte,
    Function::Motions,
    Function::Reactions,
    Function::DriverEfforts,
    Function::Masses,
];

#[test]
fn every_mutant_is_caught() {
    let mut survivors = Vec::new();
    let mut mutants = 0;
    for (name, source, _) in models().iter().filter(|(name, ..)| MODELS.contains(name)) {
        for (coordinates, set) in SETS {
            let compiled = compiled(source, coordinates);
            let record = record(name, set);
            let judge = Judge::new(&compiled, &record);
            assert_eq!(judge.verdict(None), None, "{name} in {set} coordinates, unchanged");
            for (node, change, what) in judge.mutations() {
                mutants += 1;
                if judge.verdict(Some((node, change))).is_some() {
                    continue;
                }
                let mutant = format!("{name} {set}: {what} at {}", judge.describe(node));
                match judge.equivalence(node, change) {
                    Some(reason) => println!("equivalent, {reason}: {mutant}"),
                    None => survivors.push(mutant),
                }
            }
        }
    }
    println!("{mutants} mutants, {} survivors", survivors.len());
    assert!(mutants > 1000, "only {mutants} mutants");
    assert!(survivors.is_empty(), "{}", survivors.join("\n"));
}

struct Judge<'a> {
    compiled: &'a Compiled,
    record: &'a Record,
    sources: Vec<Source>,
    outputs: BTreeMap<Function, Vec<Node>>,
    needed: Vec<Node>,
}

impl<'a> Judge<'a> {
    fn new(compiled: &'a Compiled, record: &'a Record) -> Self {
        let outputs: BTreeMap<Function, Vec<Node>> = JUDGED
            .iter()
            .map(|function| (*function, outputs(&compiled.equations, &compiled.solved, *function)))
            .collect();
        let needed = compiled.equations.graph.reachable(outputs.values().flatten().copied());
        Judge { compiled, record, sources: sources(&compiled.equations), outputs, needed }
    }

    fn verdict(&self, change: Option<(Node, Op)>) -> Option<String> {
        let evaluate = |function: Function, inputs: &Inputs| {
            if function == Function::Prepare {
                return Vec::new();
            }
            let symbols: Vec<f64> = self.sources.iter().map(|source| self.symbol(*source, inputs)).collect();
            let values = evaluate_with(&self.compiled.equations.graph, &self.needed, &symbols, change);
            self.outputs[&function].iter().map(|node| values[node.index()]).collect()
        };
        self.record.difference(self.compiled, &evaluate)
    }

    /// v̇ and λ are not known before they are solved for, nor are conditions' targets.
    fn symbol(&self, source: Source, inputs: &Inputs) -> f64 {
        match source {
            Source::Acceleration(index) => inputs.acceleration.get(index as usize).copied().unwrap_or(0.0),
            Source::Lambda(index) => inputs.lambda.get(index as usize).copied().unwrap_or(0.0),
            Source::Target(_) => 0.0,
            other => inputs.get(other),
        }
    }

    /// Flipped signs and dropped terms of every sum, difference and negation.
    fn mutations(&self) -> Vec<(Node, Op, &'static str)> {
        let zero = self.compiled.equations.zero;
        let mut found = Vec::new();
        for node in &self.needed {
            match self.compiled.equations.graph.op(*node) {
                Op::Add(a, b) => found.extend([
                    (*node, Op::Sub(a, b), "second sign flipped"),
                    (*node, Op::Sub(b, a), "first sign flipped"),
                    (*node, Op::Add(a, zero), "second term dropped"),
                    (*node, Op::Add(b, zero), "first term dropped"),
                ]),
                Op::Sub(a, b) => found.extend([
                    (*node, Op::Add(a, b), "second sign flipped"),
                    (*node, Op::Sub(b, a), "both signs flipped"),
                    (*node, Op::Add(a, zero), "second term dropped"),
                    (*node, Op::Sub(zero, b), "first term dropped"),
                ]),
                Op::Neg(a) => found.push((*node, Op::Add(a, zero), "negation dropped")),
                _ => {}
            }
        }
        found
    }

    /// Changes that change nothing, and why.
    fn equivalence(&self, node: Node, change: Op) -> Option<&'static str> {
        let graph = &self.compiled.equations.graph;
        let negates = match (graph.op(node), change) {
            (Op::Sub(a, b), Op::Sub(c, d)) => a == d && b == c,
            (Op::Neg(_), Op::Add(..)) => true,
            _ => false,
        };
        let users: Vec<Op> = self.needed.iter().map(|user| graph.op(*user)).collect();
        let uses = users.iter().filter(|op| op.operands().any(|operand| operand == node));
        let is_output = self.outputs.values().flatten().any(|output| *output == node);
        if negates
            && !is_output
            && uses.clone().count() > 0
            && uses.clone().all(|op| *op == Op::Mul(node, node))
        {
            return Some("only its square is used");
        }
        // A prismatic joint exerts nothing along its axis, and no torque on a body whose forces all meet at its centre.
        let judged = self.outputs.iter().filter(|(function, _)| **function != Function::Reactions);
        let elsewhere = graph.reachable(judged.flat_map(|(_, nodes)| nodes.iter().copied())).contains(&node);
        if negates && !elsewhere && self.vanishes(node) {
            return Some("a component of a reaction that this mechanism never exerts");
        }
        None
    }

    /// Zero to rounding at every consistent state.
    fn vanishes(&self, node: Node) -> bool {
        let graph = &self.compiled.equations.graph;
        self.record.consistent_inputs(self.compiled).iter().all(|inputs| {
            let symbols: Vec<f64> = self.sources.iter().map(|source| self.symbol(*source, inputs)).collect();
            let values = evaluate_with(graph, &self.needed, &symbols, None);
            let terms = graph.op(node).operands().map(|operand| values[operand.index()].abs());
            values[node.index()].abs() <= 1e-12 * terms.fold(1.0, f64::max)
        })
    }

    fn describe(&self, node: Node) -> String {
        let graph = &self.compiled.equations.graph;
        let name = |node: Node| match graph.op(node) {
            Op::Symbol(symbol) => graph.symbol_name(symbol).to_string(),
            Op::Constant(bits) => format!("{}", f64::from_bits(bits)),
            other => format!("{other:?}"),
        };
        let operands: Vec<String> = graph.op(node).operands().map(name).collect();
        let users: Vec<&str> = self
            .outputs
            .iter()
            .filter(|(_, nodes)| graph.reachable(nodes.iter().copied()).contains(&node))
            .map(|(function, _)| function.name())
            .collect();
        format!("{:?} of ({}), used by {}", graph.op(node), operands.join("; "), users.join(", "))
    }
}
