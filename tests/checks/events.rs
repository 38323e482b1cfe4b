//! Events of emitted models: the pendulum's zeros against its exact period, by every integrator; a loop; a body in space.

use linkwright::{
    Ali3p, DormandPrince, Event, ExplicitTrapezoidal, GeneralisedAlpha, ImplicitTrapezoidal, Integrator,
    LagrangeIndex1, MechanismDynamics, NoInputs, Projected, Rk4, SemiImplicitEuler, Simulation,
    SimulationError,
};
use linkwright_models::free_rigid_body::FreeRigidBody;
use linkwright_models::n_four_bar::NFourBar2;
use linkwright_models::simple_pendulum::SimplePendulum;
use std::f64::consts::PI;

/// The exact period of A01, s: 4 √(L/g) K(1/√2).
const PERIOD: f64 = 2.367_841_947_576_237_4;

linkwright::mechanism! {
    /// A01 with its angle and its rate, as a body under constraints.
    planar Swing {
        gravity [m/s^2] = (0, -9.81);
        body arm { mass [kg] = 1; inertia [kg*m^2] = 0; center [m] = (1, 0); }
        joint pivot: revolute(ground(0, 0) [m], arm.origin);
        start   { pivot.angle [deg] = 180; pivot.rate [rad/s] = 0; }
        options { coordinates = absolute; emit = (tangent); }
        output angle [rad] = pivot.angle;
        output rate [rad/s] = pivot.rate;
    }
}

/// The mass passes below the pivot after each half of a period, first to the right.
fn zeros<I>(integrator: I, step: f64, bound: f64)
where
    I: for<'m> Integrator<f64, MechanismDynamics<'m, SimplePendulum, f64, LagrangeIndex1, NoInputs>> + Copy,
{
    let model = SimplePendulum::<f64>::default();
    let x = Event::of("x").tolerance(1e-12);
    for (event, expected) in [
        (x, [0.25, 0.75, 1.25, 1.75, 2.25, 2.75]),
        (x.rising(), [0.25, 1.25, 2.25, 3.25, 4.25, 5.25]),
        (x.falling(), [0.75, 1.75, 2.75, 3.75, 4.75, 5.75]),
    ] {
        let mut simulation = Simulation::new(&model, SimplePendulum::START).integrator(integrator).step(step);
        let mut worst = 0.0_f64;
        for part in expected {
            let found = simulation.run_until_event(15.0, &[event], |_| ()).expect("it swings");
            let found = found.expect("it passes");
            worst = worst.max((found.time - part * PERIOD).abs());
            assert_eq!(found.rising, part % 1.0 == 0.25, "{found:?}");
            assert!(simulation.sample().outputs.x.abs() < 1e-11 && simulation.sample().outputs.y < -0.999);
        }
        println!("{event:?}: off by {worst:.1e} s");
        assert!(worst < bound, "{event:?}: off by {worst:e} s");
    }
}

#[test]
fn the_pendulum_passes_at_its_quarter_periods() {
    zeros(Rk4, 2e-3, 1e-9);
    zeros(DormandPrince::fixed(), 5e-3, 1e-9);
    zeros(DormandPrince::tolerance(1e-12), 0.2, 1e-9);
    zeros(DormandPrince::tolerance(1e-9), 0.2, 1e-6);
    zeros(ExplicitTrapezoidal, 1e-3, 3e-4);
    zeros(SemiImplicitEuler, 1e-3, 3e-2);
}

/// Implicit methods carry accelerations from step to step; a step repeated begins with those it began with before.
#[test]
fn implicit_methods_find_the_quarter_period() {
    fn quarter<I>(integrator: I) -> f64
    where
        I: for<'m> Integrator<f64, MechanismDynamics<'m, Swing, f64, LagrangeIndex1, NoInputs>>,
    {
        let model = Swing::<f64>::default();
        let mut simulation = Simulation::new(&model, Swing::START).integrator(integrator).step(1e-3);
        let level = Event::of("angle").level(1.5 * PI).tolerance(1e-10);
        let found = simulation.run_until_event(2.0, &[level], |_| ()).expect("it swings");
        let late = found.expect("it passes").time - 0.25 * PERIOD;
        assert!((simulation.sample().outputs.angle - 1.5 * PI).abs() < 1e-8);
        // It goes on from there, and does not find it again.
        assert_eq!(simulation.run_until_event(1.0, &[level], |_| ()), Ok(None));
        late
    }
    for late in [
        quarter(GeneralisedAlpha::new(0.8)),
        quarter(ImplicitTrapezoidal::<f64>::default()),
        quarter(Ali3p::new(1e7)),
    ] {
        println!("off by {late:.1e} s");
        assert!(late.abs() < 3e-6, "{late:e}");
    }
}

