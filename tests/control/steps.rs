//! Steps and their derivatives: against differences of the stepper itself, on orientations without coordinates too, and beside the plant
//! with its inputs held.

use crate::registry::{Model, vector};
use crate::walking::walk;
use crate::{STATES, assert_close, assert_close_by};
use linkwright::{
    AssembleExt, Baumgarte, ConditionKind, ExplicitTrapezoidal, Fields, LagrangeIndex1, Linearisation,
    Mechanism, Motion, Rk4, SemiImplicitEuler, State, StateOf, StepMethod, Stepper, Tangent, Vector, control,
    coordinate_rates, coordinate_values, step_map, zero_order_hold,
};
use mechanisms::zoo_laws::Servo;
use mechanisms::zoo_tangent::{Buoy, Flail, Gripper, Rocker, Spring, Swing, Winch};

/// f′(0) by differences of order four.
fn derivative(h: f64, f: impl Fn(f64) -> Vec<f64>, apart: impl Fn(usize, f64) -> f64) -> Vec<f64> {
    let values = [f(h), f(-h), f(2.0 * h), f(-2.0 * h)];
    let entry = |k: usize| {
        let [a, b] = [values[0][k] - values[1][k], values[2][k] - values[3][k]].map(|x| apart(k, x));
        (8.0 * a - b) / (12.0 * h)
    };
    (0..values[0].len()).map(entry).collect()
}

fn states_of<M: Model + Tangent<f64>>(model: &M, all: &M::Conditions) -> Vec<f64> {
    model.states().iter().map(|index| all.as_slice()[usize::from(*index)]).collect()
}

/// One step of a stepper.
fn stepped<M: Model, S: StepMethod<f64, M>>(
    parameters: &[f64],
    method: &S,
    (time, state): (f64, &StateOf<M>),
    u: &M::Inputs,
    h: f64,
) -> StateOf<M> {
    let mut plant =
        Stepper::new(M::prepared(parameters).expect("near their defaults"), *state, method.clone());
    plant.set_state(time, *state).expect("a state");
    plant.step(u, h).expect("a regular position");
    *plant.state()
}

/// A_d and B_d against differences of the stepper itself, from states that have the coordinates' values.
fn steps_are_differentiated<M: Model + Tangent<f64>, S>(method: S, h: f64)
where
    S: StepMethod<f64, M, Integrator: control::StepTangent<f64>, Formulation: control::Stabilisation<f64>>,
{
    let (_, parameters, model, states) = walk::<M>(74, STATES);
    let (name, f, internal) = (model.name(), model.states().len(), model.internal_count());
    let size = 2 * f + internal;
    let read = |time: f64, state: &StateOf<M>| -> Vec<f64> {
        let values = coordinate_values(&model, time, &state.q);
        let rates = coordinate_rates(&model, time, &state.q, &state.v);
        [states_of(&model, &values), states_of(&model, &rates), state.z.as_slice().to_vec()].concat()
    };
    let apart = |k: usize, x: f64| {
        let angle = k < f && model.conditions()[usize::from(model.states()[k])].kind == ConditionKind::Angle;
        if angle { x - (x / std::f64::consts::TAU).round() * std::f64::consts::TAU } else { x }
    };
    for at in &states {
        let state = at.state();
        let found =
            step_map(&model, &method, (at.time, &state), &at.u, h).unwrap_or_else(|e| panic!("{name}: {e}"));
        let expected = stepped(&parameters, &method, (at.time, &state), &at.u, h);
        assert!(
            found.state.q == expected.q && found.state.v == expected.v && found.state.z == expected.z,
            "{name}"
        );
        let here = read(at.time, &state);
        for k in 0..size {
            let moved = |by: f64| {
                let mut x = here.clone();
                x[k] += by;
                let motion = |j: usize| Motion { position: x[j], rate: x[f + j], acceleration: 0.0 };
                let given: Vec<Motion> = (0..f).map(motion).collect();
                let near = model.kinematics(at.time, &at.q, &given).unwrap_or_else(|e| panic!("{name}: {e}"));
                let state = State { z: vector(&x[2 * f..]), ..at.at(near.q, near.v) };
                read(at.time + h, &stepped(&parameters, &method, (at.time, &state), &at.u, h))
            };
            let expected = derivative(1e-3, moved, apart);
            let column: Vec<f64> = (0..size).map(|row| found.a.as_slice()[row * size + k]).collect();
            assert_close(&format!("{name}: A_d, column {k}"), &column, &expected, 1e-8);
        }
        let count = model.input_names().len();
        for k in 0..count {
            let moved = |by: f64| {
                let mut u = at.u.to_array();
                u.as_mut_slice()[k] += by;
                let u = M::Inputs::from_array(u);
                read(at.time + h, &stepped(&parameters, &method, (at.time, &state), &u, h))
            };
            let expected = derivative(1e-3, moved, apart);
            let column: Vec<f64> = (0..size).map(|row| found.b.as_slice()[row * count + k]).collect();
            assert_close(&format!("{name}: B_d, column {k}"), &column, &expected, 1e-8);
        }
    }
}

