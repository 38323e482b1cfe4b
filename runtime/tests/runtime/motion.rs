//! Simulations: orders of convergence, energy, uniform rotation, inputs, samples, typed errors.

use crate::double_pendulum::{DoublePendulum, Torque};
use crate::four_bar::FourBar;
use crate::support::Support;
use core::f64::consts::TAU;
use linkwright_runtime::layout::{Layout, MultiTurn, retract};
use linkwright_runtime::{
    AssembleExt, Baumgarte, Held, InputSource, Integrator, LagrangeIndex1, MechanismDynamics, Real, Rk4,
    SemiImplicitEuler, Simulation, SimulationError, State,
};

type Pendulum = State<[f64; 8], [f64; 2]>;

fn pendulum_start(upper: f64, lower: f64, v: [f64; 2]) -> Pendulum {
    State::new([upper.cos(), upper.sin(), lower.cos(), lower.sin(), 0.0, upper, 0.0, lower - upper], v)
}

fn sine_of_triple(time: f64) -> f64 {
    (3.0 * time).sin()
}

/// A shoulder torque sin 3t.
struct Shaking;

impl InputSource<f64, DoublePendulum> for Shaking {
    const HELD: bool = false;

    fn sample(&mut self, time: f64, _state: &Pendulum) -> Torque {
        Torque { shoulder: sine_of_triple(time) }
    }
}

type Shaken<'m> = MechanismDynamics<'m, DoublePendulum, f64, LagrangeIndex1, Shaking>;

fn swing<I: for<'m> Integrator<f64, Shaken<'m>>>(integrator: I, h: f64) -> Pendulum {
    let model = DoublePendulum::new();
    let start = pendulum_start(-1.0, -0.4, [1.0, -2.0]);
    Simulation::new(&model, start)
        .input_source(Shaking)
        .integrator(integrator)
        .step(h)
        .advance_until(0.4)
        .unwrap()
}

fn distance(a: &Pendulum, b: &Pendulum) -> f64 {
    let squares = a.q.iter().chain(&a.v).zip(b.q.iter().chain(&b.v)).map(|(a, b)| (a - b) * (a - b));
    squares.sum::<f64>().sqrt()
}

#[test]
fn orders_of_convergence() {
    let exact = swing(Rk4, 1.25e-4);
    let order = |coarse: f64, fine: f64| (coarse / fine).log2();
    let rk4 = order(distance(&swing(Rk4, 4e-3), &exact), distance(&swing(Rk4, 2e-3), &exact));
    assert!((3.9..4.2).contains(&rk4), "{rk4}");
    let euler = |h| distance(&swing(SemiImplicitEuler, h), &exact);
    let euler = order(euler(4e-4), euler(2e-4));
    assert!((0.9..1.1).contains(&euler), "{euler}");
}

#[test]
fn a_uniform_rotation_is_exact() {
    let model = DoublePendulum::balanced();
    let start = pendulum_start(0.0, 0.0, [314.0, -100.0]);
    let end = Simulation::new(&model, start)
        .inputs(Held(|_, _| Torque { shoulder: 0.0 }))
        .step(1e-3)
        .advance_until(10.0)
        .unwrap();
    let error = |i: usize, angle: f64| {
        (end.q[i + 1] * angle.cos() - end.q[i] * angle.sin())
            .atan2(end.q[i] * angle.cos() + end.q[i + 1] * angle.sin())
    };
    assert!(error(0, 3140.0).abs() < 1e-9 && error(2, -1000.0).abs() < 1e-9, "{end:?}");
    assert!((TAU * end.q[4] + end.q[5] - 3140.0).abs() < 1e-9);
    assert!((TAU * end.q[6] + end.q[7] + 4140.0).abs() < 1e-9);
}

#[test]
fn turns_and_pair_agree_after_a_million_steps() {
    static ANGLES: [MultiTurn; 1] = [MultiTurn { rate: &[(0, 1.0)] }];
    let layout = Layout { linear: 0, rotations: 1, quaternions: 0, angles: &ANGLES };
    let mut q = [1.0, 0.0, 0.0, 0.0];
    for step in 0..1_000_000 {
        let delta = 0.05 + 0.04 * f64::from(step % 101) / 101.0;
        let from = q;
        retract(&layout, &from, &[delta], &mut q);
    }
    let apart = (q[1] * q[3].cos() - q[0] * q[3].sin()).abs();
    assert!(apart < 1e-9, "{apart}");
    assert!((q[0] * q[0] + q[1] * q[1] - 1.0).abs() < 1e-15);
    assert!(q[2] > 1e4);
}

