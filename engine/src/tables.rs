//! The tables of a mechanism as the runtime asks for them: patterns, rows, conditions, layout, the order of elimination.

use crate::names;
use linkwright_compiler::Compiled;
use linkwright_compiler::forms::row::Whole;
use linkwright_compiler::functions::{
    CONDITION_JACOBIAN, DERIVATIVES, Function, JACOBIAN, MASS, MOTION, REACTION, Shape, Sparse,
};
use linkwright_compiler::model::{Name, Occasion, Way};
use linkwright_compiler::schedule::Operand;
use linkwright_runtime::{Condition, ConditionKind, Elimination, Flips, Layout, MultiTurn, Row, Trigger};

/// Row and column of each stored entry of a matrix.
pub type Pattern = Vec<(u16, u16)>;

pub struct Tables {
    pub name: &'static str,
    pub fingerprint: u64,
    pub layout: Layout<'static>,
    pub rows: Vec<Row>,
    pub positions: &'static [&'static str],
    pub velocities: &'static [&'static str],
    pub internal: &'static [&'static str],
    /// The contact of each gate that is held, events and memories, and what is held at the start.
    pub gates: &'static [&'static str],
    pub start_gates: Vec<f64>,
    pub memories: &'static [&'static str],
    pub triggers: Vec<Trigger>,
    /// Whether gates are forces, of rigid contacts or of dry friction in joints.
    pub rigid: bool,
    /// Whether they are those of dry friction in joints.
    pub sticks: bool,
    /// Of each gate that of the gap which presses, where it is dry friction.
    pub pressed_by: Vec<Option<usize>>,
    /// Of each gate the first that slides as one with it, where any slides along several directions.
    pub slide_as_one: Vec<usize>,
    /// Whether they part by Poisson's law.
    pub by_impulses: bool,
    pub internal_scales: Vec<f64>,
    pub inputs: &'static [&'static str],
    pub outputs: &'static [&'static str],
    pub parameters: &'static [&'static str],
    pub mass: Pattern,
    pub jacobian: Pattern,
    /// In the order of [`DERIVATIVES`].
    pub derivatives: Vec<Pattern>,
    pub null_space_first: bool,
    pub conditions: Vec<Condition>,
    pub start_conditions: Vec<u16>,
    pub start_rates: Vec<u16>,
    /// Conditions that a driver's law states.
    pub driven: Vec<u16>,
    pub independent: Vec<u16>,
    pub condition_jacobian: Pattern,
    pub flips: Vec<Flips<'static>>,
    pub idle: Vec<u16>,
    pub dependent: Pattern,
    pub scales: Vec<f64>,
    pub massless_rows: Vec<u16>,
    pub massless_weights: Vec<f64>,
    order: Vec<u16>,
    position: Vec<u16>,
    row_start: Vec<u32>,
    columns: Vec<u16>,
    /// Coordinates of linearised motions.
    pub states: Vec<u16>,
    /// Of the parameters, SI.
    pub defaults: Vec<f64>,
    pub bounds: Vec<Option<(f64, f64)>>,
    /// Masses and inertias, whether they must be positive, and whether they depend on parameters.
    pub masses: Vec<(&'static str, bool, bool)>,
    /// What the start gives.
    pub start_q: Vec<f64>,
    pub start_v: Vec<f64>,
    pub phases: Vec<f64>,
    pub row_sizes: Vec<f64>,
    /// Entries of what is kept of K(c), and of D = L U.
    pub store: usize,
    pub lu: usize,
    /// Numbers of the motion of a body, and of the reaction of a joint.
    pub lengths: [usize; 2],
    /// Rows whose phase is that of the start.
    pub open: Vec<usize>,
    /// Outputs that are angles whose turns nothing counts, and the condition of the start that states them.
    pub angles: Vec<(usize, Option<usize>)>,
}

