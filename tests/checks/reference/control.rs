//! Control work of the runtime against the reference: equations in independent coordinates, and steps with their derivatives, in both
//! precisions.

use super::{casadi, compare, hash, python, recorded, request};
use crate::registry::{At, Model, compiled, vector};
use crate::zoo_tangent::{Gripper, Rocker, Spring};
use linkwright::{
    Actuators, Assemble, Fields, Linearisation, Mechanism, Parametric, Reduced, Rk4, State, StateOf, Tangent,
    Vector, step_map, zero_order_hold,
};
use linkwright_compiler::schedule::Inputs;
use linkwright_models::delta_robot::DeltaRobot;
use linkwright_models::four_bar::FourBar;
use linkwright_models::general_four_bar::ParametricFourBar;
use linkwright_models::light_cart_pole::LightCartPole;
use linkwright_models::slider_crank::SliderCrank;
use linkwright_models::spatial_four_bar::{Fourbar1, Fourbar2};

/// The size of the steps that are compared, s.
const H: f64 = 5e-3;
/// How long inputs are held, s.
const HOLD: f64 = 0.01;
/// Of the largest entry of a matrix.
const TOLERANCE: f64 = 1e-10;

type Single<M> = <M as Model>::Single;
type InputsOf<M> = <Single<M> as Mechanism<f32>>::Inputs;

/// The same numbers in single precision.
fn narrow<V: Vector<f32>>(values: &[f64]) -> V {
    let mut vector = V::zeros(values.len());
    vector.as_mut_slice().iter_mut().zip(values).for_each(|(to, from)| *to = *from as f32);
    vector
}

fn single<M: Model<Single: Parametric<f32>>>(
    inputs: &Inputs,
) -> (Single<M>, StateOf<Single<M>, f32>, InputsOf<M>) {
    let model = Single::<M>::prepare(Fields::from_array(narrow(&inputs.parameters)))
        .expect("parameters near their defaults");
    let start = linkwright::AssembleExt::start(&model);
    let state = State { q: narrow(&inputs.q), v: narrow(&inputs.v), z: narrow(&inputs.internal), ..start };
    (model, state, Fields::from_array(narrow(&inputs.inputs)))
}

/// M_r, h and g.
fn reduced<M: Model>(inputs: &Inputs) -> Vec<f64> {
    let model = M::prepared(&inputs.parameters).expect("parameters near their defaults");
    let at = At::<M>::of(inputs);
    let found = Reduced::at(&model, at.time, &at.state(), &at.u).expect("a regular state");
    [found.mass_matrix().as_slice(), found.bias(), found.gravity()].concat()
}

fn reduced_single<M: Model<Single: Parametric<f32>>>(inputs: &Inputs) -> Vec<f64> {
    let (model, state, u) = single::<M>(inputs);
    let found = Reduced::at(&model, inputs.time as f32, &state, &u).expect("a regular state");
    let all = [found.mass_matrix().as_slice(), found.bias(), found.gravity()].concat();
    all.into_iter().map(f64::from).collect()
}

/// A_d and B_d.
fn step<M: Model + Tangent<f64>>(inputs: &Inputs) -> Vec<f64> {
    let model = M::prepared(&inputs.parameters).expect("parameters near their defaults");
    let at = At::<M>::of(inputs);
    let found = step_map(&model, &Rk4, (at.time, &at.state()), &at.u, H).expect("a regular state");
    [found.a.as_slice(), found.b.as_slice()].concat()
}

fn step_single<M: Model<Single: Parametric<f32> + Tangent<f32>>>(inputs: &Inputs) -> Vec<f64> {
    let (model, state, u) = single::<M>(inputs);
    let found = step_map(&model, &Rk4, (inputs.time as f32, &state), &u, H as f32).expect("a regular state");
    let all = [found.a.as_slice(), found.b.as_slice()].concat();
    all.into_iter().map(f64::from).collect()
}

/// The inputs of forces that give s̈ = (1, 2, …), all K of them.
fn driven<M: Model, const K: usize>(inputs: &Inputs) -> Vec<f64> {
    let model = M::prepared(&inputs.parameters).expect("parameters near their defaults");
    let (at, names) = (At::<M>::of(inputs), model.input_names().try_into().expect("K inputs"));
    let wanted: Vec<f64> = (1..=model.independent().len()).map(|k| k as f64).collect();
    let a = Reduced::at(&model, at.time, &at.state(), &at.u).expect("a regular state").acceleration(&wanted);
    let actuators = Actuators::<K>::named(&model, names).expect("they are inputs");
    let found = actuators.inputs_for(&model, (at.time, &at.state()), &a, &at.u).expect("they act");
    found.inputs.to_array().as_slice().to_vec()
}

