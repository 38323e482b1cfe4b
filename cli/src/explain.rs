//! What the compiler found out about a mechanism, gathered for people and for machines: its parts, its freedoms, the
//! coordinates and why, the start in the units of its author.

use crate::motion;
use crate::start;
use linkwright_compiler::beams::RK4;
use linkwright_compiler::check::motion::Reflected;
use linkwright_compiler::check::{self, Strain, Vibration};
use linkwright_compiler::counts::Row;
use linkwright_compiler::equations::conditions;
use linkwright_compiler::model::gears::{self, Gives, Told};
use linkwright_compiler::model::{
    ConstraintKind, Coordinate, Coordinates, Event, Frame, JointId, Load, LoadId, Mechanism, Memory,
    Redundant, Table,
};
use linkwright_compiler::schedule::{Function, count, live_values};
use linkwright_compiler::syntax::Definition;
use linkwright_compiler::{Compiled, Repetition, units::Unit};

/// A number in the unit of its author.
#[derive(Clone, Debug)]
pub struct Value {
    pub name: String,
    pub value: f64,
    pub unit: String,
}

/// A parameter, its default and bounds in its unit.
#[derive(Clone, Debug)]
pub struct Parameter {
    pub default: Value,
    pub bounds: Option<[f64; 2]>,
}

/// A body; masses in kg, moments about the centre of mass in kg m², for the default parameters.
#[derive(Clone, Debug)]
pub struct Body {
    pub name: String,
    pub shape: &'static str,
    pub mass: f64,
    /// One in the plane, three in space, none of a particle.
    pub moments: Vec<f64>,
}

/// A mode of a beam by itself.
#[derive(Clone, Debug)]
pub struct Mode {
    pub name: String,
    /// For the default parameters, Hz.
    pub hertz: f64,
    /// The longest step with which the classical Runge–Kutta method is stable, s.
    pub step: f64,
}

/// What a beam is like where the theory ends, for the default parameters and no inputs: [`Strain`].
#[derive(Clone, Debug)]
pub struct Beam {
    pub name: String,
    pub strain: Strain,
}

/// A joint between two places.
#[derive(Clone, Debug)]
pub struct Joint {
    pub name: String,
    pub kind: &'static str,
    pub places: [String; 2],
    /// The body that hangs on it in the spanning tree.
    pub carries: Option<String>,
    /// Whether a penalty acts in place of its rows.
    pub yields: bool,
    /// Whether it has play, and a contact does.
    pub play: bool,
}

/// All that `explain` tells.
#[derive(Clone, Debug)]
pub struct Explanation {
    pub name: String,
    /// As versioned JSON, kinds and units as written.
    pub definition: String,
    pub space: &'static str,
    pub parameters: Vec<Parameter>,
    /// Name and unit.
    pub inputs: Vec<[String; 2]>,
    /// Name and unit.
    pub signals: Vec<[String; 2]>,
    /// At the start.
    pub states: Vec<Value>,
    /// At the start.
    pub memories: Vec<Value>,
    /// Name, when it occurs, and what it sets.
    pub events: Vec<[String; 3]>,
    pub bodies: Vec<Body>,
    pub modes: Vec<Mode>,
    pub beams: Vec<Beam>,
    pub joints: Vec<Joint>,
    /// Name and kind of couplings and drivers.
    pub couplings: Vec<[String; 2]>,
    /// Pairs of toothings that mesh.
    pub teeth: Vec<Told>,
    /// Loads between teeth.
    pub gives: Vec<Gives>,
    /// Meshes whose stiffness follows from the shape of their teeth.
    pub meshes: Vec<MeshOf>,
    pub loads: Vec<[String; 2]>,
    /// Name, and how long a touch takes with which mass.
    pub contacts: Vec<[String; 2]>,
    /// How frictions brake near rest.
    pub frictions: Vec<[String; 2]>,
    /// How joints that yield vibrate.
    pub vibration: Option<Vibration>,
    /// Name, and knots with what stands between them.
    pub tables: Vec<[String; 2]>,
    /// Name and what it is a copy of.
    pub parts: Vec<[String; 2]>,
    /// Drivers removed.
    pub degrees_of_freedom: usize,
    /// Both numbers of freedoms in sentences, and why they differ.
    pub mobility: String,
    /// The range of motion, line by line.
    pub motion: Vec<String>,
    /// What each joint feels at the start, of one degree of freedom.
    pub reflected: Vec<Reflected>,
    /// Freedoms of the bodies less the rows of all joints and couplings.
    pub gruebler: i64,
    pub independent: Vec<String>,
    pub coordinates: &'static str,
    pub choice: String,
    /// What the accelerations are solved for first, where there was a choice.
    pub solution: Option<String>,
    /// What repeats in long functions.
    pub repetition: Vec<Repetition>,
    pub positions: Vec<String>,
    pub velocities: Vec<String>,
    /// Joint, coupling or driver, and the row.
    pub rows: Vec<[String; 2]>,
    pub redundant: Vec<[String; 2]>,
    pub keeps_redundant: bool,
    pub shared_reactions: Vec<String>,
    pub start: Vec<start::Found>,
    /// At the start, all inputs zero.
    pub outputs: Vec<Value>,
    pub functions: Vec<Row>,
}

