//! The committed values of the reference script (`tests/data/casadi`, made by RECORD_CASADI=1), compared without it.
//!
//! Every value comes with the magnitude of the terms that formed it; v̇ and λ are judged by the backward error of the
//! recorded system.

use super::request::sizes;
use super::{SETS, casadi, compiled, hash, recorded_models};
use linkwright_compiler::Compiled;
use linkwright_compiler::equations::Row;
use linkwright_compiler::model::Space;
use linkwright_compiler::order::Pattern;
use linkwright_compiler::schedule::{Function, Inputs, run};
use linkwright_compiler::solve::table::{Numeric, Table};
use serde_json::Value;
use std::ops::Range;
use std::path::PathBuf;

const ENTRY: f64 = 1e-12;
/// At consistent states; anywhere else, where D may be close to losing rank, ten times as much.
const BACKWARD: f64 = 1e-13;
/// In space, away from consistent states, a relative pivot below this costs as many digits as it is smaller.
const REGULAR: f64 = 1e-5;
/// The largest size of a row at the consistent states in units of what it is measured by: half of the largest along the motion, up to
/// the rounding to a power of two, where the states are those at which it is largest.
const MEASURED: Range<f64> = 1e-3..1.0;

pub fn folder() -> PathBuf {
    casadi::scripts().join("../data/casadi")
}

/// Compares every model in both sets of coordinates.
pub fn compare_all() {
    let models = recorded_models();
    for (name, source, definition) in &models {
        for (coordinates, set) in SETS {
            let compiled = compiled(source, coordinates);
            let record = record(name, set);
            assert_eq!(
                record.hash,
                hash(definition),
                "{name}: the recorded values belong to another definition; record them anew with RECORD_CASADI=1"
            );
            let evaluate = |function: Function, inputs: &Inputs| run(compiled.programs.get(function), inputs);
            let difference = record.difference(&compiled, &evaluate);
            if let Some(difference) = difference.or_else(|| record.measures(&compiled, &evaluate)) {
                panic!("{name} in {set} coordinates: {difference}");
            }
        }
    }
    println!("{} models agree with the committed values", models.len());
}

/// One recorded file.
pub struct Record {
    pub hash: String,
    random: Vec<State>,
    consistent: Vec<State>,
}

/// A state and what the reference says of it.
struct State {
    inputs: Inputs,
    values: Value,
}

pub fn record(name: &str, set: &str) -> Record {
    let path = folder().join(format!("{name}.{set}.json"));
    let text = std::fs::read_to_string(&path)
        .unwrap_or_else(|error| panic!("{}: {error}; record it with RECORD_CASADI=1", path.display()));
    let value: Value = serde_json::from_str(&text).unwrap();
    let states = |kind: &str| value[kind].as_array().unwrap().iter().map(State::of).collect();
    Record {
        hash: value["definition_hash"].as_str().unwrap().to_string(),
        random: states("random"),
        consistent: states("consistent"),
    }
}

impl State {
    fn of(values: &Value) -> Self {
        let list = |name: &str| numbers(&values[name]);
        let inputs = Inputs {
            parameters: list("parameters"),
            phases: list("phases"),
            time: values["time"].as_f64().unwrap(),
            q: list("q"),
            v: list("v"),
            inputs: list("inputs"),
            internal: values.get("z").map_or(Vec::new(), numbers),
            gates: values.get("gates").map_or(Vec::new(), numbers),
            two_alpha: 3.0,
            beta_squared: 5.0,
            ..Inputs::default()
        };
        State { inputs, values: values.clone() }
    }

    fn list(&self, name: &str) -> Vec<f64> {
        numbers(&self.values[name])
    }

    /// Entries of a recorded matrix: row, column, value.
    fn matrix(&self, name: &str) -> Vec<(usize, usize, f64)> {
        let entries = self.values[name].as_array().unwrap();
        let index = |value: &Value| value.as_u64().unwrap() as usize;
        entries.iter().map(|e| (index(&e[0]), index(&e[1]), e[2].as_f64().unwrap())).collect()
    }
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
}

/// The pivot of independent velocities, a square, from which on they are asked.
const SERVES: f64 = 1e-4;

