//! The model's own functions: `prepare`, `parameters`, and what follows from a state.

use super::body::{constant, literal};
use super::function::{function, list};
use super::names::{Argument, field};
use super::{Emitter, array, quoted};
use crate::model::Space;
use crate::schedule::{Function, Operand};
use std::fmt::Write;

use Argument::{Acceleration, Constants, Inputs, Lambda, Parameters, Phases, Q, Time, V};

/// `prepare`, `parameters`, and what follows from a state.
pub fn inherent(text: &mut String, emitter: &Emitter) {
    let Emitter { name, inner, mechanism, compiled, .. } = emitter;
    let mut helpers = String::new();
    let defaults = mechanism
        .parameters
        .iter()
        .map(|parameter| format!("{}: {}", field(&parameter.name.identifier()), constant(parameter.default)));
    let scalar = mechanism.parameters.is_empty().then(|| "scalar: ::core::marker::PhantomData".to_string());
    let defaults = defaults.chain(scalar).collect::<Vec<_>>().join(", ");
    let phases = array(compiled.assembly.phases.iter().map(|phase| constant(*phase)));
    let _ = writeln!(
        text,
        "impl<R: Real> Default for Parameters<R> {{ fn default() -> Self {{ {name}Parameters {{ {defaults} }} }} }}"
    );
    let _ = writeln!(
        text,
        "impl<R: Real> Default for {inner}<R> {{ \
         fn default() -> Self {{ Self::with(Default::default(), {phases}) }} }}"
    );
    let _ = writeln!(text, "impl<R: Real> {inner}<R> {{");
    let _ = writeln!(
        text,
        "/// The model with these parameters; what depends on nothing else is computed once, here.\n\
         ///\n/// # Errors\n/// A parameter that is not finite or out of its bounds, or a mass that is not positive.\n\
         pub fn prepare(parameters: Parameters<R>) -> Result<Self, SettingError> {{"
    );
    for parameter in &mechanism.parameters {
        let (what, field) = (quoted(&parameter.name.text), field(&parameter.name.identifier()));
        let _ = match parameter.bounds {
            None => writeln!(text, "check_finite({what}, parameters.{field})?;"),
            Some((least, most)) => writeln!(
                text,
                "check_setting({what}, parameters.{field}, {}, {}, {})?;",
                literal(least),
                literal(most),
                quoted(&format!("from {least:?} to {most:?} in SI units, by its declaration"))
            ),
        };
    }
    if emitter.compiled.equations.open_rows(emitter.mechanism).is_empty() {
        let _ = writeln!(text, "let model = Self::with(parameters, {phases});");
    } else {
        // Open phases belong to the start position; these parameters may ask for others there.
        let _ = writeln!(text, "let mut model = Self::with(parameters, {phases});");
        text.push_str("model.fix_phases(&<Self as Assemble<R>>::start_q());\n");
    }
    masses(text, emitter);
    text.push_str("check_constants(&model.constants)?;\nOk(model)\n}\n");
    let _ = writeln!(
        text,
        "/// The parameters the model was prepared with.\npub fn parameters(&self) -> &Parameters<R> {{ &self.parameters }}"
    );
    let body = emitter.body(Function::Prepare, &[Parameters, Phases], &mut helpers);
    let _ = writeln!(
        text,
        "fn with(parameters: Parameters<R>, phases: Phases<R>) -> Self {{\n{}\
         Self {{ parameters, phases, constants: {} }}\n}}",
        body.statements,
        array(body.outputs)
    );
    motions(text, &mut helpers, emitter);
    text.push_str("}\n");
    text.push_str(&helpers);
}

/// Masses and inertias that depend on parameters must stay what mass and inertia are.
fn masses(text: &mut String, emitter: &Emitter) {
    let names = emitter.names.within(&[], &[]);
    let program = emitter.compiled.programs.get(Function::Masses);
    for ((what, positive), output) in emitter.compiled.masses.iter().zip(&program.outputs) {
        let Operand::Source(source) = output else { continue };
        let place = names.place(*source).unwrap_or_default();
        let _ = writeln!(text, "check_mass({}, model.{place}, {positive})?;", quoted(what));
    }
}

fn planar_motion(o: &[String]) -> String {
    format!(
        "BodyMotion {{ position: {}, orientation: {}, velocity: {}, rate: {}, acceleration: {}, angular_acceleration: {} }}",
        list(&o[..2]),
        list(&o[2..4]),
        list(&o[4..6]),
        o[6],
        list(&o[7..9]),
        o[9]
    )
}

