//! Mechanisms with states beside their motion, against separate integrations of their equations.

use super::Worst;
use linkwright::{
    Ali3p, DormandPrince, Event, ExplicitTrapezoidal, GeneralisedAlpha, ImplicitTrapezoidal, Linearisation,
    Mechanism, NoInputs, Rk4, SemiImplicitEuler, Simulation, State, Variables, equilibrium,
};
use linkwright_models::braked_wheel::BrakedWheel;
use linkwright_models::dc_motor_arm::{DcMotorArm, DcMotorArmInputs};
use linkwright_models::lugre_block::{LugreBlock, LugreBlockInputs};
use linkwright_models::motor_gear_load::{
    ElasticMotorGearLoad, ElasticMotorGearLoadInputs, MotorGearLoad, MotorGearLoadInputs,
};

const VOLTAGE: DcMotorArmInputs = DcMotorArmInputs { voltage: 3.0 };
/// Angle, rate and current.
const AFTER_10_MS: [f64; 3] = [5.92081289090e-4, 0.151_706_724_118_73, 5.494_146_993_263_54];
const AFTER_1_S: [f64; 3] = [9.149_928_836_671_469, 16.814_920_126_022_002, 3.317_073_210_020_512];

#[test]
fn dc_motor_arm() {
    let model = DcMotorArm::default();
    let mut simulation = Simulation::new(&model, DcMotorArm::START)
        .held(|_, _| VOLTAGE)
        .integrator(DormandPrince::tolerance(1e-12))
        .step(1e-2);
    for (time, expected) in [(0.01, AFTER_10_MS), (1.0, AFTER_1_S)] {
        // Angles continue from sample to sample.
        simulation.run_until(time, |_| ()).expect("it turns");
        let found = simulation.sample().outputs;
        let mut worst = Worst::default();
        for (found, expected) in [found.angle, found.rate, found.current].into_iter().zip(expected) {
            worst.see(found, expected);
        }
        worst.below(2e-10, "motor on an arm");
        let named = DcMotorArm::internal(&simulation.state().z);
        assert_eq!(named.current, found.current);
    }
}

/// The current moves in every method at the order of the motion.
#[test]
fn states_keep_the_order() {
    let model = DcMotorArm::default();
    // The angle is small.
    let size = [1e2, 1.0, 1e-1];
    macro_rules! orders {
        ($($integrator:expr, $order:literal;)*) => { $(
            let error = |h: f64| {
                let simulation = Simulation::new(&model, DcMotorArm::START).held(|_, _| VOLTAGE);
                let mut simulation = simulation.integrator($integrator).step(h);
                simulation.advance_until(0.01).expect("it turns");
                let found = simulation.sample().outputs;
                let parts = [found.angle, found.rate, found.current].into_iter().zip(AFTER_10_MS).zip(size);
                parts.map(|((found, expected), size)| (found - expected).abs() * size).fold(0.0, f64::max)
            };
            let [coarse, fine] = [2e-4, 1e-4].map(error);
            let order = (coarse / fine).log2();
            println!("{:?}: {coarse:.2e} and {fine:.2e}, order {order:.3}", $integrator);
            assert!((order - $order).abs() < 0.15, "{:?}: order {order}", $integrator);
        )* };
    }
    orders! {
        Rk4, 4.0;
        ExplicitTrapezoidal, 2.0;
        SemiImplicitEuler, 1.0;
        DormandPrince::<f64>::fixed(), 5.0;
        ImplicitTrapezoidal::<f64>::default(), 2.0;
        GeneralisedAlpha::new(0.6), 2.0;
        Ali3p::new(1e8), 2.0;
    }
}

