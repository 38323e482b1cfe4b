//! Gates of contacts that are held within a step: against closed forms, against the same contacts with live gates, by every method.

use linkwright::Vector;
use linkwright::{
    Ali3p, Assemble, AssembleExt, AugmentedLagrangian, Baumgarte, DormandPrince, ExplicitTrapezoidal,
    Formulation, GeneralisedAlpha, ImplicitTrapezoidal, Integrator, LagrangeIndex1, Mechanism,
    MechanismDynamics, NoInputs, NullSpace, Partitioned, Penalty, Projected, Rk4, SemiImplicitEuler,
    Simulation, SimulationError, State, StateOf, StepError,
};
use linkwright_engine::Engine;
use linkwright_models::bouncing_ball::{BouncingBall, BouncingBallOfHuntAndCrossley};

linkwright::mechanism! {
    /// Two balls over a floor, the second on its way to it a little later than the first.
    planar Falling {
        param later [m] = 0.504;
        gravity [m/s^2] = (0, -9.81);
        particle ball { mass [kg] = 1; }
        particle other { mass [kg] = 1; }
        surface below: point(ball.center);
        surface beneath: point(other.center);
        surface floor: half_plane(line(ground(0, 0) [m], ground(1, 0) [m]));
        contact touch: between(below, floor) = kelvin_voigt(stiffness [N/m] = 1e4, damping [N*s/m] = 20);
        contact tap: between(beneath, floor) = kelvin_voigt(stiffness [N/m] = 1e4, damping [N*s/m] = 20);
        start { ball.center.x [m] = 0; ball.center.y [m] = 0.5; other.center.x [m] = 1; other.center.y = later; }
        options { contact = held; emit = (tangent); }
        output height [m] = ball.center.y;
        output second [m] = other.center.y;
        output force [N] = touch.force;
    }
}

linkwright::mechanism! {
    planar FallingAfterHuntAndCrossley {
        gravity [m/s^2] = (0, -9.81);
        particle ball { mass [kg] = 1; }
        surface below: point(ball.center);
        surface floor: half_plane(line(ground(0, 0) [m], ground(1, 0) [m]));
        contact touch: between(below, floor) = hunt_crossley(force [N] = 1000, depth [mm] = 10, dissipation [s/m] = 0.2);
        start { ball.center.x [m] = 0; ball.center.y [m] = 0.5; }
        options { contact = held; }
    }
}

linkwright::mechanism! {
    /// What pushes with the same force however deep it is, and more on the way in.
    planar Balanced {
        param push [N] = 20;
        gravity [m/s^2] = (0, -9.81);
        particle ball { mass [kg] = 1; }
        surface below: point(ball.center);
        surface floor: half_plane(line(ground(0, 0) [m], ground(1, 0) [m]));
        #[allow(penetration)]
        contact cushion: between(below, floor) = push*(1 + 0.5 [s/m]*cushion.closing);
        start { ball.center.x [m] = 0; ball.center.y [m] = -0.01; }
        options { contact = held; }
        output force [N] = cushion.force;
    }
}

#[track_caller]
fn close(found: f64, expected: f64, within: f64, what: &str) {
    println!("{what}: {found:.15}, {:.1e} off (bound {within:.0e})", (found - expected).abs());
    assert!((found - expected).abs() <= within, "{what}: {found} in place of {expected}");
}

const G: f64 = 9.81;
const STIFFNESS: f64 = 1e4;
const DAMPING: f64 = 20.0;

