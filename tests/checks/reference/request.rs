//! What the reference script is asked: a definition, and what the compiler makes of it at many states.

use super::random::Random;
use super::states::Walker;
use linkwright_compiler::Compiled;
use linkwright_compiler::emit::coordinates_json;
use linkwright_compiler::model::Space;
use linkwright_compiler::schedule::{Function, Inputs, Program, run};
use std::fmt::Write;

/// States of each kind in a request.
pub const STATES: usize = 112;

/// What else is to be compared at a consistent state: a name, and numbers row by row.
pub type Further<'a> = dyn Fn(&Inputs) -> Vec<(&'static str, Vec<Vec<f64>>)> + 'a;

/// The request as JSON text.
pub fn request(compiled: &Compiled, hash: &str, change: &dyn Fn(Function) -> Option<Program>) -> String {
    request_with(compiled, hash, change, &|_| Vec::new())
}

/// The same with what the runtime makes of the solution; a single row is a list, not a list of lists.
pub fn request_with(
    compiled: &Compiled,
    hash: &str,
    change: &dyn Fn(Function) -> Option<Program>,
    further: &Further,
) -> String {
    let walker = Walker::new(compiled);
    let mut random = Random::named(&compiled.mechanism.name.text);
    let coordinates = coordinates_json(&compiled.mechanism, &compiled.complete.equations);
    let mut text = format!(
        "{{\"definition\":{},\"coordinates\":{coordinates},\"parameters_are_si\":true,\"definition_hash\":\"{hash}\",\n\
         \"random\":[\n",
        compiled.definition
    );
    let evaluate = |function: Function, inputs: &Inputs| match change(function) {
        Some(program) => run(&program, inputs),
        None => run(compiled.programs.get(function), inputs),
    };
    for index in 0..STATES {
        let inputs = walker.anywhere(&mut random);
        text.push_str(if index == 0 { "{" } else { ",\n{" });
        random_state(&mut text, compiled, &inputs, &evaluate);
        text.push('}');
    }
    text.push_str("],\n\"consistent\":[\n");
    let (mut found, mut tries) = (0, 0);
    while found < STATES && tries < 4 * STATES {
        tries += 1;
        let Some(inputs) = walker.consistent(&mut random) else { continue };
        text.push_str(if found == 0 { "{" } else { ",\n{" });
        for (name, rows) in further(&inputs) {
            match rows.as_slice() {
                [row] => list(&mut text, name, row),
                rows => groups(&mut text, name, &rows.concat(), rows.first().map_or(1, Vec::len).max(1)),
            }
            text.push(',');
        }
        consistent_state(&mut text, compiled, inputs, &evaluate);
        text.push('}');
        found += 1;
    }
    text.push_str("]}\n");
    assert!(found >= 100, "{}: only {found} consistent states found", compiled.mechanism.name.text);
    text
}

type Evaluate<'a> = dyn Fn(Function, &Inputs) -> Vec<f64> + 'a;

fn given(text: &mut String, inputs: &Inputs) {
    list(text, "parameters", &inputs.parameters);
    let _ = write!(text, ",\"time\":{:?},", inputs.time);
    for (name, values) in
        [("inputs", &inputs.inputs), ("q", &inputs.q), ("v", &inputs.v), ("phases", &inputs.phases)]
    {
        list(text, name, values);
        text.push(',');
    }
    if !inputs.internal.is_empty() {
        list(text, "z", &inputs.internal);
        text.push(',');
    }
    if !inputs.gates.is_empty() {
        list(text, "gates", &inputs.gates);
        text.push(',');
    }
}

/// Of contacts whose gates are held the gaps and the laws without the gates, of rigid ones in their place what the gaps do at v̇ = 0 and the
/// restitutions.
fn touching(text: &mut String, compiled: &Compiled, inputs: &Inputs, evaluate: &Evaluate) {
    let count = inputs.gates.len();
    let mut told = |function: Function, names: &[&str]| {
        let found = evaluate(function, inputs);
        for (name, values) in names.iter().zip(found.chunks(count)) {
            list(text, name, values);
            text.push(',');
        }
    };
    if count > 0 {
        told(Function::Guards, &["gaps", "laws"]);
    }
    if !compiled.mechanism.events.is_empty() {
        told(Function::Assignments, &["assignments"]);
    }
    if compiled.mechanism.is_rigid() || compiled.mechanism.events.iter().any(|event| event.jump.is_some()) {
        told(Function::Strikes, &["gap_rates", "gap_biases", "restitutions"]);
    }
}

