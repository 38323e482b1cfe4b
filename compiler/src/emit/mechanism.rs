//! The implementations of `Variables` and `Mechanism`: M, Φ, D, ν, γ, Q, energies, accelerations and outputs.

use super::function::function;
use super::names::field;
use super::{Emitter, quoted, tables};
use crate::functions::{Function, JACOBIAN, MASS, Shape};
use crate::model::{Expr, Quantity, Rotor};
use std::fmt::Write;

pub fn mechanism(text: &mut String, emitter: &Emitter) {
    let Emitter { name, inner, mechanism, compiled, .. } = emitter;
    let layout = &compiled.equations.layout;
    let mut helpers = String::new();
    variables(text, emitter);
    let _ = writeln!(text, "impl<R: Real> Mechanism<R> for {inner}<R> {{");
    let _ = writeln!(text, "const NAME: &'static str = {};", quoted(name));
    let _ = writeln!(text, "const ROWS: &'static [Row] = {};", tables::rows(emitter));
    let names = [
        ("POSITION_NAMES", layout.position_names(mechanism)),
        ("VELOCITY_NAMES", layout.velocity_names(mechanism)),
    ];
    for (constant, names) in names {
        let _ = writeln!(text, "const {constant}: &'static [&'static str] = {};", tables::strings(names));
    }
    for matrix in [&MASS, &JACOBIAN] {
        tables::pattern(text, emitter, matrix);
    }
    for alias in ["Mass", "Jacobian"] {
        let _ = writeln!(text, "type {alias} = {alias}<R>;");
    }
    for (alias, shape) in [("Inputs", Shape::Inputs), ("Outputs", Shape::Outputs)] {
        let _ = writeln!(text, "type {alias} = {};", emitter.type_of(shape));
    }
    for which in [
        Function::MassMatrix,
        Function::Constraints,
        Function::ConstraintJacobian,
        Function::Nu,
        Function::Gamma,
        Function::Forces,
        Function::KineticEnergy,
        Function::PotentialEnergy,
        Function::Acceleration,
    ] {
        function(text, &mut helpers, emitter, which);
    }
    stabilised(text, &mut helpers, emitter);
    function(text, &mut helpers, emitter, Function::Outputs);
    unwrap(text, emitter);
    text.push_str("}\n");
    text.push_str(&helpers);
}

/// What a state is made of: there are no internal states and no gates yet.
fn variables(text: &mut String, emitter: &Emitter) {
    let _ = writeln!(text, "impl<R: Real> Variables<R> for {}<R> {{", emitter.inner);
    let _ = writeln!(text, "const LAYOUT: Layout = {};", tables::layout(emitter));
    for alias in ["Q", "V", "Lambda"] {
        let _ = writeln!(text, "type {alias} = {alias}<R>;");
    }
    text.push_str("type Z = ();\ntype Gates = ();\n}\n");
}

fn stabilised(text: &mut String, helpers: &mut String, emitter: &Emitter) {
    let stabilised = Function::AccelerationBaumgarte;
    if emitter.entries(Shape::Rows) > 0 {
        return function(text, helpers, emitter, stabilised);
    }
    // Nothing to stabilise.
    let head = emitter.head(stabilised.signature());
    let _ = writeln!(
        text,
        "{head} {{\n<Self as Mechanism<R>>::acceleration(self, time, state, u, a_out, lambda_out)\n}}"
    );
}

fn unwrap(text: &mut String, emitter: &Emitter) {
    let Emitter { mechanism, compiled, .. } = emitter;
    let fields: Vec<String> =
        mechanism.outputs.iter().map(|output| field(&output.name.identifier())).collect();
    // Angles of the dynamics count their turns themselves; the others are unwrapped from sample to sample, the first
    // time from what `start` states.
    let unwrapped = mechanism.outputs.iter().zip(&fields).filter_map(|(output, field)| {
        let rotor = match &output.value {
            Expr::Quantity(Quantity::JointAngle(joint, which)) => Rotor::Joint(*joint, *which),
            Expr::Quantity(Quantity::BodyAngle(body)) => Rotor::Body(*body),
            _ => return None,
        };
        let counted = compiled.equations.layout.angles.iter().any(|angle| angle.rotor == rotor);
        (!counted).then_some((rotor, field))
    });
    let unwrapped: Vec<(Rotor, &String)> = unwrapped.collect();
    let of = emitter.type_of(Shape::Outputs);
    let _ = writeln!(text, "fn unwrap(outputs: &mut {of}, previous: &{of}) {{");
    for (_, field) in &unwrapped {
        let _ = writeln!(text, "outputs.{field} = unwrap_angle(outputs.{field}, previous.{field});");
    }
    text.push_str("}\n");
    let stated: Vec<(&String, usize)> = unwrapped
        .iter()
        .filter_map(|(rotor, field)| {
            let mut conditions = compiled.equations.conditions.iter().zip(&compiled.equations.start_targets);
            let at = conditions.position(|(condition, target)| {
                target.position.is_some()
                    && match (&condition.quantity, rotor) {
                        (Quantity::JointAngle(own, which), Rotor::Joint(joint, angle)) => {
                            own == joint && which == angle
                        }
                        (Quantity::BodyAngle(own), Rotor::Body(body)) => own == body,
                        _ => false,
                    }
            })?;
            Some((*field, at))
        })
        .collect();
    if stated.is_empty() {
        return;
    }
    let zeros = format!("[R::ZERO; {}]", emitter.entries(Shape::Conditions));
    let _ = writeln!(text, "fn unwrap_start(&self, outputs: &mut {of}) {{");
    let _ = writeln!(text, "let (mut positions, mut rates) = ({zeros}, {zeros});");
    text.push_str("self.start_targets(&mut positions, &mut rates);\n");
    for (field, at) in stated {
        let _ = writeln!(text, "outputs.{field} = unwrap_angle(outputs.{field}, positions[{at}]);");
    }
    text.push_str("}\n");
}
