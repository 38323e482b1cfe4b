//! The assembled start in the units of its author: what `start` states, all coordinates of joints, the centres of the bodies,
//! outputs; and the masses that the default parameters give. All by interpreting the equations there.

use crate::explain::{Body, Value, turns};
use linkwright_compiler::Compiled;
use linkwright_compiler::check::assemble::{Ancestry, Point};
use linkwright_compiler::equations::{Equations, Laws, conditions};
use linkwright_compiler::model::{BodyId, Coordinate, InternalState, JointId, Mechanism, Rotor, Space};
use linkwright_compiler::symbolic::Node;
use linkwright_compiler::syntax::{Definition, Entry};
use linkwright_compiler::units::{Dimension, Unit};

/// What `start` says of a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Given {
    Stated,
    Guessed,
    Nothing,
}

impl Given {
    pub fn text(self) -> &'static str {
        match self {
            Given::Stated => "stated",
            Given::Guessed => "near its guess",
            Given::Nothing => "found",
        }
    }
}

/// A quantity at the start.
#[derive(Clone, Debug)]
pub struct Found {
    pub value: Value,
    pub given: Given,
}

/// What the equations say at the start.
pub struct State {
    pub bodies: Vec<Body>,
    pub found: Vec<Found>,
    pub internal: Vec<Value>,
    pub outputs: Vec<Value>,
}

/// A coordinate or rate that is asked for.
struct Asked {
    name: String,
    coordinate: Coordinate,
    /// Whether its rate is asked for.
    rate: bool,
    given: Given,
    unit: (String, f64),
}

/// Evaluates it all.
pub fn state(definition: &Definition, compiled: &Compiled) -> State {
    let mechanism = &compiled.mechanism;
    let asked = asked(definition, mechanism);
    let equations = compiled.complete.equations.clone();
    let coordinates: Vec<Coordinate> = asked.iter().map(|asked| asked.coordinate.clone()).collect();
    let known = &compiled.complete.conditions;
    let (all, conditions) = known.with(mechanism, &equations, &coordinates);
    let masses = masses(mechanism, &equations);
    let mut point = Point::at_start(mechanism, &equations, &compiled.assembly);
    let jets = conditions.iter().map(|index| &all.rows[*index].jet);
    point.evaluate(&Ancestry::of_jets(&equations, jets));
    let found = asked.into_iter().zip(&conditions).map(|(asked, index)| {
        let jet = &all.rows[*index].jet;
        let si = if asked.rate {
            let moved = jet.columns.iter().map(|(k, node)| point.get(*node) * compiled.assembly.v[*k]);
            moved.sum::<f64>() + point.get(jet.drift)
        } else {
            point.get(jet.value)
        };
        let (unit, scale) = asked.unit;
        Found { value: Value { name: asked.name, value: si / scale, unit }, given: asked.given }
    });
    let mut found: Vec<Found> = found.collect();
    found.extend(centers(definition, compiled, &equations, &mut point, &found));
    let outputs = outputs(definition, compiled, &mut point);
    let internal = internal(compiled);
    State { bodies: bodies(definition, mechanism, &mut point, &masses), found, internal, outputs }
}

/// What `start` mentions, then all other coordinates of joints.
fn asked(definition: &Definition, mechanism: &Mechanism) -> Vec<Asked> {
    let mut asked: Vec<Asked> = Vec::new();
    for start in &mechanism.start {
        // A mode at rest is not written.
        let is_rest =
            start.rate && matches!(start.coordinate, Coordinate::Mode(..)) && !start.text.ends_with(".rate");
        let written = definition.start.iter().find(|written| !is_rest && written.quantity.text == start.text);
        let own = written.and_then(|written| written.entry.unit.as_ref()).map(|unit| &unit.unit);
        let unit = own.map_or_else(
            || {
                let known = &start.coordinate;
                unit(definition, if start.rate { known.rate_dimension() } else { known.dimension() })
            },
            |unit| (unit.text.clone(), unit.scale),
        );
        let given = if start.exact { Given::Stated } else { Given::Guessed };
        let coordinate = start.coordinate.clone();
        let name = if is_rest { format!("{}.rate", start.text) } else { start.text.clone() };
        asked.push(Asked { name, coordinate, rate: start.rate, given, unit });
    }
    for (index, joint) in mechanism.joints.iter().enumerate() {
        let names = joint.form;
        let angles = if [joint.first.frame, joint.second.frame].iter().all(|frame| turns(mechanism, *frame)) {
            names.angles.len()
        } else {
            0
        };
        let angles = (0..angles).map(|which| Coordinate::Angle(Rotor::Joint(JointId(index), which)));
        let travels = (0..names.travels.len()).map(|which| Coordinate::Travel(JointId(index), which));
        for coordinate in angles.chain(travels) {
            if asked.iter().all(|known| known.rate || known.coordinate != coordinate) {
                let name = conditions::name(mechanism, &coordinate);
                let unit = unit(definition, coordinate.dimension());
                asked.push(Asked { name, coordinate, rate: false, given: Given::Nothing, unit });
            }
        }
    }
    asked
}