/// The time found is at most the tolerance behind the zero.
#[test]
fn the_tolerance_is_reached() {
    let model = SimplePendulum::<f64>::default();
    for tolerance in [1e-2, 1e-4, 1e-6, 1e-8, 1e-10] {
        let event = Event::of("x").tolerance(tolerance);
        let mut simulation = Simulation::new(&model, SimplePendulum::START).step(1e-3);
        let found = simulation.run_until_event(1.0, &[event], |_| ()).expect("it swings");
        let late = found.expect("it passes").time - 0.25 * PERIOD;
        assert!(late > -1e-11 && late < tolerance + 1e-11, "{tolerance:e}: {late:e}");
    }
}

/// At rest on the right after half a period, where the angle is 2π, and on the left after a whole one.
#[test]
fn an_absolute_swing_turns_back_where_it_should() {
    let model = Swing::<f64>::default();
    let formulation = Projected::after(LagrangeIndex1);
    let mut simulation = Simulation::new(&model, Swing::START)
        .formulation(formulation)
        .integrator(DormandPrince::tolerance(1e-11))
        .step(0.1);
    let events =
        [Event::of("rate").tolerance(1e-12), Event::of("angle").level(1.5 * PI).rising().tolerance(1e-12)];
    let mut found = Vec::new();
    while let Some(event) = simulation.run_until_event(1.9 * PERIOD, &events, |_| ()).expect("it swings") {
        found.push((event.event, event.time / PERIOD, simulation.sample().outputs.angle));
    }
    println!("{found:?}");
    // The start is at rest, and is no event.
    let expected =
        [(1, 0.25, 1.5 * PI), (0, 0.5, 2.0 * PI), (0, 1.0, PI), (1, 1.25, 1.5 * PI), (0, 1.5, 2.0 * PI)];
    assert_eq!(found.len(), expected.len(), "{found:?}");
    for (found, expected) in found.iter().zip(expected) {
        assert_eq!(found.0, expected.0);
        assert!((found.1 - expected.1).abs() < 1e-8 && (found.2 - expected.2).abs() < 1e-7, "{found:?}");
    }
}

/// A closed loop: what is found with short steps is found with long ones.
#[test]
fn a_loop_meets_its_levels() {
    let model = NFourBar2::<f64>::default();
    let levels = [0.75, 0.25].map(|level| Event::of("x").level(level).tolerance(1e-11));
    let times = |integrator: DormandPrince, step: f64| {
        let mut simulation = Simulation::new(&model, NFourBar2::START).integrator(integrator).step(step);
        let mut times = Vec::new();
        while times.len() < 2 {
            let found = simulation.run_until_event(3.0, &levels, |_| ()).expect("it falls");
            times.push(found.expect("it passes both").time);
        }
        times
    };
    let (short, long) = (times(DormandPrince::fixed(), 1e-3), times(DormandPrince::tolerance(1e-11), 0.05));
    println!("{short:?}");
    assert!(short[0] < short[1], "{short:?}");
    for (short, long) in short.iter().zip(&long) {
        assert!((short - long).abs() < 1e-8, "{short} {long}");
    }
}

/// The nut turns over: its rate about the middle axis vanishes twice in the period of 4.66008834689 s.
#[test]
fn the_free_body_turns_over() {
    let model = FreeRigidBody::<f64>::default();
    let mut simulation =
        Simulation::new(&model, FreeRigidBody::START).integrator(DormandPrince::tolerance(1e-11)).step(0.1);
    let event = Event::of("rate_y").tolerance(1e-12);
    let mut next = || {
        let found = simulation.run_until_event(20.0, &[event], |_| ()).expect("it tumbles");
        found.expect("it turns over").time
    };
    let times = [next(), next(), next()];
    println!("{times:?}");
    assert!((times[2] - times[0] - 4.660_088_346_89).abs() < 1e-7, "{times:?}");
}

#[test]
fn an_output_that_does_not_exist_is_named_with_its_neighbours() {
    let model = FreeRigidBody::<f64>::default();
    let mut simulation = Simulation::new(&model, FreeRigidBody::START).step(0.01);
    let error = simulation.run_until_event(1.0, &[Event::of("ratey")], |_| ()).unwrap_err();
    assert!(matches!(error, SimulationError::NoSuchOutput { nearest: Some("rate_y"), .. }), "{error:?}");
    assert_eq!(
        error.to_string(),
        "the mechanism has no output `ratey` to watch; perhaps `rate_y` is meant; its outputs are `rate_x`, `rate_y`, \
         `rate_z`"
    );
}
