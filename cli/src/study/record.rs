//! What is kept of a run: columns with names and units, a row for each sample, and what the summary is made of.

use super::expression::unknown;
use super::methods::EngineState;
use linkwright_compiler::Compiled;
use linkwright_compiler::functions::{MOTION, REACTION, Record};
use linkwright_compiler::model::{Coordinate, DeclaredUnit, Space};
use linkwright_engine::{Engine, Numbers};
use linkwright_runtime::{Mechanism as _, Residual, Vector};

/// What a column is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    Outputs,
    Inputs,
    State,
    Energy,
    Residual,
    Reactions,
    Efforts,
    Powers,
    Motions,
}

impl Group {
    pub const ALL: [Group; 9] = [
        Group::Outputs,
        Group::Inputs,
        Group::State,
        Group::Energy,
        Group::Residual,
        Group::Reactions,
        Group::Efforts,
        Group::Powers,
        Group::Motions,
    ];

    pub fn text(self) -> &'static str {
        match self {
            Group::Outputs => "outputs",
            Group::Inputs => "inputs",
            Group::State => "state",
            Group::Energy => "energy",
            Group::Residual => "residual",
            Group::Reactions => "reactions",
            Group::Efforts => "efforts",
            Group::Powers => "powers",
            Group::Motions => "motions",
        }
    }

    /// The groups of a list `outputs,energy`.
    pub fn list(text: &str) -> Result<Vec<Group>, String> {
        let group = |word: &str| {
            let found = Group::ALL.into_iter().find(|group| group.text() == word);
            let all = Group::ALL.into_iter().map(Group::text);
            found.ok_or_else(|| unknown("--show: nothing is called", word, all))
        };
        if text == "all" {
            return Ok(Group::ALL.into());
        }
        text.split(',').map(|word| group(word.trim())).collect()
    }

    /// Whether v̇ and λ have to be known.
    fn needs_solution(self) -> bool {
        matches!(self, Group::Reactions | Group::Efforts | Group::Motions)
    }
}

/// A column.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    pub group: Group,
    pub name: String,
    pub unit: String,
    /// One of the unit in SI.
    pub scale: f64,
}

/// The columns of these groups.
pub fn columns(compiled: &Compiled, groups: &[Group]) -> Vec<Column> {
    let mechanism = &compiled.mechanism;
    let layout = &compiled.complete.equations.layout;
    let mut columns = Vec::new();
    for &group in groups {
        let mut add = |name: String, unit: &str, scale: f64| {
            columns.push(Column { group, name, unit: unit.to_string(), scale });
        };
        let declared = |unit: &DeclaredUnit| (unit.text.clone(), unit.scale);
        match group {
            Group::Outputs => mechanism.outputs.iter().for_each(|output| {
                let (unit, scale) = declared(&output.unit);
                add(output.name.text.clone(), &unit, scale);
            }),
            Group::Inputs => mechanism.inputs.iter().for_each(|input| {
                let (unit, scale) = declared(&input.unit);
                add(input.name.text.clone(), &unit, scale);
            }),
            Group::State => {
                let names =
                    layout.position_names(mechanism).into_iter().chain(layout.velocity_names(mechanism));
                names.for_each(|name| add(name, "SI", 1.0));
                mechanism.states.iter().for_each(|state| {
                    let (unit, scale) = declared(&state.unit);
                    add(state.name.text.clone(), &unit, scale);
                });
            }
            Group::Energy => ["kinetic_energy", "potential_energy", "energy"]
                .iter()
                .for_each(|name| add(name.to_string(), "J", 1.0)),
            Group::Residual => {
                add("position_residual".to_string(), "m", 1.0);
                add("velocity_residual".to_string(), "m/s", 1.0);
            }
            Group::Reactions => {
                let joints = mechanism.joints.iter().map(|joint| joint.name.text.as_str());
                of_records(joints, &REACTION, mechanism.space).for_each(|(name, unit)| add(name, unit, 1.0));
            }
            Group::Motions => {
                let bodies = mechanism.bodies.iter().map(|body| body.name.text.as_str());
                of_records(bodies, &MOTION, mechanism.space).for_each(|(name, unit)| add(name, unit, 1.0));
            }
            Group::Efforts => {
                let drivers = || mechanism.drivers.iter().map(|driver| driver.name.text.as_str());
                mechanism.drivers.iter().for_each(|driver| {
                    let unit = match driver.coordinate {
                        Coordinate::Angle(_) => "N*m",
                        Coordinate::Travel(..) | Coordinate::Position(..) | Coordinate::Distance(..) => "N",
                        _ => "SI",
                    };
                    add(format!("{}.effort", driver.name.text), unit, 1.0);
                });
                drivers().for_each(|name| add(format!("{name}.power"), "W", 1.0));
            }
            Group::Powers => {
                mechanism.loads.iter().for_each(|load| add(format!("{}.power", load.name.text), "W", 1.0))
            }
        }
    }
    columns
}

