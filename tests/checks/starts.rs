//! Where a motion starts: turns, rates and phases, and what is refused.

use linkwright::{AssembleExt, Mechanism, Motion, Simulation, SimulationError};
use linkwright_compiler::compile;
use linkwright_compiler::model::Coordinates;
use linkwright_compiler::schedule::{Function, Inputs, run};

linkwright::mechanism! {
    /// A crank-rocker with a torsion spring, whose angle the dynamics count.
    planar Sprung {
        rod crank   { mass [kg] = 0.5; length [mm] = 200; }
        rod coupler { mass [kg] = 1;   length [mm] = 600; }
        rod rocker  { mass [kg] = 1;   length [mm] = 400; }
        joint crank_pin:  revolute(ground(0, 0) [m], crank.start);
        joint knee:       revolute(crank.end, coupler.start);
        joint wrist:      revolute(coupler.end, rocker.end);
        joint rocker_pin: revolute(ground(0.5, 0) [m], rocker.start);
        torsion_spring spring: torsion_spring(wrist, stiffness [N*m/rad] = 1);
        start  { crank_pin.angle [deg] = 90; rocker_pin.angle [deg] ~ 70; }
        expect { degrees_of_freedom = 1; }
        output angle [rad] = wrist.angle;
    }
}

/// One position reached with other turns is no second assembly, and turns that nothing states are none.
#[test]
fn a_counted_angle_is_no_second_assembly() {
    let model = Sprung::<f64>::default();
    let start = Sprung::START;
    let angle = model.outputs(0.0, &start, &()).angle;
    assert!(angle.abs() <= std::f64::consts::PI, "{angle}");
}

linkwright::mechanism! {
    /// A wheel geared to a crank, both counting their turns.
    planar Geared {
        disk crank { mass [kg] = 1; radius [m] = 0.1; }
        disk wheel { mass [kg] = 1; radius [m] = 0.04; }
        joint a: revolute(ground(0, 0) [m], crank.center);
        joint b: revolute(ground(0.14, 0) [m], wheel.center);
        gear mesh: gear(b, a, ratio = -2.5, phase = 0);
        start { a.angle [deg] = 20; a.rate [rad/s] = 1; b.angle [rad] ~ 11; }
        output crank_angle [rad] = a.angle;
        output wheel_angle [rad] = b.angle;
    }
}

/// Kinematics from an encoder that has made turns: the coupling's other angle follows with its turns.
#[test]
fn kinematics_keep_whole_turns() {
    let model = Geared::<f64>::default();
    let start = Geared::START.q;
    let phi = {
        let mut phi = [0.0; 1];
        model.constraints(0.0, &start, &mut phi);
        phi[0]
    };
    assert!(phi.abs() < 1e-12, "the start is a whole turn off: {phi}");
    for angle in [4.0, -7.5, 20.0] {
        let given = [Motion { position: angle, rate: 0.0, acceleration: 0.0 }];
        let found = model.kinematics(0.0, &start, &given).unwrap();
        let outputs = model.outputs(0.0, &found.state(), &());
        assert!((outputs.crank_angle - angle).abs() < 1e-12, "{angle}: {outputs:?}");
        assert!((outputs.wheel_angle + 2.5 * angle).abs() < 1e-11, "{angle}: {outputs:?}");
    }
}

const DRAGGED: &str = "planar Dragged {
    rod arm { mass [kg] = 1; length [m] = 1; }
    joint pin: revolute(ground(0.5 [m/s] * time, 0 [m]), arm.start);
    start { pin.angle [deg] = 90; }
}";

linkwright::mechanism! {
    /// A rod whose pin moves at 0.5 m/s.
    planar Dragged {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pin: revolute(ground(0.5 [m/s] * time, 0 [m]), arm.start);
        start { pin.angle [deg] = 90; }
    }
}

/// A rod upright on a pin at speed u has the least kinetic energy m u²/8 with ω = 3 u/(2 L): at expansion, in both sets of
/// coordinates, and at run time.
#[test]
fn unstated_rates_have_the_least_kinetic_energy() {
    for coordinates in [Coordinates::Tree, Coordinates::Absolute] {
        let compiled = compile(DRAGGED.parse().unwrap(), Some(coordinates)).unwrap();
        let rate = *compiled.assembly.v.last().unwrap();
        assert!((rate - 0.75).abs() < 1e-9, "{coordinates:?}: {rate}");
        let inputs =
            Inputs { q: compiled.assembly.q.clone(), v: compiled.assembly.v.clone(), ..Inputs::default() };
        let energy = run(compiled.programs.get(Function::KineticEnergy), &inputs)[0];
        assert!((energy - 0.03125).abs() < 1e-12, "{coordinates:?}: {energy}");
    }
    let model = Dragged::<f64>::default();
    let start = model.assemble(&Dragged::START).unwrap();
    assert!((model.kinetic_energy(0.0, &start.q, &start.v) - 0.03125).abs() < 1e-12);
}

