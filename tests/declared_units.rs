//! Values in the units that a definition declares, beside the fields in SI units.

use linkwright::{AssembleExt, Mechanism};

linkwright::mechanism! {
    planar Lift {
        param stroke [mm] = 500;
        param stiffness [N/mm] = 2;
        param share [1] = 0.5;
        param mass [kg] = 3;
        input push [kN];
        input turn [N*m];
        state warm [kJ] = 2;
        rate warm = -share*warm/5 [min] + power(push)/100;
        gravity [m/s^2] = (0, -9.81);
        body cage { mass [kg] = mass; inertia [kg*m^2] = 0.1; }
        joint rail: prismatic(ground(0, 0) [m], cage.center, axis = (0, 1));
        force push: force(rail) = push - 0*turn/1 [m];
        spring hold: spring(cage.center, ground(0, 1) [m], stiffness = stiffness, length = stroke);
        start { rail.travel [m] = 0; rail.speed [m/s] = 0; }
        output height [mm] = rail.travel;
        output speed [km/h] = rail.speed;
        output tilt [deg] = 0.5 [rad] + 0*warm*1 [rad/J];
        output heavy [N] = rail.reaction.normal;
    }
}

#[test]
fn a_value_is_set_and_read_in_its_unit() {
    let mut parameters = LiftParameters::default();
    assert_eq!((parameters.stroke, parameters.stroke_mm()), (0.5, 500.0));
    assert_eq!((parameters.stiffness, parameters.stiffness_N_per_mm()), (2000.0, 2.0));
    parameters.set_stroke_mm(250.0);
    assert_eq!(parameters.stroke, 0.25);
    let model = Lift::prepare(parameters).expect("within its bounds");
    let start = model.start();
    assert_eq!(start.z, [2000.0]);
    let mut internal = Lift::internal(&start.z);
    assert_eq!(internal.warm_kJ(), 2.0);
    internal.set_warm_kJ(3.0);
    let state = linkwright::State { z: internal.into(), ..start };
    assert_eq!(state.z, [3000.0]);
    let mut inputs: LiftInputs = LiftInputs { push: 0.0, turn: 0.0 };
    inputs.set_push_kN(0.02);
    assert!((inputs.push - 20.0).abs() < 1e-12 && (inputs.push_kN() - 0.02).abs() < 1e-15);
    let moving = linkwright::State { v: [10.0], ..state };
    let outputs: LiftOutputs = model.outputs(0.0, &moving, &inputs);
    assert_eq!(outputs.height_mm(), 0.0);
    assert!((outputs.speed_km_per_h() - 36.0).abs() < 1e-12);
    assert!((outputs.tilt_deg() - 0.5_f64.to_degrees()).abs() < 1e-12);
    let reactions = model.reactions(0.0, &moving, &inputs, &[0.0], &[]);
    assert_eq!(outputs.heavy, -reactions[0].force[0]);
}
