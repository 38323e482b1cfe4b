//! The planetary gear train: ratio, balance of powers, reflected inertia.

use super::Worst;
use linkwright::{Mechanism, Simulation};
use linkwright_models::planetary_gear_train::{PlanetaryGearTrain, PlanetaryGearTrainInputs};
use linkwright_models::toothed_gears::{
    BevelPair, BevelPairInputs, ClutchedDifferential, ClutchedDifferentialInputs, CompoundTrain,
    CompoundTrainInputs, RackAndPinion, RackAndPinionInputs, ToothedPlanetarySet, ToothedPlanetarySetInputs,
    WormDrive, WormDriveInputs,
};
use linkwright_models::yaw_drive::{YawDrive, YawDriveInputs};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

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

/// A turn of the pinion is 40 π mm of its rack, bevel gears turn as 2 to 1, the worm's wheel by a fortieth.
#[test]
fn ratios_of_racks_cones_and_worms() {
    let mut ratio = Worst::default();
    let model = RackAndPinion::<f64>::default();
    let start = RackAndPinion::START;
    let still = RackAndPinionInputs { torque: 0.0, load: 0.0 };
    let mut simulation =
        Simulation::new(&model, start).formulation(super::baumgarte(10.0)).constant(still).step(1e-3);
    simulation.run_until(PI, |_| {}).expect("a pinion turns");
    let travelled =
        model.outputs(PI, simulation.state(), &still).travel - model.outputs(0.0, &start, &still).travel;
    // At 2 rad/s a turn takes π seconds; below the axle the rack goes the way that the pinion turns.
    ratio.see(travelled / (0.04 * PI), 1.0);
    let model = BevelPair::<f64>::default();
    let still = BevelPairInputs { torque: 0.0, load: 0.0 };
    ratio.see(model.outputs(0.0, &BevelPair::START, &still).out_rate / 20.0, -0.5);
    let model = WormDrive::<f64>::default();
    let still = WormDriveInputs { torque: 0.0, load: 0.0 };
    ratio.see(model.outputs(0.0, &WormDrive::START, &still).out_rate / 100.0, -0.025);
    ratio.below(1e-12, "ratios");
}

/// Along the way that both surfaces go where they touch, a tooth of the one stands half a pitch from one of the other. Ways from the places of
/// teeth on the pitch surfaces, mm.
#[test]
fn teeth_face_spaces_of_racks_cones_and_worms() {
    let mut worst = Worst::default();
    let mut half_a_pitch = |one: f64, other: f64, what: &str| {
        let pitches = (one - other) / TAU;
        let off = pitches - 0.5 - (pitches - 0.5).round();
        println!("{what}: {off:.1e}");
        worst.see(off, 0.0);
    };
    // Modules are 2 mm, so that a pitch is 2π mm.
    let at = |angle: f64, teeth: f64, facing: f64| {
        let pitch = TAU / teeth;
        let off = angle - facing;
        off - pitch * (off / pitch).round()
    };
    let model = RackAndPinion::<f64>::default();
    let start = RackAndPinion::START;
    let motions = model.motions(0.0, &start.q, &start.v, &start.v);
    let [cosine, sine] = motions[0].orientation;
    // Below its axle the pinion's teeth go along x as its angle grows; the rack's first tooth stands 95 mm left of its centre.
    let pinion = 20.0 * at(sine.atan2(cosine), 20.0, -FRAC_PI_2);
    half_a_pitch(pinion, 1e3 * motions[1].position[0] - 95.0, "rack");
    // The angles of joints are those from y about x, and from x about z.
    let angle = |column: [f64; 3], x: usize, y: usize| column[y].atan2(column[x]);
    let model = BevelPair::<f64>::default();
    let start = BevelPair::START;
    let motions = model.motions(0.0, &start.q, &start.v, &start.v);
    let y_of_first = motions[0].orientation.map(|row| row[1]);
    let x_of_second = motions[1].orientation.map(|row| row[0]);
    // They touch at (40, 0, 20): on the first, where it goes along −y, in the direction z from its axis; on the second along y, in the direction x.
    let first = -20.0 * at(angle(y_of_first, 1, 2), 20.0, FRAC_PI_2);
    let second = 40.0 * at(angle(x_of_second, 0, 1), 40.0, 0.0);
    half_a_pitch(first, second, "cones");
    let model = WormDrive::<f64>::default();
    let start = WormDrive::START;
    let motions = model.motions(0.0, &start.q, &start.v, &start.v);
    let y_of_first = motions[0].orientation.map(|row| row[1]);
    let x_of_second = motions[1].orientation.map(|row| row[0]);
    // The crest of a right-hand thread at the angle φ of the body stands at x = p φ/2π; towards the wheel, along y, φ is the angle turned back.
    let thread = -angle(y_of_first, 1, 2);
    let wheel = 40.0 * at(angle(x_of_second, 0, 1), 40.0, -FRAC_PI_2);
    half_a_pitch(thread, wheel, "worm");
    worst.below(1e-12, "pitches by which teeth are off");
}