impl Tables {
    pub fn of(compiled: &Compiled) -> Tables {
        let Compiled { mechanism, complete, table, .. } = compiled;
        let partition = &complete.further.partition;
        let equations = &complete.equations;
        let pattern = |matrix: &Sparse| matrix.places(complete).map(pair).collect();
        let stated = |rate: bool| {
            let has = move |target: &linkwright_compiler::equations::StartTarget| {
                if rate { target.rate.is_some() } else { target.position.is_some() }
            };
            let targets = complete.conditions.start.iter().enumerate();
            short(targets.filter(|(_, target)| has(target)).map(|(index, _)| index))
        };
        let names_of = |of: Vec<&Name>| names::list(of.into_iter().map(|name| name.text.as_str()));
        let states = &mechanism.states;
        let scales = states.iter().any(|state| state.scale.is_some());
        let massless = &complete.solved.massless.rows;
        Tables {
            name: names::name(&mechanism.name.text),
            fingerprint: compiled.fingerprint(),
            layout: layout(compiled),
            rows: equations
                .rows
                .iter()
                .map(|row| Row { of: names::name(&row.of), what: names::name(row.form.name) })
                .collect(),
            positions: names::list(equations.layout.position_names(mechanism)),
            velocities: names::list(equations.layout.velocity_names(mechanism)),
            gates: names_of(mechanism.held_names()),
            memories: names_of(mechanism.memories.iter().map(|memory| &memory.name).collect()),
            triggers: mechanism
                .events_in_places()
                .into_iter()
                .map(|(_, event)| trigger(&event.occasion))
                .collect(),
            start_gates: compiled.start_gates(),
            rigid: mechanism.is_rigid(),
            sticks: mechanism.sticks(),
            pressed_by: mechanism.pressed_by(),
            slide_as_one: mechanism.slide_as_one(),
            by_impulses: mechanism.options.by_impulses,
            internal: names_of(states.iter().map(|state| &state.name).collect()),
            internal_scales: states
                .iter()
                .filter(|_| scales)
                .map(|state| state.scale.unwrap_or(1.0))
                .collect(),
            inputs: names_of(mechanism.inputs.iter().map(|it| &it.name).collect()),
            outputs: names_of(mechanism.outputs.iter().map(|it| &it.name).collect()),
            parameters: names_of(mechanism.parameters.iter().map(|it| &it.name).collect()),
            mass: pattern(&MASS),
            jacobian: pattern(&JACOBIAN),
            derivatives: DERIVATIVES.iter().map(|matrix| pattern(matrix)).collect(),
            null_space_first: complete.further.leads,
            conditions: conditions(compiled),
            start_conditions: stated(false),
            start_rates: stated(true),
            driven: short((0..complete.conditions.rows.len()).filter(|index| {
                let coordinate = &complete.conditions.rows[*index].coordinate;
                mechanism.drivers.iter().any(|driver| driver.coordinate == *coordinate)
            })),
            independent: short(compiled.independent.iter().copied()),
            condition_jacobian: pattern(&CONDITION_JACOBIAN),
            flips: flips(compiled),
            idle: short(equations.idle.iter().copied()),
            dependent: partition.pivots().map(|pivot| pair((pivot.row, pivot.velocity))).collect(),
            scales: if partition.scales.iter().any(|scale| *scale != 1.0) {
                partition.scales.clone()
            } else {
                Vec::new()
            },
            massless_rows: short(massless.keys().copied()),
            massless_weights: massless.values().copied().collect(),
            order: short(table.order.iter().copied()),
            position: short(table.position.iter().copied()),
            row_start: table.row_start.iter().map(|start| *start as u32).collect(),
            columns: short(table.columns.iter().copied()),
            states: complete.tangents.iter().flat_map(|it| short(it.states.iter().copied())).collect(),
            defaults: mechanism.defaults(),
            bounds: mechanism.parameters.iter().map(|parameter| parameter.bounds).collect(),
            masses: masses(compiled),
            start_q: compiled.assembly.q.clone(),
            start_v: compiled.assembly.v.clone(),
            phases: compiled.assembly.phases.clone(),
            row_sizes: partition.row_sizes.clone(),
            store: compiled.entries(Shape::Store),
            lu: compiled.entries(Shape::Lu),
            lengths: [&MOTION, &REACTION].map(|record| record.of(mechanism.space).length()),
            open: equations.open_rows(mechanism),
            angles: compiled.angles_in_outputs().iter().map(|angle| (angle.output, angle.stated)).collect(),
        }
    }

