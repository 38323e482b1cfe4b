//! Vehicles against separate computations.

use super::{Worst, baumgarte};
use linkwright::{
    AssembleExt, DormandPrince, Linearisation, Mechanism, Motion, Simulation, State, StateOf, equilibrium,
};
use linkwright_models::rear_wheel::{RearWheel, RearWheelParameters};
use linkwright_models::tracked_vehicle::{TrackedVehicle, TrackedVehicleOutputs, TrackedVehicleParameters};
use linkwright_models::vehicle_on_pans::{VehicleOnPans, VehicleOnPansOutputs, VehicleOnPansParameters};

fn shaken(shake: f64, pitch: f64, frequency: f64) -> TrackedVehicle {
    let parameters = TrackedVehicleParameters { shake, pitch, frequency, ..Default::default() };
    TrackedVehicle::prepare(parameters).expect("within its bounds")
}

fn angles(found: &TrackedVehicleOutputs<f64>) -> [f64; 6] {
    let TrackedVehicleOutputs {
        station_0_angle,
        station_1_angle,
        station_2_angle,
        station_3_angle,
        station_4_angle,
        station_5_angle,
        ..
    } = *found;
    [station_0_angle, station_1_angle, station_2_angle, station_3_angle, station_4_angle, station_5_angle]
}

fn loads(found: &TrackedVehicleOutputs<f64>) -> [f64; 6] {
    let TrackedVehicleOutputs {
        station_0_load,
        station_1_load,
        station_2_load,
        station_3_load,
        station_4_load,
        station_5_load,
        ..
    } = *found;
    [station_0_load, station_1_load, station_2_load, station_3_load, station_4_load, station_5_load]
}

/// Where it stands on posts at rest.
fn standing(model: &TrackedVehicle) -> StateOf<TrackedVehicle> {
    let start = TrackedVehicle::START;
    let found = equilibrium(model, 0.0, &start.q, &()).expect("its bars bear it");
    State { q: found.q, v: model.zero_v(), ..start }
}

#[test]
fn a_tracked_vehicle_stands_on_its_bars() {
    let model = shaken(0.0, 0.0, 1.0);
    let state = standing(&model);
    let found = model.outputs(0.0, &state, &());
    let mut worst = Worst::default();
    worst.see(found.heave, 0.983_695_351_1);
    worst.see(found.pitch, 8.249_875_64e-4);
    let expected = [0.56850155, 0.56654380, 0.56458849, 0.56263560, 0.56068512, 0.55873703];
    for (found, expected) in angles(&found).into_iter().zip(expected) {
        worst.see(found, expected);
    }
    // Half of the last digit that is given.
    worst.below(5e-9, "tracked vehicle, equilibrium");
    let mut worst = Worst::default();
    let expected = [19149.0349, 18055.2130, 18100.4079, 17564.3509, 17609.0152, 19393.9782];
    for (found, expected) in loads(&found).into_iter().zip(expected) {
        worst.see(found, expected);
    }
    worst.below(5.1e-5, "tracked vehicle, loads of wheels in N");
}