fn steps_by_all_methods<M: Model + Tangent<f64>>() {
    steps_are_differentiated::<M, _>(Rk4, 5e-3);
    steps_are_differentiated::<M, _>((Rk4, LagrangeIndex1), 5e-3);
    steps_are_differentiated::<M, _>(SemiImplicitEuler, 5e-3);
    steps_are_differentiated::<M, _>(ExplicitTrapezoidal, 5e-3);
    steps_are_differentiated::<M, _>((ExplicitTrapezoidal, Baumgarte { alpha: 9.0, beta: 4.0 }), 5e-3);
}

#[test]
fn derivatives_of_steps_are_those_of_the_stepper() {
    steps_by_all_methods::<Gripper>();
    steps_by_all_methods::<Winch>();
    steps_by_all_methods::<Rocker>();
    steps_by_all_methods::<Swing>();
    steps_by_all_methods::<Spring>();
    steps_by_all_methods::<Servo>();
}

/// What two positions differ by, to first order.
fn difference<M: Model>(model: &M, q: &M::Q, other: &M::Q) -> M::V {
    let layout = model.layout();
    assert!(layout.rotations == 0 && layout.angles.is_empty());
    let (mut delta, q, other) = (model.zero_v(), q.as_slice(), other.as_slice());
    for k in 0..layout.linear {
        delta.as_mut_slice()[k] = other[k] - q[k];
    }
    for b in 0..layout.quaternions {
        let part = |q: &[f64]| <[f64; 4]>::try_from(&q[layout.linear + 4 * b..][..4]).expect("four entries");
        let [w, x, y, z] = part(q);
        let [_, turned @ ..] = linkwright::quaternion::product([w, -x, -y, -z], part(other));
        for (k, half) in turned.iter().enumerate() {
            delta.as_mut_slice()[layout.linear + 3 * b + k] = 2.0 * half;
        }
    }
    delta
}

/// Where coordinates are components of ω: neighbouring motions are apart after the step by A_d times what they were before.
fn steps_move_neighbours<M: Model + Tangent<f64>, S>(method: S, h: f64)
where
    S: StepMethod<f64, M, Integrator: control::StepTangent<f64>, Formulation: control::Stabilisation<f64>>,
{
    let (_, parameters, model, states) = walk::<M>(75, STATES);
    let (name, f, n) = (model.name(), model.states().len(), model.velocity_count());
    let epsilon = 1e-5;
    for at in &states {
        let found = step_map(&model, &method, (at.time, &at.state()), &at.u, h)
            .unwrap_or_else(|e| panic!("{name}: {e}"));
        for k in 0..2 * n {
            let near = |sign: f64| {
                let mut delta = [model.zero_v(), model.zero_v()];
                delta[usize::from(k >= n)].as_mut_slice()[k % n] = sign * epsilon;
                let mut q = at.q;
                linkwright::retract(model.layout(), &at.q, &delta[0], &mut q);
                let q = linkwright::project_position(&model, at.time, &q).expect("near");
                let v = at.v.plus(1.0, &delta[1]);
                at.at(q, linkwright::project_velocity(&model, at.time, &q, &v).expect("near"))
            };
            let apart = |time: f64, here: &StateOf<M>, more: &StateOf<M>, less: &StateOf<M>| -> Vec<f64> {
                let turned =
                    difference(&model, &here.q, &more.q).plus(-1.0, &difference(&model, &here.q, &less.q));
                let rest = coordinate_rates(&model, time, &here.q, &model.zero_v());
                let s = coordinate_rates(&model, time, &here.q, &turned).plus(-1.0, &rest);
                let rates = |state: &StateOf<M>| coordinate_rates(&model, time, &state.q, &state.v);
                let rates = rates(more).plus(-1.0, &rates(less));
                let all = [states_of(&model, &s), states_of(&model, &rates)].concat();
                all.iter().map(|x| x / (2.0 * epsilon)).collect()
            };
            let (more, less) = (near(1.0), near(-1.0));
            let before = apart(at.time, &at.state(), &more, &less);
            let after = |state: &StateOf<M>| stepped(&parameters, &method, (at.time, state), &at.u, h);
            let expected = apart(at.time + h, &found.state, &after(&more), &after(&less));
            let product =
                |row: usize| (0..2 * f).map(|j| found.a.as_slice()[row * 2 * f + j] * before[j]).sum();
            let product: Vec<f64> = (0..2 * f).map(product).collect();
            // What is left goes with ε².
            assert_close(&format!("{name}: direction {k}"), &product, &expected, 1e-6);
        }
    }
}