/// With d the rate of the left shaft against the case, (J_c + 2 J + …) ω̇ = T + L + R and (2 J + 1.6² J_s) ḋ = L − R − C(d).
#[test]
fn torques_of_a_differential() {
    let model = ClutchedDifferential::<f64>::default();
    let start = ClutchedDifferential::START;
    let inputs = ClutchedDifferentialInputs { torque: 90.0, left_load: -20.0, right_load: -65.0 };
    let outputs = model.outputs(0.0, &start, &inputs);
    let mut worst = Worst::default();
    worst.see(outputs.left_rate + outputs.right_rate, 60.0);
    let (mut a, mut lambda) = (start.v, Default::default());
    model.acceleration(0.0, &start, &inputs, &mut a, &mut lambda);
    let motions = model.motions(0.0, &start.q, &start.v, &a);
    let of_case = 0.02 + 2.0 * 0.01 + 0.6 * 0.036 * 0.036 + 4e-4;
    let between = 2.0 * 0.01 + 6e-4 * 1.6 * 1.6;
    let clutch = 20.0 / (1.0_f64 + 0.01).sqrt();
    let case = (90.0 - 20.0 - 65.0) / of_case;
    let slip = (-20.0 + 65.0 - clutch) / between;
    worst.see(motions[0].angular_acceleration[0] / case, 1.0);
    worst.see(motions[1].angular_acceleration[0] / (case + slip), 1.0);
    worst.see(motions[2].angular_acceleration[0] / (case - slip), 1.0);
    worst.below(1e-10, "rates and accelerations of a differential");
}

/// Load follows the torques: 1 % more on one motor is 1.01/1.0025 of the mean on its pinion, 1/1.0025 on the others.
#[test]
fn shares_of_a_yaw_drive() {
    let model = YawDrive::<f64>::default();
    let inputs =
        YawDriveInputs { torque_0: 12_120.0, torque_1: 12_000.0, torque_2: 12_000.0, torque_3: 12_000.0 };
    let mut simulation = Simulation::new(&model, YawDrive::START)
        .formulation(super::baumgarte(10.0))
        .constant(inputs)
        .step(1e-4);
    simulation.run_until(4.0, |_| {}).expect("pinions turn");
    let outputs = model.outputs(4.0, simulation.state(), &inputs);
    let force = [outputs.force_0, outputs.force_1, outputs.force_2, outputs.force_3];
    let mean = force.iter().sum::<f64>() / 4.0;
    println!("{force:?}");
    let mut share = Worst::default();
    share.see(force[0] / mean, 1.01 / 1.0025);
    force[1..].iter().for_each(|force| share.see(force / mean, 1.0 / 1.0025));
    share.below(1e-5, "shares of the load");
    let mut size = Worst::default();
    size.see(mean / 1.0025, 130_307.482_344);
    size.below(30.0, "force in a mesh, N");
}
