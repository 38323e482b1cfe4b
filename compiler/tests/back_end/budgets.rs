//! Budgets of `expect`: what a message says adds up, and its advice is true.

use crate::compiled;
use crate::mechanisms::{CHAIN, FOUR_BAR, SHAFTS, with};
use linkwright_compiler::schedule::{Function, Program, count, live_values};

fn refusal(source: &str, budget: &str) -> String {
    let source = with(source, &format!("expect {{ {budget}; }}"));
    compiled(&source).map(|_| ()).expect_err("the budget is exceeded").to_string()
}

/// The lines of numbers before and after the sentence that says what to write.
fn numbers(message: &str) -> [Vec<usize>; 2] {
    let (table, remedies) = message.split_once("\nwrite ").expect("what to write instead");
    [table, remedies].map(|part| {
        let lines = part.lines().skip(1).filter_map(|line| line.split_whitespace().next());
        lines.map(|number| number.parse().expect("a number")).collect()
    })
}

#[test]
fn the_table_adds_up_to_the_operations() {
    for source in [FOUR_BAR, CHAIN, SHAFTS] {
        let programs = compiled(&with(source, "")).expect("it compiles").programs;
        for (function, program) in &programs.functions {
            let operations = count(program).total();
            if operations == 0 {
                continue;
            }
            let message = refusal(source, &format!("operations({}) <= {}", function.name(), operations - 1));
            let [table, remedies] = numbers(&message);
            assert_eq!(table.iter().sum::<usize>(), operations, "{message}");
            assert!(remedies.iter().all(|remedy| *remedy < operations), "{message}");
        }
    }
}

#[test]
fn the_table_speaks_of_the_mechanism() {
    let message = refusal(FOUR_BAR, "operations <= 100");
    for line in [
        "the mass matrix M",
        "loads (for itself alone \"band\"",
        "γ of",
        "the factorisation",
        "the substitution",
    ] {
        assert!(message.contains(line), "{line} is missing in\n{message}");
    }
    // No constraint, no pivot.
    let message = refusal(CHAIN, "operations <= 100");
    assert!(!message.contains("constraint") && !message.contains("watch"), "{message}");
}

/// Every remedy is one that a definition can write, with the count that it then has.
#[test]
fn advice_is_true() {
    let by_multipliers = with(FOUR_BAR, "options { solution = multipliers; } MORE");
    let message = refusal(&by_multipliers, "operations <= 100");
    let count_before = |phrase: &str| -> usize {
        let line = message.lines().find(|line| line.contains(phrase)).unwrap_or_else(|| panic!("{message}"));
        line.split_whitespace().next().and_then(|number| number.parse().ok()).expect("a count")
    };
    let taken = |source: &str, function: Function| {
        count(compiled(&with(source, "")).expect("it compiles").programs.get(function)).total()
    };
    let independent = with(FOUR_BAR, "options { solution = independent; } MORE");
    let found = count_before("by `null_space_baumgarte`, in independent velocities");
    assert_eq!(found, taken(&independent, Function::NullSpaceBaumgarte));
    let plain = count_before("by `acceleration`");
    assert_eq!(plain, taken(&by_multipliers, Function::Acceleration));
    let message = refusal(&independent, "operations <= 100");
    let plain = taken(&independent, Function::NullSpace);
    assert!(message.contains(&format!("{plain}  operations by `null_space`, without")), "{message}");

    // In tree coordinates M and Q cost something, in absolute ones M is constant.
    let message = refusal(FOUR_BAR, "operations(forces) <= 40");
    let (_, of_absolute) = message.split_once("need less:\n").expect("a remedy");
    let of_absolute = of_absolute.split_whitespace().next().and_then(|number| number.parse().ok());
    let absolute = compiled(&with(FOUR_BAR, "options { coordinates = absolute; }")).expect("it compiles");
    assert_eq!(of_absolute, Some(count(absolute.programs.get(Function::Forces)).total()), "{message}");
}

#[test]
fn live_values_are_those_of_the_emitted_order() {
    let compiled = compiled(&with(FOUR_BAR, "")).expect("it compiles");
    let program = compiled.programs.get(compiled.default_solution());
    let most = live_values(program);
    // By going through the program with the set of what is still needed.
    let mut largest = 0;
    for place in 0..=program.instructions.len() {
        let needed = |value: usize| is_needed(program, value, place);
        largest = largest.max((0..place).filter(|value| needed(*value)).count());
    }
    assert_eq!(most, largest);
    let fits = with(FOUR_BAR, &format!("expect {{ live_values <= {most}; }}"));
    assert!(crate::compiled(&fits).is_ok());
    let message = refusal(FOUR_BAR, &format!("live_values <= {}", most - 1));
    assert!(message.contains(&format!("has up to {most} values alive at once")), "{message}");
    let message = refusal(FOUR_BAR, "live_values(reactions) <= 1");
    assert!(message.contains("`reactions` has up to"), "{message}");
}

/// Whether an instruction at or after `place`, or an output, uses the value.
fn is_needed(program: &Program, value: usize, place: usize) -> bool {
    use linkwright_compiler::schedule::Operand;
    let mut later = program.instructions[place..].iter().flat_map(|instruction| instruction.operands());
    let own = Operand::Value(value as u32);
    later.any(|operand| operand == own) || program.outputs.contains(&own)
}
