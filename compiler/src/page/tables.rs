//! What a mechanism consists of, as tables: parts, bodies, joints, couplings, drivers, loads, parameters, inputs, outputs,
//! coordinates and where they start, constraint rows.

use super::table::{Table, code};
use super::text::decimal;
use crate::compiled::Compiled;
use crate::equations::conditions;
use crate::equations::coordinates::rotor_name;
use crate::forms::Law;
use crate::model::gears::Pair;
use crate::model::{
    Body, ConstraintKind, Coupled, Expr, Frame, JointId, Load, LoadId, Mechanism, Name, Rotor, Space,
    Subject, Vector, fold,
};
use std::collections::BTreeSet;

pub fn bodies(page: &mut String, compiled: &Compiled) {
    let mechanism = &compiled.mechanism;
    let mut table = Table::new(&[
        "body",
        "shape",
        "mass, kg",
        "inertia, kg m²",
        "products, kg m²",
        "centre, m",
        "hangs on",
    ]);
    for (index, body) in mechanism.bodies.iter().enumerate() {
        let attachment = compiled.complete.equations.tree.attachments.iter().find(|it| it.body.0 == index);
        let carrier = attachment.and_then(|it| it.joint);
        table.row(vec![
            code(&body.name.text),
            body.form.word.to_string(),
            value(mechanism, &body.mass),
            inertia(mechanism, body),
            if is_zero(&body.inertia.products) {
                String::new()
            } else {
                vector(mechanism, &body.inertia.products, 3)
            },
            if is_zero(&body.center) {
                String::new()
            } else {
                vector(mechanism, &body.center, mechanism.space.dimensions())
            },
            carrier
                .map_or_else(|| "nothing: free".to_string(), |(joint, _)| code(joint_name(mechanism, joint))),
        ]);
    }
    table.write(page, "Bodies");
}

fn joint_name(mechanism: &Mechanism, joint: JointId) -> &str {
    &mechanism.joints[joint.0].name.text
}

fn inertia(mechanism: &Mechanism, body: &Body) -> String {
    match mechanism.space {
        _ if !body.form.turns => String::new(),
        Space::Planar => value(mechanism, &body.inertia.moments[2]),
        Space::Spatial => vector(mechanism, &body.inertia.moments, 3),
    }
}

fn is_zero(vector: &Vector) -> bool {
    vector.iter().all(|x| matches!(x, Expr::Number(0.0)))
}

/// What was declared once and used by name, with what it brings.
pub fn parts(page: &mut String, compiled: &Compiled) {
    let mechanism = &compiled.mechanism;
    let mut table = Table::new(&["part", "is", "bodies", "joints", "loads"]);
    for part in &mechanism.parts {
        let prefix = format!("{}.", part.name.text);
        let own = |names: &mut dyn Iterator<Item = &Name>| -> String {
            let own = names.filter_map(|name| name.text.strip_prefix(&prefix)).map(code);
            own.collect::<Vec<_>>().join(", ")
        };
        table.row(vec![
            code(&part.name.text),
            code(&part.of),
            own(&mut mechanism.bodies.iter().map(|body| &body.name)),
            own(&mut mechanism.joints.iter().map(|joint| &joint.name)),
            own(&mut mechanism.loads.iter().map(|load| &load.name)),
        ]);
    }
    table.write(page, "Parts");
}

pub fn joints(page: &mut String, compiled: &Compiled) {
    let mechanism = &compiled.mechanism;
    let equations = &compiled.complete.equations;
    let mut table =
        Table::new(&["joint", "kind", "first place", "second place", "quantities", "in the equations"]);
    for (index, joint) in mechanism.joints.iter().enumerate() {
        let names = joint.form;
        let quantities = names.angles.iter().chain(names.travels).map(|[quantity, _]| *quantity);
        let quantities: Vec<String> = quantities.chain(names.effort()).map(code).collect();
        let own = equations.rows.iter().filter(|row| row.joint() == Some(JointId(index)));
        let rows: Vec<String> = own.map(|row| code(row.form.name)).collect();
        let carried =
            equations.tree.attachments.iter().find(|it| it.joint.is_some_and(|(own, _)| own.0 == index));
        let part = match carried {
            Some(attachment) => format!("carries {}", code(&mechanism.bodies[attachment.body.0].name.text)),
            None if joint.loose.is_some() => "has play".to_string(),
            None if !joint.holds() => "yields".to_string(),
            None if rows.is_empty() => "none of its rows is needed".to_string(),
            None => format!("rows {}", rows.join(", ")),
        };
        table.row(vec![
            code(&joint.name.text),
            code(joint.word()),
            code(&joint.first.text),
            code(&joint.second.text),
            quantities.join(", "),
            part,
        ]);
    }
    table.write(page, "Joints");
}