/// Height of a ball of 1 kg after `end` seconds from rest at `height`, by the closed forms of flight and contact: y + c ẏ + k y = −g from
/// y = 0 until c ẏ + k y = 0, which a bisection finds, then flight again.
fn closed_form(height: f64, end: f64) -> f64 {
    let (decay, omega) = (0.5 * DAMPING, (STIFFNESS - 0.25 * DAMPING * DAMPING).sqrt());
    let (mut time, mut y, mut v) = (0.0, height, 0.0_f64);
    loop {
        // Flight until y = 0 from above; what was let go below passes it upwards first.
        let touch = (v + (v * v + 2.0 * G * y).sqrt()) / G;
        if time + touch >= end {
            let t = end - time;
            return y + v * t - 0.5 * G * t * t;
        }
        (time, v) = (time + touch, v - G * touch);
        let rest = -G / STIFFNESS;
        let at = |t: f64| {
            let (a, b) = (-rest, (v - decay * rest) / omega);
            let (cos, sin) = ((omega * t).cos(), (omega * t).sin());
            let e = (-decay * t).exp();
            let y = rest + e * (a * cos + b * sin);
            let rate = e * ((omega * b - decay * a) * cos - (omega * a + decay * b) * sin);
            (y, rate)
        };
        let force = |t: f64| {
            let (y, rate) = at(t);
            -STIFFNESS * y - DAMPING * rate
        };
        let (mut low, mut high) = (1e-4, 1e-4);
        while force(high) > 0.0 {
            if time + high > end {
                return at(end - time).0;
            }
            (low, high) = (high, high + 1e-4);
        }
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if force(middle) > 0.0 { low = middle } else { high = middle }
        }
        if time + high >= end {
            return at(end - time).0;
        }
        let (at_release, rate) = at(high);
        (time, y, v) = (time + high, at_release, rate);
    }
}

fn errors(step: f64) -> [f64; 2] {
    let model = Falling::default();
    let mut simulation = Simulation::new(&model, Falling::START).integrator(Rk4).step(step);
    simulation.advance_until(1.0).expect("it moves");
    let outputs = simulation.sample().outputs;
    [outputs.height - closed_form(0.5, 1.0), outputs.second - closed_form(0.504, 1.0)].map(f64::abs)
}

/// Errors of fourth order, where plain steps are stuck at the first.
#[test]
fn a_jump_of_the_force_costs_no_order() {
    close(closed_form(0.5, 1.0), 0.140_026_352_533_671_8, 1e-14, "the closed form");
    let mut plain = Vec::new();
    let mut held = Vec::new();
    for step in [1e-3, 2e-4, 5e-5] {
        let model = BouncingBall::default();
        let mut simulation = Simulation::new(&model, BouncingBall::START).integrator(Rk4).step(step);
        simulation.advance_until(1.0).expect("it moves");
        plain.push((simulation.sample().outputs.height - closed_form(0.5, 1.0)).abs());
        held.push(errors(step));
    }
    println!("plain {plain:?}, held {held:?}");
    for (held, bound) in held.iter().zip([6e-7, 1.2e-9, 1e-11]) {
        assert!(held.iter().all(|error| *error <= bound), "{held:?} beyond {bound}");
    }
    assert!(plain.iter().all(|error| *error > 1e-5), "{plain:?}");
}

/// A force that begins with zero has nothing to gain.
#[test]
fn a_power_of_the_depth_gains_nothing() {
    // The height after 1 s is that of the reference in `published/contacts.rs`.
    let error = |model: &dyn Fn(f64) -> f64, step: f64| (model(step) - 0.131_956_747_826_441_5).abs();
    let live = |step: f64| {
        let model = BouncingBallOfHuntAndCrossley::default();
        let start = BouncingBallOfHuntAndCrossley::START;
        let mut simulation = Simulation::new(&model, start).integrator(Rk4).step(step);
        simulation.advance_until(1.0).expect("it moves").q[1]
    };
    let held = |step: f64| {
        let model = FallingAfterHuntAndCrossley::default();
        let start = FallingAfterHuntAndCrossley::START;
        let mut simulation = Simulation::new(&model, start).integrator(Rk4).step(step);
        simulation.advance_until(1.0).expect("it moves").q[1]
    };
    for step in [2e-4, 5e-5] {
        println!("step {step}: live {:.1e}, held {:.1e}", error(&live, step), error(&held, step));
    }
    assert!((5e-9..2e-7).contains(&error(&held, 5e-5)));
}

