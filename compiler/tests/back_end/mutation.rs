//! The self-check notices: signs of the derived graph are flipped and terms dropped, one at a time, and instructions of the
//! programs changed, and each time the compiler must contradict itself.

use crate::compiled;
use crate::mechanisms::{CHAIN, FOUR_BAR, SHAFTS, with};
use linkwright_compiler::Compiled;
use linkwright_compiler::optimize::optimize;
use linkwright_compiler::schedule::{Function, Instruction, Operand, outputs, schedule};
use linkwright_compiler::self_check::{Check, Contradiction, Extent, self_check};
use linkwright_compiler::symbolic::{Node, Op};
use std::collections::BTreeMap;

/// How often each check was the first to speak.
type Tally = BTreeMap<Check, usize>;

/// The first contradiction, and the tally with it.
fn judge(mutant: &Compiled, extent: Extent, tally: &mut Tally) -> Option<Contradiction> {
    let found = self_check(mutant, extent).into_iter().next()?;
    *tally.entry(found.check).or_default() += 1;
    Some(found)
}

#[test]
fn wrong_expressions_are_noticed() {
    let all = "options { emit = (penalty, null_space, tangent); }";
    for (name, source, more, every) in
        [("four-bar", FOUR_BAR, "options { coordinates = tree; }", 1), ("four-bar absolute", FOUR_BAR, "options { coordinates = absolute; }", 1), ("chain", CHAIN, "", 4), ("shafts", SHAFTS, "", 4), ("four-bar with all", FOUR_BAR, all, 11)]
    {
        let sound = compiled(&with(source, more)).expect("it compiles");
        for extent in [Extent::Passing, Extent::Thorough] {
        let (mut mutants, mut survivors, mut tally) = (0, Vec::new(), Tally::new());
        for (node, op, what) in mutations(&sound).into_iter().step_by(every) {
            mutants += 1;
            if judge(&with_node(&sound, node, op), extent, &mut tally).is_none() {
                survivors.push(format!("{what} of {}", describe(&sound, node)));
            }
        }
        println!("{name} {extent:?}: {mutants} mutants, {} survivors, {tally:?}", survivors.len());
        for s in &survivors { println!("   {s}"); }
        }
    }
}

/// Flipped signs and dropped terms of every sum, difference and negation that a function needs.
fn mutations(compiled: &Compiled) -> Vec<(Node, Op, &'static str)> {
    let graph = &compiled.equations.graph;
    let needed = graph.reachable(
        Function::ALL.iter().flat_map(|function| outputs(&compiled.equations, &compiled.solved, *function)),
    );
    let mut found = Vec::new();
    for node in needed {
        match graph.op(node) {
            Op::Add(a, b) => found.extend([
                (node, Op::Sub(a, b), "second sign"),
                (node, Op::Sub(b, a), "first sign"),
                (node, Op::Max(a, a), "second term"),
            ]),
            Op::Sub(a, b) => found.extend([(node, Op::Add(a, b), "second sign"), (node, Op::Max(a, a), "second term")]),
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
    mutant.equations.graph = sound.equations.graph.with(node, op);
    let optimized = optimize(&mutant.equations, &mutant.solved);
    mutant.programs = schedule(&mutant.equations, &optimized);
    mutant
}

fn describe(compiled: &Compiled, node: Node) -> String {
    let graph = &compiled.equations.graph;
    let users: Vec<&str> = Function::ALL
        .iter()
        .filter(|function| {
            let nodes = outputs(&compiled.equations, &compiled.solved, **function);
            graph.reachable(nodes).contains(&node)
        })
        .map(|function| function.name())
        .collect();
    format!("{:?}, used by {}", graph.op(node), users.join(", "))
}
