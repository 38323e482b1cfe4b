//! Frictions that remember: what holds holds without creeping, and sticks and slips at the times of the published curve.

use linkwright::{DormandPrince, Event, Rk4, Simulation};
use linkwright_models::held_block::{HeldBlock, HeldBlockInputs};
use linkwright_models::stick_slip::StickSlip;

fn close(found: f64, expected: f64, within: f64, what: &str) {
    println!("{what}: {found:.15}, {:.1e} off", (found - expected).abs());
    assert!((found - expected).abs() <= within, "{what}: {found} in place of {expected}");
}

const MASS: f64 = 2.0;
const G: f64 = 9.81;
const GRIP: f64 = 0.7;
/// Of the asperities, 1/m.
const STIFFNESS: f64 = 2000.0;

/// sin α and cos α of the slope.
fn slope() -> (f64, f64) {
    20_f64.to_radians().sin_cos()
}

/// What tears it off, N.
fn torn() -> f64 {
    let (sin, cos) = slope();
    MASS * G * (GRIP * cos - sin)
}

/// Held by the anchor at first, then with a force from 0.5 s on.
fn pulled(pull: f64, until: f64) -> [f64; 2] {
    let model = HeldBlock::default();
    let mut simulation = Simulation::new(&model, HeldBlock::START)
        .sampled(move |time, _| HeldBlockInputs { pull: if time < 0.5 { 0.0 } else { pull } })
        .integrator(Rk4)
        .step(5e-5);
    simulation.advance_until(until).expect("it is held");
    let outputs = simulation.sample().outputs;
    [outputs.place, outputs.speed]
}

#[test]
fn asperities_hold_a_block_without_creeping() {
    let (sin, cos) = slope();
    for (pull, within) in [(0.0, 1e-12), (0.8 * torn(), 1e-12)] {
        let [place, speed] = pulled(pull, 2.0);
        let held = (MASS * G * sin + pull) / (MASS * G * cos * STIFFNESS);
        close(place, held, within, "where it is held, m");
        close(speed, 0.0, within, "how fast it creeps, m/s");
    }
    // With more of what tears it off it drags its anchor along for a while, and holds.
    let whole = GRIP * MASS * G * cos;
    let pull = 0.98 * whole - MASS * G * sin;
    let [place, speed] = pulled(pull, 3.0);
    assert!(place > 1.001 * 0.98 * GRIP / STIFFNESS, "{place}");
    close(speed, 0.0, 1e-9, "how fast it creeps near the most, m/s");
}

#[test]
fn a_block_torn_off_slides_as_by_coulombs_law() {
    let (sin, cos) = slope();
    let pull = torn() + 1.0;
    let ([_, before], [_, after]) = (pulled(pull, 1.5), pulled(pull, 2.5));
    close(after - before, G * (sin - GRIP * cos) + pull / MASS, 1e-9, "acceleration, m/s²");
}

/// When it passes 0.05 m/s, upwards, downwards and upwards again.
#[test]
fn lugre_friction_of_a_contact_sticks_and_slips() {
    let model = StickSlip::default();
    let mut simulation = Simulation::new(&model, StickSlip::START)
        .integrator(DormandPrince::tolerances(1e-11, 1e-9))
        .step(1e-2);
    let level = [Event::of("speed").level(0.05)];
    for expected in [7.540_397_463_015_5, 10.064_459_252_951_8, 13.903_117_284_081_5, 20.265_837_105_147_4] {
        let mut next = || {
            let met = simulation.run_until_event(50.0, &level, |_| ()).expect("it moves");
            met.expect("it goes on").time
        };
        let mut time = next();
        if expected > 15.0 {
            // Down again between.
            time = next();
        }
        close(time, expected, 2e-6, "passes 0.05 m/s, s");
    }
}
