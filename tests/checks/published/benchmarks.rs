//! Published runs: Andrews' squeezer and the car axis of the IVP test set, Andrews' squeezer of IFToMM, Project
//! Chrono's double pendulum.

use super::{Table, Worst, baumgarte, run};
use linkwright::{DormandPrince, Mechanism, Simulation};
use linkwright_models::andrews::{Andrews, AndrewsIftomm};
use linkwright_models::car_axis::CarAxis;
use linkwright_models::double_pendulum::DoublePendulum;
use linkwright_models::light_cart_pole::LightCartPole;

/// IVP test set, reference solution at 0.03 s; good to 1e-9 in positions and 5e-8 relative in rates.
#[test]
fn andrews_of_the_ivp_test_set() {
    let model = Andrews::<f64>::default();
    let mut simulation = Simulation::new(&model, Andrews::START).formulation(baumgarte(100.0)).step(1e-6);
    let mut last = simulation.sample().outputs;
    simulation.run_until(0.03, |sample| last = sample.outputs).expect("the squeezer runs");
    let mut angles = Worst::default();
    for (found, expected) in [
        (last.beta, 15.81077119629904),
        (last.theta, -15.75637105984298),
        (last.gamma, 0.04082224013073101),
        (last.phi, -0.5347301163226948),
        (last.delta, 0.5244099658805304),
        (last.omega, 0.5347301163226948),
        (last.epsilon, 1.048080741042263),
    ] {
        angles.see(found, expected);
    }
    let mut rate = Worst::default();
    let (state, acceleration) = (*simulation.state(), simulation.acceleration().expect("it is regular"));
    let crank = model.motions(0.03, &state.q, &state.v, &acceleration)[0];
    rate.see(crank.rate / 1139.920302151208, 1.0);
    angles.below(1e-8, "Andrews (IVP), angles");
    rate.below(5e-8, "Andrews (IVP), rate of the crank, relative");
}

/// T + V − τ (β − β₀) stays what it was over the library's 0.05 s.
#[test]
fn andrews_of_iftomm_keeps_its_energy() {
    let model = AndrewsIftomm::<f64>::default();
    let mut simulation =
        Simulation::new(&model, AndrewsIftomm::START).formulation(baumgarte(100.0)).step(2e-6);
    let (energy, beta) = (simulation.energy(), simulation.sample().outputs.beta);
    assert!((beta + 0.0620).abs() < 1e-15);
    let mut worst = Worst::default();
    simulation
        .run_until(0.05, |sample| worst.see(sample.energy() - 0.033 * (sample.outputs.beta - beta), energy))
        .expect("the squeezer runs");
    worst.below(1e-9, "Andrews (IFToMM), T + V - tau (beta - beta0)");
}

/// The reference in quadruple precision at 3 s.
#[test]
fn car_axis() {
    let reference: Vec<(String, f64)> = include_str!("../../data/ivp_caraxis.csv")
        .lines()
        .skip(2)
        .map(|line| {
            let fields: Vec<&str> = line.split(',').collect();
            (fields[0].to_string(), fields[3].parse().expect("a number"))
        })
        .collect();
    let expected = |name: &str| reference.iter().find(|(known, _)| known == name).expect("a name").1;

    let model = CarAxis::<f64>::default();
    let mut simulation = Simulation::new(&model, CarAxis::START).formulation(baumgarte(100.0)).step(1e-4);
    simulation.advance_until(3.0).expect("the car runs");
    let state = *simulation.state();
    let bodies = model.motions(3.0, &state.q, &state.v, &simulation.acceleration().expect("it is regular"));
    let (mut position, mut velocity) = (Worst::default(), Worst::default());
    for (body, [x, y]) in bodies.iter().zip([["xl", "yl"], ["xr", "yr"]]) {
        for (axis, name) in [x, y].into_iter().enumerate() {
            position.see(body.position[axis], expected(name));
            velocity.see(body.velocity[axis], expected(&format!("{name}_dot")));
        }
    }
    position.below(1e-9, "car axis, position");
    velocity.below(1e-8, "car axis, velocity");

    // f + Dᵀ λ there, with the length constraint not halved.
    let lambda = simulation.multipliers().expect("it is regular");
    let row = |of: &str| {
        <CarAxis>::default().rows().iter().position(|row| row.of == of).expect("a row of that name")
    };
    let mut multipliers = Worst::default();
    multipliers.see(-lambda[row("upright")], expected("lambda1"));
    multipliers.see(-lambda[row("axle")] / 2.0, expected("lambda2"));
    multipliers.below(1e-9, "car axis, multipliers");
}

#[test]
fn double_pendulum_of_chrono() {
    let reference = Table::new(include_str!("../../data/double_pendulum_chrono_computed.csv"));
    let model = DoublePendulum::<f64>::default();
    let (mut at_one, mut along) = (Worst::default(), Worst::default());
    let mut rows = 0;
    let end = reference.get(reference.rows.len() - 1, "t");
    run(&model, DoublePendulum::START, (0.0, 5e-4), end, 200, |row, sample| {
        let time = reference.get(row, "t");
        assert!((sample.time - time).abs() < 1e-12);
        let outputs = sample.outputs;
        let worst = if time <= 1.0 { &mut at_one } else { &mut along };
        worst.see(outputs.first, reference.get(row, "phi1"));
        worst.see(outputs.second, reference.get(row, "phi2"));
        worst.see(outputs.first_rate, reference.get(row, "phi1d"));
        worst.see(outputs.second_rate, reference.get(row, "phi2d"));
        worst.see(outputs.x, reference.get(row, "x2"));
        worst.see(outputs.y, reference.get(row, "y2"));
        rows += 1;
    })
    .expect("it swings");
    assert_eq!(rows, reference.rows.len());
    at_one.below(1e-10, "double pendulum to 1 s");
    along.below(1e-8, "double pendulum to the end");
}

/// The quadrature of the energy in 30 digits, by θ̇² = 2 (g/l) cos θ / (sin²θ + ε cos²θ), at 10 s: eleven half swings with a
/// reversal of 10⁻⁶ of their duration in each. The benchmark asks for 10⁻⁶.
#[test]
fn light_cart_pole() {
    let model = LightCartPole::<f64>::default();
    let mut simulation =
        Simulation::new(&model, LightCartPole::START).integrator(DormandPrince::tolerance(1e-13)).step(1e-2);
    let energy = simulation.energy();
    simulation.advance_until(10.0).expect("it swings");
    let (state, outputs) = (*simulation.state(), simulation.sample().outputs);
    let mut worst = Worst::default();
    for (found, expected) in [
        (outputs.cart_x, 1.9997632824687277),
        (outputs.x, 0.9999980002367175),
        (outputs.y, -0.02166518967258637),
        (outputs.angle, -1.5491294418948283),
    ] {
        worst.see(found, expected);
    }
    worst.below(1e-6, "light cart-pole, position at 10 s");
    let mut kept = Worst::default();
    kept.see(model.kinetic_energy(10.0, &state.q, &state.v) + model.potential_energy(10.0, &state), energy);
    kept.below(1e-6, "light cart-pole, energy");
}