#[test]
fn derivatives_of_steps_turn_with_orientations() {
    steps_move_neighbours::<Buoy, _>(Rk4, 0.02);
    steps_move_neighbours::<Flail, _>(Rk4, 0.02);
    steps_move_neighbours::<Flail, _>(SemiImplicitEuler, 0.02);
    steps_move_neighbours::<Buoy, _>((ExplicitTrapezoidal, LagrangeIndex1), 0.02);
}

/// A_d and B_d of short steps are those of the linearised plant; C and D alone are those beside A and B.
fn short_steps_are_linear<M: Model + Tangent<f64>>() {
    let (_, _, model, states) = walk::<M>(76, STATES);
    for at in &states {
        let (state, h) = (at.state(), 1e-5);
        let here = Linearisation::at(&model, at.time, &state, &at.u).expect("regular");
        let space = here.state_space().expect("regular");
        let (a, b) = zero_order_hold(&space.a, &space.b, h).expect("finite");
        let step = step_map(&model, &(Rk4, LagrangeIndex1), (at.time, &state), &at.u, h).expect("regular");
        assert_close(&format!("{}: A_d", model.name()), step.a.as_slice(), a.as_slice(), 1e-6);
        let largest = b.max_abs();
        assert_close_by(&format!("{}: B_d", model.name()), step.b.as_slice(), b.as_slice(), 1e-4 * largest);
        let (c, d) = here.output_matrices().expect("regular");
        assert!(c == space.c && d == space.d);
    }
}

#[test]
fn steps_and_held_inputs_agree_where_steps_are_short() {
    short_steps_are_linear::<Gripper>();
    short_steps_are_linear::<Rocker>();
    short_steps_are_linear::<Spring>();
    short_steps_are_linear::<Servo>();
}

#[test]
fn single_precision_differentiates_steps() {
    let (double, single) = (Gripper::<f64>::default(), Gripper::<f32>::default());
    let (far, near) = (double.start(), single.start());
    let u = <Gripper<f64> as Mechanism<f64>>::Inputs::from_array([0.3, -0.2]);
    let w = <Gripper<f32> as Mechanism<f32>>::Inputs::from_array([0.3, -0.2]);
    let expected = step_map(&double, &Rk4, (0.0, &far), &u, 1e-2).expect("regular");
    let found = step_map(&single, &Rk4, (0.0, &near), &w, 1e-2).expect("regular");
    assert_close("A_d", &found.a.map(f64::from), &expected.a, 1e-4);
    assert_close("B_d", &found.b.map(f64::from), &expected.b, 1e-4);
    let a = |h| zero_order_hold(&[0.0_f32, 1.0, -40.0, -3.0], &[0.0_f32, 2.0], h).expect("finite");
    let b = zero_order_hold(&[0.0, 1.0, -40.0, -3.0], &[0.0, 2.0], 0.1).expect("finite");
    assert_close("e^(A h)", &a(0.1).0.map(f64::from), &b.0, 1e-5);
    assert_close("held", &a(0.1).1.map(f64::from), &b.1, 1e-5);
}