/// The stiffness of a mesh by the shape of its teeth.
#[derive(Clone, Debug)]
pub struct MeshOf {
    pub name: String,
    /// Of the series.
    pub mean: f64,
    /// At so many places, evenly over a pitch from where a pair begins to touch, N/m: exact, by the series, and how many pairs touch.
    pub places: Vec<(f64, f64, usize)>,
    /// What the series leaves out, rms over the mean, and the largest step of the exact one.
    pub left_out: f64,
    pub step: f64,
}

const PLACES: u32 = 100;

fn meshes(mechanism: &Mechanism) -> Vec<MeshOf> {
    let told = |load: &Load| {
        let (exact, series) = gears::meshes::by_shape(mechanism, load)?;
        let place = |at: u32| {
            let phase = f64::from(at) / f64::from(PLACES);
            (exact.at(phase), series.at(phase), exact.pairs(phase))
        };
        Some(MeshOf {
            name: load.name.text.clone(),
            mean: series.mean,
            places: (0..PLACES).map(place).collect(),
            left_out: series.left_out,
            step: series.step,
        })
    };
    mechanism.loads.iter().filter_map(told).collect()
}

/// Gathers it.
pub fn explain(definition: &Definition, compiled: &Compiled) -> Explanation {
    let Compiled { mechanism, complete, assembly, choice, .. } = compiled;
    let equations = &complete.equations;
    let layout = &equations.layout;
    let coordinates = if choice.coordinates == Coordinates::Absolute { "absolute" } else { "tree" };
    let row = |function: Function| Row {
        model: mechanism.name.text.clone(),
        coordinates,
        function: function.name(),
        counts: count(compiled.programs.get(function)),
        live: live_values(compiled.programs.get(function)),
    };
    let joint = |id: JointId| mechanism.joints[id.0].name.text.clone();
    let name = |coordinate: &Coordinate| conditions::name(mechanism, coordinate);
    let state = start::state(definition, compiled);
    Explanation {
        name: mechanism.name.text.clone(),
        definition: compiled.definition.clone(),
        space: mechanism.space.text(),
        parameters: parameters(definition, mechanism),
        inputs: definition
            .inputs
            .iter()
            .map(|i| [i.name.text.clone(), unit(i.unit.as_ref().map(|u| &u.unit))])
            .collect(),
        signals: mechanism.signals.iter().map(|it| [it.name.text.clone(), it.unit.text.clone()]).collect(),
        states: state.internal,
        memories: memories(mechanism),
        events: events(mechanism),
        bodies: state.bodies,
        modes: modes(mechanism),
        beams: beams(compiled),
        joints: joints(compiled),
        couplings: couplings(mechanism),
        teeth: mechanism.pairs.iter().map(|pair| Told::of(mechanism, pair)).collect(),
        gives: Gives::all(mechanism),
        meshes: meshes(mechanism),
        loads: loads(mechanism),
        contacts: told(compiled, &compiled.blows),
        frictions: told(compiled, &compiled.braking),
        vibration: compiled.vibration,
        tables: mechanism.tables.iter().map(table).collect(),
        parts: mechanism.parts.iter().map(|part| [part.name.text.clone(), part.of.clone()]).collect(),
        degrees_of_freedom: assembly.mobility.generic,
        gruebler: assembly.mobility.counted() as i64,
        mobility: assembly.mobility.to_string(),
        motion: motion::motion(compiled),
        reflected: compiled.reflected(),
        independent: assembly.independent.iter().map(name).collect(),
        coordinates,
        choice: choice.explanation(),
        solution: complete.further.explanation(),
        repetition: compiled.repetition().collect(),
        positions: layout.position_names(mechanism),
        velocities: layout.velocity_names(mechanism),
        rows: equations.rows.iter().map(|row| [row.of.clone(), row.form.name.to_string()]).collect(),
        redundant: assembly.dropped.iter().map(|row| [joint(row.joint), row.form.name.to_string()]).collect(),
        keeps_redundant: mechanism.options.redundant == Redundant::Keep,
        shared_reactions: assembly.shared.iter().map(|id| joint(*id)).collect(),
        start: state.found,
        outputs: state.outputs,
        functions: Function::ALL.map(row).into(),
    }
}

/// A unit as written.
fn unit(unit: Option<&Unit>) -> String {
    unit.map_or("1".to_string(), |unit| unit.text.clone())
}

