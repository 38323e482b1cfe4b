//! Memories and events: against closed forms, by every integrator and formulation, compiled and interpreted.

use linkwright::{
    Ali3p, AssembleExt, Baumgarte, DormandPrince, Event, ExplicitTrapezoidal, GeneralisedAlpha,
    ImplicitTrapezoidal, LagrangeIndex1, Mechanism, NullSpace, Projected, Rk4, SemiImplicitEuler, Simulation,
    SimulationError, StepError, Stepper, Trigger, Vector,
};
use linkwright_engine::{Engine, Numbers};
use mechanisms::zoo_memories::{Remembering, RememberingInputs, RememberingOutputs};

const NO_PULL: RememberingInputs = RememberingInputs { pull: 0.0 };

/// The slider after so many ticks of the controller, by the exact solution between them: x + T v + T² F/2m, v + T F/m.
fn sampled(ticks: u32) -> [f64; 4] {
    let (mass, period, target) = (2.0, 0.01, 0.2);
    let ([mut x, mut v], mut sum, mut before, mut force) = ([0.05, 0.3], 0.01, 0.05, 0.0);
    for _ in 0..ticks {
        let error = target - x;
        force = 50.0 * error + 20.0 * sum - 15.0 * (x - before) / period;
        (sum, before) = (sum + error * period, x);
        (x, v) = (x + period * v + period * period * force / (2.0 * mass), v + period * force / mass);
    }
    [x, v, force, sum]
}

/// Outputs at the end of a run.
fn after(step: f64, end: f64) -> RememberingOutputs {
    let model = Remembering::default();
    let mut simulation = Simulation::new(&model, model.start()).constant(NO_PULL).step(step);
    simulation.advance_until(end).expect("it moves");
    simulation.sample().outputs
}

#[test]
fn a_sampled_controller_is_its_exact_discretisation() {
    // Steps that are longer than the period, shorter, and such that no tick is at the end of one; the last tick is just before the end.
    for step in [0.01, 0.025, 0.0031, 0.5] {
        let found = after(step, 0.495);
        let [x, v, force, sum] = sampled(49);
        let (x, v) = {
            let next = 50.0 * (0.2 - x) + 20.0 * sum - 15.0 * (x - sampled(48)[0]) / 0.01;
            assert!((found.force - next).abs() < 1e-10, "{step}: {} for {next}, before {force}", found.force);
            (x + 0.005 * v + 0.005 * 0.005 * next / 4.0, v + 0.005 * next / 2.0)
        };
        assert!(
            (found.place - x).abs() < 1e-13 && (found.speed - v).abs() < 1e-12,
            "{step}: {found:?}, {x} {v}"
        );
        assert!((found.summed - sampled(50)[3]).abs() < 1e-14, "{step}: {}", found.summed);
    }
}

#[test]
fn ticks_do_not_drift_and_are_at_ends_of_steps() {
    let model = Remembering::default();
    let mut simulation = Simulation::new(&model, model.start()).constant(NO_PULL).step(0.01);
    let first = simulation.advance().expect("it moves");
    // Those of both ends.
    assert_eq!(first.events, 2);
    for tick in 2..2000_u32 {
        let step = simulation.advance().expect("it moves");
        let others = step.events - 1;
        assert!(step.events >= 1 && others <= 2, "{tick}: {step:?}");
        let next = simulation.state().gates[tick_place(&model)];
        assert_eq!(next, f64::from(tick) + 1.0);
    }
    // Begun later the first tick is the first that is not before.
    for (time, next) in [(0.0, 0.0), (0.01, 1.0), (0.0101, 2.0), (5.0, 500.0)] {
        let simulation = Simulation::new(&model, model.start()).constant(NO_PULL).start_time(time);
        assert_eq!(simulation.state().gates[tick_place(&model)], next, "{time}");
    }
}

/// The place of `tick` in what is held.
fn tick_place(model: &Remembering) -> usize {
    let place = model.gate_names().iter().position(|name| *name == "tick").expect("it is there");
    let index = place - (model.gate_names().len() - model.memory_names().len() - model.triggers().len());
    assert_eq!(model.triggers()[index], Trigger::Every(0.01));
    assert!(model.triggers()[..index].iter().all(|trigger| !trigger.is_periodic()));
    place
}

/// The bolt flies freely to 0.1 m, half a swing on the spring that the latch gives it, and flies back; where it is at a time after that.
fn thrown(time: f64) -> f64 {
    let off = 0.2 + std::f64::consts::PI / 10.0;
    0.1 - 0.5 * (time - off)
}