#[test]
fn energy_is_kept() {
    let model = DoublePendulum::new();
    let mut simulation = Simulation::new(&model, pendulum_start(0.5, 1.0, [0.0, 0.0]))
        .inputs(Held(|_time, _state| Torque { shoulder: 0.0 }))
        .step(5e-4);
    let before = simulation.energy();
    simulation.advance_until(2.0).unwrap();
    assert!((simulation.energy() - before).abs() < 1e-8, "{}", simulation.energy() - before);
}

#[test]
fn the_four_bar_keeps_energy_and_constraints() {
    let model = FourBar::new();
    let start = model.assemble(&model.rough_start()).unwrap();
    let mut free = Simulation::new(&model, start).step(5e-4);
    let before = free.energy();
    let mut last = -1.0;
    let end = free
        .run_until(0.5, |sample| {
            assert!(sample.time > last && (sample.energy() - before).abs() < 1e-5);
            last = sample.time;
        })
        .unwrap();
    assert_eq!(last, 0.5);
    assert!(free.constraint_residual().position < 1e-6 && free.reciprocal_condition() > 1e-4);
    assert!(
        (free.sample().outputs.crank - (TAU * end.q[12] + end.q[13])).abs() < 1e-9,
        "unwrapped as the turns count"
    );

    let a = free.acceleration().expect("it is regular");
    let lambda = free.multipliers().expect("it is regular");
    // The crank's own equation along y: m ÿ = −m g + λ(crank pin) − λ(coupler pin).
    let balance = model.masses[0] * a[1] + model.masses[0] * 9.81 - lambda[1] + lambda[3];
    assert!(balance.abs() < 1e-9, "{balance}");
}

#[test]
fn baumgarte_brings_an_error_back_critically_damped() {
    let model = FourBar::new();
    let mut start = model.assemble(&model.rough_start()).unwrap();
    start.q[0] += 1e-6;
    let before = Simulation::new(&model, start).constraint_residual().position;
    let refused = Simulation::new(&model, start).step(5e-4).advance();
    assert!(matches!(refused, Err(SimulationError::Inconsistent { .. })), "{refused:?}");
    let mut simulation = Simulation::new(&model, start)
        .formulation(Baumgarte::time_constant(0.01))
        .step(5e-4)
        .accept_inconsistent_start();
    simulation.advance_until(0.05).unwrap();
    // Φ(t) = Φ₀ (1 + t/T) e^(−t/T) from Φ̇₀ = 0, five time constants later.
    let expected = before * 6.0 * (-5.0_f64).exp();
    let found = simulation.constraint_residual().position;
    assert!((found - expected).abs() < 0.02 * expected, "{found} {expected}");
    let mut free = Simulation::new(&model, start).step(5e-4).accept_inconsistent_start();
    free.advance_until(0.05).unwrap();
    assert!(free.constraint_residual().position > 0.9 * before);
}

#[test]
fn inputs_are_asked_once_a_step_or_at_each_stage() {
    let model = DoublePendulum::new();
    let start = pendulum_start(0.0, 0.0, [0.0, 0.0]);
    let (mut held, mut sampled) = (0, 0);
    Simulation::new(&model, start)
        .inputs(Held(|_time, _state| {
            held += 1;
            Torque { shoulder: 0.1 }
        }))
        .step(0.01)
        .run_until(0.1, |sample| assert_eq!(sample.outputs.torque, 0.1))
        .unwrap();
    Simulation::new(&model, start)
        .sampled(|time, state| {
            sampled += 1;
            // Both arguments must be known here.
            Torque { shoulder: time.sin() + state.v[0].abs() }
        })
        .step(0.01)
        .run_until(0.1, |_| {})
        .unwrap();
    assert_eq!((held, sampled), (11, 41));
}

#[test]
fn the_clock_lands_on_the_end() {
    let model = DoublePendulum::balanced();
    let mut simulation = Simulation::new(&model, pendulum_start(0.0, 0.0, [1.0, 1.0]))
        .inputs(Held(|_, _| Torque { shoulder: 0.0 }))
        .step(0.3)
        .start_time(2.0);
    let times: Vec<f64> = simulation.samples(3.0).map(|sample| sample.unwrap().time).collect();
    assert_eq!(times, [2.0, 2.3, 2.6, 2.0 + 3.0 * 0.3, 3.0]);
    assert_eq!(simulation.samples(3.0).count(), 1);
    let angle = simulation.state().q[5];
    assert!((angle - 1.0).abs() < 1e-15, "{angle}");
    let mut many = Simulation::new(&model, pendulum_start(0.0, 0.0, [1.0, 1.0]))
        .inputs(Held(|_, _| Torque { shoulder: 0.0 }))
        .step(1e-3);
    assert_eq!(many.samples(1.0).count(), 1001);
}