/// Whether an error is within its bound; NaN is not.
fn within(error: f64, bound: f64) -> bool {
    error.abs() <= bound
}

type Evaluate<'a> = dyn Fn(Function, &Inputs) -> Vec<f64> + 'a;

impl Record {
    /// The consistent states or the others, with v̇ and λ of the plain solution.
    pub fn inputs(&self, compiled: &Compiled, consistent: bool) -> Vec<Inputs> {
        let (n, rows) =
            (compiled.complete.equations.layout.velocities(), compiled.complete.equations.rows.len());
        let state = |state: &State| {
            let mut inputs = state.inputs.clone();
            inputs.prepared = run(compiled.programs.get(Function::Prepare), &inputs);
            let solution = run(compiled.programs.get(Function::Acceleration), &inputs);
            inputs.acceleration = solution[..n].to_vec();
            inputs.lambda = solution[n..n + rows].to_vec();
            inputs
        };
        let states = if consistent { &self.consistent } else { &self.random };
        states.iter().map(state).collect()
    }

    /// Consistent states with the derivatives of their solution, row by row.
    pub fn sensitivities(&self) -> Vec<(Inputs, Vec<Vec<f64>>)> {
        let rows =
            |state: &State| state.values["sensitivity"].as_array().unwrap().iter().map(numbers).collect();
        self.consistent.iter().map(|state| (state.inputs.clone(), rows(state))).collect()
    }

    /// Consistent states with numbers that the runtime makes of them.
    pub fn lists(&self, name: &str) -> Vec<(Inputs, Vec<f64>)> {
        self.consistent.iter().map(|state| (state.inputs.clone(), state.list(name))).collect()
    }

    /// The first disagreement, if there is one.
    pub fn difference(&self, compiled: &Compiled, evaluate: &Evaluate) -> Option<String> {
        let random = self.random.iter().map(|state| (state, false));
        let consistent = self.consistent.iter().map(|state| (state, true));
        random.chain(consistent).find_map(|(state, consistent)| {
            let mut inputs = state.inputs.clone();
            inputs.prepared = evaluate(Function::Prepare, &inputs);
            entries(compiled, state, &inputs, consistent, evaluate)
                .or_else(|| accelerations(compiled, state, &mut inputs, consistent, evaluate))
                .or_else(|| if consistent { what_follows(compiled, state, &inputs, evaluate) } else { None })
        })
    }

    /// What rows are measured by, S, against Dᵢ M⁻¹ Dᵢᵀ of the reference at all consistent states: never much below it, and not far
    /// above the largest.
    pub fn measures(&self, compiled: &Compiled, evaluate: &Evaluate) -> Option<String> {
        let rows = compiled.complete.equations.rows.len();
        if !compiled.complete.solved.massless.rows.is_empty() {
            return None;
        }
        let mut largest = vec![0.0_f64; rows];
        for state in &self.consistent {
            let mut inputs = state.inputs.clone();
            inputs.prepared = evaluate(Function::Prepare, &inputs);
            let scales = evaluate(Function::RowScales, &inputs);
            let mass = state.matrix("mass");
            let table = Table::new(inputs.v.len(), 0, mass.iter().map(|(i, j, _)| (*i, *j)));
            let factor = Numeric::factor(&table, mass);
            for (row, largest) in largest.iter_mut().enumerate() {
                let mut d = vec![0.0; inputs.v.len()];
                for (_, column, value) in state.matrix("jacobian").iter().filter(|entry| entry.0 == row) {
                    d[*column] = *value;
                }
                *largest = largest.max(factor.inverse_square(d.iter().copied().enumerate()) / scales[row]);
            }
        }
        let watched =
            largest.iter().enumerate().filter(|(row, _)| !compiled.complete.equations.idle.contains(row));
        watched.map(|(row, found)| (row, *found)).find(|(_, found)| !MEASURED.contains(found)).map(
            |(row, found)| {
                let Row { of, form, .. } = &compiled.complete.equations.rows[row];
                format!("`{of}.{}` is measured by {:e} of what it is", form.name, 1.0 / found)
            },
        )
    }
}