/// The efforts of drivers as the rates of internal states may name them, and these rates; nothing where there are no such states.
fn internal(text: &mut String, compiled: &Compiled, inputs: &Inputs, evaluate: &Evaluate) {
    if inputs.internal.is_empty() {
        return;
    }
    let efforts = evaluate(Function::DriverEfforts, inputs);
    list(text, "efforts", &efforts[..compiled.mechanism.drivers.len()]);
    text.push(',');
    for (name, function) in
        [("internal_rates", Function::InternalRates), ("internal_starts", Function::StartInternal)]
    {
        list(text, name, &evaluate(function, inputs));
        text.push(',');
    }
}

fn random_state(text: &mut String, compiled: &Compiled, inputs: &Inputs, evaluate: &Evaluate) {
    let equations = &compiled.complete.equations;
    given(text, inputs);
    internal(text, compiled, inputs, evaluate);
    touching(text, compiled, inputs, evaluate);
    let vectors = [
        ("phi", Function::Constraints),
        ("nu", Function::Nu),
        ("gamma", Function::Gamma),
        ("forces", Function::Forces),
    ];
    for (name, function) in vectors {
        list(text, name, &evaluate(function, inputs));
        text.push(',');
    }
    let d = equations
        .rows
        .iter()
        .enumerate()
        .flat_map(|(row, r)| r.jet.columns.keys().map(move |column| (row, *column)).collect::<Vec<_>>());
    matrix(text, "jacobian", d.collect(), &evaluate(Function::ConstraintJacobian, inputs));
    text.push(',');
    matrix(text, "mass", equations.mass.keys().copied().collect(), &evaluate(Function::MassMatrix, inputs));
    text.push(',');
    energies(text, inputs, evaluate);
}

fn consistent_state(text: &mut String, compiled: &Compiled, mut inputs: Inputs, evaluate: &Evaluate) {
    let equations = &compiled.complete.equations;
    let (n, rows) = (equations.layout.velocities(), equations.rows.len());
    let solution = evaluate(Function::Acceleration, &inputs);
    inputs.acceleration = solution[..n].to_vec();
    inputs.lambda = solution[n..n + rows].to_vec();
    given(text, &inputs);
    internal(text, compiled, &inputs, evaluate);
    list(text, "acceleration", &inputs.acceleration);
    text.push(',');
    list(text, "lambda", &inputs.lambda);
    text.push(',');
    let couplings = equations.rows.iter().position(|row| row.joint().is_none()).unwrap_or(rows);
    list(text, "multipliers", &inputs.lambda[couplings..]);
    text.push(',');
    let (motion, reaction) = sizes(compiled);
    groups(text, "bodies", &evaluate(Function::Motions, &inputs), motion);
    text.push(',');
    groups(text, "reactions", &evaluate(Function::Reactions, &inputs), reaction);
    text.push(',');
    let drivers = evaluate(Function::DriverEfforts, &inputs);
    let (efforts, powers) = drivers.split_at(drivers.len() / 2);
    list(text, "driver_efforts", efforts);
    text.push(',');
    list(text, "driver_powers", powers);
    text.push(',');
    energies(text, &inputs, evaluate);
}

/// How many numbers a body's motion and a joint's reaction have.
pub fn sizes(compiled: &Compiled) -> (usize, usize) {
    match compiled.mechanism.space {
        Space::Planar => (10, 3),
        Space::Spatial => (24, 6),
    }
}

fn energies(text: &mut String, inputs: &Inputs, evaluate: &Evaluate) {
    let one = |function| evaluate(function, inputs)[0];
    let (kinetic, potential) = (one(Function::KineticEnergy), one(Function::PotentialEnergy));
    let _ = write!(text, "\"kinetic\":{kinetic:?},\"potential\":{potential:?},");
    list(text, "powers", &evaluate(Function::Powers, inputs));
}

fn list(text: &mut String, name: &str, values: &[f64]) {
    let _ = write!(text, "\"{name}\":{}", numbers(values));
}

fn numbers(values: &[f64]) -> String {
    let texts: Vec<String> = values.iter().map(|value| number(*value)).collect();
    format!("[{}]", texts.join(","))
}

/// JSON has no NaN; the script is told so and reports it.
fn number(value: f64) -> String {
    if value.is_finite() { format!("{value:?}") } else { "null".to_string() }
}

fn matrix(text: &mut String, name: &str, places: Vec<(usize, usize)>, values: &[f64]) {
    let entries: Vec<String> =
        places.iter().zip(values).map(|((i, j), x)| format!("[{i},{j},{}]", number(*x))).collect();
    let _ = write!(text, "\"{name}\":[{}]", entries.join(","));
}

fn groups(text: &mut String, name: &str, values: &[f64], size: usize) {
    let rows: Vec<String> = values.chunks(size).map(numbers).collect();
    let _ = write!(text, "\"{name}\":[{}]", rows.join(","));
}