/// A driver's power is its effort times the rate of its law, whatever the coordinates and whatever else moves.
#[test]
fn drivers_power_does_not_depend_on_coordinates() {
    let source = "planar Pulled {
        gravity [m/s^2] = (0, -9.81);
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pin: revolute(ground(0.3 [m/s] * time, 0 [m]), arm.start);
        drive pull: arm.end.x = 0.5 [m] - 0.1 [m/s] * time;
        start { pin.angle [deg] ~ 60; }
        expect { degrees_of_freedom = 1; }
    }";
    let mut powers = Vec::new();
    for coordinates in [Coordinates::Tree, Coordinates::Absolute] {
        let compiled = compile(source.parse().unwrap(), Some(coordinates)).unwrap();
        let mut inputs =
            Inputs { q: compiled.assembly.q.clone(), v: compiled.assembly.v.clone(), ..Inputs::default() };
        let n = inputs.v.len();
        let solution = run(compiled.programs.get(Function::Acceleration), &inputs);
        inputs.acceleration = solution[..n].to_vec();
        inputs.lambda = solution[n..solution.len() - 1].to_vec();
        let drivers = run(compiled.programs.get(Function::DriverEfforts), &inputs);
        assert!((drivers[1] - drivers[0] * -0.1).abs() < 1e-9 * drivers[0].abs(), "{drivers:?}");
        powers.push(drivers[1]);
    }
    assert!((powers[0] - powers[1]).abs() < 1e-9 * powers[0].abs(), "{powers:?}");
}

linkwright::mechanism! {
    /// A four-bar whose coupler's length is a parameter.
    planar Adjustable {
        param reach [m] = 2;
        gravity [m/s^2] = (0, -9.81);
        rod crank   { mass [kg] = 1; length [m] = 1; }
        rod coupler { mass [kg] = 1; length [m] = reach; }
        rod rocker  { mass [kg] = 1; length [m] = 1.5; }
        joint crank_pin:  revolute(ground(0, 0) [m], crank.start);
        joint rocker_pin: revolute(ground(2, 0) [m], rocker.start);
        joint left:  revolute(crank.end, coupler.start);
        joint right: revolute(coupler.end, rocker.end);
        start  { crank_pin.angle [deg] = 90; crank_pin.rate [rad/s] = 2; rocker_pin.angle [deg] ~ 90; }
    }
}

/// A start for other parameters is refused with the joint that is open; assembled, it runs.
#[test]
fn an_inconsistent_start_is_refused() {
    let model = Adjustable::prepare(AdjustableParameters { reach: 2.1 }).unwrap();
    let refused = Simulation::new(&model, Adjustable::START).step(1e-3).advance().unwrap_err();
    assert_eq!(refused.joint(), Some("right"), "{refused}");
    assert!(
        matches!(refused, SimulationError::Inconsistent { position, .. } if position > 0.05),
        "{refused}"
    );
    let start = model.assemble(&Adjustable::START).unwrap();
    Simulation::new(&model, start).step(1e-3).advance().unwrap();
}

/// A length that a parameter makes negative is refused before it becomes another mechanism.
#[test]
fn lengths_stay_positive() {
    let refused = Adjustable::prepare(AdjustableParameters { reach: -2.0 }).unwrap_err();
    assert_eq!((refused.what, refused.value, refused.must_be), ("length of \"coupler\"", -2.0, "positive"));
}

/// Where rounding turns the sign of a lost pivot the watch still sees it: two four-bars side by side, all links in line.
#[test]
fn a_lost_pivot_is_seen_whatever_its_sign() {
    let (_, source, _) =
        crate::reference::models().into_iter().find(|(name, ..)| *name == "n_four_bar_2").unwrap();
    for coordinates in [Coordinates::Tree, Coordinates::Absolute] {
        let compiled = crate::reference::compiled(source, coordinates);
        let layout = &compiled.complete.equations.layout;
        let acceleration = compiled.programs.get(Function::Acceleration);
        let mut missed = 0;
        for k in 0..200 {
            // All rods along one direction, cranks and couplers alike; ground pins do not matter to D.
            let angle = 0.3 + 0.01 * f64::from(k);
            let mut inputs = Inputs { v: vec![0.0; layout.velocities()], ..Inputs::default() };
            inputs.q = vec![0.0; layout.linear.len()];
            for _ in &layout.rotations {
                inputs.q.extend([angle.cos(), angle.sin()]);
            }
            let solution = run(acceleration, &inputs);
            let pivot = solution[solution.len() - 1];
            let sound = pivot > 1e-12 && solution.iter().all(|x| x.is_finite());
            missed += usize::from(sound);
        }
        assert_eq!(missed, 0, "{coordinates:?}");
    }
}

/// Every model's emitted start satisfies its own rows, counted turns included.
#[test]
fn every_start_satisfies_its_rows() {
    for (name, source, _) in crate::reference::models() {
        for (coordinates, set) in crate::reference::SETS {
            let compiled = crate::reference::compiled(source, coordinates);
            let parameters = compiled.mechanism.parameters.iter().map(|p| p.default).collect();
            let mut inputs = Inputs {
                parameters,
                phases: compiled.assembly.phases.clone(),
                q: compiled.assembly.q.clone(),
                v: compiled.assembly.v.clone(),
                ..Inputs::default()
            };
            inputs.prepared = run(compiled.programs.get(Function::Prepare), &inputs);
            let phi = run(compiled.programs.get(Function::Constraints), &inputs);
            let worst = phi.iter().fold(0.0_f64, |worst, x| worst.max(x.abs()));
            assert!(worst < 1e-13, "{name} in {set} coordinates: {worst:e}");
        }
    }
}