/// Φ, D, ν, γ, M, Q, energies and powers, entry by entry.
fn entries(
    compiled: &Compiled,
    state: &State,
    inputs: &Inputs,
    consistent: bool,
    evaluate: &Evaluate,
) -> Option<String> {
    let vectors = [
        ("phi", Function::Constraints),
        ("nu", Function::Nu),
        ("gamma", Function::Gamma),
        ("forces", Function::Forces),
        ("powers", Function::Powers),
    ];
    for (name, function) in vectors {
        if consistent && name == "phi" {
            continue;
        }
        let (expected, scale) = (state.list(name), state.list(&format!("{name}_scale")));
        let found = evaluate(function, inputs);
        for (index, ((e, f), scale)) in expected.iter().zip(&found).zip(scale).enumerate() {
            if !within(e - f, ENTRY * scale) {
                return Some(format!("{name}[{index}] is {f:?}, the reference says {e:?}"));
            }
        }
    }
    if let Some(difference) = touching(state, inputs, evaluate) {
        return Some(difference);
    }
    for (name, function) in [("kinetic", Function::KineticEnergy), ("potential", Function::PotentialEnergy)] {
        let pair = state.list(name);
        let found = evaluate(function, inputs)[0];
        if !within(pair[0] - found, ENTRY * pair[1]) {
            return Some(format!("{name} is {found:?}, the reference says {:?}", pair[0]));
        }
    }
    let equations = &compiled.complete.equations;
    let jacobian: Vec<(usize, usize)> = equations
        .rows
        .iter()
        .enumerate()
        .flat_map(|(row, r)| r.jet.columns.keys().map(move |column| (row, *column)))
        .collect();
    let mass: Vec<(usize, usize)> = equations.mass.keys().copied().collect();
    for (name, function, places) in
        [("jacobian", Function::ConstraintJacobian, jacobian), ("mass", Function::MassMatrix, mass)]
    {
        let mut found = std::collections::BTreeMap::new();
        for (place, value) in places.iter().zip(evaluate(function, inputs)) {
            found.insert(*place, value);
        }
        for entry in state.values[name].as_array().unwrap() {
            let place = (entry[0].as_u64().unwrap() as usize, entry[1].as_u64().unwrap() as usize);
            let (expected, scale) = (entry[2].as_f64().unwrap(), entry[3].as_f64().unwrap());
            let value = found.remove(&place).unwrap_or(0.0);
            if !within(expected - value, ENTRY * scale) {
                return Some(format!("{name}{place:?} is {value:?}, the reference says {expected:?}"));
            }
        }
        // Rotations in space may leave rounding where the reference has no entry: measured by the largest of its row.
        let rows = state.values[name].as_array().unwrap().iter();
        let largest = |row: usize| match compiled.mechanism.space {
            Space::Planar => 0.0,
            Space::Spatial => rows
                .clone()
                .filter(|entry| entry[0].as_u64() == Some(row as u64))
                .fold(0.0_f64, |m, entry| m.max(entry[3].as_f64().unwrap())),
        };
        let there = |(row, _): (usize, usize), value: f64| value.abs() > (ENTRY * largest(row)).max(1e-300);
        if let Some((place, value)) = found.iter().find(|(place, value)| there(**place, **value)) {
            return Some(format!("{name}{place:?} is {value:?}, the reference has no entry there"));
        }
    }
    None
}

/// Gaps and laws of contacts whose gates are held; of rigid ones, and of what rubs there, the rates and their derivatives.
fn touching(state: &State, inputs: &Inputs, evaluate: &Evaluate) -> Option<String> {
    let guards = ["gaps", "laws"].map(|name| (name, Function::Guards));
    let strikes = ["gap_rates", "gap_biases", "restitutions"].map(|name| (name, Function::Strikes));
    for (which, (name, function)) in guards.into_iter().enumerate().chain(strikes.into_iter().enumerate()) {
        if state.values.get(name).is_none() {
            continue;
        }
        let (expected, scale) = (state.list(name), state.list(&format!("{name}_scale")));
        let found = evaluate(function, inputs);
        let found = found.iter().skip(which * inputs.gates.len());
        for (index, ((e, f), scale)) in expected.iter().zip(found).zip(scale).enumerate() {
            if !within(e - f, ENTRY * scale) {
                return Some(format!("{name}[{index}] is {f:?}, the reference says {e:?}"));
            }
        }
    }
    None
}