/// Held by its motor: at rest the current is V/R, and the arm hangs where its moment is K V/R; the slow eigenvalues are those of the
/// three equations written down by hand.
#[test]
fn a_motor_holds_its_arm() {
    let model = DcMotorArm::default();
    let inputs = DcMotorArmInputs { voltage: 0.3 };
    let found = equilibrium(&model, 0.0, &DcMotorArm::START.q, &inputs).expect("it hangs");
    let current: f64 = 0.3 / 0.5;
    assert!((found.z[0] - current).abs() < 1e-14, "{:?}", found.z);
    let state = State { q: found.q, z: found.z, ..DcMotorArm::START };
    let angle = (0.08 * current / 0.0981).asin();
    assert!((model.outputs(0.0, &state, &inputs).angle - angle).abs() < 1e-14);
    let linear = Linearisation::at(&model, 0.0, &state, &inputs).expect("a regular state");
    let space = linear.state_space().expect("one coordinate");
    let (inertia, constant, resistance, inductance) = (0.02, 0.08, 0.5, 2e-3);
    let expected = [
        [0.0, 1.0, 0.0],
        [-0.0981 * angle.cos() / inertia, 0.0, constant / inertia],
        [0.0, -constant / inductance, -resistance / inductance],
    ];
    for (found, expected) in space.a.iter().zip(expected.iter().flatten()) {
        assert!((found - expected).abs() < 1e-12 * (1.0 + expected.abs()), "{:?}", space.a);
    }
    assert!((space.b[2] - 1.0 / inductance).abs() < 1e-9 && space.b[0] == 0.0 && space.b[1] == 0.0);
    assert_eq!(space.c, [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]);
}

#[test]
fn braked_wheel() {
    let model = BrakedWheel::default();
    let mut simulation = Simulation::new(&model, BrakedWheel::START)
        .input_source(NoInputs)
        .integrator(DormandPrince::tolerance(1e-12))
        .step(1e-2);
    assert_eq!(Variables::<f64>::internal_scales(&model), [1e-3]);
    let mut worst = Worst::default();
    // The brake is fully on: its law has a kink here.
    simulation.advance_until(0.3).expect("it rolls");
    let found = simulation.sample().outputs;
    worst.see(found.speed, 18.924_651_388_497_83);
    worst.see(found.spin, 58.875_954_885_553_37);
    worst.see(found.slip, -0.060_913_498_475_065);
    simulation.advance_until(1.0).expect("it rolls");
    let found = simulation.sample().outputs;
    worst.see(found.place, 17.275_484_471_766_03);
    worst.see(found.speed, 13.590_967_309_533_108);
    worst.see(found.spin, 42.231_209_820_847_47);
    worst.see(found.slip, -0.067_810_064_052_679);
    worst.see(found.force / 1e3, -1.905_275_790_837_8);
    worst.below(1e-9, "braked wheel");
}

/// Before it slides the block gives way and comes back on another way.
#[test]
fn lugre_block_before_it_slides() {
    // Up to 1.425 N, held, down to its opposite, held, and back.
    let corners = [(0.0, 0.0), (5.0, 1.425), (6.0, 1.425), (16.0, -1.425), (17.0, -1.425), (22.0, 0.0)];
    let push = move |time: f64| {
        let piece = corners.windows(2).find(|pair| time <= pair[1].0).unwrap_or(&corners[4..]);
        let [(from, low), (to, high)] = [piece[0], piece[1]];
        low + (high - low) * (time - from) / (to - from)
    };
    let model = LugreBlock::default();
    let mut simulation = Simulation::new(&model, LugreBlock::START)
        .sampled(move |time, _| LugreBlockInputs { push: push(time) })
        .integrator(DormandPrince::tolerances(1e-12, 1e-10))
        .step(1e-2);
    let mut worst = Worst::default();
    for (time, place) in [
        (2.5, 9.648_146_480_6e-6),
        (5.0, 4.480_774_362_81e-5),
        (6.0, 4.574_964_122_24e-5),
        (11.0, 3.574_123_045_06e-5),
        (16.0, -9.075_539_740_6e-6),
        (17.0, f64::NAN),
        (22.0, -9.026_563_073_1e-9),
    ] {
        simulation.advance_until(time).expect("it gives way");
        if !place.is_nan() {
            worst.see(simulation.sample().outputs.place, place);
        }
    }
    worst.below(1e-11, "LuGre block, place");
}

