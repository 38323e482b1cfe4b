//! Dry friction in joints: it holds, slides and turns back as closed forms say, in trees and closed loops, under every formulation and by every
//! explicit method; energy is balanced; the interpreter moves it to the same bits; errors where nothing holds.

use linkwright::{
    AssembleExt, AugmentedLagrangian, Baumgarte, DormandPrince, ExplicitTrapezoidal, LagrangeIndex1,
    NullSpace, Partitioned, Penalty, Projected, Rk4, SemiImplicitEuler, Simulation, SimulationError, Vector,
};
use linkwright_engine::{Engine, Numbers};
use mechanisms::zoo_dry::{Braking, BrakingInSpace, BrakingInSpaceParameters, BrakingInputs};

linkwright::mechanism! {
    /// A block on a rail, thrown up a slope of 20 or 30 degrees.
    planar Slope {
        param slope [deg] = 20;
        gravity = (-9.81 [m/s^2]*sin(slope), -9.81 [m/s^2]*cos(slope));
        body block { mass [kg] = 2; inertia [kg*m^2] = 0.01; }
        joint rail: prismatic(ground(0, 0) [m], block.center, axis = (1, 0));
        friction rub: on(rail) = dry(static = 0.5, length [m] = 0.2);
        state taken [J] = 0;
        rate taken = power(rub);
        start { rail.travel [m] = 0; rail.speed [m/s] = 2; }
        output pressed [N] = rub.normal;
        output force [N] = rub.force;
        output friction [J] = taken;
    }
}

linkwright::mechanism! {
    /// A mass on a rail that rides on a driven belt, held back by a spring.
    planar Carried {
        param sliding [N] = 0.5;
        body belt { mass [kg] = 1; inertia [kg*m^2] = 1; }
        body block { mass [kg] = 1; inertia [kg*m^2] = 1; }
        joint guide: prismatic(ground(0, 0) [m], belt.center, axis = (1, 0));
        joint over: prismatic(belt.center, block.center, axis = (1, 0));
        drive run: guide.travel = 0.2 [m/s]*time;
        friction rub: on(over) = dry(force = sliding, breakaway [N] = 1);
        spring back: spring(ground(-10, 0) [m], block.center, stiffness [N/m] = 1, length [m] = 10);
        start { over.travel [m] = 0; over.speed [m/s] = 0; }
        output sliding [m/s] = rub.sliding;
        output x [m] = block.center.x;
    }
}

linkwright::mechanism! {
    /// A four-bar whose two pins at the ground brake it until it stands: there both hold the same.
    planar FourBar {
        gravity [m/s^2] = (0, -9.81);
        param large [m] = 0.03;
        rod crank { mass [kg] = 1; length [m] = 0.2; }
        rod coupler { mass [kg] = 2.5; length [m] = 0.5; }
        rod rocker { mass [kg] = 2; length [m] = 0.4; }
        joint a: revolute(ground(0, 0) [m], crank.start);
        joint b: revolute(crank.end, coupler.start);
        joint c: revolute(coupler.end, rocker.end);
        joint d: revolute(ground(0.6, 0) [m], rocker.start);
        friction drum: on(a) = dry(static = 0.4, kinetic = 0.3, radius = large);
        friction band: on(d) = dry(torque [N*m] = 1.5, breakaway [N*m] = 2);
        state taken [J] = 0;
        rate taken = power(drum) + power(band);
        start { a.angle [deg] = 60; a.rate [rad/s] = 12; rocker.angle [deg] ~ 98; }
        output angle [rad] = a.angle;
        output rate [rad/s] = a.rate;
        output first [N*m] = drum.torque;
        output other [N*m] = band.torque;
        output pressed [N] = drum.normal;
        output friction [J] = taken;
    }
}

linkwright::mechanism! {
    /// A drum under a brake whose torque is an input, turned by a load.
    planar Hoist {
        input grip [N*m];
        gravity [m/s^2] = (0, -9.81);
        disk drum { mass [kg] = 2; radius [m] = 0.1; }
        joint axle: revolute(ground(0, 0) [m], drum.center);
        torque load: torque(axle) = 3 [N*m];
        friction brake: on(axle) = dry(torque = grip);
        start { axle.angle [rad] = 0; }
        output rate [rad/s] = axle.rate;
        output held [N*m] = brake.torque;
    }
}

#[track_caller]
fn close(found: f64, expected: f64, within: f64, what: &str) {
    println!("{what}: {found:.15}, {:.1e} off (bound {within:.0e})", (found - expected).abs());
    assert!((found - expected).abs() <= within, "{what}: {found} in place of {expected}");
}

fn slope(degrees: f64) -> Slope {
    Slope::prepare(SlopeParameters { slope: degrees.to_radians() }).expect("a slope")
}

