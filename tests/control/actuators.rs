//! Inputs for accelerations: there and back, the least of several, as derivatives find them, and what cannot be driven.

use crate::registry::Model;
use crate::walking::walk;
use crate::{STATES, assert_close, solved};
use linkwright::{
    Actuators, AssembleExt, Fields, LinearisationError, Mechanism, Reduced, Tangent, Vector, actuation,
};
use linkwright_models::delta_robot::DeltaRobot;
use linkwright_models::slider_crank::SliderCrank;
use mechanisms::zoo_tangent::{Gripper, Rocker, Swing};

/// Inputs of forward dynamics are given back, of several solutions the least; as the way by derivatives finds them.
fn inputs_come_back<M: Model, const K: usize>(names: [&'static str; K], alone: bool) {
    let (_, _, model, states) = walk::<M>(71, STATES);
    let (name, actuators) = (model.name(), Actuators::named(&model, names).expect("they are inputs"));
    for at in &states {
        let (state, a) = (at.state(), solved(&model, at));
        let found = actuators
            .inputs_for(&model, (at.time, &state), &a, &at.u)
            .unwrap_or_else(|error| panic!("{name}: {error}"));
        if alone {
            assert_close(name, found.inputs.to_array().as_slice(), at.u.to_array().as_slice(), 1e-9);
        }
        let (mut again, mut lambda) = (model.zero_v(), model.zero_lambda());
        model.acceleration(at.time, &state, &found.inputs, &mut again, &mut lambda);
        assert_close(name, again.as_slice(), a.as_slice(), 1e-8);
        assert_close(&format!("{name}: λ"), found.lambda.as_slice(), lambda.as_slice(), 1e-8);
    }
}

#[test]
fn actuators_undo_the_motion() {
    inputs_come_back::<SliderCrank, 1>(["torque"], true);
    inputs_come_back::<SliderCrank, 1>(["gas"], true);
    inputs_come_back::<SliderCrank, 2>(["torque", "gas"], false);
    inputs_come_back::<DeltaRobot, 3>(["torque[0]", "torque[1]", "torque[2]"], true);
    inputs_come_back::<Gripper, 1>(["drive"], true);
    inputs_come_back::<Gripper, 2>(["drive", "pull"], false);
    inputs_come_back::<Swing, 1>(["right"], true);
    inputs_come_back::<Rocker, 2>(["drive", "push"], true);
}

/// Against the way by derivatives.
fn as_by_derivatives<M: Model + Tangent<f64>, const K: usize>(names: [&'static str; K]) {
    let (_, _, model, states) = walk::<M>(72, STATES);
    for at in &states {
        let (state, a) = (at.state(), solved(&model, at));
        let actuators = Actuators::named(&model, names).expect("they are inputs");
        let found = actuators.inputs_for(&model, (at.time, &state), &a, &at.u).expect("actuated");
        let other = actuation(&model, at.time, &state, &a, &at.u, &names).expect("actuated");
        let (found, other) = (found.inputs.to_array(), other.inputs.to_array());
        assert_close(model.name(), found.as_slice(), other.as_slice(), 1e-9);
    }
}

#[test]
fn the_least_inputs_are_those_by_derivatives() {
    as_by_derivatives::<Gripper, 2>(["drive", "pull"]);
    as_by_derivatives::<Swing, 2>(["left", "right"]);
    as_by_derivatives::<Rocker, 2>(["drive", "push"]);
}

linkwright::mechanism! {
    /// A rod whose input enters with its square.
    pub planar Curve {
        input current [A];
        input torque [N*m];
        gravity [m/s^2] = (0, -9.81);
        rod bar { mass [kg] = 2; length [m] = 0.6; }
        joint pin: revolute(ground(0, 0) [m], bar.start);
        torque magnet: torque(pin) = 0.5 [N*m/A^2] * current^2;
        torque motor: torque(pin) = torque;
        start { pin.angle [rad] = 0.5; pin.rate [rad/s] = 0; }
    }
}

#[test]
fn what_actuators_cannot_do_they_say() {
    let model = Curve::<f64>::default();
    let (start, none) = (model.start(), CurveInputs { current: 0.0, torque: 0.0 });
    let with = |names: [&'static str; 1], a| {
        Actuators::named(&model, names)?.inputs_for(&model, (0.0, &start), &a, &none)
    };
    let error = with(["current"], [3.0]).expect_err("it enters with its square");
    assert!(matches!(error, LinearisationError::Curved { .. }), "{error}");
    assert!(error.to_string().contains("bar.rate") || error.to_string().contains("pin.rate"), "{error}");
    // g = ½ m g L cos θ, I = m L²/3.
    let inputs = with(["torque"], [3.0]).expect("a torque").inputs;
    let expected = 2.0 * 0.36 / 3.0 * 3.0 + 9.81 * 0.6 * 0.5_f64.cos();
    assert!((inputs.torque - expected).abs() < 1e-12, "{inputs:?} {expected}");
    let error = with(["torqeu"], [3.0]).expect_err("no such input");
    assert_eq!(error.to_string(), "there is no input `torqeu`; name some of `current` `torque`");
    let nobody = Actuators::<0>::named(&model, []).expect("none is named");
    let error = nobody.inputs_for(&model, (0.0, &start), &[3.0], &none).expect_err("none acts");
    assert!(matches!(error, LinearisationError::Unactuated { actuators: 0, .. }), "{error}");

    let (_, _, model, states) = walk::<DeltaRobot>(73, 1);
    let at = &states[0];
    let a = solved(&model, at);
    let two = Actuators::named(&model, ["torque[0]", "torque[2]"]).expect("they are inputs");
    let none = <DeltaRobot as Mechanism<f64>>::Inputs::from_array([0.0; 3]);
    let error = two.inputs_for(&model, (at.time, &at.state()), &a, &none).expect_err("two of three");
    assert!(matches!(error, LinearisationError::Unactuated { actuators: 2, .. }), "{error}");
    let mut off = a;
    off.as_mut_slice()[0] += 1.0;
    let error = two.inputs_for(&model, (at.time, &at.state()), &off, &none).expect_err("off the constraints");
    assert!(matches!(error, LinearisationError::Inconsistent { .. }), "{error}");
}

#[test]
fn single_precision_finds_the_inputs() {
    let (double, single) = (DeltaRobot::<f64>::default(), DeltaRobot::<f32>::default());
    let names = ["torque[0]", "torque[1]", "torque[2]"];
    let (far, near) = (double.start(), single.start());
    let none = <DeltaRobot<f64> as Mechanism<f64>>::Inputs::from_array([0.0; 3]);
    let few = <DeltaRobot<f32> as Mechanism<f32>>::Inputs::from_array([0.0; 3]);
    let wanted = [3.0, -2.0, 1.0];
    let a = Reduced::at(&double, 0.0, &far, &none).expect("regular").acceleration(&wanted);
    let expected = Actuators::named(&double, names).unwrap().inputs_for(&double, (0.0, &far), &a, &none);
    let expected = expected.expect("actuated").inputs.to_array();
    let a = Reduced::at(&single, 0.0, &near, &few).expect("regular").acceleration(&wanted.map(|x| x as f32));
    let found = Actuators::named(&single, names).unwrap().inputs_for(&single, (0.0, &near), &a, &few);
    let found = found.expect("actuated").inputs.to_array().map(f64::from);
    assert_close("torques", &found, &expected, 1e-4);
}