/// The first unit of `start` for this dimension and its SI value, else that of the SI.
fn unit(definition: &Definition, dimension: Dimension) -> (String, f64) {
    let mut units =
        definition.start.iter().filter_map(|start| start.entry.unit.as_ref()).map(|unit| &unit.unit);
    let found: Option<&Unit> = units.find(|unit| unit.dimension == dimension);
    found.map_or_else(|| (dimension.to_string(), 1.0), |unit| (unit.text.clone(), unit.scale))
}

/// Centres of mass, of what bends the origins of its frame, unless `start` mentions them.
fn centers(
    definition: &Definition,
    compiled: &Compiled,
    equations: &Equations,
    point: &mut Point,
    known: &[Found],
) -> Vec<Found> {
    let (unit, scale) = unit(definition, Dimension::LENGTH);
    let mut found = Vec::new();
    let axes = compiled.mechanism.space.dimensions();
    for (body, motion) in compiled.mechanism.bodies.iter().zip(&equations.motions) {
        point.evaluate(&Ancestry::of(equations, motion.position.iter().copied()));
        let place = if body.deforms.is_some() { "origin" } else { "center" };
        for (axis, node) in ["x", "y", "z"].iter().zip(&motion.position).take(axes) {
            let name = format!("{}.{place}.{axis}", body.name.text);
            if known.iter().all(|known| known.value.name != name) {
                let value = Value { name, value: point.get(*node) / scale, unit: unit.clone() };
                found.push(Found { value, given: Given::Nothing });
            }
        }
    }
    found
}

fn internal(compiled: &Compiled) -> Vec<Value> {
    let both = compiled.mechanism.states.iter().zip(compiled.mechanism.internal_starts());
    let value = |(state, start): (&InternalState, f64)| {
        let (unit, scale) = (state.unit.text.clone(), state.unit.scale);
        Value { name: state.name.text.clone(), value: start / scale, unit }
    };
    both.map(value).collect()
}

/// The unit of a declaration, and one of it in SI.
fn unit_of(entry: &Entry) -> (String, f64) {
    let unit = entry.unit.as_ref().map(|written| &written.unit);
    unit.map_or(("1".to_string(), 1.0), |unit| (unit.text.clone(), unit.scale))
}

fn outputs(definition: &Definition, compiled: &Compiled, point: &mut Point) -> Vec<Value> {
    let outputs = &compiled.complete.solved.outputs;
    point.evaluate(&Ancestry::of(point.equations, outputs.iter().copied()));
    let both = definition.outputs.iter().zip(outputs);
    both.map(|(output, node)| {
        let (text, scale) = unit_of(&output.entry);
        Value { name: output.name.text.clone(), value: point.get(*node) / scale, unit: text }
    })
    .collect()
}

/// The nodes of mass and moments of each body.
fn masses(mechanism: &Mechanism, equations: &Equations) -> Vec<Vec<Node>> {
    let laws = Laws::moving(
        equations.graph.sheet(),
        mechanism,
        &equations.symbols,
        &equations.layout,
        &equations.kinematics,
    );
    let nodes = mechanism.bodies.iter().map(|body| {
        let mut nodes = vec![laws.value(&body.mass).bare];
        if body.form.turns {
            let moments = laws.vector(&body.inertia.moments).bare;
            nodes.extend(if mechanism.space == Space::Planar { &moments[2..] } else { &moments[..] });
        }
        nodes
    });
    nodes.collect()
}

fn bodies(
    definition: &Definition,
    mechanism: &Mechanism,
    point: &mut Point,
    masses: &[Vec<Node>],
) -> Vec<Body> {
    point.evaluate(&Ancestry::of(point.equations, masses.iter().flatten().copied()));
    let body = |(index, nodes): (usize, &Vec<Node>)| {
        let values: Vec<f64> = nodes.iter().map(|node| point.get(*node)).collect();
        let BodyId(index) = BodyId(index);
        Body {
            name: mechanism.bodies[index].name.text.clone(),
            shape: definition.bodies[index].form.word,
            mass: values[0],
            moments: values[1..].to_vec(),
        }
    };
    masses.iter().enumerate().map(body).collect()
}