/// With g, μ and α: it stops after v²/(2 g (sin α + μ cos α)), and there it stays where tan α < μ.
#[test]
fn a_block_on_a_rail_stops_and_stays() {
    let model = slope(20.0);
    let mut simulation = Simulation::new(&model, Slope::START).step(1e-2);
    simulation.advance_until(0.251_117_160_261_027 - 1e-9).expect("it moves");
    assert!(simulation.state().v[0] > 0.0 && simulation.state().v[0] < 1e-7);
    let mut changed = 0;
    while simulation.time() < 2.0 {
        changed += simulation.advance().expect("it rests").gates_changed;
    }
    assert_eq!(changed, 1);
    let (outputs, angle) = (simulation.sample().outputs, 20.0_f64.to_radians());
    close(simulation.state().q[0], 0.251_117_160_261_027, 1e-12, "where it stays");
    close(simulation.state().v[0], 0.0, 0.0, "creeping");
    close(outputs.pressed, 2.0 * 9.81 * angle.cos(), 1e-7, "what presses");
    close(outputs.force, 2.0 * 9.81 * angle.sin(), 1e-12, "what holds");
    let taken = -2.0 * 9.81 * angle.cos() * 0.5 * 0.251_117_160_261_027;
    close(outputs.friction, taken, 1e-8, "what friction took");
}

/// Where tan α > μ it slides back, in both sets of coordinates alike.
#[test]
fn a_block_on_a_rail_slides_back() {
    let model = slope(30.0);
    let run = |h: f64| Simulation::new(&model, Slope::START).step(h);
    let end = |state: linkwright::StateOf<Slope>| [state.q[0], state.v[0]];
    let found = [
        (end(run(1e-2).run_until(1.0, |_| {}).expect("it moves")), 1e-12),
        (
            end(run(1e-2)
                .integrator(DormandPrince::tolerance(1e-11))
                .run_until(1.0, |_| {})
                .expect("it moves")),
            1e-10,
        ),
        (end(run(1e-2).formulation(LagrangeIndex1).run_until(1.0, |_| {}).expect("it moves")), 1e-12),
        (end(run(1e-3).integrator(ExplicitTrapezoidal).run_until(1.0, |_| {}).expect("it moves")), 1e-10),
        (end(run(1e-5).integrator(SemiImplicitEuler).run_until(1.0, |_| {}).expect("it moves")), 2e-4),
    ];
    for ([x, v], within) in found {
        close(x, 0.017_843_517_838_295, within, "where it is after 1 s");
        close(v, -0.513_551_854_988_346, within, "and how fast");
    }
    let source =
        Slope::<f64>::SOURCE.replace("output force", "options { coordinates = absolute; } output force");
    let engine: Engine = Engine::read(&source).expect("it is good");
    let engine = engine.prepared(&[30.0_f64.to_radians()]).expect("a slope");
    let mut simulation = Simulation::new(&engine, engine.start()).constant(engine.no_inputs()).step(1e-2);
    simulation.advance_until(1.0).expect("it moves");
    assert_eq!(simulation.state().v.as_slice().len(), 3);
    close(simulation.state().q.as_slice()[0], 0.017_843_517_838_295, 1e-11, "in absolute coordinates");
}

/// The belt of the sources: a slip takes π + 2 atan(0.4), what sticks 5 s.
#[test]
fn a_mass_on_a_belt_sticks_and_slips() {
    let model = Carried::default();
    let mut simulation = Simulation::new(&model, Carried::START).step(1e-2);
    let slip = core::f64::consts::PI + 2.0 * 0.4_f64.atan();
    let mut begins = 5.0;
    for turn in 0..3 {
        for (time, slides) in [
            (begins - 1e-6, false),
            (begins + 1e-3, true),
            (begins + slip - 1e-3, true),
            (begins + slip + 1e-6, false),
        ] {
            simulation.advance_until(time).expect("it moves");
            let sliding = simulation.sample().outputs.sliding;
            assert_eq!(sliding < -1e-5, slides, "turn {turn}, {time} s: {sliding}");
            assert!(slides || sliding == 0.0, "turn {turn}, {time} s: {sliding}");
        }
        // Where it sticks again is where the spring pulls with 2·0.5 − 1 = 0 N.
        close(simulation.sample().outputs.x, 0.2e-6, 1e-7, "where it sticks again");
        begins += slip + 5.0;
    }
    close(begins, 5.0 + 3.0 * 8.902_605_407_814_52, 1e-12, "period");
}