/// Where the bolt is after 1.2 s, its speed, and that with which it was caught.
macro_rules! caught {
    ($integrator:expr, $formulation:expr, $step:expr) => {{
        let model = Remembering::default();
        let simulation = Simulation::new(&model, model.start()).constant(NO_PULL).formulation($formulation);
        let mut simulation = simulation.integrator($integrator).step($step);
        simulation.advance_until(1.2).expect("it moves");
        let RememberingOutputs { caught, back, impact, .. } = simulation.sample().outputs;
        [(caught - thrown(1.2)).abs(), (back + 0.5).abs(), (impact - 0.5).abs()]
    }};
}

/// The spring that the latch switches on has no force at the latch, but its stiffness jumps there; where it lets go it has none either.
#[test]
fn a_latch_catches_and_lets_go_by_every_method() {
    let of = |name: &str, errors: [f64; 3], bound: f64| {
        println!("{name}: {errors:?}");
        assert!(errors.iter().all(|error| *error <= bound), "{name}: {errors:?} beyond {bound}");
    };
    of("rk4", caught!(Rk4, LagrangeIndex1, 1e-3), 1e-10);
    of("rk4, stabilised", caught!(Rk4, Baumgarte { alpha: 10.0, beta: 10.0 }, 1e-3), 1e-10);
    of("rk4, projected", caught!(Rk4, Projected::after(NullSpace), 1e-3), 1e-10);
    of("dormand-prince", caught!(DormandPrince::tolerance(1e-11), LagrangeIndex1, 0.05), 1e-8);
    of("trapezoidal", caught!(ExplicitTrapezoidal, LagrangeIndex1, 1e-3), 1e-4);
    of("semi-implicit", caught!(SemiImplicitEuler, LagrangeIndex1, 1e-3), 1e-2);
    of("generalised alpha", caught!(GeneralisedAlpha::new(0.9), LagrangeIndex1, 1e-3), 1e-4);
    of("implicit trapezoidal", caught!(ImplicitTrapezoidal::default(), LagrangeIndex1, 1e-3), 1e-4);
    of("ali3p", caught!(Ali3p::new(1e9), LagrangeIndex1, 1e-3), 1e-4);
}

/// A reaction and an input: what is set follows from the accelerations there.
#[test]
fn what_is_set_may_be_of_results_and_inputs() {
    let source = "planar Swinging {
        input pull [N];
        gravity [m/s^2] = (0, -9.81);
        rod pendulum { mass [kg] = 0.5; length [m] = 0.6; }
        joint pivot: revolute(ground(1, 0) [m], pendulum.start);
        memory swings = 0;
        memory load [N] = 0;
        event swing: pivot.angle crosses -90 [deg] { swings = swings + 1; load = pivot.reaction.size; }
        event pushed: time rises 0.6 [s] { load = 2*pull; }
        start { pivot.angle [deg] = -30; pivot.rate [rad/s] = 0; }
        output swings = swings;
        output load [N] = load; }";
    let engine = Engine::read(source).expect("it is well");
    let pull = |_: f64, _: &_| Numbers::of(&[7.0]);
    let mut simulation = Simulation::new(&engine, engine.start()).sampled(pull).step(1e-3);
    simulation.advance_until(0.5).expect("it moves");
    // Through the lowest point with ½ J ω² = m g l/2 (1 − cos 60°), J = m l²/3: ω² = 3 g (1 − cos 60°)/l; the pin then bears m g + m ω² l/2.
    let load = 0.5 * 9.81 * (1.0 + 1.5 * (1.0 - 0.5));
    let outputs = simulation.sample().outputs;
    assert_eq!(outputs.as_slice()[0], 1.0);
    assert!((outputs.as_slice()[1] - load).abs() < 1e-9, "{outputs:?} for {load}");
    simulation.advance_until(0.7).expect("it moves");
    assert_eq!(simulation.sample().outputs.as_slice(), [1.0, 14.0]);
    simulation.advance_until(1.2).expect("it moves");
    let outputs = simulation.sample().outputs;
    assert_eq!(outputs.as_slice()[0], 2.0);
    assert!((outputs.as_slice()[1] - load).abs() < 1e-9, "{outputs:?} for {load}");
}