pub fn couplings(page: &mut String, compiled: &Compiled) {
    let mechanism = &compiled.mechanism;
    let mut table = Table::new(&["coupling", "what it holds"]);
    for constraint in &mechanism.constraints {
        let coordinate = |coupled| match coupled {
            Coupled::Angle(rotor) => code(&format!("{}.angle", rotor_name(mechanism, rotor))),
            Coupled::Travel(joint) => code(&format!("{}.travel", joint_name(mechanism, joint))),
        };
        let holds = match &constraint.kind {
            ConstraintKind::Coupling(coupling) => {
                let (_, dimension) = coupling.kind.factor;
                let unit = if dimension.is_one() { String::new() } else { format!("{dimension} ") };
                let (driven, other) = (coordinate(coupling.driven()), coordinate(coupling.other()));
                format!("{driven} = {} {unit}· {other} + phase", value(mechanism, &coupling.factor))
            }
            ConstraintKind::Equation { .. } => "an equation; its row stands under Φ".to_string(),
            ConstraintKind::Teeth { pair, .. } => teeth(mechanism, &mechanism.pairs[*pair]),
        };
        table.row(vec![code(&constraint.name.text), holds]);
    }
    for driver in &mechanism.drivers {
        let quantity = code(&conditions::name(mechanism, &driver.coordinate));
        table.row(vec![code(&driver.name.text), format!("{quantity} follows a law of time")]);
    }
    table.write(page, "Couplings and drivers");
}

/// Σ z θ = constant, and what the pair is.
fn teeth(mechanism: &Mechanism, pair: &Pair) -> String {
    let term = |(factor, rotor): &(f64, Rotor)| {
        format!("{factor} {}", code(&format!("{}.angle", rotor_name(mechanism, *rotor))))
    };
    let travel = |(factor, joint): &(f64, JointId)| {
        format!("{} {}", decimal(*factor), code(&format!("{}.travel", joint_name(mechanism, *joint))))
    };
    let terms: Vec<String> = pair.terms.iter().map(term).chain(pair.travels.iter().map(travel)).collect();
    let held = if pair.follows.is_some() { "; the pairs before it hold it already" } else { "" };
    format!("{} = const{held}", terms.join(" + ").replace("+ -", "− "))
}

pub fn loads(page: &mut String, compiled: &Compiled) {
    let mechanism = &compiled.mechanism;
    let mut table = Table::new(&["load", "kind", "on", "data"]);
    for load in &mechanism.loads {
        let on = load.on.iter().map(|subject| match subject {
            Subject::Place(place) => code(&place.text),
            Subject::Rotor(rotor) => code(rotor_name(mechanism, *rotor)),
            Subject::Travel(joint) | Subject::Bearing(joint, _) | Subject::Joint(joint) => {
                code(joint_name(mechanism, *joint))
            }
            Subject::Touches(contact) => code(&mechanism.loads[contact.0].name.text),
            Subject::Body(body) => code(&mechanism.bodies[body.0].name.text),
            Subject::Expression(..) => "an expression".to_string(),
            Subject::Toothing(id) => code(&mechanism.toothing(*id).text),
        });
        let on: Vec<String> = on.collect();
        let blow = told(mechanism, &compiled.blows, load);
        let data = match (load.form.law, blow) {
            (Law::None, _) => match told(mechanism, &compiled.braking, load) {
                Some(braking) => format!("{}; {braking}", arguments(mechanism, load)),
                None => arguments(mechanism, load),
            },
            (_, Some(blow)) => blow,
            (Law::Value(_) | Law::Conjugate | Law::Components(_), None) => law(mechanism, &load.law),
        };
        table.row(vec![code(&load.name.text), load.form.title.to_string(), on.join(", "), data]);
    }
    table.write(page, "Loads");
    if let Some(vibration) = compiled.vibration {
        page.push_str(&format!("\nOf joints that yield, {vibration}.\n"));
    }
}

/// What was found of a load.
fn told<T: std::fmt::Display>(mechanism: &Mechanism, found: &[(LoadId, T)], load: &Load) -> Option<String> {
    let named = |id: LoadId| mechanism.loads[id.0].name.text == load.name.text;
    found.iter().find(|(id, _)| named(*id)).map(|(_, found)| found.to_string())
}

