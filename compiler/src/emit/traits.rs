//! The implementations of the runtime's traits and the model's own functions.

use super::body::{constant, literal};
use super::names::{Argument, field};
use super::{Emitter, array, quoted, tables};
use crate::model::{Expr, Quantity, Rotor, Space};
use crate::schedule::{Function, Operand};
use std::fmt::Write;

use Argument::{
    Acceleration, BetaSquared, Compliance, Constants, GivenForces, GivenRows, Inputs, Lambda, Lu, Parameters,
    Phases, Q, Store, Target, Time, TwoAlpha, V,
};

/// Arguments of the solution: of `acceleration`, and the first of `acceleration_baumgarte`.
pub const SOLUTION: [Argument; 5] = [Constants, Time, Q, V, Inputs];

/// Short names for the types of this mechanism.
pub fn aliases(text: &mut String, emitter: &Emitter) {
    let name = &emitter.name;
    let equations = &emitter.compiled.equations;
    let columns = |jets: Vec<&crate::equations::Jet>| jets.iter().map(|jet| jet.columns.len()).sum::<usize>();
    let freedoms = emitter.velocities() + equations.idle.len() - emitter.rows();
    let arrays = [
        ("Constants", emitter.compiled.programs.prepared),
        ("Phases", equations.symbols.phases.len()),
        ("Q", emitter.positions()),
        ("V", emitter.velocities()),
        ("Lambda", emitter.rows()),
        ("Mass", equations.mass.len()),
        ("Jacobian", columns(equations.rows.iter().map(|row| &row.jet).collect())),
        ("Conditions", emitter.conditions()),
        ("ConditionJacobian", columns(equations.conditions.iter().map(|c| &c.jet).collect())),
        ("Factor", emitter.compiled.table.columns.len()),
        ("System", emitter.compiled.table.order.len()),
        ("Dense", emitter.rows() * emitter.velocities()),
        ("Basis", freedoms * emitter.velocities()),
        ("Reduced", freedoms * freedoms),
        ("Store", emitter.compiled.solved.stored.as_ref().map_or(0, |stored| stored.kept.len())),
        ("Lu", emitter.compiled.solved.null_space.as_ref().map_or(0, |written| written.kept.len())),
    ];
    let solved = &emitter.compiled.solved;
    let absent = |alias: &str| {
        alias == "Store" && solved.stored.is_none() || alias == "Lu" && solved.null_space.is_none()
    };
    for (alias, length) in arrays.into_iter().filter(|(alias, _)| !absent(alias)) {
        let _ = writeln!(text, "type {alias}<R> = [R; {length}];");
    }
    let _ = writeln!(text, "type Parameters<R> = {name}Parameters<R>;");
    if !emitter.mechanism.inputs.is_empty() {
        let _ = writeln!(text, "type Inputs<R> = {name}Inputs<R>;");
    }
    if !emitter.mechanism.outputs.is_empty() {
        let _ = writeln!(text, "type Outputs<R> = {name}Outputs<R>;");
    }
}

/// `Fields` of the parameters, and of the inputs and outputs where there are any.
pub fn fields(text: &mut String, emitter: &Emitter) {
    let Emitter { name, mechanism, .. } = emitter;
    let parameters = mechanism.parameters.iter().map(|parameter| &parameter.name).collect::<Vec<_>>();
    let inputs = mechanism.inputs.iter().map(|input| &input.name).collect();
    let outputs = mechanism.outputs.iter().map(|output| &output.name).collect();
    for (of, names) in [("Parameters", parameters), ("Inputs", inputs), ("Outputs", outputs)] {
        if names.is_empty() && of != "Parameters" {
            continue;
        }
        let n = names.len();
        let fields: Vec<String> = names.iter().map(|name| field(&name.identifier())).collect();
        let scalar = if names.is_empty() { "scalar: ::core::marker::PhantomData" } else { "" };
        let given: Vec<String> =
            fields.iter().enumerate().map(|(index, field)| format!("{field}: values[{index}]")).collect();
        let _ = writeln!(
            text,
            "impl<R: Real> Fields<R> for {of}<R> {{\n\
             const NAMES: &'static [&'static str] = {};\n\
             type Array = [R; {n}];\n\
             fn from_array(values: [R; {n}]) -> Self {{ {name}{of} {{ {}{scalar} }} }}\n\
             fn to_array(&self) -> [R; {n}] {{ {} }}\n}}",
            tables::strings(names.iter().map(|name| name.text.clone()).collect()),
            given.join(", "),
            array(fields.iter().map(|field| format!("self.{field}")))
        );
    }
}

/// One function: signature, loads, instructions, result.
pub fn function(
    text: &mut String,
    helpers: &mut String,
    emitter: &Emitter,
    function: Function,
    arguments: &[Argument],
    signature: &str,
    result: impl Fn(&[String]) -> String,
) {
    let body = emitter.body(function, arguments, helpers);
    let _ = writeln!(text, "fn {signature} {{");
    let uses = |text: &String| text.contains("constants");
    if uses(&body.statements) || body.outputs.iter().any(uses) {
        text.push_str("let constants = &self.constants;\n");
    }
    text.push_str(&body.statements);
    let _ = writeln!(text, "{}\n}}", result(&body.outputs));
}

