//! A statement that cannot be read may be what code relies on that uses the mechanism.

use linkwright::*;

mechanism! {
    pub planar Crank {
        imput drive [N*m];
        rod arm { mass [kg] = 2; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
        start { pivot.angle [deg] = 30; }
        outptu angle [rad] = pivot.angle;
    }
}

impl From<f64> for CrankInputs {
    fn from(drive: f64) -> Self {
        CrankInputs { drive }
    }
}

impl Pushed for CrankInputs {}
impl Pushed for CrankOutputs {}

trait Pushed {}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let inputs = CrankInputs::from(1.0);
    let model = Crank::default();
    let mut simulation = model.simulation(Crank::START).constant(inputs).step(1e-3);
    simulation.run_until(1.0, |sample| println!("{}", sample.outputs.angle))?;
    let CrankInputs { drive } = inputs;
    println!("{drive}");
    Ok(())
}