#[test]
fn the_interpreter_has_the_same_bits() {
    let engine = Engine::read(Remembering::SOURCE).expect("it is well");
    let model = Remembering::default();
    let mut one = Simulation::new(&model, model.start()).constant(RememberingInputs { pull: 0.0 }).step(7e-3);
    let mut other = Simulation::new(&engine, engine.start()).constant(engine.no_inputs()).step(7e-3);
    assert_eq!((model.memory_names(), model.triggers()), (engine.memory_names(), engine.triggers()));
    let mut events = 0;
    for _ in 0..150 {
        let (step, same) = (one.advance().expect("it moves"), other.advance().expect("it moves"));
        assert_eq!((step.events, step.gates_changed), (same.events, same.gates_changed));
        events += step.events;
        let [a, b] = [one.state().gates.as_slice(), other.state().gates.as_slice()];
        assert!(a.iter().zip(b).all(|(a, b)| a.to_bits() == b.to_bits()), "{a:?} {b:?}");
    }
    assert!(events > 105, "{events}");
}

#[test]
fn samples_between_steps_and_events_of_outputs_see_memories() {
    let model = Remembering::default();
    let build = |step| Simulation::new(&model, model.start()).constant(NO_PULL).step(step);
    let (mut plain, mut seen) = (build(0.01).integrator(DormandPrince::tolerance(1e-11)), Vec::new());
    plain.run_every(0.005, 0.1, |sample| seen.push((sample.time, sample.outputs.force))).expect("it moves");
    // At a tick itself a sample is of before or after.
    let between =
        |time: &f64| ((time + 0.005) / 0.01).fract() < 1e-6 || ((time + 0.005) / 0.01).fract() > 1.0 - 1e-6;
    assert!(seen.iter().filter(|(time, _)| between(time)).count() == 10);
    for (time, force) in seen.iter().filter(|(time, _)| between(time)) {
        let ticks = (time / 0.01 + 1.000_001).floor() as u32;
        assert!((force - sampled(ticks)[2]).abs() < 1e-10, "{time}: {force}");
    }
    // An output that jumps passes a level at its event.
    let mut simulation = build(0.01);
    let found = simulation
        .run_until_event(2.0, &[Event::of("impact").level(0.3).rising()], |_| ())
        .expect("it moves");
    let time = found.expect("it is caught").time;
    assert!((time - 0.2).abs() < 2e-9, "{time}");
}

#[test]
fn events_without_end_are_an_error() {
    let source = "planar Restless {
        body slider { mass [kg] = 1; inertia [kg*m^2] = 0.01; }
        joint rail: prismatic(ground(0, 0) [m], slider.origin, axis = (1, 0));
        memory way = 1;
        event there: way falls 0.5 { way = 1; }
        event back: way rises 0.5 { way = 0; }
        event begin: rail.travel rises 0.1 [m] { way = 0; }
        start { rail.travel [m] = 0; rail.speed [m/s] = 1; }
        output way = way; }";
    let engine = Engine::read(source).expect("it is well");
    let mut simulation = Simulation::new(&engine, engine.start()).constant(engine.no_inputs()).step(0.03);
    let error = simulation.advance_until(1.0).expect_err("it never ends");
    let SimulationError::EventWithoutEnd { event, time, most: 32 } = error else { panic!("{error}") };
    assert!(["there", "back"].contains(&event) && (time - 0.1).abs() < 1e-9, "{error}");
    assert_eq!(error.joint(), Some(event));
    assert!(error.to_string().contains("occurs without end at t = 0.1"), "{error}");
    // It stands at the step before.
    assert!(
        (simulation.time() - 0.09).abs() < 1e-12 && simulation.state().gates.as_slice().last() == Some(&1.0)
    );
}

#[test]
fn what_takes_whole_steps_refuses() {
    let model = Remembering::default();
    let mut stepper = Stepper::new(model, model.start(), Rk4);
    assert_eq!(stepper.step(&NO_PULL, 1e-3).expect_err("it takes whole steps"), StepError::HeldGates);
    assert!(StepError::HeldGates.to_string().contains("memories"), "{}", StepError::HeldGates);
}

#[test]
fn what_is_not_finite_is_named() {
    let source = "planar Broken {
        body slider { mass [kg] = 1; inertia [kg*m^2] = 0.01; }
        joint rail: prismatic(ground(0, 0) [m], slider.origin, axis = (1, 0));
        memory ratio = 1;
        event begin: rail.travel rises 0.1 [m] { ratio = 1/(ratio - 1); }
        start { rail.travel [m] = 0; rail.speed [m/s] = 1; }
        output ratio = ratio; }";
    let engine = Engine::read(source).expect("it is well");
    let mut simulation = Simulation::new(&engine, engine.start()).constant(engine.no_inputs()).step(0.03);
    let error = simulation.advance_until(1.0).expect_err("it is infinite");
    assert!(matches!(error, SimulationError::NonFinite { what: "ratio", .. }), "{error}");
}
