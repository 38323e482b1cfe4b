//! A wrong sign cannot ship, of what touches, rubs, yields and bends as well: every sign of the derived accelerations and rates of
//! internal states is flipped and every term dropped, one at a time, and the generic solver, which knows nothing of the graph, must notice
//! each at one of some states along the motion and with other velocities there.
//!
//! `tests/checks/reference/mutation.rs` does the same by recorded values of CasADi for what a recorded system has.

mod mapping;

use linkwright::{Fields, StateOf, Vector};
use linkwright_compiler::functions::Argument;
use linkwright_compiler::schedule::{Function, Source, outputs, sources};
use linkwright_compiler::symbolic::{Node, Op, Unary, evaluate_with};
use linkwright_compiler::{Compiled, compile};
use linkwright_generic::Mechanism;
use mapping::states::{Random, scattered, states};
use mapping::truth::{At, Truth};
use mechanisms::mutants::{self, Mutant};
use mechanisms::registry::Model;
use std::cell::RefCell;

/// From here on a difference is noticed; what is right differs by a hundredth at most.
const NOTICED: f64 = 1e-8;
const MOMENTS: usize = 6;
/// Of the terms of a sum: what changes less of it everywhere is rounding, as what cancels leaves it.
const VANISHES: f64 = 1e-12;
/// How far positions are moved at most, m and rad.
const SPREAD: f64 = 0.6;

struct Judge<'a, M: Model> {
    compiled: &'a Compiled,
    model: &'a M,
    coordinates: &'a str,
    sources: Vec<Source>,
    /// v̇ and λ, and ż.
    accelerations: Vec<Node>,
    rates: Vec<Node>,
    needed: Vec<Node>,
    cases: Vec<Case<M>>,
}

/// A state with what the generic solver says of it.
struct Case<M: Model> {
    time: f64,
    state: StateOf<M>,
    values: Vec<f64>,
    angles: Vec<f64>,
    truth: Truth,
}

