//! The self-check notices: signs of the derived graph are flipped and terms dropped, one at a time, and instructions of the
//! programs changed, and each time the compiler must contradict itself. That it is silent where all is right is tested on every
//! mechanism in `tests/checks/self_check.rs`.

use crate::compiled;
use crate::mechanisms::{BEAMS, CHAIN, FOUR_BAR, SHAFTS, with};
use linkwright_compiler::Compiled;
use linkwright_compiler::complete::Complete;
use linkwright_compiler::optimize::optimize;
use linkwright_compiler::schedule::{Function, Instruction, Operand, Program, outputs, schedule};
use linkwright_compiler::self_check::{Check, Extent, self_check};
use linkwright_compiler::symbolic::{Node, Op, evaluate};
use std::collections::{BTreeMap, BTreeSet};

/// How often each check was the first to speak.
type Tally = BTreeMap<Check, usize>;

/// Whether the check speaks of a mutant; counted by what it says first.
fn is_noticed(mutant: &Compiled, extent: Extent, tally: &mut Tally) -> bool {
    let found = self_check(mutant, extent);
    found.first().map(|first| *tally.entry(first.check).or_default() += 1).is_some()
}

/// Mutants of a mechanism, every so many of them: each is noticed, or there is a reason why it cannot be seen.
fn expressions(source: &str, options: &str, every: usize, checks: &[Check]) {
    let sound = compiled(&with(source, options)).expect("it compiles");
    assert!(self_check(&sound, Extent::Thorough).is_empty());
    let (mut mutants, mut tally, mut explained) = (0, Tally::new(), BTreeMap::<&str, usize>::new());
    let mut survivors = Vec::new();
    for (node, op, what) in mutations(&sound).into_iter().step_by(every) {
        mutants += 1;
        if is_noticed(&with_node(&sound, node, op), Extent::Thorough, &mut tally) {
            continue;
        }
        let users = users(&sound, node);
        let reason = if changes_nothing(&sound, node, op) {
            Some("a term that is nothing, whatever the state")
        } else {
            reason(&sound, node, &users)
        };
        match reason {
            Some(reason) => *explained.entry(reason).or_default() += 1,
            None => survivors.push(format!(
                "{what} of {:?}, used by {users:?}",
                sound.complete.equations.graph.read().op(node)
            )),
        }
    }
    println!("{mutants} mutants, noticed by {tally:?}, not noticed {explained:?}");
    assert!(survivors.is_empty(), "{}", survivors.join("\n"));
    assert!(mutants > 50, "only {mutants} mutants");
    for check in checks {
        assert!(tally.contains_key(check), "{check:?} has noticed nothing: {tally:?}");
    }
}

/// How many mutants there are, and how many of them the check notices.
pub fn noticed(sound: &Compiled) -> (usize, usize) {
    let mutants = mutations(sound);
    let is_noticed = |(node, op, _): &(Node, Op, _)| {
        !self_check(&with_node(sound, *node, *op), Extent::Thorough).is_empty()
    };
    (mutants.len(), mutants.iter().filter(|mutant| is_noticed(mutant)).count())
}

#[test]
fn wrong_expressions_are_noticed_in_tree_coordinates() {
    use Check::*;
    let checks = [Start, Jacobian, Gamma, MassMatrix, InverseDynamics, Energy, Solution, Baumgarte, Motions];
    expressions(FOUR_BAR, "options { coordinates = tree; }", 2, &checks);
}

#[test]
fn wrong_expressions_are_noticed_in_absolute_coordinates() {
    let checks = [Check::Start, Check::Gamma, Check::Energy, Check::Solution, Check::Baumgarte];
    expressions(FOUR_BAR, "options { coordinates = absolute; }", 5, &checks);
}

#[test]
fn wrong_expressions_are_noticed_in_a_chain() {
    expressions(CHAIN, "", 23, &[Check::MassMatrix, Check::InverseDynamics, Check::Energy, Check::Motions]);
}

#[test]
fn wrong_expressions_are_noticed_in_a_driven_loop() {
    expressions(SHAFTS, "", 19, &[Check::Gamma, Check::Solution, Check::Motions]);
}

#[test]
fn wrong_expressions_of_beams_are_noticed() {
    let checks = [Check::MassMatrix, Check::InverseDynamics, Check::Energy, Check::Solution];
    expressions(BEAMS, "", 9, &checks);
}

#[test]
fn wrong_expressions_are_noticed_beyond_the_default() {
    let options = "options { emit = (penalty, null_space, tangent); coordinates = tree; }";
    expressions(FOUR_BAR, options, 9, &[Check::Factorisation, Check::NullSpace, Check::Tangent]);
}

