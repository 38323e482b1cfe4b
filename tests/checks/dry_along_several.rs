//! Dry friction where surfaces slide along several directions, in sleeves, balls and on pins that cross: against closed forms, and energies.

use linkwright::{
    AssembleExt, DormandPrince, LagrangeIndex1, NullSpace, Partitioned, Projected, Rk4, Simulation, Vector,
};
use linkwright_engine::{Engine, Numbers};
use mechanisms::zoo_dry::{BrakingAllWays, BrakingAllWaysInputs};

#[track_caller]
fn close(found: f64, expected: f64, within: f64, what: &str) {
    println!("{what}: {found:.15}, {:.1e} off (bound {within:.0e})", (found - expected).abs());
    assert!((found - expected).abs() <= within, "{what}: {found} in place of {expected}");
}

fn read(source: &str) -> Engine {
    Engine::read(source).unwrap_or_else(|found| panic!("{found}"))
}

/// A rod of 2 kg in its sleeve that slides as easily as it turns, J = m r², with these statements.
fn rod(inertia: f64, statements: &str) -> Engine {
    read(&format!(
        "spatial Sleeve {{
            body rod {{ mass [kg] = 2; inertia [kg*m^2] = ({inertia}, 0.02, 0.02); }}
            joint sleeve: cylindrical(ground(0, 0, 0) [m], rod.center, axis = (1, 0, 0));
            {statements}
            output turned [m] = sleeve.angle*0.03 [m]; output rate [m/s] = sleeve.rate*0.03 [m];
            output x [m] = sleeve.travel; output v [m/s] = sleeve.speed; }}"
    ))
}

const FREE: &str = "start { sleeve.angle [rad] = 0; sleeve.travel [m] = 0; sleeve.rate [rad/s] = 10; sleeve.speed [m/s] = 0.4; }";

/// Nothing pulls: it goes straight on, and stands after |v| m/f, having gone |v|² m/(2 f).
#[test]
fn what_slides_and_turns_goes_straight() {
    let engine =
        rod(0.0018, &format!("friction bush: on(sleeve) = dry(radius [m] = 0.03, force [N] = 4); {FREE}"));
    for step in [0.1, 0.03, 1e-3] {
        let mut simulation = Simulation::new(&engine, engine.start()).constant(engine.no_inputs()).step(step);
        simulation.advance_until(0.2).expect("it slides");
        let outputs = simulation.sample().outputs.as_slice().to_vec();
        close(outputs[1], 0.3 * 0.2, 1e-12, "how fast it turns");
        close(outputs[3], 0.4 * 0.2, 1e-12, "how fast it slides");
        simulation.advance_until(1.0).expect("it stands");
        let outputs = simulation.sample().outputs.as_slice().to_vec();
        close(outputs[0], 0.6 * 0.0625, 1e-11, "how far it turned");
        close(outputs[2], 0.8 * 0.0625, 1e-11, "how far it slid");
        assert_eq!([outputs[1], outputs[3]], [0.0; 2]);
    }
}

/// What is pulled by γ f along it while it turns stands after t = w m/(f (1 − γ²)), having turned by 2 w² m/(f (4 − γ²)) and slid by
/// w² m γ/(4 f (1 − γ²)): with φ the angle between v and the pull, |v| sin φ = w tan(φ/2)^(1/γ).
#[test]
fn what_is_pulled_turns_aside() {
    let statements = "friction bush: on(sleeve) = dry(radius [m] = 0.03, force [N] = 4);
        force pull: force(rod.center) = (2 [N], 0, 0);
        start { sleeve.angle [rad] = 0; sleeve.travel [m] = 0; sleeve.rate [rad/s] = 20; sleeve.speed [m/s] = 0; }";
    let run = |engine: &Engine, step: f64| {
        let mut simulation = Simulation::new(engine, engine.start()).constant(engine.no_inputs()).step(step);
        simulation.advance_until(0.4 - 1e-4).expect("it slides");
        assert!(simulation.state().v.max_abs() > 1e-5);
        let mut changed = 0;
        while simulation.time() < 0.6 {
            changed += simulation.advance().expect("it stands").gates_changed;
        }
        assert_eq!((changed, simulation.state().v.max_abs()), (1, 0.0));
        let state = simulation.state();
        // N along the axis, and at the radius.
        close(state.gates.as_slice()[1], -2.0, 1e-12, "what holds it");
        let turned = simulation.sample().outputs.as_slice()[0];
        [turned.rem_euclid(core::f64::consts::TAU * 0.03), simulation.sample().outputs.as_slice()[2]]
    };
    let in_tree = rod(0.0018, statements);
    let absolute = rod(0.0018, &format!("{statements} options {{ coordinates = absolute; }}"));
    for (engine, step, within) in [(&in_tree, 1e-2, 1e-6), (&in_tree, 1e-3, 1e-10), (&absolute, 1e-3, 1e-9)] {
        let [turned, slid] = run(engine, step);
        close(turned, 0.096, within, "how far it turned");
        close(slid, 0.03, within, "how far it slid");
    }
}