/// A rod that falls against a stop and comes back, in coordinates with constraints; the same with live gates; and with a pad on the rod that
/// rubs.
macro_rules! stopped {
    ($name:ident, $gates:ident) => {
        linkwright::mechanism! {
            planar $name {
                gravity [m/s^2] = (0, -9.81);
                rod arm { mass [kg] = 2; length [m] = 0.6; }
                particle bob { mass [kg] = 1; }
                joint hinge: revolute(ground(0, 0) [m], arm.start);
                joint end: distance(arm.end, bob.center, length [m] = 0.4);
                surface tip: circle(bob.center, radius [m] = 0.05);
                surface wall: half_plane(line(ground(0.15, -3) [m], ground(0.15, 3) [m]));
                limit stop: hinge.angle [deg] in -200..-100 = kelvin_voigt(stiffness [N*m] = 2000, damping [N*m*s] = 3);
                contact strike: between(tip, wall) = kelvin_voigt(stiffness [N/m] = 8000, damping [N*s/m] = 12);
                friction grip: on(strike) = coulomb(coefficient = 0.3, speed [m/s] = 0.5);
                start { hinge.angle [deg] = -150; bob.center.x [m] = -0.6; bob.center.y [m] ~ -0.65; }
                options { coordinates = absolute; contact = $gates; emit = (tangent, penalty, projection, null_space); }
                output angle [rad] = hinge.angle;
                output stopped [N*m] = stop.force;
                output pressed [N] = strike.force;
                output lost [W] = -power(grip);
            }
        }
    };
}
stopped!(Stopped, held);
stopped!(StoppedLive, live);

/// The angle of the rod in the end, and in how many steps gates changed.
fn angle_after<M, F, I>(model: &M, start: StateOf<M>, formulation: F, integrator: I, step: f64) -> (f64, u32)
where
    M: Assemble<f64, Inputs = ()>,
    F: Formulation<f64, M>,
    I: for<'m> Integrator<f64, MechanismDynamics<'m, M, f64, F, NoInputs>>,
    M::Outputs: linkwright::Fields<f64>,
{
    let mut simulation =
        Simulation::new(model, start).formulation(formulation).integrator(integrator).step(step);
    let (mut changed, mut gates) = (0, simulation.state().gates.clone());
    simulation
        .run_until(END, |sample| {
            changed += u32::from(sample.state.gates != gates);
            gates = sample.state.gates.clone();
        })
        .expect("it moves");
    let outputs = linkwright::Fields::to_array(&simulation.sample().outputs);
    (outputs.as_slice()[0], changed)
}

const END: f64 = 0.8;

/// At one state with live gates all is what it is where gates are live.
#[test]
fn held_is_live_at_one_state() {
    let (held, live) = (Stopped::default(), StoppedLive::default());
    let mut simulation = Simulation::new(&live, StoppedLive::START).integrator(Rk4).step(1e-3);
    let (mut closed, mut compared) = ([0; 2], 0);
    simulation
        .run_until(1.2, |sample| {
            let StateOf::<StoppedLive> { q, v, .. } = sample.state;
            let mut state = State { q, v, z: (), gates: [0.5; 2] };
            state.gates = held.live_gates(sample.time, &state);
            let (outputs, expected) = (held.outputs(0.0, &state, &()), sample.outputs.into_held());
            assert!(
                (outputs.stopped - expected.stopped).abs() <= 1e-12 * expected.stopped.abs(),
                "{outputs:?}, {expected:?}"
            );
            assert!(
                (outputs.pressed - expected.pressed).abs() <= 1e-12 * expected.pressed.abs(),
                "{outputs:?}, {expected:?}"
            );
            assert!(
                (outputs.lost - expected.lost).abs() <= 1e-9 * expected.lost.abs() + 1e-15,
                "{outputs:?}, {expected:?}"
            );
            let of = |model: &dyn Fn(&mut [f64; 5], &mut [f64; 3]) -> f64| {
                let (mut a, mut lambda) = ([0.0; 5], [0.0; 3]);
                model(&mut a, &mut lambda);
                a
            };
            let with_held = of(&|a, lambda| held.acceleration(0.0, &state, &(), a, lambda));
            let with_live = of(&|a, lambda| live.acceleration(0.0, &sample.state, &(), a, lambda));
            let size = with_live.iter().fold(1.0_f64, |size, a| size.max(a.abs()));
            assert!(with_held.iter().zip(with_live).all(|(a, b)| (a - b).abs() <= 1e-11 * size));
            closed[0] += usize::from(state.gates[0] > 0.5);
            closed[1] += usize::from(state.gates[1] > 0.5);
            compared += 1;
        })
        .expect("it moves");
    println!("{compared} states, of which closed: {closed:?}");
    assert!(closed.iter().all(|count| *count > 5), "{closed:?}");
}

