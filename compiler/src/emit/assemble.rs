//! The implementation of `Assemble`: conditions of the start, and what the other formulations solve with.

use super::function::functions;
use super::rust::{constant, literal};
use super::{Emitter, array, solutions, tables};
use crate::functions::{CONDITION_JACOBIAN, Interface, Shape};
use std::fmt::Write;

pub fn assemble(text: &mut String, emitter: &Emitter) {
    let Emitter { inner, compiled, .. } = emitter;
    let equations = &compiled.complete.equations;
    let mut helpers = String::new();
    let stated = |rate: bool| {
        let targets = compiled.complete.conditions.start.iter().enumerate();
        let has = move |target: &crate::equations::StartTarget| {
            if rate { target.rate.is_some() } else { target.position.is_some() }
        };
        tables::indices(targets.filter(|(_, target)| has(target)).map(|(index, _)| index))
    };
    let _ = writeln!(text, "impl<R: Real> Assemble<R> for {inner}<R> {{");
    tables::method(text, "conditions", "&[Condition]", &tables::conditions(emitter));
    let lists = [
        ("start_conditions", stated(false)),
        ("start_rates", stated(true)),
        ("independent", tables::indices(compiled.independent.iter().copied())),
    ];
    for (method, list) in lists {
        tables::method(text, method, "&[u16]", &list);
    }
    tables::method(text, "flips", "&[Flips<'_>]", &tables::flips(emitter));
    if !equations.idle.is_empty() {
        let idle = tables::indices(equations.idle.iter().copied());
        tables::method(text, "idle", "&[u16]", &idle);
    }
    if compiled.complete.further.partition.pivots().next().is_some() {
        let pivots = tables::pairs(
            compiled.complete.further.partition.pivots().map(|pivot| (pivot.row, pivot.velocity)),
        );
        tables::method(text, "dependent", "&[(u16, u16)]", &pivots);
    }
    if compiled.complete.further.partition.scales.iter().any(|scale| *scale != 1.0) {
        let scales = array(compiled.complete.further.partition.scales.iter().map(|scale| literal(*scale)));
        tables::method(text, "scales", "&[f64]", &format!("&{scales}"));
    }
    let massless = &compiled.complete.solved.massless;
    if !massless.rows.is_empty() {
        let rows = tables::indices(massless.rows.keys().copied());
        tables::method(text, "massless_rows", "&[u16]", &rows);
        let weights = array(massless.rows.values().map(|rho| literal(*rho)));
        tables::method(text, "massless_weights", "&[f64]", &format!("&{weights}"));
    }
    tables::pattern(text, emitter, &CONDITION_JACOBIAN);
    tables::method(text, "elimination", "Elimination<'_>", &tables::elimination(emitter));
    for alias in ["Conditions", "ConditionJacobian", "Factor", "System", "Dense", "Basis", "Reduced"] {
        let _ = writeln!(text, "type {alias} = {alias}<R>;");
    }
    let velocities = emitter.compiled.entries(Shape::Velocities);
    let _ = writeln!(
        text,
        "type Choice = [u16; {velocities}];\nfn choice(&self) -> [u16; {velocities}] {{ [0; {velocities}] }}"
    );
    functions(text, &mut helpers, emitter, Interface::Assemble);
    solutions::factorisation(text, emitter);
    solutions::jacobian(text, emitter);
    let numbers = |values: &[f64]| array(values.iter().map(|value| constant(*value)));
    let sizes = numbers(&compiled.complete.further.partition.row_sizes);
    let _ = writeln!(text, "fn row_sizes(&self) -> Lambda<R> {{ {sizes} }}");
    let _ = writeln!(text, "fn start_q(&self) -> Q<R> {{ {} }}", numbers(&compiled.assembly.q));
    let _ = writeln!(text, "fn start_v(&self) -> V<R> {{ {} }}", numbers(&compiled.assembly.v));
    if emitter.mechanism.states.is_empty() {
        text.push_str("fn start_internal(&self) {}\n");
    }
    if emitter.mechanism.holds() {
        let _ =
            writeln!(text, "fn start_gates(&self) -> Gates<R> {{ {} }}", numbers(&compiled.start_gates()));
    } else {
        text.push_str("fn start_gates(&self) {}\n");
    }
    let open = compiled.complete.equations.open_rows(emitter.mechanism);
    if !open.is_empty() {
        // The residual with the old phase is what the new phase differs by.
        text.push_str("fn fix_phases(&mut self, q: &Q<R>) {\nlet mut phi = [R::ZERO; ");
        let _ = writeln!(
            text,
            "{}];\nself.constraints(R::ZERO, q, &mut phi);",
            emitter.compiled.entries(Shape::Rows)
        );
        text.push_str("let mut phases = self.phases;\n");
        for (phase, row) in open.iter().enumerate() {
            let _ = writeln!(text, "phases[{phase}] = phases[{phase}] + phi[{row}];");
        }
        text.push_str("*self = Self::with(self.parameters, phases);\n}\n");
    }
    text.push_str("}\n");
    text.push_str(&helpers);
}
