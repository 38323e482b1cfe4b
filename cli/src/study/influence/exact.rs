//! Exact derivatives of outputs by parameters, of the mechanism as it is assembled: by the runtime's `Assembled`, which needs of the
//! definition's graph only what a parameter does to the coordinates that are held.

use super::Parameter;
use crate::study::methods::{AnyEngine, EngineState};
use crate::study::{Failure, Loaded};
use linkwright_compiler::check::assemble::{Ancestry, Point};
use linkwright_compiler::equations::tangent::{Matrix, coordinates_by_parameters};
use linkwright_engine::{Derivatives, Engine, EngineError, Numbers};
use linkwright_runtime::{
    Assemble, Condition, ConditionKind, Linearisation, Mechanism, MovedOf, Tangent, Vector,
};

/// Relative to a row's own derivative: what does not close.
const OPEN: f64 = 1e-9;

/// What differentiates.
pub struct Exact<'l> {
    engine: &'l Engine<Derivatives>,
    point: Point<'l>,
    /// ∂s/∂p and ∂ṡ/∂p.
    coordinates: [Matrix; 2],
    ancestry: Ancestry,
}

impl<'l> Exact<'l> {
    pub fn of(loaded: &'l Loaded) -> Result<Self, Failure> {
        let AnyEngine::Implicit(engine) = &loaded.engine else {
            return Err(Failure::Motion(EngineError::NoDerivatives.to_string()));
        };
        let complete = &loaded.compiled.complete;
        let equations = &complete.equations;
        let states = engine.states().iter().map(|index| &complete.conditions.rows[usize::from(*index)]);
        let coordinates = coordinates_by_parameters(equations, &states.collect::<Vec<_>>());
        let nodes = coordinates.iter().flatten().flat_map(|row| row.values().copied());
        let ancestry = Ancestry::of(equations, nodes);
        let mut point = Point::new(equations);
        point.set(&equations.symbols.parameters, engine.parameters());
        point.set(&equations.symbols.phases, engine.phases());
        Ok(Exact { engine, point, coordinates, ancestry })
    }

    /// The names of the coordinates that are held.
    pub fn held(&self) -> Vec<String> {
        let conditions =
            self.engine.states().iter().map(|index| &self.engine.conditions()[usize::from(*index)]);
        let name = |condition: &Condition| match (condition.kind, condition.of.rsplit_once(".rate.")) {
            (ConditionKind::Rate, Some((body, axis))) => format!("the turn of {body} about its {axis}"),
            _ => condition.of.to_string(),
        };
        conditions.map(name).collect()
    }

    /// ∂y/∂p of all outputs at a state, SI, for each parameter; or why there is none.
    pub fn at(
        &mut self,
        time: f64,
        state: &EngineState,
        inputs: &Numbers,
        by: &[Parameter],
    ) -> Vec<Result<Vec<f64>, String>> {
        let engine = self.engine;
        let here = match Linearisation::at(engine, time, state, inputs) {
            Ok(here) => here,
            Err(error) => return by.iter().map(|_| Err(error.to_string())).collect(),
        };
        let by_parameters = here.by_parameters();
        let assembled = match by_parameters.assembled() {
            Ok(assembled) => assembled,
            Err(error) => return by.iter().map(|_| Err(error.to_string())).collect(),
        };
        let symbols = &self.point.equations.symbols;
        self.point.set(&[symbols.time], &[time]);
        self.point.set_q(state.q.as_slice());
        self.point.set_v(state.v.as_slice());
        self.point.evaluate(&self.ancestry);
        let one = |parameter: &Parameter| {
            let index = parameter.index;
            let of = |matrix: &Matrix| -> Vec<f64> {
                matrix.iter().map(|row| row.get(&index).map_or(0.0, |node| self.point.get(*node))).collect()
            };
            let [positions, rates] = [0, 1].map(|which| of(&self.coordinates[which]));
            let moved = assembled.column(index, [&positions, &rates]);
            let given = by_parameters.constraints(index);
            closes(engine, time, state, &moved, given.as_slice())?;
            let outputs = assembled.outputs(index, &moved).as_slice().to_vec();
            match outputs.iter().all(|value| value.is_finite()) {
                true => Ok(outputs),
                false => Err("a derivative is no finite number here".to_string()),
            }
        };
        by.iter().map(one).collect()
    }
}

/// An error where D δq = −∂Φ/∂p does not hold: a row that repeats others does so for these lengths only.
fn closes(
    engine: &Engine<Derivatives>,
    time: f64,
    state: &EngineState,
    moved: &MovedOf<f64, Engine<Derivatives>>,
    given: &[f64],
) -> Result<(), String> {
    if engine.idle().is_empty() {
        return Ok(());
    }
    let mut jacobian = engine.zero_jacobian();
    engine.constraint_jacobian(time, &state.q, &mut jacobian);
    let mut open = given.to_vec();
    for (entry, (row, column)) in jacobian.as_slice().iter().zip(engine.jacobian_pattern()) {
        open[usize::from(*row)] += entry * moved.position.as_slice()[usize::from(*column)];
    }
    let size = given.iter().fold(0.0, |size: f64, entry| size.max(entry.abs()));
    match open.iter().position(|entry| entry.abs() > OPEN * size) {
        None => Ok(()),
        Some(row) => Err(format!(
            "with this parameter alone changed, {} does not close: it repeats others for these lengths only",
            engine.rows()[row].of
        )),
    }
}