/// M and K of the whole vehicle, which is two halves, in (heave, pitch), and its undamped modes.
#[test]
fn modes_of_a_tracked_vehicle() {
    let model = shaken(0.0, 0.0, 1.0);
    let state = standing(&model);
    let linear = Linearisation::at(&model, 0.0, &state, &()).expect("regular");
    let a = linear.state_space().expect("two coordinates").a;
    // Twice the kinetic energy of both halves at rates of one.
    let energy = |heave: f64, pitch: f64| {
        let stand = model.outputs(0.0, &state, &());
        let motion = [(stand.heave, heave), (stand.pitch, pitch)].map(|(position, rate)| Motion {
            position,
            rate,
            acceleration: 0.0,
        });
        let moving = model.kinematics(0.0, &state.q, &motion).expect("regular");
        4.0 * model.kinetic_energy(0.0, &moving.q, &moving.v)
    };
    let (heave, pitch) = (energy(1.0, 0.0), energy(0.0, 1.0));
    let mixed = (energy(1.0, 1.0) - heave - pitch) / 2.0;
    let mut worst = Worst::default();
    for (found, expected) in [(heave, 21001.8326), (mixed, 955.1167), (pitch, 47897.6797)] {
        worst.see(found, expected);
    }
    worst.below(5.1e-5, "tracked vehicle, masses");
    // K = −M A₂₁: a row of A holds positions before rates.
    let by = |row: usize, column: usize| -a[4 * (2 + row) + column];
    let mut worst = Worst::default();
    for (found, expected) in [
        (heave * by(0, 0) + mixed * by(1, 0), 841_548.177),
        (heave * by(0, 1) + mixed * by(1, 1), -120_450.854),
        (mixed * by(0, 0) + pitch * by(1, 0), -120_450.854),
        (mixed * by(0, 1) + pitch * by(1, 1), 1_490_236.637),
    ] {
        worst.see(found / expected, 1.0);
    }
    worst.below(1e-8, "tracked vehicle, stiffnesses");
    let (half, product) = ((by(0, 0) + by(1, 1)) / 2.0, by(0, 0) * by(1, 1) - by(0, 1) * by(1, 0));
    let root = (half * half - product).sqrt();
    let mut worst = Worst::default();
    for (squared, expected, shape) in
        [(half - root, 0.858_814_168, 1.5514), (half + root, 1.035_839_790, f64::NAN)]
    {
        worst.see(squared.sqrt() / core::f64::consts::TAU, expected);
        let found = (squared - by(0, 0)) / by(0, 1);
        println!("pitch to heave {found}");
        assert!(shape.is_nan() || (found - shape).abs() < 1e-4, "{found}");
    }
    worst.below(1e-9, "tracked vehicle, modes in Hz");
}

/// After a run, the state at its end and half of the way from peak to peak in the last period: of the arms, heave and pitch.
fn shake(model: &TrackedVehicle, frequency: f64, end: f64) -> ([f64; 4], [f64; 8]) {
    let mut simulation = Simulation::new(model, TrackedVehicle::START)
        .formulation(baumgarte(20.0))
        .integrator(DormandPrince::tolerance(1e-11))
        .step(1.0 / 256.0);
    // The wave has a kink of its curvature there.
    simulation.run_until(1.0, |_| ()).expect("it moves");
    simulation.run_until(end - 1.0 / frequency, |_| ()).expect("it moves");
    let (mut least, mut most) = ([f64::INFINITY; 8], [f64::NEG_INFINITY; 8]);
    simulation
        .run_every(1.0 / (2000.0 * frequency), end, |sample| {
            let [a, b, c, d, e, f] = angles(&sample.outputs);
            let found = [a, b, c, d, e, f, sample.outputs.heave, sample.outputs.pitch];
            for ((least, most), found) in least.iter_mut().zip(&mut most).zip(found) {
                (*least, *most) = (least.min(found), most.max(found));
            }
        })
        .expect("it moves");
    let rates = TrackedVehicle::velocities(&simulation.state().v);
    let found = simulation.sample().outputs;
    let half = core::array::from_fn(|k| (most[k] - least[k]) / 2.0);
    ([found.heave, found.pitch, rates.mast_speed, rates.hull_rate], half)
}

/// Against separate integrations of the two equations in (heave, pitch), by Dormand and Prince of order 8 to 1e-11, sampled as often: the
/// last digits that are given.
#[test]
fn a_tracked_vehicle_is_shaken() {
    let mut worst = Worst::default();
    let mut peaks = Worst::default();
    for (run, frequency, end, state, half) in [
        (
            (0.04, 0.0),
            0.6,
            14.0 + 1.0 / 3.0,
            [9.644_696_47e-1, 1.228_945_21e-3, -1.469_864_36e-1, 5.148_347_77e-4],
            [0.02458029, 0.02417293, 0.02379967, 0.02346193, 0.02316118, 0.0228988, 0.0437002, 0.00042187],
        ),
        (
            (0.04, 0.0),
            1.0,
            9.0,
            [0.960_703_365_6, 0.001_332_258_9, 0.256_504_018_8, -0.008_042_347_3],
            [0.06543521, 0.06628454, 0.06726775, 0.06838751, 0.06964667, 0.07104692, 0.04618215, 0.00145664],
        ),
        (
            (0.0, 0.05),
            0.8,
            8.75,
            [9.793_566_20e-1, -1.395_598_38e-2, -8.410_372_15e-4, 1.357_021_57e-1],
            [0.09837355, 0.06339992, 0.02873854, 0.00679899, 0.04045716, 0.0748806, 0.00391724, 0.03030213],
        ),
    ] {
        let model = shaken(run.0, run.1, frequency);
        let (found_state, found_half) = shake(&model, frequency, end);
        println!("{run:?} {frequency} Hz: {found_state:?}, {found_half:?}");
        for (found, expected) in found_state.into_iter().zip(state) {
            worst.see(found, expected);
        }
        for (found, expected) in found_half.into_iter().zip(half) {
            peaks.see(found, expected);
        }
    }
    worst.below(1e-8, "tracked vehicle, states after shaking");
    peaks.below(1e-7, "tracked vehicle, half of the way from peak to peak");
}