/// v̇ and λ of both formulations by the backward error of the recorded system; the pivot by another factorisation.
fn accelerations(
    compiled: &Compiled,
    state: &State,
    inputs: &mut Inputs,
    consistent: bool,
    evaluate: &Evaluate,
) -> Option<String> {
    let bound = if consistent { BACKWARD } else { 10.0 * BACKWARD };
    let (mass, jacobian) = (state.matrix("mass"), state.matrix("jacobian"));
    let (forces, gamma, nu) = (state.list("forces"), state.list("gamma"), state.list("nu"));
    let n = forces.len();
    let mut rate: Vec<f64> = nu.iter().map(|nu| -nu).collect();
    for (row, column, value) in &jacobian {
        rate[*row] += value * inputs.v[*column];
    }
    // At consistent states Φ is what the walk left of it, as good as zero.
    let phi = if state.values.get("phi").is_some() { state.list("phi") } else { vec![0.0; nu.len()] };
    let stabilised: Vec<f64> = gamma
        .iter()
        .zip(&rate)
        .zip(&phi)
        .map(|((g, r), p)| g - inputs.two_alpha * r - inputs.beta_squared * p)
        .collect();
    // In space, where much may cancel of what forms Q and γ, a tenth of their terms counts as their size.
    let share = match compiled.mechanism.space {
        Space::Planar => 0.0,
        Space::Spatial => 0.1,
    };
    let terms = state.list("forces_scale").into_iter().chain(state.list("gamma_scale"));
    let background: Vec<f64> = terms.map(|terms| share * terms).collect();
    let solution = evaluate(Function::Acceleration, inputs);
    let solutions =
        Function::SOLUTIONS.iter().flat_map(|[plain, with]| [(*plain, &gamma), (*with, &stabilised)]);
    for (function, gamma) in
        solutions.filter(|(function, _)| (function.signature().emitted)(&compiled.complete))
    {
        let z = evaluate(function, inputs);
        let mut residual: Vec<f64> = forces.iter().chain(gamma).copied().collect();
        let mut weight: Vec<f64> =
            residual.iter().zip(&background).map(|(x, least)| x.abs().max(*least)).collect();
        let mut take = |i: usize, j: usize, value: f64| {
            residual[i] -= value * z[j];
            weight[i] += (value * z[j]).abs();
        };
        for (i, j, value) in &mass {
            take(*i, *j, *value);
            if i != j {
                take(*j, *i, *value);
            }
        }
        for (row, column, value) in &jacobian {
            take(*column, n + row, *value);
            take(n + row, *column, *value);
        }
        let worst = residual.iter().fold(0.0_f64, |m, x| if x.is_nan() { f64::NAN } else { m.max(x.abs()) });
        let size = weight.iter().fold(0.0_f64, |m, x| m.max(*x));
        let pivot = z[z.len() - 1];
        let by_independent = Function::SOLUTIONS[1].contains(&function);
        if by_independent && consistent && pivot < SERVES {
            continue;
        }
        let lost = match compiled.mechanism.space {
            // Digits are lost as the pivot itself is smaller.
            _ if by_independent && !consistent => pivot.sqrt().recip().clamp(1.0, 1e6),
            Space::Spatial if !consistent => (REGULAR / pivot).clamp(1.0, 1e4),
            _ => 1.0,
        };
        if !within(worst, bound * lost * size.max(f64::MIN_POSITIVE)) {
            let (name, error) = (function.name(), worst / size);
            return Some(format!("{name} has backward error {error:e} at a relative pivot of {pivot:e}"));
        }
    }
    (inputs.acceleration, inputs.lambda) = (solution[..n].to_vec(), solution[n..n + nu.len()].to_vec());
    let scales = evaluate(Function::RowScales, inputs);
    pivot(compiled, inputs, &mass, &jacobian, &scales, solution[solution.len() - 1])
}