/// Name and unit of each number of the entries: `pin.force.x`, N.
fn of_records<'n>(
    names: impl Iterator<Item = &'n str>,
    record: &'static Record,
    space: Space,
) -> impl Iterator<Item = (String, &'static str)> {
    let kind = record.of(space);
    let fields: Vec<(String, &'static str)> = kind
        .fields
        .iter()
        .flat_map(|field| {
            let unit = match field.name {
                "position" => "m",
                "velocity" => "m/s",
                "acceleration" => "m/s^2",
                "rate" => "rad/s",
                "angular_acceleration" => "rad/s^2",
                "force" => "N",
                "torque" => "N*m",
                _ => "1",
            };
            let axes = ["x", "y", "z"];
            let length = field.length();
            (0..length).map(move |index| {
                let own = match (field.name, length) {
                    (name, 1) => name.to_string(),
                    ("orientation", 2) => format!("orientation.{}", ["cos", "sin"][index]),
                    ("orientation", _) => format!("orientation.{}{}", axes[index / 3], axes[index % 3]),
                    (name, _) => format!("{name}.{}", axes[index]),
                };
                (own, unit)
            })
        })
        .collect();
    names.flat_map(move |name| {
        let entry = |(field, unit): &(String, &'static str)| (format!("{name}.{field}"), *unit);
        fields.iter().map(entry).collect::<Vec<_>>()
    })
}

/// A run.
#[derive(Clone, Debug, Default)]
pub struct Trajectory {
    pub columns: Vec<Column>,
    pub times: Vec<f64>,
    /// Row by row, in the units of the columns.
    pub values: Vec<f64>,
    pub extremes: Extremes,
}

/// What the summary tells.
#[derive(Clone, Copy, Debug)]
pub struct Extremes {
    /// Kinetic and potential energy at the start, at the end, and their least and largest sum, J.
    pub energy: [f64; 2],
    pub energy_range: [f64; 2],
    /// The largest residuals and when.
    pub position: [f64; 2],
    pub velocity: [f64; 2],
}

impl Default for Extremes {
    fn default() -> Self {
        Extremes {
            energy: [f64::NAN; 2],
            energy_range: [f64::INFINITY, f64::NEG_INFINITY],
            position: [0.0; 2],
            velocity: [0.0; 2],
        }
    }
}

impl Trajectory {
    pub fn new(columns: Vec<Column>) -> Self {
        Trajectory { columns, ..Trajectory::default() }
    }

    pub fn rows(&self) -> impl ExactSizeIterator<Item = &[f64]> {
        // Without columns a row is nothing, and there is one for each time all the same.
        let width = self.columns.len();
        (0..self.times.len()).map(move |row| &self.values[row * width..(row + 1) * width])
    }

    /// Adds a sample.
    pub fn add<D: 'static>(
        &mut self,
        engine: &Engine<D>,
        groups: &[Group],
        time: f64,
        state: &EngineState,
        inputs: &Numbers,
        outputs: &Numbers,
    ) {
        let kinetic = engine.kinetic_energy(time, &state.q, &state.v);
        let potential = engine.potential_energy(time, state);
        let residual = Residual::of(engine, time, state);
        self.extremes.add(self.times.is_empty(), time, kinetic + potential, &residual);
        let needs_solution = groups.iter().any(|group| group.needs_solution());
        let solved = needs_solution.then(|| engine.solution_at(time, state, inputs));
        let from = self.values.len();
        for group in groups {
            match (group, &solved) {
                (Group::Outputs, _) => self.values.extend_from_slice(outputs.as_slice()),
                (Group::Inputs, _) => self.values.extend_from_slice(inputs.as_slice()),
                (Group::State, _) => [&state.q, &state.v, &state.z]
                    .iter()
                    .for_each(|part| self.values.extend_from_slice(part.as_slice())),
                (Group::Energy, _) => self.values.extend([kinetic, potential, kinetic + potential]),
                (Group::Residual, _) => self.values.extend([residual.position, residual.velocity]),
                (Group::Powers, _) => {
                    self.values.extend_from_slice(engine.powers(time, state, inputs).as_slice());
                }
                (Group::Reactions, Some(solved)) => {
                    let (a, lambda) = (&solved.acceleration, &solved.multipliers);
                    let reactions = engine.reactions(time, state, inputs, a, lambda);
                    self.values.extend_from_slice(reactions.as_slice());
                }
                (Group::Motions, Some(solved)) => {
                    let motions = engine.motions(time, &state.q, &state.v, &solved.acceleration);
                    self.values.extend_from_slice(motions.as_slice());
                }
                (Group::Efforts, Some(solved)) => {
                    let efforts = engine.driver_efforts(time, &state.q, &state.v, &solved.multipliers);
                    self.values.extend_from_slice(efforts.as_slice());
                }
                (Group::Reactions | Group::Motions | Group::Efforts, None) => {}
            }
        }
        for (value, column) in self.values[from..].iter_mut().zip(&self.columns) {
            if column.scale != 1.0 {
                *value /= column.scale;
            }
        }
        self.times.push(time);
    }
}

impl Extremes {
    fn add(&mut self, is_first: bool, time: f64, energy: f64, residual: &Residual) {
        if is_first {
            self.energy[0] = energy;
        }
        self.energy[1] = energy;
        self.energy_range = [self.energy_range[0].min(energy), self.energy_range[1].max(energy)];
        for (largest, now) in
            [(&mut self.position, residual.position), (&mut self.velocity, residual.velocity)]
        {
            if now > largest[0] {
                *largest = [now, time];
            }
        }
    }
}