fn driven_single<M: Model<Single: Parametric<f32>>, const K: usize>(inputs: &Inputs) -> Vec<f64> {
    let (model, state, u) = single::<M>(inputs);
    let names = model.input_names().try_into().expect("K inputs");
    let wanted: Vec<f32> = (1..=model.independent().len()).map(|k| k as f32).collect();
    let time = inputs.time as f32;
    let a = Reduced::at(&model, time, &state, &u).expect("a regular state").acceleration(&wanted);
    let actuators = Actuators::<K>::named(&model, names).expect("they are inputs");
    let found = actuators.inputs_for(&model, (time, &state), &a, &u).expect("they act");
    found.inputs.to_array().as_slice().iter().map(|value| f64::from(*value)).collect()
}

/// C and D, then A and B, then A_d and B_d with inputs held.
fn linear<M: Model + Tangent<f64>>(inputs: &Inputs) -> [Vec<f64>; 3] {
    let model = M::prepared(&inputs.parameters).expect("parameters near their defaults");
    let at = At::<M>::of(inputs);
    let here = Linearisation::at(&model, at.time, &at.state(), &at.u).expect("a regular state");
    let ((c, d), space) = (here.output_matrices().expect("regular"), here.state_space().expect("regular"));
    let (a, b) = zero_order_hold(&space.a, &space.b, HOLD).expect("finite");
    let all = |a: &[f64], b: &[f64]| [a, b].concat();
    [
        all(c.as_slice(), d.as_slice()),
        all(space.a.as_slice(), space.b.as_slice()),
        all(a.as_slice(), b.as_slice()),
    ]
}

/// C and D, then A_d and B_d of the A and B of double precision.
fn linear_single<M: Model<Single: Parametric<f32> + Tangent<f32>> + Tangent<f64>>(
    inputs: &Inputs,
) -> [Vec<f64>; 2] {
    let (model, state, u) = single::<M>(inputs);
    let here = Linearisation::at(&model, inputs.time as f32, &state, &u).expect("a regular state");
    let (c, d) = here.output_matrices().expect("regular");
    let [_, space, _] = linear::<M>(inputs);
    let size = 2 * M::standard().states().len();
    let (a, b) = space.split_at(size * size);
    let (a, b): (<Single<M> as Tangent<f32>>::StateMatrix, <Single<M> as Tangent<f32>>::InputMatrix) =
        (narrow(a), narrow(b));
    let (a, b) = zero_order_hold(&a, &b, HOLD as f32).expect("finite");
    let all = |a: &[f32], b: &[f32]| [a, b].concat().into_iter().map(f64::from).collect();
    [all(c.as_slice(), d.as_slice()), all(a.as_slice(), b.as_slice())]
}

/// Each independent coordinate as the velocity that is its rate.
fn velocities<M: Model>(inputs: &Inputs) -> Vec<f64> {
    let model = M::standard();
    let mut jacobian = model.zero_condition_jacobian();
    model.condition_jacobian(inputs.time, &vector(&inputs.q), &mut jacobian);
    let velocity = |index: &u16| {
        let entries =
            jacobian.as_slice().iter().zip(model.condition_pattern()).filter(|(_, place)| place.0 == *index);
        let entries: Vec<_> = entries.filter(|(entry, _)| **entry != 0.0).collect();
        assert!(
            entries.len() == 1 && *entries[0].0 == 1.0,
            "{}: its coordinates are no velocities",
            model.name()
        );
        f64::from(entries[0].1.1)
    };
    model.independent().iter().map(velocity).collect()
}

fn driven_equations<M: Model<Single: Parametric<f32>>, const K: usize>(inputs: &Inputs) -> Vec<Row> {
    let mut rows = equations::<M>(inputs);
    rows.push(("driven", vec![driven::<M, K>(inputs)]));
    rows.push(("driven_single", vec![driven_single::<M, K>(inputs)]));
    rows
}

