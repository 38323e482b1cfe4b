//! Joints that yield: a chain beside the same with constraints, what its forces keep, and the step limit of the explicit trapezoidal rule.

use crate::registry::compiled;
use linkwright::{AssembleExt, ExplicitTrapezoidal, Rk4, Simulation};
use linkwright_compiler::model::Coordinates;
use linkwright_engine::Engine;
use linkwright_models::penalty_chain::{PenaltyChain, PenaltyChainParameters};

/// x and y of the tip of five rods on pins after 1 s, m: (M_ij) = Σ_b m a_bi a_bj cos(θ_i − θ_j) + δ_ij m l²/12, a_bi being l above the rod b and l/2 on
/// it, integrated with Runge and Kutta's rule of order 4 at 1e-4 and 5e-5 s, which agree to 2e-14.
const TIP: [f64; 2] = [-0.443778566403415, -0.894729739722492];

linkwright::mechanism! {
    /// The chain of `PenaltyChain` with constraints.
    planar PinnedChain {
        gravity [m/s^2] = (0, -9.81);
        repeat i in 0..5 {
            rod link[i] { mass [kg] = 0.1; length [m] = 0.2; }
        }
        joint pin[0]: revolute(ground(0, 0) [m], link[0].start);
        repeat i in 1..5 {
            joint pin[i]: revolute(link[i - 1].end, link[i].start);
        }
        repeat i in 0..5 {
            start { link[i].angle [deg] = -60; link[i].rate [rad/s] = 0; }
        }
        expect { degrees_of_freedom = 5; }
        output tip_x [m] = link[4].end.x;
        output tip_y [m] = link[4].end.y;
    }
}

/// How far from `TIP` a chain ends.
macro_rules! missed {
    ($model:expr, $integrator:expr, $h:expr) => {{
        let model = &$model;
        let mut simulation = Simulation::new(model, model.start()).integrator($integrator).step($h);
        simulation.advance_until(1.0).expect("it moves");
        let outputs = simulation.sample().outputs;
        f64::hypot(outputs.tip_x - TIP[0], outputs.tip_y - TIP[1])
    }};
}

fn chain(stiffness: f64, damping: f64) -> PenaltyChain {
    PenaltyChain::prepare(PenaltyChainParameters { stiffness, damping, smallest: 1e-8 })
        .expect("values within their bounds")
}

/// The constrained chain ends where the separate integration does.
#[test]
fn the_constrained_chain_is_that_of_a_separate_integration() {
    let missed = missed!(PinnedChain::<f64>::default(), Rk4, 1e-3);
    assert!(missed < 1e-9, "{missed:.1e}");
}

/// The stiffer the pins, the nearer the chain is to the constrained one: a hundred times stiffer a hundred times nearer.
#[test]
fn stiff_pins_hold_the_chain_together() {
    let soft = missed!(chain(1e4, 10.0), ExplicitTrapezoidal, 5e-5);
    let stiff = missed!(chain(1e6, 100.0), ExplicitTrapezoidal, 1e-5);
    println!("missed by {soft:.3e} m at 1e4 N/m and {stiff:.3e} m at 1e6 N/m");
    assert!(soft < 5e-3 && stiff < 5e-5, "{soft:.1e}, {stiff:.1e}");
    assert!((50.0..200.0).contains(&(soft / stiff)), "{soft:.1e}, {stiff:.1e}");
}

/// Nothing but the dampers takes energy, and of the explicit trapezoidal rule, whose amplitudes shrink by (ω h)⁴/16 a step, little at small steps.
#[test]
fn springs_give_back_what_they_take() {
    let model = chain(1e5, 0.0);
    let mut simulation = Simulation::new(&model, model.start()).integrator(Rk4).step(2e-5);
    let before = simulation.sample().outputs.energy;
    simulation.advance_until(0.5).expect("it moves");
    let after = simulation.sample().outputs.energy;
    assert!((after - before).abs() < 1e-7, "{:.1e} J", after - before);
}

/// A mass on a joint that yields falls by one step at a time; the steps that the compiler names divide those that settle from those that
/// grow, for all dampings.
#[test]
fn the_step_limit_divides_what_settles_from_what_grows() {
    for damping in [0.0, 0.05, 0.3, 1.0, 2.5] {
        // ζ = c/(2 √(k m)), k = 800 N/m and m = 2 kg.
        let source = format!(
            "planar Bead {{ gravity [m/s^2] = (0, -10); particle bead {{ mass [kg] = 2; }}
             joint top: revolute(ground(0, 0) [m], bead.center) = penalty(stiffness [N/m] = 800, damping [N*s/m] = {});
             output y [m] = bead.center.y; }}",
            80.0 * damping
        );
        let compiled = linkwright_compiler::compile(source.parse().expect("tokens"), Some(Coordinates::Tree));
        let compiled = compiled.expect("it compiles");
        let limit = compiled.vibration.expect("it yields").longest_step();
        let engine: Engine = Engine::of(&compiled).expect("it fits");
        let largest = |h: f64| {
            let mut simulation = Simulation::new(&engine, engine.start())
                .constant(engine.no_inputs())
                .integrator(ExplicitTrapezoidal)
                .step(h);
            let mut largest = 0.0_f64;
            for _ in 0..3000 {
                let Ok(step) = simulation.advance() else { return f64::INFINITY };
                let _ = step;
                let y = simulation.sample().outputs.as_slice()[0];
                if !y.is_finite() {
                    return f64::INFINITY;
                }
                largest = largest.max(y.abs());
            }
            largest
        };
        // It sags by m g/k = 25 mm, and swings at most as far again.
        let (below, above) = (largest(0.995 * limit), largest(1.005 * limit));
        println!("damping {damping}: limit {limit:.4e} s, {below:.3e} m below and {above:.3e} m above");
        assert!(below < 0.2, "damping {damping}: {below} m");
        assert!(above > 10.0, "damping {damping}: {above} m");
    }
}