fn parameters(definition: &Definition, mechanism: &Mechanism) -> Vec<Parameter> {
    let both = definition.parameters.iter().zip(&mechanism.parameters);
    both.map(|(written, known)| {
        let of = written.entry.unit.as_ref().map(|written| &written.unit);
        let scale = of.map_or(1.0, |unit| unit.scale);
        let default = Value { name: known.name.text.clone(), value: known.default / scale, unit: unit(of) };
        Parameter { default, bounds: known.bounds.map(|(least, most)| [least / scale, most / scale]) }
    })
    .collect()
}

fn joints(compiled: &Compiled) -> Vec<Joint> {
    let Compiled { mechanism, complete, .. } = compiled;
    let equations = &complete.equations;
    let carries = |index: usize| {
        let mut attachments = equations.tree.attachments.iter();
        let of_joint = |joint: Option<(JointId, Frame)>| joint.is_some_and(|(id, _)| id.0 == index);
        let body = attachments.find(|attachment| of_joint(attachment.joint))?.body;
        Some(mechanism.bodies[body.0].name.text.clone())
    };
    let joint = |(index, joint): (usize, &linkwright_compiler::model::Joint)| Joint {
        name: joint.name.text.clone(),
        kind: joint.word(),
        places: [joint.first.text.clone(), joint.second.text.clone()],
        carries: carries(index),
        yields: joint.penalty.is_some(),
        play: joint.loose.is_some(),
    };
    mechanism.joints.iter().enumerate().map(joint).collect()
}

fn modes(mechanism: &Mechanism) -> Vec<Mode> {
    let modes = mechanism.modes().into_iter();
    modes.map(|(name, rate)| Mode { name, hertz: rate / std::f64::consts::TAU, step: RK4 / rate }).collect()
}

fn beams(compiled: &Compiled) -> Vec<Beam> {
    let Compiled { mechanism, complete, assembly, .. } = compiled;
    let strains = check::strains(mechanism, &complete.equations, &complete.solved, assembly).into_iter();
    strains.map(|strain| Beam { name: mechanism.bodies[strain.body.0].name.text.clone(), strain }).collect()
}

fn couplings(mechanism: &Mechanism) -> Vec<[String; 2]> {
    let couplings = mechanism.constraints.iter().map(|constraint| {
        let kind = match &constraint.kind {
            ConstraintKind::Coupling(coupling) => coupling.form.call.word,
            ConstraintKind::Equation { .. } => "equation",
            ConstraintKind::Teeth { form, .. } => form.call.word,
        };
        [constraint.name.text.clone(), kind.to_string()]
    });
    let drivers = mechanism.drivers.iter().map(|driver| {
        [driver.name.text.clone(), format!("driver of {}", conditions::name(mechanism, &driver.coordinate))]
    });
    couplings.chain(drivers).collect()
}

/// What was found of loads, by their names.
fn told<T: std::fmt::Display>(compiled: &Compiled, found: &[(LoadId, T)]) -> Vec<[String; 2]> {
    let name = |id: LoadId| compiled.mechanism.loads[id.0].name.text.clone();
    found.iter().map(|(id, found)| [name(*id), found.to_string()]).collect()
}

fn loads(mechanism: &Mechanism) -> Vec<[String; 2]> {
    let loads = mechanism.loads.iter();
    loads.map(|load| [load.name.text.clone(), load.form.title.to_string()]).collect()
}

/// Whether a body has an orientation.
pub fn turns(mechanism: &Mechanism, frame: Frame) -> bool {
    match frame {
        Frame::Ground => true,
        Frame::Body(body) => mechanism.bodies[body.0].form.turns,
    }
}

/// `37 knots of angle from 0 deg to 360 deg, periodic`.
fn table(table: &Table) -> [String; 2] {
    let along = table.arguments.iter().zip(&table.knots).map(|(axis, knots)| {
        let ends = [knots[0], knots[knots.len() - 1]].map(|knot| axis.shown(knot)).join(" to ");
        format!("{} knots of {} from {ends}", knots.len(), axis.name)
    });
    let along: Vec<String> = along.collect();
    [table.name.text.clone(), format!("{}, {}", along.join(", "), table.kind.word())]
}

/// What memories hold at the start, in their units.
fn memories(mechanism: &Mechanism) -> Vec<Value> {
    let value = |memory: &Memory| {
        let (unit, scale) = (memory.unit.text.clone(), memory.unit.scale);
        Value { name: memory.name.text.clone(), value: memory.start / scale, unit }
    };
    mechanism.memories.iter().map(value).collect()
}

fn events(mechanism: &Mechanism) -> Vec<[String; 3]> {
    let said = |event: &Event| {
        let sets = event.sets.iter().map(|(memory, _)| mechanism.memories[memory.0].name.text.as_str());
        let jumps = event.jump.iter().map(|jump| jump.name.clone());
        let sets = sets.map(str::to_string).chain(jumps);
        let sets = format!("sets {}", sets.collect::<Vec<_>>().join(", "));
        [event.name.text.clone(), event.occasion.said(), sets]
    };
    mechanism.events.iter().map(said).collect()
}