/// The named arguments that are not zero.
fn arguments(mechanism: &Mechanism, load: &Load) -> String {
    let is_zero = |values: &[Expr]| values.iter().all(|expr| matches!(expr, Expr::Number(0.0)));
    let given = load.arguments().filter(|(_, values)| !is_zero(values));
    let texts = given.map(|(argument, values)| {
        let values: Vec<String> = values.iter().map(|expr| value(mechanism, expr)).collect();
        let values = match &values[..] {
            [first, others @ ..] if others.iter().all(|other| other == first) => first.clone(),
            several => format!("({})", several.join(", ")),
        };
        let unit = argument.dimension().map(|dimension| dimension.to_string().replace('*', " "));
        format!("{} {values} {}", argument.name.replace('_', " "), unit.unwrap_or_default())
    });
    texts.collect::<Vec<_>>().join(", ")
}

/// What a law depends on.
fn law(mechanism: &Mechanism, components: &[Expr]) -> String {
    let (mut names, mut moves) = (BTreeSet::new(), false);
    components.iter().for_each(|expr| named(mechanism, expr, &mut names, &mut moves));
    let mut names: Vec<String> = names.into_iter().map(|name| code(&name)).collect();
    if moves {
        names.push("the motion".to_string());
    }
    if names.is_empty() {
        let values: Vec<String> = components.iter().map(|expr| value(mechanism, expr)).collect();
        return format!("constant, {}", values.join(", "));
    }
    format!("a law of {}", names.join(", "))
}

pub fn settings(page: &mut String, compiled: &Compiled) {
    let mechanism = &compiled.mechanism;
    let mut table = Table::new(&["parameter", "unit as written", "default, SI", "bounds, SI"]);
    for parameter in &mechanism.parameters {
        let bounds = parameter.bounds.map(|(least, most)| format!("{} to {}", decimal(least), decimal(most)));
        table.row(vec![
            code(&parameter.name.text),
            code(&parameter.unit.text),
            decimal(parameter.default),
            bounds.unwrap_or_default(),
        ]);
    }
    table.write(page, "Parameters");
    let mut table = Table::new(&["input", "unit as written, given in SI"]);
    for input in &mechanism.inputs {
        table.row(vec![code(&input.name.text), code(&input.unit.text)]);
    }
    table.write(page, "Inputs");
    let mut table = Table::new(&["signal", "unit as written"]);
    for signal in &mechanism.signals {
        table.row(vec![code(&signal.name.text), code(&signal.unit.text)]);
    }
    table.write(page, "Signals");
    let mut table = Table::new(&["state", "unit as written", "at the start, SI", "scale, SI"]);
    for state in &mechanism.states {
        let scale = state.scale.map_or(String::new(), decimal);
        let start = value(mechanism, &state.start);
        table.row(vec![code(&state.name.text), code(&state.unit.text), start, scale]);
    }
    table.write(page, "States");
    let mut table = Table::new(&["memory", "unit as written", "at the start, SI"]);
    for memory in &mechanism.memories {
        table.row(vec![code(&memory.name.text), code(&memory.unit.text), decimal(memory.start)]);
    }
    table.write(page, "Memories");
    let mut table = Table::new(&["event", "occurs", "sets"]);
    for event in &mechanism.events {
        let sets = event.sets.iter().map(|(memory, _)| code(&mechanism.memories[memory.0].name.text));
        let sets = sets.chain(event.jump.iter().map(|jump| code(&jump.name)));
        table.row(vec![code(&event.name.text), event.occasion.said(), sets.collect::<Vec<_>>().join(", ")]);
    }
    table.write(page, "Events");
    let mut table = Table::new(&["output", "unit as written, given in SI"]);
    for output in &mechanism.outputs {
        table.row(vec![code(&output.name.text), code(&output.unit.text)]);
    }
    table.write(page, "Outputs");
}

