//! The fifth step of the tutorial: the mechanism of the fourth, compiled, and moved by a program.
//!
//! ```text
//! cargo run --release --example tutorial_simulation
//! ```

use linkwright::{AssembleExt, Baumgarte, Sampled, Simulation, mechanism};

mechanism!(file = "../docs/tutorial/4_driven.mech");

fn main() -> Result<(), Box<dyn std::error::Error>> {
    for radius in [0.15, 0.2] {
        println!(
            "a crank of {} mm: the pin of the rocker carries up to {:.3} N",
            1e3 * radius,
            largest(radius)?
        );
    }
    Ok(())
}

/// Of the force in the rocker's pin, while the motor brings the crank to 90 rpm.
fn largest(radius: f64) -> Result<f64, Box<dyn std::error::Error>> {
    let model = CrankRocker::prepare(CrankRockerParameters { radius, ..CrankRockerParameters::default() })?;
    let start = model.assemble(&CrankRocker::START)?;
    // What the motor is to keep, in SI units here: 90 rpm.
    let target = 90.0 * std::f64::consts::TAU / 60.0;
    let mut simulation = Simulation::new(&model, start)
        .formulation(Baumgarte { alpha: 10.0, beta: 10.0 })
        .inputs(Sampled(|_, _| CrankRockerInputs { target }))
        .step(1e-3);
    let mut largest = 0.0_f64;
    simulation.run_until(3.0, |sample| largest = largest.max(sample.outputs.pin))?;
    Ok(largest)
}

/// What the command line measures in the fourth step.
#[test]
fn it_agrees_with_the_command_line() {
    for (radius, measured) in [(0.15, 71.70436832055431), (0.2, 165.63559312)] {
        let force = largest(radius).expect("it runs");
        assert!((force - measured).abs() < 1e-6 * measured, "{force}");
    }
}