/// A pull that grows tears it off where its size is that of what holds; whichever method and step, it goes the same way from there, which is that
/// of an integration in steps of a twentieth of the time since (J = 6 m r²). Work and energy are balanced.
#[test]
fn what_is_torn_off_goes_against_what_resists() {
    let statements = "friction bush: on(sleeve) = dry(radius [m] = 0.03, force [N] = 4, breakaway [N] = 5);
        force pull: force(rod.center) = (4 [N]*sin(time*1 [rad/s]), 0, 0);
        torque turn: torque(sleeve) = 0.16 [N*m]*sin(time*1 [rad/s]);
        state work [J] = 0; rate work = power(bush) + power(pull) + power(turn);
        start { sleeve.angle [rad] = 0; sleeve.rate [rad/s] = 0; sleeve.travel [m] = 0; sleeve.speed [m/s] = 0; }
        output balance [J] = kinetic_energy - work;";
    let engine = rod(0.0108, statements);
    let torn = 0.75_f64.asin();
    let outputs = |sample: &Numbers| sample.as_slice().to_vec();
    let mut simulation =
        Simulation::new(&engine, engine.start()).constant(engine.no_inputs()).integrator(Rk4).step(1e-2);
    simulation.advance_until(torn - 1e-7).expect("it holds");
    assert_eq!(simulation.state().v.max_abs(), 0.0);
    for step in [1e-2, 1e-3] {
        let mut simulation =
            Simulation::new(&engine, engine.start()).constant(engine.no_inputs()).integrator(Rk4).step(step);
        simulation.advance_until(1.0).expect("it is torn off");
        let found = outputs(&simulation.sample().outputs);
        let balance = found[0];
        close(found[2], 0.019_057_238_862_6, 1e-8, "how fast it turns");
        close(found[4], 0.021_458_551_455_8, 3e-8, "how fast it slides");
        close(balance, 0.0, 1e-10, "energy and work");
        simulation.advance_until(4.0).expect("it comes back");
        close(outputs(&simulation.sample().outputs)[0], 0.0, 1e-7, "energy and work");
    }
    let mut simulation = Simulation::new(&engine, engine.start())
        .constant(engine.no_inputs())
        .integrator(DormandPrince::tolerance(1e-9))
        .step(1e-2);
    simulation.advance_until(1.0).expect("it is torn off");
    close(outputs(&simulation.sample().outputs)[2], 0.019_057_238_862_6, 1e-7, "by steps of its own");
}

/// A ball slides about the axis that it turns about: |ω| falls by T/J.
#[test]
fn a_ball_slides_about_its_axis() {
    let engine = read(
        "spatial Ball {
            body ball { mass [kg] = 1; inertia [kg*m^2] = (0.5, 0.5, 0.5); }
            joint socket: spherical(ground(0, 0, 0) [m], ball.center);
            friction rub: on(socket) = dry(torque [N*m] = 1.5, breakaway [N*m] = 2);
            start { ball.rate.x [rad/s] = 2; ball.rate.y [rad/s] = -3; ball.rate.z [rad/s] = 6; }
            output x [rad/s] = ball.rate.x; output y [rad/s] = ball.rate.y; output z [rad/s] = ball.rate.z; output lost [W] = -power(rub); }",
    );
    let mut simulation = Simulation::new(&engine, engine.start()).constant(engine.no_inputs()).step(1e-2);
    simulation.advance_until(1.4).expect("it slides");
    let outputs = simulation.sample().outputs.as_slice().to_vec();
    let left = 1.0 - 1.4 * 3.0 / 7.0;
    for (found, begun) in outputs.iter().zip([2.0, -3.0, 6.0]) {
        close(*found, left * begun, 1e-10, "rate");
    }
    close(outputs[3], 1.5 * 7.0 * left, 1e-9, "power");
    simulation.advance_until(7.0 / 3.0 - 1e-3).expect("it slides");
    close(simulation.state().v.as_slice().iter().map(|v| v * v).sum::<f64>().sqrt(), 3e-3, 1e-9, "speed");
    simulation.advance_until(3.0).expect("it stands");
    assert!(simulation.state().v.max_abs() < 1e-300, "{:e}", simulation.state().v.max_abs());
}

/// Everything in one mechanism, under each formulation; interpreted it moves to the same bits.
#[test]
fn all_ways_are_braked() {
    let model = BrakingAllWays::default();
    let inputs = BrakingAllWaysInputs { wind: 0.1 };
    let run = || Simulation::new(&model, BrakingAllWays::START).integrator(Rk4).constant(inputs).step(2e-3);
    let (mut one, engine) = (run(), read(BrakingAllWays::<f64>::SOURCE));
    let mut other =
        Simulation::new(&engine, engine.start()).integrator(Rk4).constant(Numbers::of(&[0.1])).step(2e-3);
    let (begun, mut taken, mut before, mut changed) = (one.energy(), 0.0, one.sample().outputs.lost, 0);
    while one.time() < 0.5 {
        let step = one.advance().expect("it moves");
        other.advance().expect("it moves");
        let now = one.sample().outputs.lost;
        taken += 0.5 * step.size * (before + now);
        (before, changed) = (now, changed + step.gates_changed);
    }
    let found = |simulation: &[f64]| simulation.iter().map(|v| v.to_bits()).collect::<Vec<_>>();
    assert_eq!(found(one.state().v.as_slice()), found(other.state().v.as_slice()));
    assert_eq!(found(one.state().gates.as_slice()), found(other.state().gates.as_slice()));
    println!("{changed} changes, {taken} J taken of {begun}");
    // By the trapezoidal rule, and what jumps.
    close(one.energy() + taken, begun, 2e-2, "energy and what was taken");
    assert!(changed > 0);
    macro_rules! under {
        ($($formulation:expr),* $(,)?) => {$({
            let mut simulation = run().formulation($formulation);
            simulation.advance_until(0.5).expect("it moves");
            for (found, wanted) in simulation.state().q.as_slice().iter().zip(one.state().q.as_slice()) {
                close(*found, *wanted, 1e-7, stringify!($formulation));
            }
        })*};
    }
    under!(LagrangeIndex1, Projected::after(LagrangeIndex1), NullSpace, Partitioned::default());
}
