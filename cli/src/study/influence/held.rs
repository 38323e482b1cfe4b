//! The mechanism assembled with other parameters at the same coordinates and rates, and what is then measured: for differences of
//! quantities that have no exact derivatives.

use crate::study::Loaded;
use crate::study::measure::GROUPS;
use crate::study::methods::{AnyEngine, EngineState};
use crate::study::record::{Column, Trajectory, columns};
use crate::study::runs::prepared;
use crate::with_engine;
use linkwright_engine::{Engine, Numbers};
use linkwright_runtime::{Assemble, AssembleExt, ConditionKind, Mechanism, Motion, State, Vector};

/// A state whose independent coordinates are held, at time zero.
pub struct Assembled<'l> {
    columns: Vec<Column>,
    state: &'l EngineState,
    inputs: &'l Numbers,
    motions: Vec<Motion<f64>>,
    /// How many coordinates would fix the whole.
    freedoms: usize,
}

/// What cannot be assembled anew at the same position: three numbers do not say how a ball is turned.
const FREE: &str = "no coordinates say how a body on a ball is turned, so that differences cannot hold it: declare an output, whose derivative is exact";

impl<'l> Assembled<'l> {
    pub fn of(loaded: &Loaded, state: &'l EngineState, inputs: &'l Numbers) -> Self {
        let motions = with_engine!(&loaded.engine, |engine| motions(engine, state));
        let freedoms = loaded.compiled.complete.tangents.as_ref().map_or(0, |it| it.states.len());
        Assembled { freedoms, columns: columns(&loaded.compiled, &GROUPS), state, inputs, motions }
    }

    /// All columns as they are.
    pub fn base(&self, engine: &AnyEngine) -> Vec<f64> {
        with_engine!(engine, |engine| self.seen(engine, self.state))
    }

    /// All columns with other parameters, SI.
    pub fn with(&self, engine: &AnyEngine, parameters: &[f64]) -> Result<Vec<f64>, String> {
        let engine = prepared(engine, parameters)?;
        with_engine!(&engine, |engine| {
            let near = &self.state.q;
            if engine.independent().len() < self.freedoms {
                return Err(FREE.to_string());
            }
            let moved = engine.kinematics(0.0, near, &self.motions).map_err(|error| error.to_string())?;
            let mut state = State { q: moved.q, v: moved.v, ..self.state.clone() };
            if !state.gates.as_slice().is_empty() {
                state.gates = engine.live_gates(0.0, &state);
            }
            Ok(self.seen(engine, &state))
        })
    }

    fn seen<D: 'static>(&self, engine: &Engine<D>, state: &EngineState) -> Vec<f64> {
        let mut row = Trajectory::new(self.columns.clone());
        let outputs = engine.outputs(0.0, state, self.inputs);
        row.add(engine, &GROUPS, 0.0, state, self.inputs, &outputs);
        row.values
    }
}

/// The independent coordinates and their rates at a state, at time zero.
fn motions<D: 'static>(engine: &Engine<D>, state: &EngineState) -> Vec<Motion<f64>> {
    let targets = engine.zero_conditions();
    let [mut values, mut cosines, mut rates] = [(); 3].map(|()| engine.zero_conditions());
    // The residual is the value less the target; of an angle its sine.
    engine.condition_residual(0.0, &state.q, &targets, &mut values);
    engine.condition_cosines(0.0, &state.q, &targets, &mut cosines);
    engine.condition_drift(0.0, &state.q, &mut rates);
    let mut jacobian = engine.zero_condition_jacobian();
    engine.condition_jacobian(0.0, &state.q, &mut jacobian);
    for (entry, (row, column)) in jacobian.as_slice().iter().zip(engine.condition_pattern()) {
        rates.as_mut_slice()[usize::from(*row)] += entry * state.v.as_slice()[usize::from(*column)];
    }
    let motion = |index: &u16| {
        let index = usize::from(*index);
        let value = values.as_slice()[index];
        let position = match engine.conditions()[index].kind {
            ConditionKind::Angle => value.atan2(cosines.as_slice()[index]),
            ConditionKind::Linear | ConditionKind::Rate => value,
        };
        Motion { position, rate: rates.as_slice()[index], acceleration: 0.0 }
    };
    engine.independent().iter().map(motion).collect()
}