#[test]
fn single_precision_runs() {
    let model = DoublePendulum::<f32>::new();
    let start = model.assemble(&State::new([1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0], [0.0; 2])).unwrap();
    assert!((start.q[1] - Real::sin(0.3_f32)).abs() < 1e-6);
    let mut simulation =
        Simulation::new(&model, start).inputs(Held(|_, _| Torque { shoulder: 0.0_f32 })).step(1e-3);
    let before = simulation.energy();
    simulation.advance_until(1.0).unwrap();
    assert!((simulation.energy() - before).abs() < 1e-3);
}

#[test]
fn step_and_settings_are_checked() {
    let model = FourBar::new();
    let start = model.assemble(&model.rough_start()).unwrap();
    assert_eq!(Simulation::new(&model, start).advance().unwrap_err(), SimulationError::StepMissing);
    for step in [0.0, -1e-3, f64::NAN, f64::INFINITY] {
        let error = Simulation::new(&model, start).step(step).advance().unwrap_err();
        assert!(matches!(error, SimulationError::Step { .. }), "{error:?}");
    }
    for end in [-1.0, f64::NAN, f64::INFINITY] {
        let error = Simulation::new(&model, start).step(1e-3).run_until(end, |_| ()).unwrap_err();
        assert!(matches!(error, SimulationError::End { .. }), "{error:?}");
    }
    let negative = Baumgarte { alpha: 1.0, beta: -1.0 };
    let mut simulation = Simulation::new(&model, start).formulation(negative).step(1e-3);
    let error = simulation.advance().unwrap_err();
    assert!(error.to_string().contains("beta is -1; it must be zero or positive"), "{error}");
    assert!(std::error::Error::source(&error).is_some());
    assert_eq!((simulation.time(), simulation.state()), (0.0, &start));
}

#[test]
fn a_breakdown_names_the_joint_and_keeps_the_state() {
    let model = FourBar { lengths: [0.2, 0.4, 0.2], ground: 0.4, ..FourBar::new() };
    let start = State::new(model.rough([0.0; 3]), [0.0; 9]);
    let mut simulation = Simulation::new(&model, start).step(1e-3);
    let error = simulation.run_until(1.0, |_| ()).unwrap_err();
    assert!(
        matches!(error, SimulationError::Breakdown { time: 0.0, pivot, .. } if pivot < 1e-14),
        "{error:?}"
    );
    let joint = error.joint().unwrap();
    assert!(error.to_string().contains(joint) && (joint.ends_with("_pin") || joint == "bearing"), "{error}");
    assert_eq!(
        (simulation.time(), simulation.state(), simulation.reciprocal_condition()),
        (0.0, &start, 1.0)
    );
}

#[test]
fn what_has_no_mass_is_named() {
    let model = DoublePendulum { lower_inertia: 0.0, lower_center: 0.0, ..DoublePendulum::new() };
    let error = Simulation::new(&model, pendulum_start(0.0, 0.0, [0.0; 2]))
        .inputs(Held(|_, _| Torque { shoulder: 0.0 }))
        .step(1e-3)
        .advance()
        .unwrap_err();
    assert!(
        matches!(
            error,
            SimulationError::SingularMass { velocity: "lower.rate", .. } | SimulationError::NonFinite { .. }
        ),
        "{error:?}"
    );
}

#[test]
fn what_is_not_finite_is_named() {
    let model = DoublePendulum::new();
    let mut simulation = Simulation::new(&model, pendulum_start(0.0, 0.0, [0.0; 2]))
        .inputs(Held(|time, _| Torque { shoulder: if time > 0.05 { f64::NAN } else { 0.0 } }))
        .formulation(LagrangeIndex1)
        .step(0.01);
    let samples = simulation.samples(1.0);
    let error = samples.filter_map(Result::err).next().unwrap();
    assert!(matches!(error, SimulationError::NonFinite { what: "upper.cos", .. }), "{error:?}");
    assert!(simulation.state().q.iter().all(|entry| entry.is_finite()) && simulation.time() < 0.07);
}

#[test]
fn constraints_that_depend_on_time_are_followed() {
    let model = Support { mass: 2.0, angle: 0.4 };
    let start = model.project(1.0, &State::new([0.1, 0.0, 1.0, 0.0], [0.0; 3]));
    // Massless in rotation: eliminated before its row, so the plain factorisation must report it.
    let error = Simulation::new(&model, start.unwrap()).step(0.01).start_time(1.0).advance().unwrap_err();
    assert!(matches!(error, SimulationError::SingularMass { velocity: "body.rate", .. }), "{error:?}");
}
