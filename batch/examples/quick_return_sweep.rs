//! A hundred thousand quick returns, each with another flywheel and another cutting force: how even the crank turns.
//!
//! The force acts on the forward stroke alone, and the motor's torque does its work over a turn, 2π T = 0.6 m · F. The more of both, and
//! the lighter the flywheel, the more the crank's speed varies within a turn: the coefficient of fluctuation (ω_max − ω_min)/ω_mean.
//!
//! ```text
//! RUSTFLAGS="-C target-cpu=native" cargo run --release -p linkwright-batch --example quick_return_sweep [-- members]
//! ```

use linkwright::lanes::InScalars;
use linkwright::{Lanes, Real, Rk4};
use linkwright_batch::{Batch, Group, InLanesOf, Widest};
use linkwright_models::quick_return::{
    QuickReturn, QuickReturnInputs, QuickReturnOutputs, QuickReturnParameters,
};
use std::error::Error;
use std::time::Instant;

/// The step, s, and how many make a turn at 15 rad/s.
const H: f64 = 2e-4;
const STEPS: usize = 2095;
/// What the flywheels (kg m²) and the forces (N) run through.
const FLYWHEELS: [f64; 2] = [1.0, 10.0];
const FORCES: [f64; 2] = [0.0, 150.0];
const STROKE: f64 = 0.6;

fn main() -> Result<(), Box<dyn Error>> {
    let asked = std::env::args().nth(1).map_or(Ok(100_000), |text| text.parse::<usize>())?;
    let side = asked.isqrt().max(2);
    let part = |index: usize| index as f64 / (side - 1) as f64;
    let flywheel = |row: usize| FLYWHEELS[0] * (FLYWHEELS[1] / FLYWHEELS[0]).powf(part(row));
    let force = |column: usize| FORCES[0] + (FORCES[1] - FORCES[0]) * part(column);

    let begin = Instant::now();
    let mut batch = Batch::<QuickReturn, _>::prepare(side * side, Rk4, |member| QuickReturnParameters {
        flywheel: flywheel(member / side),
    })?;
    let prepared = begin.elapsed();
    let law = InLanesOf::new(|group: &Group<'_, QuickReturn, Widest>| {
        let mut most = Widest::ZERO;
        (0..Widest::LANES).for_each(|lane| most.set_lane(lane, force(group.member(lane) % side)));
        cutting(group.models, group.times, group.states, most)
    });
    let speeds = batch.fold(&law, H, STEPS, [f64::INFINITY, 0.0], |_, [least, most], outputs| {
        let QuickReturnOutputs { rate, .. } = *outputs;
        (*least, *most) = (least.min(rate), most.max(rate));
    });
    let passed = begin.elapsed();

    println!(
        "fluctuation of the crank's speed, % of its mean; flywheel in kg m² downwards, force in N to the right\n"
    );
    let shown = |index: usize| index * (side - 1) / 5;
    print!("{:>8}", "");
    (0..6).for_each(|column| print!("{:>8.0}", force(shown(column))));
    println!();
    for row in (0..6).map(shown) {
        print!("{:>8.2}", flywheel(row));
        for column in (0..6).map(shown) {
            let [least, most] = speeds[row * side + column];
            print!("{:>8.2}", 200.0 * (most - least) / (most + least));
        }
        println!();
    }
    let fluctuation =
        |row: usize, column: usize| speeds[row * side + column][1] - speeds[row * side + column][0];
    assert!(
        fluctuation(0, side - 1) > fluctuation(side - 1, side - 1),
        "a heavier flywheel turns more evenly"
    );
    assert_eq!(batch.failures().count(), 0);
    println!(
        "\n{} mechanisms, {STEPS} steps each: {:.2} s, of which {:.2} s were assembly; {:.1} million steps a second",
        batch.len(),
        passed.as_secs_f64(),
        prepared.as_secs_f64(),
        (batch.len() * STEPS) as f64 / (passed - prepared).as_secs_f64() / 1e6
    );
    Ok(())
}

/// The force where the slider moves forward, to −x, and the torque that does its work. One function for a number and for lanes.
fn cutting<R: Real>(
    model: &<QuickReturn as InScalars>::In<R>,
    time: R,
    state: &linkwright::lanes::StateIn<QuickReturn, R>,
    most: R,
) -> QuickReturnInputs<R> {
    let none = QuickReturnInputs { drive: R::ZERO, cutting: R::ZERO };
    let outputs = linkwright::Mechanism::outputs(model, time, state, &none);
    let forward = outputs.speed.less(R::ZERO);
    let drive = most * R::from_f64(STROKE / std::f64::consts::TAU);
    QuickReturnInputs { drive, cutting: R::select(forward, most, R::ZERO) }
}