/// What wheels press on their pans.
fn pressed(found: &VehicleOnPansOutputs<f64>) -> [f64; 6] {
    let VehicleOnPansOutputs {
        station_0_load,
        station_1_load,
        station_2_load,
        station_3_load,
        station_4_load,
        station_5_load,
        ..
    } = *found;
    [station_0_load, station_1_load, station_2_load, station_3_load, station_4_load, station_5_load]
}

/// Posts at rest bear the weight, none of it by their stops, as those of the vehicle that is tied to them do.
#[test]
fn a_vehicle_stands_on_pans() {
    let parameters = VehicleOnPansParameters { shake: 0.0, ..Default::default() };
    let model = VehicleOnPans::prepare(parameters).expect("within its bounds");
    let mut simulation = Simulation::new(&model, VehicleOnPans::START).step(1e-3);
    simulation.run_until(20.0, |_| ()).expect("it stands");
    let found = simulation.sample().outputs;
    let weight: f64 = pressed(&found).into_iter().sum();
    assert!((weight - 11_200.0 * 9.81).abs() < 1e-3, "{weight}");
    let VehicleOnPansOutputs { stops_0_load, stops_2_load, stops_3_load, stops_5_load, .. } = found;
    assert_eq!([stops_0_load, stops_2_load, stops_3_load, stops_5_load], [0.0; 4]);
    let tied = shaken(0.0, 0.0, 1.0);
    let tied = loads(&tied.outputs(0.0, &standing(&tied), &()));
    for (found, tied) in pressed(&found).into_iter().zip(tied) {
        // Pans that yield by 10 mm pitch it by 2e-5 rad more.
        assert!((found - tied).abs() < 0.01 * tied, "{found} {tied}");
    }
}

/// Two methods agree on the way of a shaken vehicle whose wheels climb their stops, off their pans meanwhile, as those between no stops never are;
/// the first arm swings by 25 degrees up and 13 down from where it hangs at rest, where the source has some 20.
#[test]
fn wheels_climb_the_stops_of_their_pans() {
    let model = VehicleOnPans::prepare(VehicleOnPansParameters::default()).expect("within its bounds");
    let mut simulation = Simulation::new(&model, VehicleOnPans::START).step(2.5e-4);
    let (mut climbed, mut least, mut most) = ([0; 2], f64::INFINITY, f64::NEG_INFINITY);
    simulation
        .run_until(8.0, |sample| {
            let [first, second, _, _, fifth, _] = pressed(&sample.outputs);
            let VehicleOnPansOutputs { stops_0_load, station_0_angle, .. } = sample.outputs;
            climbed[0] += u32::from(first == 0.0 && stops_0_load > 0.0);
            climbed[1] += u32::from(second == 0.0 || fifth == 0.0);
            if sample.time > 2.0 {
                (least, most) = (least.min(station_0_angle), most.max(station_0_angle));
            }
        })
        .expect("it moves");
    assert!(climbed[0] > 1000 && climbed[1] == 0, "{climbed:?}");
    let [up, down] = [least, most].map(|angle| (angle - 0.569_f64).abs().to_degrees());
    assert!((up - 25.2).abs() < 0.1 && (down - 12.9).abs() < 0.1, "{up} {down}");
    let mut other = Simulation::new(&model, VehicleOnPans::START)
        .integrator(DormandPrince::tolerance(1e-9))
        .step(1.0 / 256.0);
    other.run_until(1.0, |_| ()).expect("it moves");
    other.run_until(8.0, |_| ()).expect("it moves");
    let mut worst = Worst::default();
    for outputs in [simulation.sample().outputs, other.sample().outputs] {
        worst.see(outputs.heave, 1.032_122_49);
        worst.see(outputs.pitch, 1.349_04e-3);
        worst.see(outputs.station_0_angle, 0.758_348_87);
        worst.see(outputs.station_3_angle, 0.748_822_90);
    }
    worst.below(1e-7, "vehicle on pans after 8 s");
}

