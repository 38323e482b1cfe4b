//! Budgets of `expect` against what the functions take: where it goes, and what would take less.
//!
//! Advice is counted, not guessed: the mechanism is compiled or counted again as advised, and what takes no less is not
//! mentioned. All that happens only where a budget is exceeded.

mod expenses;
mod messages;

use crate::choice::Rejected;
use crate::compiled::Compiled;
use crate::complete::Complete;
use crate::diagnostics::Diagnostics;
use crate::functions::{Function, outputs};
use crate::model::{Budgeted, Coordinates, Mechanism};
use crate::schedule::{self, Program, count, live_values, nodes_of};
use crate::solve;
use expenses::expenses;
use messages::Remedy;

/// How a mechanism is compiled: model, `DEFINITION`, coordinates.
type Compile = dyn Fn(Mechanism, String, Option<Coordinates>) -> Result<Compiled, Diagnostics>;

/// Functions against `expect`.
pub fn budget(compiled: &Compiled, compile: &Compile, errors: &mut Diagnostics) {
    let programs = &compiled.programs;
    for budget in &compiled.mechanism.expect.budgets {
        let name = budget.function.as_deref().unwrap_or(compiled.default_solution().name());
        let Some((function, program)) =
            programs.functions.iter().find(|(function, _)| function.name() == name)
        else {
            let known: Vec<&str> = programs.functions.iter().map(|(function, _)| function.name()).collect();
            errors.error(budget.span, messages::unknown_function(name, &known));
            continue;
        };
        if !(function.signature().emitted)(&compiled.complete) {
            errors.error(budget.span, messages::not_emitted(name));
            continue;
        }
        let found = taken(budget.of, program);
        if found <= budget.limit {
            continue;
        }
        let of = (name, *function == compiled.default_solution());
        let remedies = remedies(compiled, compile, *function, (budget.of, found));
        errors.error(
            budget.span,
            match budget.of {
                Budgeted::Operations => {
                    let table = expenses(compiled, *function);
                    messages::too_many_operations(of, budget.limit, found, &table, &remedies)
                }
                Budgeted::LiveValues => {
                    let results = program.outputs.len();
                    messages::too_many_live_values(of, budget.limit, found, results, &remedies)
                }
            },
        );
    }
}

fn taken(of: Budgeted, program: &Program) -> usize {
    match of {
        Budgeted::Operations => count(program).total(),
        Budgeted::LiveValues => live_values(program),
    }
}

/// Changes that would take less, with the operations they would take, the least first.
fn remedies(
    compiled: &Compiled,
    compile: &Compile,
    function: Function,
    (of, found): (Budgeted, usize),
) -> Vec<(Remedy, usize)> {
    let mut remedies: Vec<(Remedy, usize)> = Vec::new();
    if let Some((coordinates, other)) = in_other_coordinates(compiled, compile) {
        remedies.push((Remedy::Coordinates(coordinates), taken(of, other.programs.get(function))));
    }
    if let Some(pair) = function.pair().filter(|_| function.is_stabilised()) {
        let [plain, _] = Function::SOLUTIONS[pair];
        remedies.push((Remedy::WithoutBaumgarte(plain), taken(of, compiled.programs.get(plain))));
    }
    if of == Budgeted::Operations {
        remedies.extend(with_constants(compiled, function).map(|count| (Remedy::Constants, count)));
        let other = in_independent_velocities(compiled, function);
        remedies.extend(other.map(|(function, count)| (Remedy::Independent(function), count)));
    }
    remedies.retain(|(_, count)| *count < found);
    remedies.sort_by_key(|(_, count)| *count);
    remedies
}

/// The mechanism in the coordinates that were not taken, unless they are known to be out of the question.
fn in_other_coordinates(compiled: &Compiled, compile: &Compile) -> Option<(&'static str, Compiled)> {
    if matches!(compiled.choice.rejected, Some(Rejected::Estimated(_))) {
        return None;
    }
    let (word, other) = match compiled.choice.coordinates {
        Coordinates::Absolute => ("tree", Coordinates::Tree),
        _ => ("absolute", Coordinates::Absolute),
    };
    let mut mechanism = compiled.mechanism.clone();
    mechanism.options.self_check = Some(false);
    let other = compile(mechanism, compiled.definition.clone(), Some(other)).ok()?;
    Some((word, other))
}

/// Operations if every parameter were a constant, with its default as value.
fn with_constants(compiled: &Compiled, function: Function) -> Option<usize> {
    let parameters = &compiled.mechanism.parameters;
    if parameters.is_empty() {
        return None;
    }
    let equations = &compiled.complete.equations;
    let g = equations.graph.sheet();
    let defaults = parameters.iter().map(|parameter| g.number(parameter.default).bare);
    let replaced = equations.symbols.parameters.iter().copied().zip(defaults).collect();
    let nodes = outputs(&compiled.complete, function);
    let nodes = g.graph().substitute(&nodes, &replaced);
    Some(nodes_of(equations, &nodes).len())
}

/// The function that gives the same by independent velocities, where it is not emitted, and its operations.
fn in_independent_velocities(compiled: &Compiled, function: Function) -> Option<(Function, usize)> {
    let Complete { equations, solved, further, .. } = &compiled.complete;
    let [multipliers, independent] = Function::SOLUTIONS;
    let place = multipliers.iter().position(|known| *known == function)?;
    let closed = !equations.rows.is_empty() && further.null_space.is_none();
    if !closed {
        return None;
    }
    let massless = !solved.massless.rows.is_empty();
    // What takes more helps nobody.
    let most = solved.counts.total();
    let partitions = std::slice::from_ref(&further.partition);
    let count = &schedule::count_outputs;
    let cheapest = solve::cheapest(equations, partitions, massless, None, most, count)?;
    // On a graph of its own: nothing of it is left behind.
    let mut complete = compiled.complete.clone();
    complete.equations = cheapest.equations;
    complete.further.null_space = Some(cheapest.written);
    complete.further.leads = true;
    let function = independent[place];
    Some((function, nodes_of(&complete.equations, &outputs(&complete, function)).len()))
}
