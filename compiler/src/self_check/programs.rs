//! Every program against the graph: selection, sharing and order may not change a value by more than its rounding.

use super::machine::Machine;
use super::quantity::Quantity;
use super::{Check, Report};
use crate::functions::{Function, outputs};
use crate::schedule::sources;
use crate::symbolic::evaluate_reachable;

pub fn check(machine: &Machine, report: &mut Report) {
    let compiled = machine.compiled;
    let (equations, inputs) = (&compiled.complete.equations, report.inputs);
    let functions: Vec<_> =
        Function::ALL.into_iter().filter(|function| *function != Function::Prepare).collect();
    let of = |function: &Function| outputs(&compiled.complete, *function);
    let wanted: Vec<_> = functions.iter().map(of).collect();
    let symbols: Vec<f64> =
        sources(&compiled.complete).into_iter().map(|source| inputs.get(source)).collect();
    let order = equations.graph.read().reachable(wanted.iter().flatten().copied());
    let mut values = Vec::new();
    evaluate_reachable(&equations.graph.read(), &order, &symbols, &mut values);
    // Where nothing in the graph is divided by zero, the other sign of a zero makes no infinity.
    let finite = order.iter().all(|node| values[node.index()].is_finite());
    for (function, nodes) in functions.into_iter().zip(wanted) {
        let plain = machine.plain(function, inputs);
        let same = |(program, graph): (&f64, f64)| *program == graph || program.is_nan() && graph.is_nan();
        let expected: Vec<f64> = nodes.iter().map(|node| values[node.index()]).collect();
        if plain.len() == expected.len() && plain.iter().zip(expected.iter().copied()).all(same) {
            continue;
        }
        // The signs are distributed otherwise at most, which changes nothing but zeros; the bound says whether that matters.
        let bounded = machine.run(function, inputs);
        for (index, expected) in expected.into_iter().enumerate() {
            let at = || format!("result {index} of `{}`", function.name());
            let found = bounded.get(index).copied().unwrap_or(Quantity::exact(f64::INFINITY));
            let found =
                if finite && !found.value.is_finite() { Quantity::exact(f64::INFINITY) } else { found };
            report.compare(Check::Programs, at, found, Quantity::exact(expected));
        }
    }
}