/// A of steady running, row by row, and the force on the wheel.
fn running(speed: f64, braking: f64) -> ([f64; 16], f64) {
    let parameters = RearWheelParameters { speed, braking, ..Default::default() };
    let model = RearWheel::<f64>::prepare(parameters).expect("within its bounds");
    let start = model.assemble(&RearWheel::START).expect("it can start at any speed");
    let linear = Linearisation::at(&model, 0.0, &start, &()).expect("regular");
    assert!(linear.acceleration().iter().all(|a| a.abs() < 1e-9), "it runs steadily");
    let a = linear.state_space().expect("two coordinates").a;
    (a, model.outputs(0.0, &start, &()).force)
}

/// c₁ … c₄ of λ⁴ + c₁ λ³ + c₂ λ² + c₃ λ + c₄ = det(λ − A), after Faddeev and Le Verrier.
fn characteristic(a: &[f64; 16]) -> [f64; 4] {
    let mut power = *a;
    core::array::from_fn(|k| {
        let c = -(0..4).map(|i| power[5 * i]).sum::<f64>() / (k + 1) as f64;
        (0..4).for_each(|i| power[5 * i] += c);
        power = core::array::from_fn(|at| (0..4).map(|k| a[at / 4 * 4 + k] * power[4 * k + at % 4]).sum());
        c
    })
}

/// The last determinant of Hurwitz but one: two roots ± iω make it zero.
fn hurwitz([a, b, c, d]: [f64; 4]) -> f64 {
    a * b * c - c * c - a * a * d
}

#[test]
fn a_rear_wheel_under_braking() {
    let mut worst = Worst::default();
    for (braking, pairs) in [
        (0.0, [(-7.8286281, 104.7001958), (-85.9501536, 44.1153891)]),
        (-0.06, [(7.3466465, 106.2464313), (-48.5002463, 103.3137043)]),
    ] {
        let found = characteristic(&running(20.0, braking).0);
        // λ² − 2 Re λ + |λ|² of each pair.
        let [(p, q), (r, s)] = pairs.map(|(re, im): (f64, f64)| (-2.0 * re, re * re + im * im));
        for (found, expected) in found.into_iter().zip([p + r, q + s + p * r, p * s + q * r, q * s]) {
            worst.see(found / expected, 1.0);
        }
    }
    // Eigenvalues are given to 5e-8 of ten to a hundred; of four coefficients one is a difference.
    worst.below(2e-8, "rear wheel, characteristic polynomial");
}

/// Against bisections of the largest real part of the eigenvalues of A written down by hand.
#[test]
fn flutter_of_a_rear_wheel() {
    let (mut slips, mut forces) = (Worst::default(), Worst::default());
    for (speed, slip, force) in [
        (10.0, -0.053_126_939_79, -812.331_019),
        (15.0, -0.042_826_164_71, -705.678_522),
        (20.0, -0.036_097_850_21, -621.491_739),
        (40.0, -0.022_911_218_80, -423.015_769),
        (60.0, -0.017_501_541_07, -329.992_826),
    ] {
        let (mut calm, mut flutters) = (0.0, -0.08);
        while calm - flutters > 1e-12 {
            let middle = 0.5 * (calm + flutters);
            if hurwitz(characteristic(&running(speed, middle).0)) > 0.0 {
                calm = middle
            } else {
                flutters = middle
            }
        }
        slips.see(calm, slip);
        forces.see(running(speed, calm).1, force);
    }
    slips.below(1e-10, "rear wheel, slip at which flutter begins");
    forces.below(1e-6, "rear wheel, force at which flutter begins, in N");
}