/// Whether a node is the same with another operation, as where what pulls at a mass has no lever about it and is written as a difference.
fn changes_nothing(compiled: &Compiled, node: Node, op: Op) -> bool {
    let graph = compiled.complete.equations.graph.read();
    let mutant = graph.with(node, op);
    (1..=4).all(|draw| {
        // Parts of the golden ratio's multiples: numbers between 0.5 and 1.5 without a relation to one another.
        let at = |symbol: usize| 0.5 + ((draw * (symbol + 1)) as f64 * 0.618_033_988_749_895).fract();
        let at: Vec<f64> = (0..graph.symbol_count()).map(at).collect();
        let [own, other] = [&*graph, &mutant].map(|graph| evaluate(graph, &at)[node.index()]);
        (own - other).abs() <= 1e-13 * own.abs()
    })
}

/// Why a mutant cannot be noticed at a few states without another derivation; `None` if it should have been.
fn reason(compiled: &Compiled, node: Node, users: &BTreeSet<Function>) -> Option<&'static str> {
    use Function::*;
    let only = |known: &[Function]| users.iter().all(|user| known.contains(user));
    let uses = |known: &[Function]| known.iter().all(|user| users.contains(user));
    let conditions =
        [ConditionResidual, ConditionCosines, ConditionJacobian, ConditionBias, ConditionDrift, RowCosines];
    if only(&[Reactions, Motions, Outputs, DriverEfforts, PotentialEnergy, OutputTangent])
        && users.contains(&Reactions)
    {
        return Some("reactions: compared with the graph only");
    }
    if only(&[
        Outputs,
        StartTargets,
        Masses,
        DriverEfforts,
        ParameterTangent,
        InputTangent,
        OutputTangent,
        CoordinateTangent,
        RateTangent,
    ]) || only(&conditions)
    {
        return Some(
            "quantities that the user asks for, and their derivatives: compared with the graph only",
        );
    }
    if !is_solution(compiled, node)
        && only(&[
            Acceleration,
            AccelerationBaumgarte,
            NullSpace,
            NullSpaceBaumgarte,
            RowScales,
            Factor,
            System,
            FactorJacobian,
        ])
    {
        return Some("the watch over the pivots");
    }
    if only(&[System]) {
        return Some("right-hand sides that are compared with the graph only");
    }
    if only(&[PotentialEnergy, Motions]) {
        return Some("a constant of an energy or a position, whose rate is right");
    }
    if uses(&[MassMatrix, KineticEnergy]) || uses(&[Forces, Powers]) || uses(&[Forces, PotentialEnergy]) {
        return Some("another mechanism: both sides of the identity changed");
    }
    None
}

/// Whether v̇ or λ, of whichever function, need the node.
fn is_solution(compiled: &Compiled, node: Node) -> bool {
    let Complete { solved, further, .. } = &compiled.complete;
    let mut nodes: Vec<Node> = Vec::new();
    for solution in [&solved.index1, &solved.baumgarte] {
        nodes.extend(solution.acceleration.iter().chain(&solution.lambda));
    }
    nodes.extend(further.stored.iter().flat_map(|stored| stored.kept.iter().chain(&stored.solution)));
    nodes.extend(further.null_space.iter().flat_map(|written| {
        let solutions = [&written.plain, &written.stabilised].into_iter();
        let solutions = solutions.flat_map(|solution| solution.acceleration.iter().chain(&solution.lambda));
        solutions.chain(&written.kept).chain(&written.dependent)
    }));
    compiled.complete.equations.graph.read().reachable(nodes).contains(&node)
}

/// Flipped signs, dropped terms and sums in place of products, of every node that a function needs.
fn mutations(compiled: &Compiled) -> Vec<(Node, Op, &'static str)> {
    let graph = compiled.complete.equations.graph.read();
    let of = |function: &Function| outputs(&compiled.complete, *function);
    let mut found = Vec::new();
    for node in graph.reachable(Function::ALL.iter().flat_map(of)) {
        match graph.op(node) {
            Op::Add(a, b) => found.extend([
                (node, Op::Sub(a, b), "second sign"),
                (node, Op::Sub(b, a), "first sign"),
                (node, Op::Max(a, a), "second term"),
            ]),
            Op::Sub(a, b) => {
                found.extend([(node, Op::Add(a, b), "second sign"), (node, Op::Max(a, a), "second term")]);
            }
            Op::Neg(a) => found.push((node, Op::Max(a, a), "sign")),
            Op::Mul(a, b) => found.push((node, Op::Add(a, b), "product")),
            _ => {}
        }
    }
    found
}

/// The model with one node computed otherwise, and all programs written from that.
fn with_node(sound: &Compiled, node: Node, op: Op) -> Compiled {
    let mut mutant = sound.clone();
    mutant.complete.equations.graph = sound.complete.equations.graph.read().with(node, op).into();
    let optimized = optimize(&mutant.complete);
    mutant.programs = schedule(&mutant.complete, &optimized);
    mutant
}

/// The functions that need a node.
fn users(compiled: &Compiled, node: Node) -> BTreeSet<Function> {
    let needs = |function: &Function| {
        let nodes = outputs(&compiled.complete, *function);
        compiled.complete.equations.graph.read().reachable(nodes).contains(&node)
    };
    Function::ALL.into_iter().filter(needs).collect()
}