/// It stands where both brakes hold, and what it had is what friction took; Dormand and Prince's method tells where that is.
#[test]
fn a_four_bar_is_braked_until_it_sticks() {
    let model = FourBar::default();
    let begun = Simulation::new(&model, FourBar::START).step(1e-3).energy();
    let mut simulation = Simulation::new(&model, FourBar::START)
        .formulation(Projected::after(LagrangeIndex1))
        .integrator(DormandPrince::tolerance(1e-11))
        .step(1e-2);
    let mut changed = 0;
    while simulation.time() < 4.0 {
        changed += simulation.advance().expect("it moves").gates_changed;
        let sample = simulation.sample();
        close(sample.energy() - sample.outputs.friction, begun, 1e-8, "energy and what was taken");
        assert!(sample.state.v.max_abs() < 60.0);
    }
    let rest = simulation.sample();
    println!("{changed} changes, rests at {:?}", rest.outputs);
    assert!(changed > 6);
    close(rest.outputs.rate, 0.0, 1e-12, "rate at rest");
    let most = 0.4 * 0.03 * rest.outputs.pressed;
    assert!(rest.outputs.first.abs() <= most && rest.outputs.other.abs() <= 2.0, "{:?}", rest.outputs);
    macro_rules! under {
        ($($formulation:expr),* $(,)?) => {$({
            let mut simulation = Simulation::new(&model, FourBar::START).formulation($formulation).integrator(Rk4).step(1e-3);
            simulation.advance_until(4.0).expect("it moves");
            let outputs = simulation.sample().outputs;
            close((outputs.angle - rest.outputs.angle).sin(), 0.0, 2e-7, stringify!($formulation));
            close(outputs.friction, rest.outputs.friction, 2e-7, "what was taken");
        })*};
    }
    under!(
        Baumgarte { alpha: 10.0, beta: 10.0 },
        LagrangeIndex1,
        Projected::after(LagrangeIndex1),
        NullSpace,
        Partitioned::default(),
        AugmentedLagrangian::new(Penalty { alpha: 1e7, omega: 10.0, mu: 1.0 }),
    );
}

/// The order of a method is kept through sticking and turning.
#[test]
fn order_is_kept() {
    let model = FourBar::default();
    let run = |h: f64| {
        let mut simulation = Simulation::new(&model, FourBar::START)
            .formulation(Projected::after(LagrangeIndex1))
            .integrator(Rk4)
            .step(h);
        simulation.advance_until(1.5).expect("it moves");
        simulation.sample().outputs.angle
    };
    let exact = run(1.25e-4);
    let [coarse, fine] = [4e-3, 2e-3].map(|h| (run(h) - exact).abs());
    println!("errors {coarse:e}, {fine:e}: order {}", (coarse / fine).log2());
    assert!((coarse / fine).log2() > 3.3, "{coarse:e}, {fine:e}");
}

/// A brake that is let go, and applied again.
#[test]
fn a_brake_holds_by_an_input() {
    let model = Hoist::default();
    let grip = |time: f64, _: &linkwright::StateOf<Hoist>| HoistInputs {
        grip: if time < 0.5 {
            4.0
        } else if time < 1.0 {
            1.0
        } else {
            5.0
        },
    };
    let mut simulation = Simulation::new(&model, Hoist::START).held(grip).step(1e-2);
    simulation.advance_until(0.49).expect("it holds");
    close(simulation.sample().outputs.rate, 0.0, 0.0, "held");
    close(simulation.state().gates[0], -3.0, 1e-12, "with what is asked of it");
    simulation.advance_until(1.0).expect("it slips");
    // (3 − 1) N m on 0.01 kg m² for 0.5 s.
    close(simulation.sample().outputs.rate, 100.0, 1e-9, "slipping");
    simulation.advance_until(1.5 - 1e-6).expect("it is braked");
    close(simulation.sample().outputs.rate, 2e-4, 1e-8, "just before it stands");
    simulation.advance_until(2.0).expect("it holds");
    close(simulation.sample().outputs.rate, 0.0, 0.0, "held again");
}

/// A wheel of 0.01 kg m² at 100 rad/s under a brake whose torque is an input, above or below what is written to hold.
fn wheel(torque: f64) -> Result<[f64; 2], SimulationError> {
    let source = "planar Wheel {
        input pedal [N*m];
        body wheel { mass [kg] = 1; inertia [kg*m^2] = 0.01; }
        joint axle: revolute(ground(0, 0) [m], wheel.origin);
        friction drum: on(axle) = dry(torque = pedal, breakaway [N*m] = 2);
        start { axle.angle [rad] = 0; axle.rate [rad/s] = 100; }
        output rate [rad/s] = axle.rate; output torque [N*m] = drum.torque; }";
    let engine = Engine::read(source).unwrap_or_else(|found| panic!("{found}"));
    let mut simulation = Simulation::new(&engine, engine.start()).constant(Numbers::of(&[torque])).step(1e-2);
    simulation.advance_until(0.4)?;
    let outputs = simulation.sample().outputs;
    Ok([outputs.as_slice()[0], outputs.as_slice()[1]])
}