/// q beside v, with their values at the start.
pub fn coordinates(page: &mut String, compiled: &Compiled) {
    let layout = &compiled.complete.equations.layout;
    let (q, v) = (layout.position_names(&compiled.mechanism), layout.velocity_names(&compiled.mechanism));
    // What is left of a zero by rounding is one.
    let settled = |values: &[f64]| -> Vec<f64> {
        values.iter().map(|value| if value.abs() < 1e-12 { 0.0 } else { *value }).collect()
    };
    let (at, rate) = (settled(&compiled.assembly.q), settled(&compiled.assembly.v));
    let (linear, rotations) = (layout.linear.len(), layout.rotations.len());
    let mut table = Table::new(&["#", "q", "at the start", "v", "at the start "]);
    for index in 0..linear {
        let unit = if layout.linear[index].is_length(&compiled.mechanism) { "m" } else { "rad" };
        let row = [q[index].clone(), format!("{} {unit}", decimal(at[index]))];
        table.row(coordinate(index, row, &v[index], format!("{} {unit}/s", decimal(rate[index]))));
    }
    for r in 0..rotations {
        let (index, pair) = (linear + r, layout.pair(r));
        let degrees = libm::atan2(at[pair + 1], at[pair]).to_degrees();
        let row = [format!("{}`, `{}", q[pair], q[pair + 1]), format!("{}°", decimal(degrees))];
        table.row(coordinate(index, row, &v[index], format!("{} rad/s", decimal(rate[index]))));
    }
    for b in 0..layout.quaternions.len() {
        let (first, omega) = (layout.quaternion(b), layout.omega(b));
        for axis in 0..3 {
            // Four entries beside three rates.
            let own = if axis == 0 { first..first + 2 } else { first + 1 + axis..first + 2 + axis };
            let values: Vec<String> = own.clone().map(|k| decimal(at[k])).collect();
            let row = [q[own].join("`, `"), values.join(", ")];
            let index = omega + axis;
            table.row(coordinate(index, row, &v[index], format!("{} rad/s", decimal(rate[index]))));
        }
    }
    for a in 0..layout.angles.len() {
        let turns = layout.turns(a);
        let value = format!("{}, {} rad", decimal(at[turns]), decimal(at[turns + 1]));
        let name = format!("`{}`, `{}`", q[turns], q[turns + 1]);
        table.row(vec![String::new(), name, value, String::new(), String::new()]);
    }
    table.write(page, "Coordinates");
}

fn coordinate(index: usize, [q, at]: [String; 2], v: &str, rate: String) -> Vec<String> {
    vec![index.to_string(), format!("`{q}`"), at, code(v), rate]
}

/// Constraint rows, and those that are left out.
pub fn rows(page: &mut String, compiled: &Compiled) {
    let mechanism = &compiled.mechanism;
    let mut table = Table::new(&["#", "of", "row", "components along"]);
    for (index, row) in compiled.complete.equations.rows.iter().enumerate() {
        let axes = match row.axes {
            None => String::new(),
            Some(Frame::Ground) => "the world".to_string(),
            Some(Frame::Body(body)) => code(&mechanism.bodies[body.0].name.text),
        };
        table.row(vec![index.to_string(), code(&row.of), code(row.form.name), axes]);
    }
    table.write(page, "Constraint rows");
    let mut table = Table::new(&["redundant row of", "row"]);
    for row in &compiled.assembly.dropped {
        table.row(vec![code(joint_name(mechanism, row.joint)), code(row.form.name)]);
    }
    table.write(page, "Redundant rows");
    if !compiled.assembly.shared.is_empty() {
        let shared: Vec<String> =
            compiled.assembly.shared.iter().map(|joint| code(joint_name(mechanism, *joint))).collect();
        page.push_str(&format!(
            "\nThe others fix what these fix; the reactions of {} are not unique.\n",
            shared.join(", ")
        ));
    }
}

fn vector(mechanism: &Mechanism, vector: &Vector, dimensions: usize) -> String {
    let values: Vec<String> = vector.iter().take(dimensions).map(|x| value(mechanism, x)).collect();
    format!("({})", values.join(", "))
}

/// The value at the defaults, and the parameters that it depends on.
fn value(mechanism: &Mechanism, expr: &Expr) -> String {
    let defaults: Vec<f64> = mechanism.parameters.iter().map(|parameter| parameter.default).collect();
    let value = fold::evaluate(expr, &defaults).map(decimal);
    let (mut names, mut moves) = (BTreeSet::new(), false);
    named(mechanism, expr, &mut names, &mut moves);
    let names: Vec<String> = names.into_iter().map(|name| code(&name)).collect();
    match (value, names.is_empty()) {
        (Some(value), true) => value,
        (Some(value), false) => format!("{value} by {}", names.join(", ")),
        (None, _) => format!("by {}", names.join(", ")),
    }
}

/// Parameters, inputs, states and time in an expression, and whether it depends on the motion.
fn named(mechanism: &Mechanism, expr: &Expr, names: &mut BTreeSet<String>, moves: &mut bool) {
    expr.visit(&mut |expr| match expr {
        Expr::Parameter(id) => {
            names.insert(mechanism.parameters[id.0].name.text.clone());
        }
        Expr::Input(id) => {
            names.insert(mechanism.inputs[id.0].name.text.clone());
        }
        Expr::State(id) => {
            names.insert(mechanism.states[id.0].name.text.clone());
        }
        Expr::Memory(id) => {
            names.insert(mechanism.memories[id.0].name.text.clone());
        }
        Expr::Time => {
            names.insert("time".to_string());
        }
        Expr::Quantity(_) | Expr::Gate(..) => *moves = true,
        _ => {}
    });
}