/// A row that is measured by four times its size, or a quarter of it.
#[test]
fn wrong_sizes_of_rows_are_noticed() {
    for options in ["options { coordinates = tree; }", "options { coordinates = absolute; }"] {
        let sound = compiled(&with(FOUR_BAR, options)).expect("it compiles");
        for row in 0..sound.complete.equations.rows.len() {
            for factor in [0.25, 4.0] {
                let mut mutant = sound.clone();
                let g = mutant.complete.equations.graph.sheet();
                mutant.complete.solved.row_scales[row] =
                    (factor * g.on(mutant.complete.solved.row_scales[row])).bare;
                let optimized = optimize(&mutant.complete);
                mutant.programs = schedule(&mutant.complete, &optimized);
                let found = self_check(&mutant, Extent::Thorough);
                assert!(found.first().is_some_and(|first| first.check == Check::Scales), "{row}: {found:?}");
            }
        }
    }
}

/// Every instruction changed is noticed by the check that is part of every expansion.
#[test]
fn wrong_instructions_are_noticed() {
    let options = "options { emit = (penalty, null_space, tangent); }";
    let sound = compiled(&with(FOUR_BAR, options)).expect("it compiles");
    let (mut mutants, mut tally, mut survivors) = (0, Tally::new(), Vec::new());
    for (place, (function, program)) in sound.programs.functions.iter().enumerate() {
        let decisive = decisive(program);
        for index in (0..program.instructions.len()).step_by(3).filter(|index| decisive[*index]) {
            let Some(instruction) = changed(program, index) else { continue };
            mutants += 1;
            let mut mutant = sound.clone();
            mutant.programs.functions[place].1.instructions[index] = instruction;
            if !is_noticed(&mutant, Extent::Passing, &mut tally) {
                survivors.push(format!("{} {index}: {:?}", function.name(), program.instructions[index]));
            }
        }
    }
    println!("{mutants} mutants, noticed by {tally:?}");
    assert!(mutants > 300, "only {mutants} mutants");
    assert!(survivors.is_empty(), "{}", survivors.join("\n"));
    assert!(tally.contains_key(&Check::Programs) && tally.contains_key(&Check::Solution), "{tally:?}");
}

/// The instructions that reach a result otherwise than as one of those of which the largest is taken.
fn decisive(program: &Program) -> Vec<bool> {
    let mut decisive = vec![false; program.instructions.len()];
    let mark = |operand: Operand, decisive: &mut Vec<bool>| {
        if let Operand::Value(value) = operand {
            decisive[value as usize] = true;
        }
    };
    program.outputs.iter().for_each(|output| mark(*output, &mut decisive));
    for (index, instruction) in program.instructions.iter().enumerate().rev() {
        if decisive[index] && !matches!(instruction, Instruction::Max(..) | Instruction::Min(..)) {
            instruction.operands().for_each(|operand| mark(operand, &mut decisive));
        }
    }
    decisive
}

fn changed(program: &Program, index: usize) -> Option<Instruction> {
    match program.instructions[index] {
        Instruction::Add(a, b) => Some(Instruction::Sub(a, b)),
        Instruction::Sub(a, b) => Some(Instruction::Add(a, b)),
        Instruction::Mul(a, b) => Some(Instruction::Add(a, b)),
        Instruction::MulAdd(a, b, c, product, addend) => Some(Instruction::MulAdd(a, b, c, !product, addend)),
        Instruction::Neg(a) => Some(Instruction::Max(a, a)),
        _ => None,
    }
}

/// A contradiction is an error that says whose mistake it is, where it is and what to report.
#[test]
fn a_contradiction_names_the_case() {
    let sound = compiled(&with(FOUR_BAR, "options { coordinates = tree; }")).expect("it compiles");
    let entries: Vec<Node> = sound.complete.equations.rows[0].jet.columns.values().copied().collect();
    let wrong = mutations(&sound).into_iter().find(|(node, ..)| entries.contains(node));
    let (node, op, _) = wrong.expect("an entry of D is no single symbol");
    let mutant = with_node(&sound, node, op);
    let found = self_check(&mutant, Extent::Passing);
    let message = found.first().expect("a wrong D is noticed").to_string();
    for part in [
        "mistake of Linkwright, not of the definition",
        "D against differences",
        "row `x` of \"wrist\" along ",
        "q = [",
        "report",
    ] {
        assert!(message.contains(part), "{part} is missing in\n{message}");
    }
    assert!(self_check(&mutant, Extent::Off).is_empty());
}

#[test]
fn the_definition_decides_how_much_is_checked() {
    let extent = |options: &str| {
        let compiled = compiled(&with(FOUR_BAR, options)).expect("it compiles");
        Extent::asked(compiled.mechanism.options.self_check)
    };
    assert_eq!(extent("options { self_check = on; }"), Extent::Thorough);
    assert_eq!(extent("options { self_check = off; }"), Extent::Off);
    let errors =
        compiled(&with(FOUR_BAR, "options { self_check = maybe; }")).map(|_| ()).expect_err("no such word");
    assert!(errors.to_string().contains("expected `on` or `off`, found `maybe`"), "{errors}");
}