impl StoppedLiveOutputs {
    fn into_held(self) -> StoppedOutputs {
        let StoppedLiveOutputs { angle, stopped, pressed, lost } = self;
        StoppedOutputs { angle, stopped, pressed, lost }
    }
}

/// Where it is by a method that finds the jumps of live gates by its error.
fn reference() -> f64 {
    let live = StoppedLive::default();
    let projected = Projected::after(NullSpace);
    angle_after(&live, StoppedLive::START, projected, DormandPrince::tolerance(1e-13), 1e-3).0
}

macro_rules! by_each {
    ($reference:expr; $($name:literal: $formulation:expr, $integrator:expr, $order:literal, $bound:literal;)*) => {$({
        let model = Stopped::default();
        let error = |step: f64| {
            let (angle, changed) = angle_after(&model, Stopped::START, $formulation(step), $integrator, step);
            assert!(changed >= 4, "{}: gates changed in {changed} steps", $name);
            (angle - $reference).abs()
        };
        let [coarse, fine] = [error(1e-3), error(2.5e-4)];
        let order = (coarse / fine).log2() / 2.0;
        let live = StoppedLive::default();
        let (plain, _) = angle_after(&live, StoppedLive::START, $formulation(2.5e-4), $integrator, 2.5e-4);
        let plain = (plain - $reference).abs();
        println!("{}: {coarse:.1e}, {fine:.1e}, order {order:.2}; live {plain:.1e}", $name);
        assert!(fine <= $bound && fine < 1.2 * plain, "{}: {fine:e}", $name);
        assert!(order >= $order, "{}: order {order}", $name);
    })*};
}

#[test]
fn every_method_keeps_its_order() {
    let reference = reference();
    let model = Stopped::default();
    let penalty = Penalty::for_model(&model, 0.0, &Stopped::START.q, 1e-3);
    by_each! { reference;
        "index 1, RK4": |_| LagrangeIndex1, Rk4, 3.5, 1e-8;
        "null space, RK4": |_| NullSpace, Rk4, 3.5, 1e-8;
        "projected, RK4": |_| Projected::after(NullSpace), Rk4, 3.5, 1e-8;
        "partitioned, RK4": |_| Partitioned::default(), Rk4, 3.0, 1e-4;
        "Baumgarte, RK4": |_| Baumgarte { alpha: 10.0, beta: 10.0 }, Rk4, 3.5, 1e-8;
        "augmented Lagrangian, RK4": |_| AugmentedLagrangian::new(penalty), Rk4, 3.5, 1e-8;
        "index 1, explicit trapezoidal": |_| LagrangeIndex1, ExplicitTrapezoidal, 1.8, 1e-3;
        "index 1, semi-implicit Euler": |_| LagrangeIndex1, SemiImplicitEuler, 0.5, 1e-2;
        "index 1, Dormand and Prince": |_| LagrangeIndex1, DormandPrince::tolerance(1e-11), 0.0, 1e-8;
        "implicit trapezoidal": |_| LagrangeIndex1, ImplicitTrapezoidal::<f64>::default(), 1.8, 1e-3;
        "generalised-alpha": |_| LagrangeIndex1, GeneralisedAlpha::new(0.8), 1.8, 1e-3;
        "ALI3-P": |_| LagrangeIndex1, Ali3p::new(1e9), 1.5, 1e-3;
    }
}