/// What would push does nothing; what slides with more than is written to hold with holds with that; no number is an error.
#[test]
fn a_brake_takes_any_input() {
    let [rate, torque] = wheel(-40.0).expect("it turns");
    close(rate, 100.0, 1e-12, "rate");
    close(torque, 0.0, 0.0, "torque");
    let [rate, _] = wheel(1.0).expect("it slows down");
    close(rate, 60.0, 1e-9, "rate");
    let [rate, torque] = wheel(5.0).expect("it stands");
    close(rate, 0.0, 0.0, "rate");
    close(torque, 0.0, 1e-12, "torque");
    for none in [f64::NAN, f64::INFINITY] {
        let error = wheel(none).expect_err("no number");
        assert!(matches!(error, SimulationError::NonFinite { .. }), "{error}");
    }
}

/// One share alone is both.
#[test]
fn what_slides_holds_with_the_same() {
    let of = |shares: &str| {
        let source = format!(
            "planar Slope {{ gravity [m/s^2] = (-4, -9);
             body block {{ mass [kg] = 2; inertia [kg*m^2] = 0.01; }}
             joint rail: prismatic(ground(0, 0) [m], block.center, axis = (1, 0));
             friction rub: on(rail) = dry({shares});
             start {{ rail.travel [m] = 0; rail.speed [m/s] = 1; }} output x [m] = rail.travel; output force [N] = rub.force; }}"
        );
        let engine = Engine::read(&source).unwrap_or_else(|found| panic!("{found}"));
        let mut simulation = Simulation::new(&engine, engine.start()).constant(engine.no_inputs()).step(1e-2);
        simulation.advance_until(0.5).expect("it stands");
        simulation.sample().outputs.as_slice().to_vec()
    };
    let found = of("kinetic = 0.5");
    // v²/2(μ g + 4), then what is asked.
    close(found[0], 0.5 / 8.5, 1e-12, "where it stands");
    close(found[1].abs(), 8.0, 1e-11, "what holds it");
    assert_eq!(found, of("static = 0.5"));
}

/// Everything in one mechanism: energy is balanced, and interpreted it moves to the same bits.
#[test]
fn the_interpreter_brakes_alike() {
    let model = Braking::default();
    let inputs = BrakingInputs { pedal: 0.1 };
    let mut simulation = Simulation::new(&model, Braking::START).integrator(Rk4).constant(inputs).step(1e-3);
    let engine: Engine = Engine::read(Braking::<f64>::SOURCE).expect("it is good");
    let mut other =
        Simulation::new(&engine, engine.start()).integrator(Rk4).constant(Numbers::of(&[0.1])).step(1e-3);
    let mut changed = 0;
    while simulation.time() < 1.5 {
        changed += simulation.advance().expect("it moves").gates_changed;
        other.advance().expect("it moves");
    }
    assert!(changed > 3, "{changed} changes");
    assert_eq!(simulation.state().q.as_slice(), other.state().q.as_slice());
    assert_eq!(simulation.state().v.as_slice(), other.state().v.as_slice());
    assert_eq!(simulation.state().gates.as_slice(), other.state().gates.as_slice());
}

/// In space: N of a pin with shoulder and length and of a rail. What was there is what was taken.
#[test]
fn joints_in_space_are_braked() {
    let model = BrakingInSpace::prepare(BrakingInSpaceParameters { grip: 1.5 }).expect("it is good");
    let mut simulation = Simulation::new(&model, BrakingInSpace::START).integrator(Rk4).step(1e-3);
    let (begun, mut taken, mut before) = (simulation.energy(), 0.0, simulation.sample().outputs.lost);
    let mut changed = 0;
    while simulation.time() < 1.0 {
        let step = simulation.advance().expect("it moves");
        let now = simulation.sample().outputs.lost;
        (taken, before, changed) =
            (taken + 0.5 * step.size * (before + now), now, changed + step.gates_changed);
    }
    println!("{changed} changes, {taken} J taken of {begun}");
    // By the trapezoidal rule, and what jumps.
    close(simulation.energy() + taken, begun, 2e-2, "energy and what was taken");
    assert!(changed > 0);
}

/// Friction that presses harder by itself than it lets go.
#[test]
fn errors_name_what_sticks() {
    let model = FourBar::prepare(FourBarParameters { large: 5.0 }).expect("a large pin");
    let error = Simulation::new(&model, FourBar::START).step(1e-3).advance_until(1.0).expect_err("it jams");
    assert!(matches!(error, SimulationError::Locked { friction: "drum", .. }), "{error:?}");
    assert_eq!(error.joint(), Some("drum"));
}