pub fn all(outputs: &[String]) -> String {
    format!("*out = {};", array(outputs.iter().cloned()))
}

fn one(outputs: &[String]) -> String {
    outputs[0].clone()
}

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
    if open_rows(emitter).is_empty() {
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

/// `[a, b, c]` of texts.
fn list(texts: &[String]) -> String {
    array(texts.iter().cloned())
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
        |outputs| array(outputs.iter().cloned()),
    );
    text.push_str("/// Power of each load (W), in the order of `LOADS`, what springs store included.\npub ");
    function(
        text,
        helpers,
        emitter,
        Function::Powers,
        &[Constants, Time, Q, V, Inputs],
        &format!("powers(&self, time: R, q: &Q<R>, v: &V<R>, u: &Inputs<R>) -> [R; {loads}]"),
        |outputs| array(outputs.iter().cloned()),
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
        let rotor = match &output.value {
            Expr::Quantity(Quantity::JointAngle(joint, which)) => Rotor::Joint(*joint, *which),
            Expr::Quantity(Quantity::BodyAngle(body)) => Rotor::Body(*body),
            _ => return None,
        };
        let counted = compiled.equations.layout.angles.iter().any(|angle| angle.rotor == rotor);
        (!counted).then_some((rotor, field))
    });
    let unwrapped: Vec<(Rotor, &String)> = unwrapped.collect();
    text.push_str("fn unwrap(outputs: &mut Outputs<R>, previous: &Outputs<R>) {\n");
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
    let zeros = format!("[R::ZERO; {}]", emitter.conditions());
    text.push_str("fn unwrap_start(&self, outputs: &mut Outputs<R>) {\n");
    let _ = writeln!(text, "let (mut positions, mut rates) = ({zeros}, {zeros});");
    text.push_str("self.start_targets(&mut positions, &mut rates);\n");
    for (field, at) in stated {
        let _ = writeln!(text, "outputs.{field} = unwrap_angle(outputs.{field}, positions[{at}]);");
    }
    text.push_str("}\n");
}

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
    let upright = equations.rows.iter().enumerate().filter(|(_, row)| row.upright.is_some());
    let _ = writeln!(text, "impl<R: Real> Assemble<R> for {inner}<R> {{");
    let _ = writeln!(text, "const CONDITIONS: &'static [Condition] = {};", tables::conditions(emitter));
    let lists = [
        ("START_CONDITIONS", stated(false)),
        ("START_RATES", stated(true)),
        ("INDEPENDENT", tables::indices(compiled.independent.iter().copied())),
        ("FLIPS", tables::indices(upright.map(|(index, _)| index))),
    ];
    for (constant, list) in lists {
        let _ = writeln!(text, "const {constant}: &'static [u16] = {list};");
    }
    if !equations.idle.is_empty() {
        let idle = tables::indices(equations.idle.iter().copied());
        let _ = writeln!(text, "const IDLE: &'static [u16] = {idle};");
    }
    if compiled.partition.pivots().next().is_some() {
        let pivots = tables::pairs(compiled.partition.pivots().map(|pivot| (pivot.row, pivot.velocity)));
        let _ = writeln!(text, "const DEPENDENT: &'static [(u16, u16)] = {pivots};");
    }
    if compiled.partition.scales.iter().any(|scale| *scale != 1.0) {
        let scales = array(compiled.partition.scales.iter().map(|scale| literal(*scale)));
        let _ = writeln!(text, "const SCALES: &'static [f64] = &{scales};");
    }
    let massless = &compiled.solved.massless;
    if !massless.rows.is_empty() {
        let rows = tables::indices(massless.rows.iter().copied());
        let _ = writeln!(text, "const MASSLESS_ROWS: &'static [u16] = {rows};");
        let _ = writeln!(text, "const MASSLESS_WEIGHT: f64 = {};", literal(massless.weight));
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
    write(
        Function::StartTargets,
        &[Constants],
        "start_targets(&self, positions: &mut Conditions<R>, rates: &mut Conditions<R>)",
        |outputs| {
            let (positions, rates) = outputs.split_at(outputs.len() / 2);
            let list = |values: &[String]| array(values.iter().cloned());
            format!("*positions = {};\n*rates = {};", list(positions), list(rates))
        },
    );
    factorisation(text, &mut helpers, emitter);
    null_space(text, &mut helpers, emitter);
    let numbers = |values: &[f64]| array(values.iter().map(|value| constant(*value)));
    let _ = writeln!(text, "fn start_q() -> Q<R> {{ {} }}", numbers(&compiled.assembly.q));
    let _ = writeln!(text, "fn start_v() -> V<R> {{ {} }}", numbers(&compiled.assembly.v));
    let open = open_rows(emitter);
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

/// K(c), written out where that is asked for, else by tables.
fn factorisation(text: &mut String, helpers: &mut String, emitter: &Emitter) {
    let Some(stored) = &emitter.compiled.solved.stored else {
        text.push_str(
            "type Store = tabled::Store<R, Self>;\n\
             fn store() -> Self::Store { tabled::store::<R, Self>() }\n\
             fn factor(&self, time: R, q: &Q<R>, compliance: R, store: &mut Self::Store) -> R {\n\
             tabled::factor::<R, Self>(self, time, q, compliance, store)\n}\n\
             fn solve(&self, store: &Self::Store, forces: &V<R>, rows: &Lambda<R>, a: &mut V<R>, lambda: &mut Lambda<R>) {\n\
             tabled::solve::<R, Self>(store, forces, rows, a, lambda)\n}\n",
        );
        return;
    };
    let (kept, velocities) = (stored.kept.len(), emitter.velocities());
    let _ = writeln!(text, "type Store = Store<R>;\nfn store() -> Store<R> {{ [R::ZERO; {kept}] }}");
    let list = |values: &[String]| array(values.iter().cloned());
    function(
        text,
        helpers,
        emitter,
        Function::Factor,
        &[Constants, Time, Q, Compliance],
        "factor(&self, time: R, q: &Q<R>, compliance: R, store: &mut Store<R>) -> R",
        |outputs| format!("*store = {};\n{}", list(&outputs[..kept]), outputs[kept]),
    );
    function(
        text,
        helpers,
        emitter,
        Function::Solve,
        &[Constants, Store, GivenForces, GivenRows],
        "solve(&self, store: &Store<R>, forces: &V<R>, rows: &Lambda<R>, a_out: &mut V<R>, lambda_out: &mut Lambda<R>)",
        |outputs| {
            let (a, lambda) = outputs.split_at(velocities);
            format!("*a_out = {};\n*lambda_out = {};", list(a), list(lambda))
        },
    );
    if !emitter.compiled.solved.emits_system {
        return;
    }
    let rows = kept + velocities;
    function(
        text,
        helpers,
        emitter,
        Function::System,
        &[Constants, Time, Q, V, Inputs, TwoAlpha, BetaSquared, Compliance],
        "system(&self, time: R, q: &Q<R>, v: &V<R>, u: &Inputs<R>, two_alpha: R, beta_squared: R, compliance: R, \
         store_out: &mut Store<R>, forces_out: &mut V<R>, rows_out: &mut Lambda<R>) -> R",
        |outputs| {
            let (rest, pivot) = outputs.split_at(outputs.len() - 1);
            format!(
                "*store_out = {};\n*forces_out = {};\n*rows_out = {};\n{}",
                list(&rest[..kept]),
                list(&rest[kept..rows]),
                list(&rest[rows..]),
                pivot[0]
            )
        },
    );
}

/// The equations in independent velocities, where they are asked for; the runtime has them by tables.
fn null_space(text: &mut String, helpers: &mut String, emitter: &Emitter) {
    let Some(written) = &emitter.compiled.solved.null_space else {
        text.push_str("type Lu = ();\nfn lu() {}\n");
        return;
    };
    let (kept, velocities) = (written.kept.len(), emitter.velocities());
    let _ = writeln!(text, "type Lu = Lu<R>;\nfn lu() -> Lu<R> {{ [R::ZERO; {kept}] }}");
    let list = |values: &[String]| array(values.iter().cloned());
    function(
        text,
        helpers,
        emitter,
        Function::FactorJacobian,
        &[Constants, Time, Q],
        "factor_jacobian(&self, time: R, q: &Q<R>, lu: &mut Lu<R>) -> R",
        |outputs| format!("*lu = {};\n{}", list(&outputs[..kept]), outputs[kept]),
    );
    function(
        text,
        helpers,
        emitter,
        Function::DependentVelocities,
        &[Constants, Lu, GivenRows, V],
        "dependent_velocities(&self, lu: &Lu<R>, rows: &Lambda<R>, v: &V<R>, out: &mut V<R>)",
        all,
    );
    function(
        text,
        helpers,
        emitter,
        Function::NullSpace,
        &SOLUTION,
        "null_space(&self, time: R, q: &Q<R>, v: &V<R>, u: &Inputs<R>, a_out: &mut V<R>, \
         lambda_out: &mut Lambda<R>) -> R",
        solution_of(velocities),
    );
}

/// v̇ and λ to where they go, the pivot as the result.
fn solution_of(velocities: usize) -> impl Fn(&[String]) -> String {
    move |outputs| {
        let (a, rest) = outputs.split_at(velocities);
        let (lambda, pivot) = rest.split_at(rest.len() - 1);
        format!(
            "*a_out = {};\n*lambda_out = {};\n{}",
            array(a.iter().cloned()),
            array(lambda.iter().cloned()),
            pivot[0]
        )
    }
}

/// Rows of the couplings whose phase comes from the assembled start.
fn open_rows(emitter: &Emitter) -> Vec<usize> {
    let constraints = emitter.mechanism.constraints.iter();
    let open = constraints.filter(|constraint| crate::equations::couplings::is_open(constraint));
    let rows = &emitter.compiled.equations.rows;
    open.filter_map(|c| rows.iter().position(|row| row.joint.is_none() && row.of == c.name.text)).collect()
}
