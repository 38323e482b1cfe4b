//! The sixth step of the tutorial: the same mechanism inside a control loop, as a microcontroller would hold it.
//!
//! ```text
//! cargo run --release --example tutorial_controller
//! ```

use linkwright::{AssembleExt, Rk4, Stepper, mechanism};

mechanism!(file = "../docs/tutorial/4_driven.mech");

/// Plain data that owns its model: it can stand in a `static`, and nothing of it allocates or panics.
struct Controller {
    plant: Stepper<CrankRocker<f64>, Rk4>,
    target: f64,
}

impl Controller {
    /// One tick of 1 ms: the target goes up until the crank runs at 90 rpm.
    fn tick(&mut self) -> Result<f64, linkwright::StepError> {
        let goal = 90.0 * core::f64::consts::TAU / 60.0;
        self.target = (self.target + 0.01).min(goal);
        let inputs = CrankRockerInputs { target: self.target };
        self.plant.step(&inputs, 1e-3)?;
        Ok(self.plant.outputs(&inputs).speed)
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let model = CrankRocker::prepare(CrankRockerParameters::default())?;
    let mut controller = Controller { plant: model.stepper(model.start(), Rk4), target: 0.0 };
    let mut speed = 0.0;
    for _ in 0..3000 {
        speed = controller.tick()?;
    }
    println!("after 3 s the crank turns at {:.2} rpm", 60.0 * speed / core::f64::consts::TAU);
    Ok(())
}

/// The loop that a controller runs, against the same law in a simulation of the fifth step's kind.
#[test]
fn the_tick_moves_as_a_simulation_does() {
    use linkwright::{Sampled, Simulation};
    let model = CrankRocker::prepare(CrankRockerParameters::default()).expect("good parameters");
    let mut controller = Controller { plant: model.stepper(model.start(), Rk4), target: 10.0 };
    let start = model.assemble(&CrankRocker::START).expect("it has a start");
    let target = 90.0 * core::f64::consts::TAU / 60.0;
    let mut simulation =
        Simulation::new(&model, start).inputs(Sampled(|_, _| CrankRockerInputs { target })).step(1e-3);
    let mut speed = 0.0;
    for _ in 0..1000 {
        speed = controller.tick().expect("it steps");
    }
    simulation.advance_until(1.0).expect("it moves");
    let beside = simulation.sample().outputs.speed;
    assert!((speed - beside).abs() < 1e-3 * beside, "{speed} {beside}");
}
