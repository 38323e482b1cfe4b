//! The implementation of `Assemble`: conditions of the start, and what the other formulations solve with.

use super::body::{constant, literal};
use super::function::{all, function, list};
use super::names::Argument;
use super::{Emitter, array, solutions, tables};
use crate::schedule::Function;
use std::fmt::Write;

use Argument::{Constants, Q, Target, Time, V};

pub fn assemble(text: &mut String, emitter: &Emitter) {
    let Emitter { inner, compiled, .. } = emitter;
    let equations = &compiled.equations;
    let mut helpers = String::new();
    let stated = |rate: bool| {
        let targets = equations.start_targets.iter().enumerate();
        let has = move |target: &crate::equations::StartTarget| {
            if rate { target.rate.is_some() } else { target.position.is_some() }
        };
        tables::indices(targets.filter(|(_, target)| has(target)).map(|(index, _)| index))
    };
    let _ = writeln!(text, "impl<R: Real> Assemble<R> for {inner}<R> {{");
    let _ = writeln!(text, "const CONDITIONS: &'static [Condition] = {};", tables::conditions(emitter));
    let lists = [
        ("START_CONDITIONS", stated(false)),
        ("START_RATES", stated(true)),
        ("INDEPENDENT", tables::indices(compiled.independent.iter().copied())),
    ];
    for (constant, list) in lists {
        let _ = writeln!(text, "const {constant}: &'static [u16] = {list};");
    }
    let _ = writeln!(text, "const FLIPS: &'static [Flips] = {};", tables::flips(emitter));
    if !equations.idle.is_empty() {
        let idle = tables::indices(equations.idle.iter().copied());
        let _ = writeln!(text, "const IDLE: &'static [u16] = {idle};");
    }
    if compiled.partition.pivots().next().is_some() {
        let pivots = tables::pairs(compiled.partition.pivots().map(|pivot| (pivot.row, pivot.velocity)));
        let _ = writeln!(text, "const DEPENDENT: &'static [(u16, u16)] = {pivots};");
    }
    let sizes = array(compiled.partition.row_sizes.iter().map(|size| literal(*size)));
    let _ = writeln!(text, "const ROW_SIZES: &'static [f64] = &{sizes};");
    if compiled.partition.scales.iter().any(|scale| *scale != 1.0) {
        let scales = array(compiled.partition.scales.iter().map(|scale| literal(*scale)));
        let _ = writeln!(text, "const SCALES: &'static [f64] = &{scales};");
    }
    let massless = &compiled.solved.massless;
    if !massless.rows.is_empty() {
        let rows = tables::indices(massless.rows.keys().copied());
        let _ = writeln!(text, "const MASSLESS_ROWS: &'static [u16] = {rows};");
        let weights = array(massless.rows.values().map(|rho| literal(*rho)));
        let _ = writeln!(text, "const MASSLESS_WEIGHTS: &'static [f64] = &{weights};");
    }
    let jets = equations.conditions.iter().map(|condition| &condition.jet);
    let _ = writeln!(
        text,
        "const CONDITION_PATTERN: &'static [(u16, u16)] = {};",
        tables::jacobian_pattern(jets)
    );
    let _ = writeln!(text, "const ELIMINATION: Elimination = {};", tables::elimination(emitter));
    for alias in ["Conditions", "ConditionJacobian", "Factor", "System", "Dense", "Basis", "Reduced"] {
        let _ = writeln!(text, "type {alias} = {alias}<R>;");
    }
    let velocities = emitter.velocities();
    let _ = writeln!(
        text,
        "type Choice = [u16; {velocities}];\nfn choice() -> [u16; {velocities}] {{ [0; {velocities}] }}"
    );
    let mut write =
        |which: Function, arguments: &[Argument], signature: &str, result: fn(&[String]) -> String| {
            function(text, &mut helpers, emitter, which, arguments, signature, result);
        };
    let position = [Constants, Time, Q];
    let targeted = [Constants, Time, Q, Target];
    let target = "time: R, q: &Q<R>, target: &Conditions<R>, out: &mut Conditions<R>";
    write(Function::ConditionResidual, &targeted, &format!("condition_residual(&self, {target})"), all);
    write(Function::ConditionCosines, &targeted, &format!("condition_cosines(&self, {target})"), all);
    write(
        Function::ConditionJacobian,
        &position,
        "condition_jacobian(&self, time: R, q: &Q<R>, out: &mut ConditionJacobian<R>)",
        all,
    );
    write(
        Function::ConditionBias,
        &[Constants, Time, Q, V],
        "condition_bias(&self, time: R, q: &Q<R>, v: &V<R>, out: &mut Conditions<R>)",
        all,
    );
    write(
        Function::ConditionDrift,
        &position,
        "condition_drift(&self, time: R, q: &Q<R>, out: &mut Conditions<R>)",
        all,
    );
    write(Function::RowCosines, &position, "row_cosines(&self, time: R, q: &Q<R>, out: &mut Lambda<R>)", all);
    write(Function::RowScales, &[Constants], "row_scales(&self, out: &mut Lambda<R>)", all);
    write(
        Function::StartTargets,
        &[Constants],
        "start_targets(&self, positions: &mut Conditions<R>, rates: &mut Conditions<R>)",
        |outputs| {
            let (positions, rates) = outputs.split_at(outputs.len() / 2);
            format!("*positions = {};\n*rates = {};", list(positions), list(rates))
        },
    );
    solutions::factorisation(text, &mut helpers, emitter);
    solutions::null_space(text, &mut helpers, emitter);
    let numbers = |values: &[f64]| array(values.iter().map(|value| constant(*value)));
    let _ = writeln!(text, "fn start_q() -> Q<R> {{ {} }}", numbers(&compiled.assembly.q));
    let _ = writeln!(text, "fn start_v() -> V<R> {{ {} }}", numbers(&compiled.assembly.v));
    let open = compiled.equations.open_rows(emitter.mechanism);
    if !open.is_empty() {
        // The residual with the old phase is what the new phase differs by.
        text.push_str("fn fix_phases(&mut self, q: &Q<R>) {\nlet mut phi = [R::ZERO; ");
        let _ = writeln!(text, "{}];\nself.constraints(R::ZERO, q, &mut phi);", emitter.rows());
        text.push_str("let mut phases = self.phases;\n");
        for (phase, row) in open.iter().enumerate() {
            let _ = writeln!(text, "phases[{phase}] = phases[{phase}] + phi[{row}];");
        }
        text.push_str("*self = Self::with(self.parameters, phases);\n}\n");
    }
    text.push_str("}\n");
    text.push_str(&helpers);
}