/// Two bodies in free fall keep their momentum and angular momentum, whatever the joint between them exerts.
#[test]
fn momentum_is_kept() {
    linkwright::mechanism! {
        planar Pair {
            body a { mass [kg] = 1.2; inertia [kg*m^2] = 0.02; point p [m] = (0.3, 0.1); }
            body b { mass [kg] = 0.8; inertia [kg*m^2] = 0.015; point p [m] = (-0.1, 0.05); }
            joint pin: revolute(a.p, b.p) = penalty(stiffness [N/m] = 200, damping [N*s/m] = 3);
            start { pin.rate [rad/s] = 5; a.rate [rad/s] = -2; a.angle [rad] = 0; b.angle [rad] = 1; }
            output moment [N*m*s] = 0.02 [kg*m^2]*a.rate + 0.015 [kg*m^2]*b.rate
                + 1.2 [kg]*(a.center.x*a.center.velocity.y - a.center.y*a.center.velocity.x)
                + 0.8 [kg]*(b.center.x*b.center.velocity.y - b.center.y*b.center.velocity.x);
            output drift [N*s] = 1.2 [kg]*a.center.velocity.x + 0.8 [kg]*b.center.velocity.x;
            output apart [m] = distance(a.p, b.p);
        }
    }
    let model = Pair::<f64>::default();
    let mut simulation = Simulation::new(&model, model.start()).integrator(Rk4).step(1e-3);
    let before = simulation.sample().outputs;
    simulation.advance_until(1.0).expect("it moves");
    let after = simulation.sample().outputs;
    assert!(after.apart > 1e-4, "the joint gives way: {} m", after.apart);
    assert!((after.moment - before.moment).abs() < 1e-9, "{:.1e}", after.moment - before.moment);
    assert!((after.drift - before.drift).abs() < 1e-12, "{:.1e}", after.drift - before.drift);
}

/// In both sets of coordinates the bodies of the chain are free: the functions are the same.
#[test]
fn a_chain_that_yields_has_no_tree() {
    let sets = [Coordinates::Tree, Coordinates::Absolute].map(|set| compiled::<PenaltyChain>(Some(set)));
    for compiled in &sets {
        assert_eq!(compiled.complete.equations.symbols.v.len(), 15);
        assert!(compiled.complete.equations.rows.is_empty());
    }
}

linkwright::mechanism! {
    spatial Hinged {
        gravity [m/s^2] = (0.002, 0.003, -0.01);
        body arm { mass [kg] = 2; inertia [kg*m^2] = (0.02, 0.03, 0.04); center [m] = (0.3, 0, 0); point pin [m] = (0, 0, 0); }
        joint hinge: revolute(ground(0, 0, 0) [m], arm.pin, axis = (0, 0, 1))
            = penalty(stiffness [N/m] = 2000, damping [N*s/m] = 10, torsional_stiffness [N*m/rad] = 20, torsional_damping [N*m*s/rad] = 0.1);
        start { arm.orientation = (1, 0, 0, 0); }
        output x [m] = arm.center.x;
        output y [m] = arm.center.y;
        output z [m] = arm.center.z;
    }
}

linkwright::mechanism! {
    spatial OnTwoBalls {
        gravity [m/s^2] = (0.002, 0.003, -0.01);
        body arm { mass [kg] = 2; inertia [kg*m^2] = (0.02, 0.03, 0.04); center [m] = (0.3, 0, 0); point up [m] = (0, 0, 0.1); point down [m] = (0, 0, -0.1); }
        joint top: spherical(ground(0, 0, 0.1) [m], arm.up) = penalty(stiffness [N/m] = 1000, damping [N*s/m] = 5);
        joint low: spherical(ground(0, 0, -0.1) [m], arm.down) = penalty(stiffness [N/m] = 1000, damping [N*s/m] = 5);
        start { arm.orientation = (1, 0, 0, 0); }
        output x [m] = arm.center.x;
        output y [m] = arm.center.y;
        output z [m] = arm.center.z;
    }
}

/// The paper makes a revolute joint of two spherical ones on a line: of length L and with k, c each they are one with 2 k and 2 c, about axes across it k L²/2
/// and c L²/2, as long as the turns are small.
#[test]
fn a_revolute_joint_is_two_spherical_ones_on_a_line() {
    macro_rules! end {
        ($model:ty) => {{
            let model = <$model>::default();
            let mut simulation = Simulation::new(&model, model.start()).integrator(Rk4).step(1e-3);
            simulation.advance_until(0.3).expect("it moves");
            let outputs = simulation.sample().outputs;
            [outputs.x, outputs.y, outputs.z]
        }};
    }
    let (hinged, on_balls) = (end!(Hinged<f64>), end!(OnTwoBalls<f64>));
    assert!(hinged[2] < -1e-4, "it gives way: {hinged:?}");
    for (one, other) in hinged.iter().zip(on_balls) {
        assert!((one - other).abs() < 1e-10, "{hinged:?} and {on_balls:?}");
    }
}
