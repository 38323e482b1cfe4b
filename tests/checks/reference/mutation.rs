//! A wrong sign cannot ship: every sign of the derived graph is flipped and every term dropped, one at a time, and the
//! recorded reference must notice each.

use super::recorded::{Record, record};
use super::{SETS, compiled, recorded_models};
use linkwright_compiler::Compiled;
use linkwright_compiler::functions::Argument;
use linkwright_compiler::model::{Coordinates, Space};
use linkwright_compiler::schedule::{Function, Inputs, Source, outputs, sources};
use linkwright_compiler::symbolic::{Node, Op, Unary, evaluate_with};
use mechanisms::mutants::{self, Mutant};
use std::cell::RefCell;
use std::collections::BTreeMap;

/// The models mutated: loops with general bodies; slots, slides and loads; time, springs and particles; teeth that give; beams
/// that bend and shear; in space a loop with a ball and a cross, a chain of all that screws and slides with a particle, a driven loop of
/// constant-velocity joints, a long tree; rigid contacts that rub.
pub const MODELS: [&str; 10] = [
    "general_four_bar",
    "quick_return",
    "car_axis",
    "crank",
    "gear_pair",
    "gripping_in_space",
    "jack",
    "shafts",
    "sheared",
    "snake",
];

/// Functions that the reference judges.
const JUDGED: [Function; 20] = [
    Function::MassMatrix,
    Function::Constraints,
    Function::ConstraintJacobian,
    Function::Nu,
    Function::Gamma,
    Function::Forces,
    Function::KineticEnergy,
    Function::PotentialEnergy,
    Function::Powers,
    Function::Guards,
    Function::Strikes,
    Function::Acceleration,
    Function::AccelerationBaumgarte,
    Function::NullSpace,
    Function::NullSpaceBaumgarte,
    Function::Motions,
    Function::Reactions,
    Function::DriverEfforts,
    Function::Masses,
    Function::RowScales,
];

