//! A wrong sign cannot ship, of what touches, rubs, yields and bends as well: every sign of the derived accelerations and rates of
//! internal states is flipped and every term dropped, one at a time, and the generic solver, which knows nothing of the graph, must notice
//! each at one of some states along the motion and with other velocities there.
//!
//! A pass of Newton's method corrects what an earlier one did wrong. So friction by reactions is judged with one pass, which the generic solver takes
//! likewise; what Newton's method begins with on curves and in line contacts is not judged, nor where bars are nearest, of which their distance does not depend at
//! first order. `tests/checks/reference/mutation.rs` does the same by recorded values of CasADi for what a recorded system has.

mod mapping;

use linkwright::{AssembleExt, Fields, StateOf, Vector};
use linkwright_compiler::functions::Argument;
use linkwright_compiler::schedule::{Function, Source, outputs, sources};
use linkwright_compiler::symbolic::{Graph, Node, Op, Unary, evaluate_with};
use linkwright_compiler::{Compiled, compile};
use linkwright_generic::Mechanism;
use mapping::relevance::{TIE, distances};
use mapping::states::{Random, beside, is_within_half_a_turn, scattered, states};
use mapping::truth::{At, Truth};
use mechanisms::mutants::{self, Mutant};
use mechanisms::registry::Model;
use std::cell::RefCell;
use std::collections::BTreeSet;
use std::f64::consts::TAU;

const MOMENTS: usize = 6;
/// Of the terms of a sum: what changes less of it is rounding, and what changes less of it everywhere is what rounding leaves where terms cancel.
const VANISHES: f64 = 1e-12;
const CANCELS: f64 = 1e-10;
/// N²: what is added to the squares of forces, so that sizes are smooth.
const SMOOTHES: f64 = 1e-9;
/// And what is no rounding.
const ALTERS: f64 = 1e-6;
const SEEDS: u64 = 20;
/// How far positions are moved at most, m and rad.
const SPREAD: f64 = 0.6;
/// Cases wanted in which a term has a part, states drawn among which they are looked for, and tries to get there from the nearest of these.
const WANTED: usize = 3;
const MANY: usize = 20;
const DRAWN: usize = 1000;
const TRIES: usize = 100;
const LEAST_STEP: f64 = 1e-3;
/// Tries to get to where a change moves the results by so often what is noticed.
const PROVOKED: usize = 1000;
const PLAIN: f64 = 10.0;
/// By what factor more, or less, these are moved.
const FARTHER: f64 = 5.0;

/// How a mechanism is judged.
#[derive(Clone, Copy)]
struct Trial {
    /// From here on a difference is noticed; what is right differs by a hundredth at most.
    noticed: f64,
    /// Passes of friction by reactions, in place of those of the definition.
    passes: Option<usize>,
}

struct Judge<'a, M: Model> {
    compiled: &'a Compiled,
    trial: Trial,
    model: &'a M,
    coordinates: &'a str,
    /// The largest input.
    largest: f64,
    sources: Vec<Source>,
    /// v̇ and λ, and ż.
    accelerations: Vec<Node>,
    rates: Vec<Node>,
    needed: Vec<Node>,
    cases: Vec<Case<M>>,
}

struct Moment<M: Model> {
    time: f64,
    state: StateOf<M>,
    inputs: Vec<f64>,
}

/// A state that may become a case.
struct Drawn<M: Model> {
    moment: Moment<M>,
    /// By node, how far off it is from a part in the results.
    distances: Vec<f64>,
}

/// A state with what the generic solver says of it.
struct Case<M: Model> {
    moment: Moment<M>,
    angles: Vec<f64>,
    truth: Truth,
}

