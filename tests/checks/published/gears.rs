//! The planetary gear train: ratio, balance of powers, reflected inertia.

use super::Worst;
use linkwright::{Mechanism, Simulation};
use linkwright_models::planetary_gear_train::{PlanetaryGearTrain, PlanetaryGearTrainInputs};
use linkwright_models::toothed_gears::{
    CompoundTrain, CompoundTrainInputs, ToothedPlanetarySet, ToothedPlanetarySetInputs,
};
use std::f64::consts::{PI, TAU};

/// ω_sun = 3 ω_arm, and T_in ω_in = T_out ω_out at constant speed.
#[test]
fn ratio_and_torques() {
    let model = PlanetaryGearTrain::<f64>::default();
    let balanced = PlanetaryGearTrainInputs { arm_torque: 0.3, sun_torque: -0.1 };
    let mut simulation = Simulation::new(&model, PlanetaryGearTrain::START)
        .formulation(super::baumgarte(10.0))
        .held(|_, _| balanced)
        .step(1e-3);
    let (mut ratio, mut speed) = (Worst::default(), Worst::default());
    simulation
        .run_until(5.0, |sample| {
            ratio.see(sample.outputs.sun_rate / sample.outputs.arm_rate, 3.0);
            ratio.see(sample.outputs.planet_rate / sample.outputs.arm_rate, -3.0);
            speed.see(sample.outputs.arm_rate, 10.0);
        })
        .expect("gears turn");
    ratio.below(1e-12, "gear ratio");
    speed.below(1e-11, "speed under balanced torques");
    let state = simulation.state();
    let powers = model.powers(5.0, state, &balanced);
    assert_eq!(PlanetaryGearTrain::LOADS, ["input", "output"]);
    let mut balance = Worst::default();
    balance.see(powers[0], 3.0);
    balance.see(powers[1], -3.0);
    balance.below(1e-11, "powers of input and output");
}

/// T_arm + 3 T_sun = J ω̇ with J = J_arm + m_arm (a/2)² + m_p a² + 9 J_p + 9 J_s.
#[test]
fn reflected_inertia() {
    let axes: f64 = 0.06;
    let disk = |mass: f64, radius: f64| mass * radius * radius / 2.0;
    let inertia =
        4e-4 + 0.6 * (axes / 2.0).powi(2) + 0.3 * axes * axes + 9.0 * disk(0.3, 0.02) + 9.0 * disk(1.0, 0.04);
    let model = PlanetaryGearTrain::<f64>::default();
    let inputs = PlanetaryGearTrainInputs { arm_torque: 0.7, sun_torque: 0.02 };
    let start = PlanetaryGearTrain::START;
    let (mut a, mut lambda) = (start.v, Default::default());
    model.acceleration(0.0, &start, &inputs, &mut a, &mut lambda);
    let arm = model.motions(0.0, &start.q, &start.v, &a)[0];
    let mut worst = Worst::default();
    worst.see(arm.angular_acceleration, (0.7 + 3.0 * 0.02) / inertia);
    worst.below(1e-10, "acceleration of the arm");
}

/// By numbers of teeth: ω_sun = 3 ω_arm, ω_planet = −3 ω_arm, and all planets alike.
#[test]
fn ratios_of_teeth() {
    let model = ToothedPlanetarySet::<f64>::default();
    let mut simulation = Simulation::new(&model, ToothedPlanetarySet::START)
        .formulation(super::baumgarte(10.0))
        .constant(ToothedPlanetarySetInputs { arm_torque: 0.0, sun_torque: 0.0 })
        .step(1e-3);
    let mut ratio = Worst::default();
    simulation
        .run_until(1.0, |sample| {
            ratio.see(sample.outputs.sun_rate / 10.0, 3.0);
            ratio.see(sample.outputs.planet_rate / 10.0, -3.0);
        })
        .expect("gears turn");
    ratio.below(1e-12, "rates of sun and planet");

    let model = CompoundTrain::<f64>::default();
    let outputs = model.outputs(0.0, &CompoundTrain::START, &CompoundTrainInputs { torque: 0.0 });
    let mut ratio = Worst::default();
    ratio.see(50.0 / outputs.out_rate, 10.0);
    ratio.below(1e-13, "ratio of the train");
}

/// A tooth of the sun faces a space of each planet, and each planet's a space of the ring: z₁(θ₁ − ψ) + z₂(θ₂ − ψ − π) = π + 2πk, and in
/// the ring z₁(θ₁ − ψ) − z₂(θ₂ − ψ) = π + 2πk.
#[test]
fn teeth_face_spaces() {
    let model = ToothedPlanetarySet::<f64>::default();
    let start = ToothedPlanetarySet::START;
    let mut a = start.v;
    a.iter_mut().for_each(|rate| *rate = 0.0);
    let motions = model.motions(0.0, &start.q, &start.v, &a);
    let angle = |body: usize| {
        let [cosine, sine] = motions[body].orientation;
        sine.atan2(cosine)
    };
    // In the order of the definition: arm, sun, ring, planets.
    let mut worst = Worst::default();
    for planet in 0..3 {
        let psi = angle(0) + f64::from(planet) * TAU / 3.0;
        let own = angle(3 + planet as usize);
        let sun = 40.0 * (angle(1) - psi) + 20.0 * (own - psi - PI) - PI;
        let ring = 20.0 * (own - psi) - 80.0 * (angle(2) - psi) - PI;
        for sum in [sun, ring] {
            worst.see((sum / TAU - (sum / TAU).round()).abs(), 0.0);
        }
    }
    worst.below(1e-12, "pitches by which teeth are off");
}