impl<'a, M: Model> Judge<'a, M> {
    fn new(
        name: &str,
        compiled: &'a Compiled,
        model: &'a M,
        [definition, coordinates]: [&'a str; 2],
        seeds: u64,
    ) -> Self {
        let mut generic =
            Mechanism::from_definition(definition).unwrap_or_else(|error| panic!("{name}: {error}"));
        let mut cases = Vec::new();
        for seed in 0..seeds {
            let mut random = Random(seed);
            let values: Vec<f64> = M::Inputs::NAMES.iter().map(|_| random.unit()).collect();
            let mut angles = vec![0.0; generic.bodies().count()];
            let along = if seed == 0 { states(name, model, &values, MOMENTS, &mut random) } else { vec![] };
            let scattered = (0..MOMENTS).filter_map(|_| scattered(model, SPREAD, &mut random));
            for (time, state) in along.into_iter().chain(scattered) {
                let before = angles.clone();
                let motions = mapping::bodies(model, time, &state, &model.zero_v(), &mut angles);
                let modes = mapping::beams::modes(
                    coordinates,
                    state.q.as_slice(),
                    state.v.as_slice(),
                    model.zero_v().as_slice(),
                );
                let at = At {
                    time,
                    inputs: &values,
                    internal: state.z.as_slice(),
                    motions: &motions,
                    modes: &modes,
                };
                let truth = Truth::of(name, &mut generic, &at);
                cases.push(Case { time, state, values: values.clone(), angles: before, truth });
            }
        }
        let accelerations = outputs(&compiled.complete, Function::Acceleration);
        let rates = outputs(&compiled.complete, Function::InternalRates);
        let roots = accelerations.iter().chain(&rates).copied();
        let needed = compiled.complete.equations.graph.read().reachable(roots);
        Judge {
            compiled,
            model,
            coordinates,
            sources: sources(&compiled.complete),
            accelerations,
            rates,
            needed,
            cases,
        }
    }

    /// The values of all symbols at a case, with v̇ and λ once these are known.
    fn symbols(&self, case: &Case<M>, solved: Option<(&[f64], &[f64])>) -> Vec<f64> {
        let Case { time, state, values, .. } = case;
        let parameters = self.model.parameter_values();
        let symbol = |source: &Source| {
            let list: &[f64] = match source.argument {
                Argument::Time => std::slice::from_ref(time),
                Argument::Q => state.q.as_slice(),
                Argument::V => state.v.as_slice(),
                Argument::Z => state.z.as_slice(),
                Argument::Gates => state.gates.as_slice(),
                Argument::Inputs => values,
                Argument::Parameters => &parameters,
                Argument::Phases => &self.compiled.assembly.phases,
                Argument::Acceleration => solved.map_or(&[], |solved| solved.0),
                Argument::Lambda => solved.map_or(&[], |solved| solved.1),
                // Of other functions.
                _ => &[],
            };
            list.get(source.index as usize).copied().unwrap_or(0.0)
        };
        self.sources.iter().map(symbol).collect()
    }

    /// How far a graph with a change is off at a case, at most.
    fn difference(&self, case: &Case<M>, change: Option<(Node, Op)>) -> f64 {
        let Case { time, state, angles, truth, .. } = case;
        let graph = self.compiled.complete.equations.graph.read();
        let taken = |nodes: &[Node], solved| -> Vec<f64> {
            let found = evaluate_with(&graph, &self.needed, &self.symbols(case, solved), change);
            nodes.iter().map(|node| found[node.index()]).collect()
        };
        let solution = taken(&self.accelerations, None);
        let mut a = self.model.zero_v();
        let (accelerations, rest) = solution.split_at(a.as_slice().len());
        a.as_mut_slice().copy_from_slice(accelerations);
        let lambda = &rest[..self.model.zero_lambda().as_slice().len()];
        let rates =
            if self.rates.is_empty() { vec![] } else { taken(&self.rates, Some((accelerations, lambda))) };
        let motions = mapping::bodies(self.model, *time, state, &a, &mut angles.clone());
        let modes =
            mapping::beams::modes(self.coordinates, state.q.as_slice(), state.v.as_slice(), accelerations);
        truth.difference(&motions, &modes, &rates, &[])
    }

    fn is_noticed(&self, change: (Node, Op), first: &RefCell<usize>) -> bool {
        // What notices one mutant is likely to notice the next.
        let start = *first.borrow();
        let count = self.cases.len();
        let found = (0..count).map(|k| (start + k) % count).find(|case| {
            let difference = self.difference(&self.cases[*case], Some(change));
            difference.is_nan() || difference > NOTICED
        });
        if let Some(found) = found {
            *first.borrow_mut() = found;
        }
        found.is_some()
    }

    /// Flipped signs and dropped terms of every sum, difference and negation.
    fn mutations(&self) -> Vec<Mutant> {
        let equations = &self.compiled.complete.equations;
        mutants::mutants(&equations.graph.read(), &self.needed, equations.zero)
    }

    /// Changes that change nothing: what is only squared, or whose size alone counts.
    fn is_equivalent(&self, node: Node, change: Op) -> bool {
        let graph = self.compiled.complete.equations.graph.read();
        let negates = mutants::negates(&graph, node, change);
        let is_output = self.accelerations.iter().chain(&self.rates).any(|output| *output == node);
        let even =
            |op: &Op| matches!(op, Op::Unary(Unary::Abs | Unary::Cos, _)) || *op == Op::Mul(node, node);
        let mut users =
            self.needed.iter().map(|user| graph.op(*user)).filter(|op| op.operands().any(|it| it == node));
        negates && !is_output && users.all(|op| even(&op))
    }

    /// The most by which a change alters the value of its node, relative to the terms there.
    fn alters(&self, node: Node, change: Op) -> f64 {
        let graph = self.compiled.complete.equations.graph.read();
        let of = |case: &Case<M>| {
            let symbols = self.symbols(case, None);
            let plain = evaluate_with(&graph, &self.needed, &symbols, None);
            let changed = evaluate_with(&graph, &self.needed, &symbols, Some((node, change)));
            let largest =
                graph.op(node).operands().map(|it| plain[it.index()].abs()).fold(f64::MIN_POSITIVE, f64::max);
            (changed[node.index()] - plain[node.index()]).abs() / largest
        };
        self.cases.iter().map(of).fold(0.0, f64::max)
    }

    fn describe(&self, node: Node) -> String {
        let graph = self.compiled.complete.equations.graph.read();
        let users =
            self.needed.iter().map(|user| graph.op(*user)).filter(|op| op.operands().any(|it| it == node));
        let users: Vec<String> = users.map(|op| format!("{op:?}")).collect();
        format!("{}, used by {}", mutants::describe(&graph, node), users.join("; "))
    }
}

fn every_mutant_is_caught<M: Model>(name: &str, texts: [&str; 2], seeds: u64) {
    let tokens = M::source().parse().unwrap_or_else(|error| panic!("{error}"));
    let compiled = compile(tokens, None).unwrap_or_else(|errors| panic!("{errors}"));
    let model = M::standard();
    let judge = Judge::new(name, &compiled, &model, texts, seeds);
    for case in &judge.cases {
        let difference = judge.difference(case, None);
        assert!(difference < 0.01 * NOTICED, "{name} at {} s, unchanged: {difference:.1e}", case.time);
    }
    let first = RefCell::new(0);
    let mutations = judge.mutations();
    let survivors: Vec<String> = mutations
        .iter()
        .filter(|(node, change, _)| {
            !judge.is_noticed((*node, *change), &first) && !judge.is_equivalent(*node, *change)
        })
        .map(|(node, change, what)| {
            (judge.alters(*node, *change), format!("{what} at {}", judge.describe(*node)))
        })
        .filter(|(part, _)| *part > VANISHES)
        .map(|(part, text)| format!("{text}, {part:.1e} of its terms"))
        .collect();
    println!("{name}: {} mutants, {} survivors\n{}", mutations.len(), survivors.len(), survivors.join("\n"));
    assert!(mutations.len() > 100, "{name}: only {} mutants", mutations.len());
    assert!(survivors.is_empty(), "{name}:\n{}", survivors.join("\n"));
}

macro_rules! judged {
    ($($name:ident: $model:path, $seeds:literal),* $(,)?) => {
        $(#[test] fn $name() {
            use $model as Model;
            let texts = [Model::<f64>::DEFINITION, Model::<f64>::COORDINATES];
            every_mutant_is_caught::<Model<f64>>(stringify!($name), texts, $seeds);
        })*
    };
}

judged! {
    bent: mechanisms::zoo_beams::Bent, 20,
    bent_in_space: mechanisms::zoo_beams_in_space::BentInSpace, 20,
    loose_ball: mechanisms::zoo_loose::LooseBall, 20,
    loose_loop: mechanisms::zoo_loose::LooseLoop, 20,
    yielding_in_space: mechanisms::zoo_penalties::YieldingInSpace, 20,
}