    pub fn elimination(&self) -> Elimination<'_> {
        let Tables { order, position, row_start, columns, .. } = self;
        Elimination { order, position, row_start, columns }
    }

    /// Places of the entries of the matrix of [`DERIVATIVES`] whose pattern is called so.
    pub fn derivative(&self, pattern: &str) -> &[(u16, u16)] {
        let index = DERIVATIVES.iter().position(|known| known.pattern == pattern);
        index.map_or(&[], |index| &self.derivatives[index])
    }
}

fn pair((row, column): (usize, usize)) -> (u16, u16) {
    (row as u16, column as u16)
}

fn short(indices: impl Iterator<Item = usize>) -> Vec<u16> {
    indices.map(|index| index as u16).collect()
}

/// The lists inside the layout, and inside flips, live as long as the program, as names do: they are a few numbers.
fn layout(compiled: &Compiled) -> Layout<'static> {
    let layout = &compiled.complete.equations.layout;
    let angles = layout.angles.iter().map(|angle| {
        let rate: Vec<(u32, f64)> =
            angle.rate.iter().map(|(index, weight)| (*index as u32, *weight)).collect();
        MultiTurn { rate: rate.leak() }
    });
    Layout {
        linear: layout.linear.len(),
        rotations: layout.rotations.len(),
        quaternions: layout.quaternions.len(),
        angles: angles.collect::<Vec<_>>().leak(),
    }
}

/// The direction rows, joint by joint.
fn flips(compiled: &Compiled) -> Vec<Flips<'static>> {
    let rows = &compiled.complete.equations.rows;
    let upright: Vec<usize> = (0..rows.len()).filter(|row| rows[*row].upright.is_some()).collect();
    let is_axis = |row: &usize| rows[*row].form.part_of == Some(Whole::Axis);
    let joints = upright.chunk_by(|a, b| rows[*a].origin == rows[*b].origin).map(|joint| {
        let (axes, turns) = match joint {
            [first, second, turns @ ..] if is_axis(first) && is_axis(second) => {
                (Some([*first as u16, *second as u16]), turns)
            }
            turns => (None, turns),
        };
        Flips { axes, turns: short(turns.iter().copied()).leak() }
    });
    joints.collect()
}

fn conditions(compiled: &Compiled) -> Vec<Condition> {
    let conditions = compiled.complete.conditions.rows.iter().map(|condition| {
        let kind = match condition {
            condition if !condition.coordinate.has_value() => ConditionKind::Rate,
            condition if condition.angular && !condition.counted => ConditionKind::Angle,
            _ => ConditionKind::Linear,
        };
        Condition { of: names::name(&condition.of), kind }
    });
    conditions.collect()
}

/// What depends on no parameter has been judged by the compiler.
fn masses(compiled: &Compiled) -> Vec<(&'static str, bool, bool)> {
    let outputs = &compiled.programs.get(Function::Masses).outputs;
    let both = compiled.masses.iter().zip(outputs);
    let one = |((what, positive), output): (&(String, bool), &Operand)| {
        (names::name(what), *positive, matches!(output, Operand::Source(_)))
    };
    both.map(one).collect()
}

/// What lets an event occur.
fn trigger(occasion: &Occasion) -> Trigger {
    match occasion {
        Occasion::Passing(_, Way::Rises) => Trigger::Rises,
        Occasion::Passing(_, Way::Falls) => Trigger::Falls,
        Occasion::Passing(_, Way::Crosses) => Trigger::Crosses,
        Occasion::Every(period) => Trigger::Every(*period),
    }
}