/// The watched pivot against the pivots of a plain factorisation in the same order.
fn pivot(
    compiled: &Compiled,
    inputs: &Inputs,
    mass: &[(usize, usize, f64)],
    jacobian: &[(usize, usize, f64)],
    scales: &[f64],
    found: f64,
) -> Option<String> {
    let n = inputs.v.len();
    let equations = &compiled.complete.equations;
    if !compiled.complete.solved.massless.rows.is_empty() || equations.rows.is_empty() {
        return None;
    }
    // Prescribed velocities and their rows are not eliminated: they stand apart at the end.
    let all = n + equations.rows.len();
    let mut sequence = compiled.complete.solved.order.sequence.clone();
    let eliminated = sequence.clone();
    sequence.extend((0..all).filter(|unknown| !eliminated.contains(unknown)));
    let inside = |i: &usize, j: &usize| eliminated.contains(i) && eliminated.contains(j);
    let mut entries = mass.to_vec();
    entries.extend(jacobian.iter().map(|(row, column, value)| (n + row, *column, *value)));
    entries.retain(|(i, j, _)| inside(i, j));
    let rows =
        equations.rows.iter().enumerate().flat_map(|(row, r)| {
            r.jet.columns.keys().map(move |column| (n + row, *column)).collect::<Vec<_>>()
        });
    let structure = equations.mass.keys().copied().chain(rows).filter(|(i, j)| inside(i, j));
    let pattern = Pattern::new(n, equations.rows.len(), structure);
    let table = Table::with_order(&pattern, sequence);
    let factor = Numeric::factor(&table, entries);
    let watched = || eliminated.iter().filter(|unknown| **unknown >= n).map(|unknown| unknown - n);
    let relative = |row: usize| factor.pivots[n + row].abs() / scales[row];
    let expected = watched().fold(f64::INFINITY, |least, row| least.min(relative(row)));
    let same = (expected - found).abs() <= 1e-9 * expected.abs().max(1e-3);
    (!same)
        .then(|| format!("the smallest relative pivot is {found:?}, another factorisation says {expected:?}"))
}

/// Bodies, reactions and drivers at consistent states, within what the condition allows.
fn what_follows(compiled: &Compiled, state: &State, inputs: &Inputs, evaluate: &Evaluate) -> Option<String> {
    let tolerance = 1e-13 * state.values["condition"].as_f64().unwrap().max(100.0);
    let flat = |name: &str| -> Vec<f64> {
        state.values[name].as_array().unwrap().iter().flat_map(numbers).collect()
    };
    let size = |values: &[f64]| values.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    let close = |name: &str, expected: &[f64], found: &[f64], least: f64, skip: &dyn Fn(usize) -> bool| {
        let largest = size(expected).max(least);
        let wrong = expected
            .iter()
            .zip(found)
            .enumerate()
            .find(|(index, (e, f))| !skip(*index) && !within(**e - **f, tolerance * largest));
        wrong.map(|(index, (e, f))| format!("{name}[{index}] is {f:?}, the reference says {e:?}"))
    };
    let (motion, _) = sizes(compiled);
    // Orientation, ω and ω̇ of what has none.
    let particle = |index: usize| {
        let body = &compiled.mechanism.bodies[index / motion];
        let angular = match compiled.mechanism.space {
            Space::Planar => matches!(index % motion, 2 | 3 | 6 | 9),
            Space::Spatial => matches!(index % motion, 3..12 | 15..18 | 21..24),
        };
        !body.form.turns && angular
    };
    let bodies = evaluate(Function::Motions, inputs);
    let reactions = evaluate(Function::Reactions, inputs);
    // A joint may have nothing to carry of the forces that there are; in the plane all of them, as of what slides without weight.
    let nothing = size(&flat("reactions")) == 0.0;
    let forces = match compiled.mechanism.space {
        Space::Planar if !nothing => 0.0,
        _ => size(&state.list("forces_scale")),
    };
    close("bodies", &flat("bodies"), &bodies, 1e-12, &particle)
        .or_else(|| close("reactions", &flat("reactions"), &reactions, forces.max(1e-12), &|_| false))
        .or_else(|| {
            let drivers = evaluate(Function::DriverEfforts, inputs);
            let mut expected = state.list("driver_efforts");
            expected.extend(state.list("driver_powers"));
            close("drivers", &expected, &drivers, 1e-12, &|_| false)
        })
}