/// Pulled slowly by a soft spring it sticks and slips.
#[test]
fn lugre_block_sticks_and_slips() {
    let model = LugreBlock::default();
    let mut simulation = Simulation::new(&model, LugreBlock::START)
        .sampled(|time, state| {
            let place = LugreBlock::positions(&state.q).rail_travel;
            LugreBlockInputs { push: 2.0 * (0.1 * time - place) }
        })
        .integrator(DormandPrince::tolerances(1e-11, 1e-9))
        .step(1e-2);
    let level = [Event::of("speed").level(0.05)];
    let mut crossings = Vec::new();
    while crossings.len() < 4 {
        let met = simulation.run_until_event(50.0, &level, |_| ()).expect("it moves");
        let occurrence = met.expect("it goes on");
        crossings.push(occurrence.time);
    }
    let mut worst = Worst::default();
    for (found, expected) in
        crossings.iter().zip([7.540_397_463_015_5, 10.064_459_252_951_8, 13.903_117_284_081_5])
    {
        worst.see(*found, expected);
    }
    worst.below(1e-6, "LuGre block, times of slipping");
}

#[test]
fn motor_gear_load() {
    let model = MotorGearLoad::default();
    let (mut a, mut lambda) = (model.zero_v(), model.zero_lambda());
    for (drive, expected) in [(12.0, 367.346_938_775_510_2), (14.6, 500.0)] {
        let inputs = MotorGearLoadInputs { drive };
        let state = MotorGearLoad::START;
        model.acceleration(0.0, &state, &inputs, &mut a, &mut lambda);
        let motions = model.motions(0.0, &state.q, &state.v, &a);
        let mut worst = Worst::default();
        worst.see(motions[0].angular_acceleration, expected);
        worst.see(motions[1].angular_acceleration, expected / 5.0);
        worst.below(1e-11, "motor and load");
    }
    let elastic = ElasticMotorGearLoad::default();
    let inputs = ElasticMotorGearLoadInputs { drive: 0.0 };
    let linear = Linearisation::at(&elastic, 0.0, &ElasticMotorGearLoad::START, &inputs).expect("regular");
    let space = linear.state_space().expect("two coordinates");
    // One eigenvalue of the block is zero, the other is their sum.
    let squared = -(space.a[2 * 4] + space.a[3 * 4 + 1]);
    assert!((squared.sqrt() - 329.983_164_553_72).abs() < 1e-9, "{}", squared.sqrt());
}

mod steady {
    linkwright::mechanism! {
        /// A motor that turns already, warms up, and whose power is measured slowly.
        pub planar Settled {
            param resistance [ohm] = 0.5;
            state current [A] = 0;
            rate  current = (3 [V] - resistance*current - 0.08 [V*s]*axle.rate)/2e-3 [H];
            state warmth [1] = 1;
            rate  warmth = 0.1 [1/(A^2*s)]*current^2 - warmth^1.5/10 [s];
            state felt [W] = 0, scale = 1 [W];
            rate  felt = (power(motor) - felt)/0.1 [s];
            state turned [rad] = 0.25;
            rate  turned = axle.rate;
            body arm { mass [kg] = 0.1; inertia [kg*m^2] = 0.02; }
            joint  axle:  revolute(ground(0, 0) [m], arm.center);
            torque motor: torque(axle) = 0.08 [N*m/A]*current;
            start { axle.rate [rad/s] = 10; steady = (warmth, current, felt); }
            output turned [rad] = turned;
        }
    }
}

/// i = (V − K ω)/R; w^1.5 = 10·0.1 i²; what is felt is the power K i ω. What is not named begins as it is declared.
#[test]
fn steady_states_begin_where_they_rest() {
    let found = steady::Settled::internal(&steady::Settled::START.z);
    let current = (3.0 - 0.08 * 10.0) / 0.5_f64;
    let mut worst = Worst::default();
    worst.see(found.current, current);
    worst.see(found.warmth, (current * current).powf(2.0 / 3.0));
    worst.see(found.felt, 0.08 * current * 10.0);
    worst.see(found.turned, 0.25);
    worst.below(1e-12, "steady states");
}