type Row = (&'static str, Vec<Vec<f64>>);

fn equations<M: Model<Single: Parametric<f32>>>(inputs: &Inputs) -> Vec<Row> {
    vec![
        ("control_coordinates", vec![velocities::<M>(inputs)]),
        ("reduced", vec![reduced::<M>(inputs)]),
        ("reduced_single", vec![reduced_single::<M>(inputs)]),
    ]
}

fn steps<M: Model<Single: Parametric<f32> + Tangent<f32>> + Tangent<f64>, const K: usize>(
    inputs: &Inputs,
) -> Vec<Row> {
    let mut rows = driven_equations::<M, K>(inputs);
    rows.push(("step_size", vec![vec![H]]));
    rows.push(("step", vec![step::<M>(inputs)]));
    rows.push(("step_single", vec![step_single::<M>(inputs)]));
    let [outputs, space, held] = linear::<M>(inputs);
    let [outputs_single, held_single] = linear_single::<M>(inputs);
    rows.push(("outputs", vec![outputs]));
    rows.push(("outputs_single", vec![outputs_single]));
    rows.push(("hold", vec![vec![HOLD]]));
    rows.push(("space", vec![space]));
    rows.push(("held", vec![held]));
    rows.push(("held_single", vec![held_single]));
    rows
}

fn write<M: Model>(folder: &std::path::Path, name: &str, rows: fn(&Inputs) -> Vec<Row>) {
    let compiled = compiled::<M>(None);
    let text = request::request_with(&compiled, &hash(&compiled.definition), &|_| None, &rows);
    std::fs::write(folder.join(format!("{name}.control.json")), text).unwrap();
}

fn requests(folder: &str) -> std::path::PathBuf {
    let folder = casadi::target().join(folder);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

#[test]
fn control_work_agrees_with_casadi() {
    let Some(python) = python() else { return };
    let folder = requests("control-requests");
    write::<FourBar>(&folder, "four_bar", equations::<FourBar>);
    write::<ParametricFourBar>(&folder, "parametric_four_bar", equations::<ParametricFourBar>);
    write::<LightCartPole>(&folder, "light_cart_pole", equations::<LightCartPole>);
    write::<DeltaRobot>(&folder, "delta_robot", driven_equations::<DeltaRobot, 3>);
    write::<Fourbar1>(&folder, "fourbar_1", equations::<Fourbar1>);
    write::<Fourbar2>(&folder, "fourbar_2", equations::<Fourbar2>);
    write::<Rocker>(&folder, "rocker", steps::<Rocker, 2>);
    write::<Spring>(&folder, "spring", steps::<Spring, 1>);
    compare(&python, &folder, &["--minimum", "100"]);
}

/// What is recorded too: a loop that turns and slides, and one with derivatives.
#[test]
fn recorded_control_work_agrees_with_casadi() {
    let Some(python) = python() else { return };
    let folder = requests("control-requests-recorded");
    write::<SliderCrank>(&folder, "slider_crank", driven_equations::<SliderCrank, 2>);
    write::<Gripper>(&folder, "gripper", steps::<Gripper, 2>);
    let record = recorded::folder();
    let mut arguments = vec!["--minimum", "100"];
    if std::env::var_os("RECORD_CASADI").is_some() {
        arguments.extend(["--record", record.to_str().unwrap(), "--states", "1"]);
    }
    compare(&python, &folder, &arguments);
}

fn compare_recorded<M: Model>(name: &str, what: &str, found: fn(&Inputs) -> Vec<f64>) {
    let record = recorded::record(name, "control");
    let own = hash(&compiled::<M>(None).definition);
    assert_eq!(record.hash, own, "{name}: record it anew with RECORD_CASADI=1");
    let states = record.lists(what);
    assert!(!states.is_empty(), "{name}");
    for (inputs, expected) in states {
        let found = found(&inputs);
        let largest = expected.iter().fold(0.0_f64, |most, entry| most.max(entry.abs()));
        for (k, (found, expected)) in found.iter().zip(&expected).enumerate() {
            let off = (found - expected).abs();
            assert!(off <= TOLERANCE * largest, "{name}: {what}[{k}] is {found:?}, not {expected:?}");
        }
    }
}

/// The committed values hold on every machine, with CasADi or without.
#[test]
fn control_work_agrees_with_the_recorded_values() {
    if std::env::var_os("RECORD_CASADI").is_none() {
        compare_recorded::<SliderCrank>("slider_crank", "reduced", reduced::<SliderCrank>);
        compare_recorded::<SliderCrank>("slider_crank", "driven", driven::<SliderCrank, 2>);
        compare_recorded::<Gripper>("gripper", "reduced", reduced::<Gripper>);
        compare_recorded::<Gripper>("gripper", "driven", driven::<Gripper, 2>);
        compare_recorded::<Gripper>("gripper", "step", step::<Gripper>);
    }
}