#[test]
fn every_mutant_is_caught() {
    let mut survivors = Vec::new();
    let mut mutants = 0;
    for (name, source, _) in recorded_models().iter().filter(|(name, ..)| MODELS.contains(name)) {
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

/// By what factor a row's size may be off: as the condition that its pivots stand for (`checks/rank.rs`).
const MEASURED: f64 = 30.0;
/// What vanishes to rounding, in units of one or of the terms that formed it.
const VANISHES: f64 = 1e-12;
/// The same away from consistent states, where the elimination may have lost digits.
const VANISHES_ANYWHERE: f64 = 1e-9;

struct Judge<'a> {
    compiled: &'a Compiled,
    record: &'a Record,
    sources: Vec<Source>,
    outputs: BTreeMap<Function, Vec<Node>>,
    needed: Vec<Node>,
}

impl<'a> Judge<'a> {
    fn new(compiled: &'a Compiled, record: &'a Record) -> Self {
        let outputs: BTreeMap<Function, Vec<Node>> =
            JUDGED.iter().map(|function| (*function, outputs(&compiled.complete, *function))).collect();
        let needed = compiled.complete.equations.graph.read().reachable(outputs.values().flatten().copied());
        Judge { compiled, record, sources: sources(&compiled.complete), outputs, needed }
    }

    fn verdict(&self, change: Option<(Node, Op)>) -> Option<String> {
        // Functions are asked for one after the other at the same symbols.
        let latest: RefCell<(Vec<f64>, Vec<f64>)> = RefCell::default();
        let evaluate = |function: Function, inputs: &Inputs| {
            if function == Function::Prepare {
                return Vec::new();
            }
            let symbols: Vec<f64> = self.sources.iter().map(|source| self.symbol(*source, inputs)).collect();
            if function == Function::RowScales {
                // What pivots are measured by is as it should be, whatever changed.
                let values = evaluate_with(
                    &self.compiled.complete.equations.graph.read(),
                    &self.needed,
                    &symbols,
                    None,
                );
                return self.outputs[&function].iter().map(|node| values[node.index()]).collect();
            }
            let (known, values) = &mut *latest.borrow_mut();
            if values.is_empty() || *known != symbols {
                *values = evaluate_with(
                    &self.compiled.complete.equations.graph.read(),
                    &self.needed,
                    &symbols,
                    change,
                );
                *known = symbols;
            }
            self.outputs[&function].iter().map(|node| values[node.index()]).collect()
        };
        let measured = |function: Function, inputs: &Inputs| {
            if function == Function::Prepare {
                return Vec::new();
            }
            let symbols: Vec<f64> = self.sources.iter().map(|source| self.symbol(*source, inputs)).collect();
            let values =
                evaluate_with(&self.compiled.complete.equations.graph.read(), &self.needed, &symbols, change);
            self.outputs[&function].iter().map(|node| values[node.index()]).collect()
        };
        let differs = self.record.difference(self.compiled, &evaluate);
        differs.or_else(|| self.record.measures(self.compiled, &measured))
    }

    /// v̇ and λ are not known before they are solved for, nor are conditions' targets.
    fn symbol(&self, source: Source, inputs: &Inputs) -> f64 {
        match source.argument {
            Argument::Acceleration | Argument::Lambda => {
                inputs.of(source.argument).get(source.index as usize).copied().unwrap_or(0.0)
            }
            // Of functions that are not judged here.
            Argument::Target
            | Argument::GivenForces
            | Argument::GivenRows
            | Argument::Store
            | Argument::Lu => 0.0,
            _ => inputs.get(source),
        }
    }

    /// Flipped signs and dropped terms of every sum, difference and negation.
    fn mutations(&self) -> Vec<Mutant> {
        // Independent velocities are judged where they may lead: in absolute coordinates of trees, whose recorded states are near dead
        // centres of theirs, rounding hides small terms.
        let leads = |function: &Function| {
            function.pair() != Some(1) || self.compiled.choice.coordinates == Coordinates::Tree
        };
        // Forces of rigid contacts are drawn: some of them move a light body so much that what others do is rounding beside it.
        let is_judged = |function: &Function| {
            leads(function) && (*function != Function::Motions || !self.compiled.mechanism.is_rigid())
        };
        let judged = self.outputs.iter().filter(|(function, _)| is_judged(function));
        let roots = judged.flat_map(|(_, nodes)| nodes).copied();
        let equations = &self.compiled.complete.equations;
        let graph = equations.graph.read();
        mutants::mutants(&graph, &graph.reachable(roots), equations.zero)
    }

    /// Changes that change nothing, and why.
    fn equivalence(&self, node: Node, change: Op) -> Option<&'static str> {
        let graph = &self.compiled.complete.equations.graph.read();
        let negates = mutants::negates(graph, node, change);
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
        if !is_output && self.is_whole_turns(node, change) && uses.clone().count() > 0 {
            let periodic = |op: &Op| matches!(op, Op::Unary(Unary::Cos | Unary::Sin, _));
            if uses.clone().all(periodic) {
                return Some("whole turns within a sine or cosine");
            }
        }
        if self.measures_only(node) && self.measures_alike(node, change) {
            return Some("what a row is measured by, within what the rank along the motion is known to");
        }
        // A prismatic joint exerts nothing along its axis, and no torque on a body whose forces all meet at its centre. What
        // is judged at consistent states only may vanish there.
        let anywhere: Vec<Node> = self.outputs_of(|function| function != Function::Reactions);
        let reactions_only = !graph.reachable(anywhere).contains(&node);
        let consistent = self.record.inputs(self.compiled, true);
        if negates && reactions_only && self.changes_nothing(node, change, &consistent, VANISHES) {
            return Some("a component of a reaction that this mechanism never exerts");
        }
        if self.compiled.mechanism.space == Space::Planar {
            return None;
        }
        // Where constant rotations should cancel, their rounding is left as a factor.
        let is_rounding =
            |node: Node| matches!(graph.op(node), Op::Constant(bits) if f64::from_bits(bits).abs() < 1e-15);
        let negligible =
            |node: Node| matches!(graph.op(node), Op::Mul(a, b) if is_rounding(a) || is_rounding(b));
        if !graph.reachable_until(self.outputs_of(|_| true), negligible).contains(&node) {
            return Some("multiplied by the rounding of a constant");
        }
        // In space components vanish where a body keeps to a plane or an axis, and so does fill of the elimination.
        let at_consistent = [Function::Motions, Function::Reactions, Function::DriverEfforts];
        let anywhere: Vec<Node> = self.outputs_of(|function| !at_consistent.contains(&function));
        if !self.changes_nothing(node, change, &consistent, VANISHES) {
            return None;
        }
        if !graph.reachable(anywhere).contains(&node) {
            return Some("a term that vanishes wherever the mechanism can be");
        }
        let others = self.record.inputs(self.compiled, false);
        let everywhere = self.changes_nothing(node, change, &others, VANISHES_ANYWHERE);
        everywhere.then_some("a term that vanishes everywhere")
    }

    /// Whether an angle is changed by nothing but what its whole turns count for.
    fn is_whole_turns(&self, node: Node, change: Op) -> bool {
        let equations = &self.compiled.complete.equations;
        let (graph, layout) = (equations.graph.read(), &equations.layout);
        let counts = |node: Node| {
            let entries = (0..layout.angles.len()).map(|angle| equations.symbols.q[layout.turns(angle)]);
            let is_turn = |constant: Node| matches!(graph.op(constant), Op::Constant(bits) if f64::from_bits(bits) == std::f64::consts::TAU);
            let turns: Vec<Node> = entries.collect();
            matches!(graph.op(node), Op::Mul(a, b) if is_turn(a) && turns.contains(&b) || is_turn(b) && turns.contains(&a))
        };
        match (graph.op(node), change) {
            (Op::Add(a, b), Op::Add(c, _) | Op::Sub(c, _)) => c == a && counts(b) || c == b && counts(a),
            _ => false,
        }
    }

    /// Whether the node has a part in nothing but the size that a row's pivot is divided by.
    fn measures_only(&self, node: Node) -> bool {
        let others = self.outputs.iter().flat_map(|(function, nodes)| match function {
            Function::RowScales => &[],
            // The pivot is the last.
            function if function.pair().is_some() => &nodes[..nodes.len().saturating_sub(1)],
            _ => &nodes[..],
        });
        !self.compiled.complete.equations.graph.read().reachable(others.copied()).contains(&node)
    }

    /// Whether rows are measured by the same to within [`MEASURED`], for all parameters that were recorded.
    fn measures_alike(&self, node: Node, change: Op) -> bool {
        let graph = &self.compiled.complete.equations.graph.read();
        let states = [true, false].map(|consistent| self.record.inputs(self.compiled, consistent));
        states.iter().flatten().all(|inputs| {
            let symbols: Vec<f64> = self.sources.iter().map(|source| self.symbol(*source, inputs)).collect();
            let scales = |change| {
                let values = evaluate_with(graph, &self.needed, &symbols, change);
                self.outputs[&Function::RowScales].iter().map(|node| values[node.index()]).collect::<Vec<_>>()
            };
            let ratios =
                scales(Some((node, change))).into_iter().zip(scales(None)).map(|(own, right)| own / right);
            ratios.into_iter().all(|ratio| (1.0 / MEASURED..MEASURED).contains(&ratio))
        })
    }

    fn outputs_of(&self, wanted: impl Fn(Function) -> bool) -> Vec<Node> {
        let functions = self.outputs.iter().filter(|(function, _)| wanted(**function));
        functions.flat_map(|(_, nodes)| nodes.iter().copied()).collect()
    }

    /// Whether the node's value is the same, to within `tolerance` of its terms, in all these states.
    fn changes_nothing(&self, node: Node, change: Op, states: &[Inputs], tolerance: f64) -> bool {
        let graph = &self.compiled.complete.equations.graph.read();
        states.iter().all(|inputs| {
            let symbols: Vec<f64> = self.sources.iter().map(|source| self.symbol(*source, inputs)).collect();
            let values = |change| evaluate_with(graph, &self.needed, &symbols, change);
            let (plain, changed) = (values(None), values(Some((node, change))));
            let terms = graph.op(node).operands().map(|operand| plain[operand.index()].abs());
            (changed[node.index()] - plain[node.index()]).abs() <= tolerance * terms.fold(1.0, f64::max)
        })
    }

    fn describe(&self, node: Node) -> String {
        let graph = &self.compiled.complete.equations.graph.read();
        let users: Vec<&str> = self
            .outputs
            .iter()
            .filter(|(_, nodes)| graph.reachable(nodes.iter().copied()).contains(&node))
            .map(|(function, _)| function.name())
            .collect();
        format!("{}, used by {}", mutants::describe(graph, node), users.join(", "))
    }
}