impl<'a, M: Model> Judge<'a, M> {
    fn new(
        name: &str,
        compiled: &'a Compiled,
        model: &'a M,
        [definition, coordinates]: [&'a str; 2],
        trial: Trial,
    ) -> (Self, Mechanism) {
        let accelerations = outputs(&compiled.complete, Function::Acceleration);
        let rates = outputs(&compiled.complete, Function::InternalRates);
        let roots = accelerations.iter().chain(&rates).copied();
        let needed = compiled.complete.equations.graph.read().reachable(roots);
        let sources = sources(&compiled.complete);
        let largest = mapping::largest_input(name);
        let mut judge = Judge {
            compiled,
            trial,
            model,
            coordinates,
            largest,
            sources,
            accelerations,
            rates,
            needed,
            cases: Vec::new(),
        };
        let mut generic =
            Mechanism::from_definition(definition).unwrap_or_else(|error| panic!("{name}: {error}"));
        generic.set_friction_passes(trial.passes);
        let still = vec![0.0; generic.bodies().count()];
        let start = model.start();
        let motions = mapping::bodies(model, 0.0, &start, &model.zero_v(), &mut still.clone());
        let begun = mapping::state(&generic, &motions, start.z.as_slice());
        // Which teeth are between which is as at the start.
        generic.keep_phases(0.0, &begun.q).unwrap_or_else(|error| panic!("{name}: {error}"));
        for seed in 0..SEEDS {
            let mut random = Random(seed);
            let inputs: Vec<f64> = M::Inputs::NAMES.iter().map(|_| largest * random.unit()).collect();
            let mut angles = still.clone();
            let along = if seed == 0 { states(name, model, &inputs, MOMENTS, &mut random) } else { vec![] };
            let scattered = (0..MOMENTS).filter_map(|_| scattered(model, SPREAD, &mut random));
            for (time, state) in along.into_iter().chain(scattered) {
                let moment = Moment { time, state, inputs: inputs.clone() };
                judge.add(name, moment, &mut angles, &mut generic);
            }
        }
        for moment in judge.with_all_terms(&mut Random(SEEDS)) {
            judge.add(name, moment, &mut still.clone(), &mut generic);
        }
        (judge, generic)
    }

    fn add(&mut self, name: &str, moment: Moment<M>, angles: &mut Vec<f64>, generic: &mut Mechanism) {
        let (model, Moment { time, state, inputs }) = (self.model, &moment);
        let before = angles.clone();
        let motions = mapping::bodies(model, *time, state, &model.zero_v(), angles);
        let modes = mapping::beams::modes(
            self.coordinates,
            state.q.as_slice(),
            state.v.as_slice(),
            model.zero_v().as_slice(),
        );
        let at = At { time: *time, inputs, internal: state.z.as_slice(), motions: &motions, modes: &modes };
        let truth = Truth::of(name, generic, &at);
        self.cases.push(Case { moment, angles: before, truth });
    }

    /// States at which each term that may be changed has a part in what is judged: among many that are drawn, and on from those of them which
    /// come nearest to that.
    fn with_all_terms(&self, random: &mut Random) -> Vec<Moment<M>> {
        let terms: BTreeSet<usize> = self.mutations().iter().map(|(node, ..)| node.index()).collect();
        let mut seen = vec![0; self.needed.iter().map(|node| node.index() + 1).max().unwrap_or(0)];
        // Whether any term has not had a part in as many before.
        let is_wanted = |distances: &[f64], seen: &mut Vec<usize>| {
            let has_part = terms.iter().filter(|term| distances[**term] <= TIE);
            has_part.fold(false, |is_wanted, term| {
                seen[*term] += 1;
                is_wanted || seen[*term] <= WANTED
            })
        };
        for case in &self.cases {
            is_wanted(&self.distances(&case.moment), &mut seen);
        }
        let start = self.model.start();
        let mut taken = Vec::new();
        let mut left = Vec::new();
        for _ in 0..DRAWN {
            let by = SPREAD * FARTHER.powf(random.unit());
            match self.draw(&start, by, random) {
                Some(drawn) if is_wanted(&drawn.distances, &mut seen) => taken.push(drawn.moment),
                Some(drawn) => left.push(drawn),
                None => {}
            }
        }
        for term in terms.iter().copied() {
            if seen[term] >= WANTED {
                continue;
            }
            left.sort_by(|a, b| a.distances[term].total_cmp(&b.distances[term]));
            for nearest in left.iter().take(WANTED) {
                if let Some(reached) = self.approach(nearest, term, random) {
                    is_wanted(&reached.distances, &mut seen);
                    taken.push(reached.moment);
                }
            }
        }
        taken
    }

    fn distances(&self, moment: &Moment<M>) -> Vec<f64> {
        let graph = self.compiled.complete.equations.graph.read();
        let values = evaluate_with(&graph, &self.needed, &self.symbols(moment, None), None);
        distances(&graph, &self.needed, &self.judged(), &values)
    }

    fn draw(&self, base: &StateOf<M>, by: f64, random: &mut Random) -> Option<Drawn<M>> {
        let inputs = M::Inputs::NAMES.iter().map(|_| self.largest * random.unit()).collect();
        let state = beside(self.model, base, [by, 2.0 * by], random)?;
        if !is_within_half_a_turn(self.model, &state) {
            return None;
        }
        let moment = Moment { time: 0.0, state, inputs };
        Some(Drawn { distances: self.distances(&moment), moment })
    }

    /// From one state on to others beside it that are nearer to where a term has a part.
    fn approach(&self, from: &Drawn<M>, term: usize, random: &mut Random) -> Option<Drawn<M>> {
        let (mut state, mut distance, mut step) = (from.moment.state, from.distances[term], SPREAD);
        if distance.is_infinite() {
            return None;
        }
        for _ in 0..TRIES {
            match self.draw(&state, step, random) {
                Some(drawn) if drawn.distances[term] <= TIE => return Some(drawn),
                Some(drawn) if drawn.distances[term] < distance => {
                    (state, distance) = (drawn.moment.state, drawn.distances[term]);
                }
                _ => step = (0.95 * step).max(LEAST_STEP),
            }
        }
        None
    }

    /// From state to state to one at which a change moves the results further, until it would be noticed.
    fn provoked(&self, change: (Node, Op), random: &mut Random) -> Option<Moment<M>> {
        let graph = self.compiled.complete.equations.graph.read();
        let results = self.judged();
        let moves = |moment: &Moment<M>| {
            let symbols = self.symbols(moment, None);
            let [plain, changed] =
                [None, Some(change)].map(|it| evaluate_with(&graph, &self.needed, &symbols, it));
            let largest = results.iter().map(|it| plain[it.index()].abs()).fold(1.0, f64::max);
            let moved = results.iter().map(|it| (changed[it.index()] - plain[it.index()]).abs());
            moved.fold(0.0, f64::max) / largest
        };
        let start = self.model.start();
        let (mut state, mut most, mut step) = (start, 0.0, FARTHER * SPREAD);
        for _ in 0..PROVOKED {
            let Some(drawn) = self.draw(&state, step, random) else { continue };
            let moved = moves(&drawn.moment);
            if moved > PLAIN * self.trial.noticed {
                return Some(drawn.moment);
            }
            if moved > most {
                (state, most) = (drawn.moment.state, moved);
            } else {
                step = (0.99 * step).max(LEAST_STEP);
            }
        }
        None
    }

    /// The values of all symbols at a moment, with v̇ and λ once these are known.
    fn symbols(&self, moment: &Moment<M>, solved: Option<(&[f64], &[f64])>) -> Vec<f64> {
        let Moment { time, state, inputs } = moment;
        let parameters = self.model.parameter_values();
        let symbol = |source: &Source| {
            let list: &[f64] = match source.argument {
                Argument::Time => std::slice::from_ref(time),
                Argument::Q => state.q.as_slice(),
                Argument::V => state.v.as_slice(),
                Argument::Z => state.z.as_slice(),
                Argument::Gates => state.gates.as_slice(),
                Argument::Inputs => inputs,
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
        let Case { moment, angles, truth } = case;
        let Moment { time, state, .. } = moment;
        let graph = self.compiled.complete.equations.graph.read();
        let taken = |nodes: &[Node], solved| -> Vec<f64> {
            let found = evaluate_with(&graph, &self.needed, &self.symbols(moment, solved), change);
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
            difference.is_nan() || difference > self.trial.noticed
        });
        if let Some(found) = found {
            *first.borrow_mut() = found;
        }
        found.is_some()
    }

    /// Flipped signs and dropped terms of every sum, difference and negation, but for whole turns: the orientation of a body does not say how
    /// often it has turned, and no state here has.
    fn mutations(&self) -> Vec<Mutant> {
        let equations = &self.compiled.complete.equations;
        let graph = equations.graph.read();
        let keeps_turns = |(node, change, _): &Mutant| {
            let Op::Add(a, b) = graph.op(*node) else { return true };
            let other = if is_turn(&graph, b) { a } else { b };
            let others = [Op::Add(other, equations.zero), Op::Sub(other, b), Op::Sub(other, a)];
            !(is_turn(&graph, a) || is_turn(&graph, b)) || !others.contains(change)
        };
        let mut found = mutants::mutants(&graph, &graph.reachable(self.judged()), equations.zero);
        found.retain(keeps_turns);
        found
    }

    /// v̇ and ż. Multipliers are judged where rates depend on them.
    fn judged(&self) -> Vec<Node> {
        let count = self.model.zero_v().as_slice().len();
        let graph = self.compiled.complete.equations.graph.read();
        let is_multiplier = |node: Node| match graph.op(node) {
            Op::Symbol(symbol) => self.sources[symbol as usize].argument == Argument::Lambda,
            _ => false,
        };
        let takes_multipliers = graph.reachable(self.rates.iter().copied()).into_iter().any(is_multiplier);
        let solved = if takes_multipliers { &self.accelerations } else { &self.accelerations[..count] };
        solved.iter().chain(&self.rates).copied().collect()
    }

    /// Changes that change nothing: what is only squared, or whose size alone counts.
    fn is_equivalent(&self, node: Node, change: Op) -> bool {
        let graph = self.compiled.complete.equations.graph.read();
        let negates = mutants::negates(&graph, node, change);
        let is_output = self.accelerations.iter().chain(&self.rates).any(|output| *output == node);
        let even =
            |op: &Op| matches!(op, Op::Unary(Unary::Abs | Unary::Cos, _)) || *op == Op::Mul(node, node);
        let turns = graph.op(node).operands().any(|it| is_turn(&graph, it));
        let users =
            || self.needed.iter().map(|user| graph.op(*user)).filter(|op| op.operands().any(|it| it == node));
        let negates = negates && users().all(|op| even(&op));
        if self.smoothes(&graph, node, change) {
            return true;
        }
        // Beyond its ends a bore is open however far away its wall is.
        if self.is_of_what_is_open(&graph, node) {
            return true;
        }
        // But for whole turns.
        let turned = turns && users().all(|op| matches!(op, Op::Unary(Unary::Cos, _)));
        // A counted angle may do no more than to move a body along its screw, which changes nothing else.
        let moved = turns && users().all(|op| matches!(op, Op::Mul(..)));
        !is_output && (negates || turned || moved)
    }

    /// Whether a change is one of ε² alone in ε² + R·R.
    fn smoothes(&self, graph: &Graph, node: Node, change: Op) -> bool {
        let Op::Add(a, b) = graph.op(node) else { return false };
        let is_small = graph.value(a).is_some_and(|value| value > 0.0 && value < SMOOTHES);
        is_small && [Op::Add(b, self.compiled.complete.equations.zero), Op::Sub(b, a)].contains(&change)
    }

    /// The most by which a change alters the value of its node, relative to the largest term there in any case.
    fn alters(&self, node: Node, change: Op) -> f64 {
        let graph = self.compiled.complete.equations.graph.read();
        let of = |case: &Case<M>| {
            let symbols = self.symbols(&case.moment, None);
            let plain = evaluate_with(&graph, &self.needed, &symbols, None);
            let changed = evaluate_with(&graph, &self.needed, &symbols, Some((node, change)));
            let terms = graph.op(node).operands().map(|it| plain[it.index()].abs());
            [(changed[node.index()] - plain[node.index()]).abs(), terms.fold(f64::MIN_POSITIVE, f64::max)]
        };
        let most = |all: [f64; 2], of: [f64; 2]| [all[0].max(of[0]), all[1].max(of[1])];
        let [change, largest] = self.cases.iter().map(of).fold([0.0; 2], most);
        change / largest
    }

    /// Whether a node has a part in nothing but how a gap |g| changes, which never closes.
    fn is_of_what_is_open(&self, graph: &Graph, node: Node) -> bool {
        let opens = |mask: Node| {
            let is_abs = |it: Node, of: Node| graph.op(it) == Op::Unary(Unary::Abs, of);
            let is_gap =
                |op: Op| matches!(op, Op::Select(its, gap, open) if its == mask && is_abs(open, gap));
            self.needed.iter().any(|it| is_gap(graph.op(*it)))
        };
        let uses = self.needed.iter().filter(|user| graph.op(**user).operands().any(|it| it == node));
        let mut uses = uses.peekable();
        uses.peek().is_some()
            && uses.all(|user| match graph.op(*user) {
                Op::Select(mask, gap, open) => open == node && gap != node && opens(mask),
                Op::Unary(Unary::Sign, _) | Op::Neg(_) | Op::Mul(..) => self.is_of_what_is_open(graph, *user),
                _ => false,
            })
    }

    /// Whether all that a change makes of a term is lost later, in each of several cases in which that term has a part: it cancels in a sum, as what
    /// moves the foot of a perpendicular does in its length, or is one of two that are alike, as the distances from both edges that end in a corner.
    /// Of what is lost in many cases it need not be known where.
    fn is_lost(&self, node: Node, change: Op) -> bool {
        let graph = self.compiled.complete.equations.graph.read();
        let results = self.judged();
        let lost = |case: &Case<M>| {
            let symbols = self.symbols(&case.moment, None);
            let plain = evaluate_with(&graph, &self.needed, &symbols, None);
            let distance = distances(&graph, &self.needed, &results, &plain)[node.index()];
            if distance > TIE {
                return None;
            }
            let changed = evaluate_with(&graph, &self.needed, &symbols, Some((node, change)));
            let alters = |it: Node, of: Node| {
                (changed[it.index()] - plain[it.index()]).abs()
                    / plain[of.index()].abs().max(f64::MIN_POSITIVE)
            };
            if alters(node, node) < ALTERS {
                return None;
            }
            let loses = |node: &Node| match graph.op(*node) {
                Op::Add(a, b) | Op::Sub(a, b) => {
                    alters(*node, a) < VANISHES && alters(a, a) > ALTERS && alters(b, a) > ALTERS
                }
                // Where both are alike it does not matter which is taken.
                Op::Min(a, b) | Op::Max(a, b) | Op::Select(_, a, b) => {
                    let [a, b] = [a, b].map(|it| (plain[it.index()], changed[it.index()]));
                    (a.0 - b.0).abs() < VANISHES * a.0.abs() && (a.1 - b.1).abs() > ALTERS * a.0.abs()
                }
                // A force of one component by its size is 1 or −1.
                Op::Mul(a, b) => {
                    alters(*node, *node) < VANISHES && alters(a, a) > ALTERS && alters(b, b) > ALTERS
                }
                _ => false,
            };
            let largest = results.iter().map(|it| plain[it.index()].abs()).fold(1.0, f64::max);
            let is_same =
                results.iter().all(|it| (changed[it.index()] - plain[it.index()]).abs() < VANISHES * largest);
            Some((is_same, distance > 0.0 || self.needed.iter().any(loses)))
        };
        let found: Vec<(bool, bool)> = self.cases.iter().filter_map(lost).collect();
        found.iter().all(|(is_same, _)| *is_same)
            && (found.iter().filter(|(_, is_lost)| *is_lost).count() >= WANTED || found.len() >= MANY)
    }

    fn describe(&self, node: Node) -> String {
        let graph = self.compiled.complete.equations.graph.read();
        let users =
            self.needed.iter().map(|user| graph.op(*user)).filter(|op| op.operands().any(|it| it == node));
        let users: Vec<String> = users.map(|op| format!("{op:?}")).collect();
        format!("{}, used by {}", mutants::describe(&graph, node), users.join("; "))
    }
}

/// 2π k.
fn is_turn(graph: &Graph, node: Node) -> bool {
    let is_whole = |it: Node| graph.value(it) == Some(TAU);
    matches!(graph.op(node), Op::Mul(a, b) if is_whole(a) || is_whole(b))
}

/// A definition whose friction takes so many passes.
fn with_passes(source: &str, passes: usize) -> String {
    let option = format!("friction_passes = {passes};");
    match source.split_once("friction_passes = ") {
        Some((before, after)) => {
            let (_, after) = after.split_once(';').expect("an option ends");
            format!("{before}{option}{after}")
        }
        None => {
            let (inner, _) = source.rsplit_once('}').expect("a definition ends");
            format!("{inner} options {{ {option} }} }}")
        }
    }
}

fn every_mutant_is_caught<M: Model>(name: &str, texts: [&str; 2], trial: Trial) {
    let Trial { noticed, passes } = trial;
    let source = passes.map_or(M::source().to_string(), |passes| with_passes(M::source(), passes));
    let tokens = source.parse().unwrap_or_else(|error| panic!("{error}"));
    let compiled = compile(tokens, None).unwrap_or_else(|errors| panic!("{errors}"));
    let model = M::standard();
    let (mut judge, mut generic) = Judge::new(name, &compiled, &model, texts, trial);
    let mut most = 0.0_f64;
    for case in &judge.cases {
        let difference = judge.difference(case, None);
        most = most.max(difference);
        assert!(difference < 0.01 * noticed, "{name} at {} s, unchanged: {difference:.1e}", case.moment.time);
    }
    println!("{name}: {most:.1e} unchanged");
    let first = RefCell::new(0);
    let mutations = judge.mutations();
    let left: Vec<&Mutant> = mutations
        .iter()
        .filter(|(node, change, _)| {
            !judge.is_noticed((*node, *change), &first)
                && !judge.is_equivalent(*node, *change)
                && !judge.is_lost(*node, *change)
                && judge.alters(*node, *change) > CANCELS
        })
        .collect();
    let (mut random, still) = (Random(SEEDS + 1), vec![0.0; generic.bodies().count()]);
    let mut survivors = Vec::new();
    for (node, change, what) in left {
        if let Some(moment) = judge.provoked((*node, *change), &mut random) {
            judge.add(name, moment, &mut still.clone(), &mut generic);
            let case = &judge.cases[judge.cases.len() - 1];
            let off = judge.difference(case, None);
            assert!(off < 0.01 * noticed, "{name}, a state that was sought: {off:.1e}");
        }
        if !judge.is_noticed((*node, *change), &first) {
            let part = judge.alters(*node, *change);
            survivors.push(format!("{what} at {}, {part:.1e} of its terms", judge.describe(*node)));
        }
    }
    println!("{name}: {} mutants, {} survivors\n{}", mutations.len(), survivors.len(), survivors.join("\n"));
    assert!(mutations.len() > 100, "{name}: only {} mutants", mutations.len());
    assert!(survivors.is_empty(), "{name}:\n{}", survivors.join("\n"));
}

macro_rules! judged {
    ($trial:expr; $($name:ident: $model:path),* $(,)?) => {
        $(#[test] fn $name() {
            use $model as Model;
            let texts = [Model::<f64>::DEFINITION, Model::<f64>::COORDINATES];
            every_mutant_is_caught::<Model<f64>>(stringify!($name), texts, $trial);
        })*
    };
}

judged! {
    Trial { noticed: 1e-11, passes: Some(1) };
    rubbed: mechanisms::zoo_friction::Rubbed,
    rubbed_loop: mechanisms::zoo_friction::RubbedLoop,
    rubbed_arm: mechanisms::zoo_friction::RubbedArm,
    rubbed_shafts: mechanisms::zoo_friction::RubbedShafts,
    rubbed_threads: mechanisms::zoo_friction::RubbedThreads,
    sliding: mechanisms::zoo_friction::Sliding,
    bristly: mechanisms::zoo_bristles::Bristly,
}

judged! {
    Trial { noticed: 1e-8, passes: None };
    bent: mechanisms::zoo_beams::Bent,
    bent_in_space: mechanisms::zoo_beams_in_space::BentInSpace,
    bristly_bodies: mechanisms::zoo_bristles::BristlyBodies,
    bristly_pairs: mechanisms::zoo_bristles::BristlyPairs,
    bumping: mechanisms::zoo_contacts::Bumping,
    docking: mechanisms::zoo_gates::Docking,
    landing: mechanisms::zoo_gates::Landing,
    loose_ball: mechanisms::zoo_loose::LooseBall,
    loose_loop: mechanisms::zoo_loose::LooseLoop,
    rubbing_beams: mechanisms::zoo_rubbing_beams::RubbingBeams,
    rubbing_bodies: mechanisms::zoo_rubbing::RubbingBodies,
    rubbing_pairs: mechanisms::zoo_rubbing::RubbingPairs,
    touching: mechanisms::zoo_contacts::Touching,
    wired: mechanisms::zoo_curves::Wired,
    yielding_in_space: mechanisms::zoo_penalties::YieldingInSpace,
}