fn spatial_motion(o: &[String]) -> String {
    format!(
        "SpatialMotion {{ position: {}, orientation: [{}, {}, {}], velocity: {}, rate: {}, acceleration: {}, \
         angular_acceleration: {} }}",
        list(&o[..3]),
        list(&o[3..6]),
        list(&o[6..9]),
        list(&o[9..12]),
        list(&o[12..15]),
        list(&o[15..18]),
        list(&o[18..21]),
        list(&o[21..])
    )
}

fn motions(text: &mut String, helpers: &mut String, emitter: &Emitter) {
    let mechanism = emitter.mechanism;
    let (motion, reaction) = match mechanism.space {
        Space::Planar => ("BodyMotion", "Reaction"),
        Space::Spatial => ("SpatialMotion", "SpatialReaction"),
    };
    let (bodies, joints, loads, drivers) =
        (mechanism.bodies.len(), mechanism.joints.len(), mechanism.loads.len(), mechanism.drivers.len());
    text.push_str(
        "/// Position, velocity and acceleration of every body's centre of mass, in the order of `BODIES`,\n\
         /// from a state and its accelerations.\npub ",
    );
    function(
        text,
        helpers,
        emitter,
        Function::Motions,
        &[Constants, Time, Q, V, Acceleration],
        &format!("motions(&self, time: R, q: &Q<R>, v: &V<R>, a: &V<R>) -> [{motion}<R>; {bodies}]"),
        |outputs| match mechanism.space {
            Space::Planar => array(outputs.chunks(10).map(planar_motion)),
            Space::Spatial => array(outputs.chunks(24).map(spatial_motion)),
        },
    );
    text.push_str(
        "/// Force and torque that each joint exerts on the body of its second place, in the order of `JOINTS`:\n\
         /// force in world axes at that place (N), torque about it (N m).\npub ",
    );
    function(
        text,
        helpers,
        emitter,
        Function::Reactions,
        &[Constants, Time, Q, V, Inputs, Acceleration, Lambda],
        &format!(
            "reactions(&self, time: R, q: &Q<R>, v: &V<R>, u: &Inputs<R>, a: &V<R>, lambda: &Lambda<R>) -> \
             [{reaction}<R>; {joints}]"
        ),
        |outputs| match mechanism.space {
            Space::Planar => array(
                outputs
                    .chunks(3)
                    .map(|o| format!("Reaction {{ force: [{}, {}], torque: {} }}", o[0], o[1], o[2])),
            ),
            Space::Spatial => array(outputs.chunks(6).map(|o| {
                format!("SpatialReaction {{ force: {}, torque: {} }}", list(&o[..3]), list(&o[3..]))
            })),
        },
    );
    text.push_str(
        "/// M v̇ − Q: the forces that the accelerations `a` need beside loads and constraints, one for each velocity\n\
         /// (N m or N). Of a tree without constraints these are the efforts of its joints (inverse dynamics).\npub ",
    );
    function(
        text,
        helpers,
        emitter,
        Function::InverseDynamics,
        &[Constants, Time, Q, V, Inputs, Acceleration],
        "inverse_dynamics(&self, time: R, q: &Q<R>, v: &V<R>, u: &Inputs<R>, a: &V<R>) -> V<R>",
        list,
    );
    text.push_str("/// Power of each load (W), in the order of `LOADS`, what springs store included.\npub ");
    function(
        text,
        helpers,
        emitter,
        Function::Powers,
        &[Constants, Time, Q, V, Inputs],
        &format!("powers(&self, time: R, q: &Q<R>, v: &V<R>, u: &Inputs<R>) -> [R; {loads}]"),
        list,
    );
    text.push_str(
        "/// Effort of each driver along its quantity (N m or N) and its power (W), from the multipliers.\npub ",
    );
    function(
        text,
        helpers,
        emitter,
        Function::DriverEfforts,
        &[Constants, Time, Q, V, Lambda],
        &format!(
            "driver_efforts(&self, time: R, q: &Q<R>, v: &V<R>, lambda: &Lambda<R>) -> [[R; 2]; {drivers}]"
        ),
        |outputs| {
            let (efforts, powers) = outputs.split_at(outputs.len() / 2);
            array(efforts.iter().zip(powers).map(|(effort, power)| format!("[{effort}, {power}]")))
        },
    );
}