/// The second ball comes to the floor in the step in which the first does.
#[test]
fn what_closes_in_one_step_keeps_its_order() {
    let model = Falling::default();
    let mut simulation = Simulation::new(&model, Falling::START).integrator(Rk4).step(3e-3);
    let touches = [0.5_f64, 0.504].map(|height| (2.0 * height / G).sqrt());
    let mut both = 0;
    while simulation.time() < 0.33 {
        let step = simulation.advance().expect("it moves");
        let begin = step.time - step.size;
        let within = touches.iter().filter(|touch| begin < **touch && **touch <= step.time).count();
        assert_eq!(step.gates_changed as usize, within, "to {} s", step.time);
        both += usize::from(within == 2);
        for (gate, touch) in simulation.state().gates.iter().zip(touches) {
            assert_eq!(*gate > 0.5, step.time > touch, "at {} s", step.time);
        }
    }
    assert_eq!(both, 1, "both come down in one step");
    for (height, found) in [(0.5, simulation.state().q[1]), (0.504, simulation.state().q[3])] {
        close(found, closed_form(height, simulation.time()), 1e-5, "height");
    }
}

/// A weight on a force that is larger wherever it is: it goes in and out in no time.
#[test]
fn chatter_is_named() {
    let model = Balanced::default();
    let mut simulation = Simulation::new(&model, Balanced::START).integrator(Rk4).step(1e-3);
    let error = simulation.advance_until(30.0).expect_err("it chatters");
    let SimulationError::Chatter { contact: "cushion", time, most: 32 } = error else { panic!("{error}") };
    assert!(time >= simulation.time() && time <= simulation.time() + 1e-3, "{error}");
    assert!(error.to_string().contains("`cushion` opens and closes without end"), "{error}");
    assert_eq!(error.joint(), Some("cushion"));
}

/// Whatever a start says of its gates, they are those of its state; what a stepper cannot do it refuses.
#[test]
fn a_start_in_the_floor_is_closed() {
    assert_eq!(Balanced::START.gates, [1.0]);
    let model = Balanced::default();
    assert_eq!(model.start().gates, [1.0]);
    assert_eq!(model.gate_names(), ["cushion"]);
    let open = State { gates: [0.0], ..Balanced::START };
    let mut simulation = Simulation::new(&model, open).step(1e-3);
    assert_eq!(simulation.sample().outputs.force, 20.0);
    let raised = State { q: [0.0, 0.3], ..Balanced::START };
    assert_eq!(model.live_gates(0.0, &raised), [0.0]);
    assert_eq!(model.project(0.0, &raised).expect("nothing binds it").gates, [0.0]);
    let mut stepper = model.stepper(Balanced::START, Rk4);
    assert_eq!(stepper.step(&(), 1e-3).expect_err("it finds no touch"), StepError::HeldGates);
    assert_eq!(StepError::HeldGates.code(), 8);
}

/// Samples at even times are of the motion before a touch where they are before it.
#[test]
fn dense_output_ends_where_a_gate_changes() {
    let model = Falling::default();
    let mut simulation =
        Simulation::new(&model, Falling::START).integrator(DormandPrince::tolerance(1e-11)).step(0.1);
    let mut worst = 0.0_f64;
    simulation
        .run_every(0.003, 1.0, |sample| {
            worst = worst.max((sample.outputs.height - closed_form(0.5, sample.time)).abs())
        })
        .expect("it moves");
    println!("worst sample {worst:.1e}");
    assert!(worst < 1e-8, "{worst:e}");
}

/// Read while the program runs, a mechanism moves by the same bits, gates and all.
#[test]
fn the_engine_has_the_same_bits() {
    let engine = Engine::read(Stopped::SOURCE).expect("it is well");
    let model = Stopped::default();
    let mut one = Simulation::new(&model, model.start()).step(1e-3);
    let mut other = Simulation::new(&engine, engine.start()).constant(engine.no_inputs()).step(1e-3);
    let mut changed = 0;
    for _ in 0..800 {
        let (step, same) = (one.advance().expect("it moves"), other.advance().expect("it moves"));
        assert_eq!(step, same);
        assert_eq!(one.state().q, other.state().q.as_slice());
        assert_eq!(one.state().v, other.state().v.as_slice());
        assert_eq!(one.state().gates, other.state().gates.as_slice());
        changed += step.gates_changed;
    }
    assert!(changed >= 4, "{changed}");
    assert_eq!(engine.gate_names(), model.gate_names());
}
