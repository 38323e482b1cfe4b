//! The implementation of `Mechanism`: M, Φ, D, ν, γ, Q, energies, accelerations and outputs.

use super::function::{SOLUTION, all, function, one, solution_of};
use super::names::{Argument, field};
use super::{Emitter, quoted, tables};
use crate::model::{Coordinate, Expr, Quantity};
use crate::schedule::Function;
use std::fmt::Write;

use Argument::{BetaSquared, Constants, Inputs, Q, Time, TwoAlpha, V};

pub fn mechanism(text: &mut String, emitter: &Emitter) {
    let Emitter { name, inner, mechanism, compiled, .. } = emitter;
    let layout = &compiled.equations.layout;
    let mut helpers = String::new();
    let _ = writeln!(text, "impl<R: Real> Mechanism<R> for {inner}<R> {{");
    let _ = writeln!(text, "const NAME: &'static str = {};", quoted(name));
    let _ = writeln!(text, "const LAYOUT: Layout = {};", tables::layout(emitter));
    let _ = writeln!(text, "const ROWS: &'static [Row] = {};", tables::rows(emitter));
    let names = [
        ("POSITION_NAMES", layout.position_names(mechanism)),
        ("VELOCITY_NAMES", layout.velocity_names(mechanism)),
    ];
    for (constant, names) in names {
        let _ = writeln!(text, "const {constant}: &'static [&'static str] = {};", tables::strings(names));
    }
    let _ = writeln!(text, "const MASS_PATTERN: &'static [(u16, u16)] = {};", tables::mass_pattern(emitter));
    let jets = compiled.equations.rows.iter().map(|row| &row.jet);
    let _ =
        writeln!(text, "const JACOBIAN_PATTERN: &'static [(u16, u16)] = {};", tables::jacobian_pattern(jets));
    for alias in ["Q", "V", "Lambda", "Mass", "Jacobian", "Inputs", "Outputs"] {
        let _ = writeln!(text, "type {alias} = {alias}<R>;");
    }
    let mut write =
        |which: Function, arguments: &[Argument], signature: &str, result: fn(&[String]) -> String| {
            function(text, &mut helpers, emitter, which, arguments, signature, result);
        };
    let position = [Constants, Time, Q];
    let state = [Constants, Time, Q, V];
    let with_inputs = [Constants, Time, Q, V, Inputs];
    write(Function::MassMatrix, &position, "mass_matrix(&self, time: R, q: &Q<R>, out: &mut Mass<R>)", all);
    write(
        Function::Constraints,
        &position,
        "constraints(&self, time: R, q: &Q<R>, out: &mut Lambda<R>)",
        all,
    );
    write(
        Function::ConstraintJacobian,
        &position,
        "constraint_jacobian(&self, time: R, q: &Q<R>, out: &mut Jacobian<R>)",
        all,
    );
    write(Function::Nu, &position, "nu(&self, time: R, q: &Q<R>, out: &mut Lambda<R>)", all);
    write(Function::Gamma, &state, "gamma(&self, time: R, q: &Q<R>, v: &V<R>, out: &mut Lambda<R>)", all);
    write(
        Function::Forces,
        &with_inputs,
        "forces(&self, time: R, q: &Q<R>, v: &V<R>, u: &Inputs<R>, out: &mut V<R>)",
        all,
    );
    write(Function::KineticEnergy, &state, "kinetic_energy(&self, time: R, q: &Q<R>, v: &V<R>) -> R", one);
    write(Function::PotentialEnergy, &position, "potential_energy(&self, time: R, q: &Q<R>) -> R", one);

    let solution = solution_of(emitter.velocities());
    function(
        text,
        &mut helpers,
        emitter,
        Function::Acceleration,
        &SOLUTION,
        "acceleration(&self, time: R, q: &Q<R>, v: &V<R>, u: &Inputs<R>, a_out: &mut V<R>, \
         lambda_out: &mut Lambda<R>) -> R",
        &solution,
    );
    let stabilised = "acceleration_baumgarte(&self, time: R, q: &Q<R>, v: &V<R>, u: &Inputs<R>, two_alpha: R, \
                      beta_squared: R, a_out: &mut V<R>, lambda_out: &mut Lambda<R>) -> R";
    if emitter.rows() == 0 {
        // Nothing to stabilise.
        let _ = writeln!(
            text,
            "fn {stabilised} {{\n<Self as Mechanism<R>>::acceleration(self, time, q, v, u, a_out, lambda_out)\n}}"
        );
    } else {
        let [constants, time, q, v, inputs] = SOLUTION;
        function(
            text,
            &mut helpers,
            emitter,
            Function::AccelerationBaumgarte,
            &[constants, time, q, v, inputs, TwoAlpha, BetaSquared],
            stabilised,
            solution,
        );
    }
    outputs(text, &mut helpers, emitter);
    text.push_str("}\n");
    text.push_str(&helpers);
}

fn outputs(text: &mut String, helpers: &mut String, emitter: &Emitter) {
    let Emitter { name, mechanism, compiled, .. } = emitter;
    let fields: Vec<String> =
        mechanism.outputs.iter().map(|output| field(&output.name.identifier())).collect();
    function(
        text,
        helpers,
        emitter,
        Function::Outputs,
        &[Constants, Time, Q, V, Inputs],
        "outputs(&self, time: R, q: &Q<R>, v: &V<R>, u: &Inputs<R>) -> Outputs<R>",
        |outputs| {
            if outputs.is_empty() {
                return String::new();
            }
            let values: Vec<String> =
                fields.iter().zip(outputs).map(|(field, value)| format!("{field}: {value}")).collect();
            format!("{name}Outputs {{ {} }}", values.join(", "))
        },
    );
    // Angles of the dynamics count their turns themselves; the others are unwrapped from sample to sample, the first
    // time from what `start` states.
    let unwrapped = mechanism.outputs.iter().zip(&fields).filter_map(|(output, field)| {
        let Expr::Quantity(Quantity::Coordinate(coordinate @ Coordinate::Angle(rotor))) = &output.value
        else {
            return None;
        };
        let counted = compiled.equations.layout.angles.iter().any(|angle| angle.rotor == *rotor);
        (!counted).then_some((coordinate, field))
    });
    let unwrapped: Vec<(&Coordinate, &String)> = unwrapped.collect();
    text.push_str("fn unwrap(outputs: &mut Outputs<R>, previous: &Outputs<R>) {\n");
    for (_, field) in &unwrapped {
        let _ = writeln!(text, "outputs.{field} = unwrap_angle(outputs.{field}, previous.{field});");
    }
    text.push_str("}\n");
    let stated: Vec<(&String, usize)> = unwrapped
        .iter()
        .filter_map(|(angle, field)| {
            let mut conditions = compiled.equations.conditions.iter().zip(&compiled.equations.start_targets);
            let at = conditions.position(|(condition, target)| {
                target.position.is_some() && condition.coordinate == **angle
            })?;
            Some((*field, at))
        })
        .collect();
    if stated.is_empty() {
        return;
    }
    let zeros = format!("[R::ZERO; {}]", emitter.conditions());
    text.push_str("fn unwrap_start(&self, outputs: &mut Outputs<R>) {\n");
    let _ = writeln!(text, "let (mut positions, mut rates) = ({zeros}, {zeros});");
    text.push_str("self.start_targets(&mut positions, &mut rates);\n");
    for (field, at) in stated {
        let _ = writeln!(text, "outputs.{field} = unwrap_angle(outputs.{field}, positions[{at}]);");
    }
    text.push_str("}\n");
}
