//! A statement that swallows the next one may have taken what code relies on that uses the mechanism.

use linkwright::*;

mechanism! {
    pub planar Crank {
        param length [m] = 1
        input drive [N*m];
        output angle [rad] = pivot.angle;
        rod arm { mass [kg] = 2; length [m] = length; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
        torque motor: torque(pivot) = drive;
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let model = Crank::prepare(CrankParameters { length: 2.0, ..Default::default() })?;
    let mut simulation = model.simulation(Crank::START).constant(CrankInputs { drive: 1.0 }).step(1e-3);
    simulation.run_until(1.0, |sample| println!("{}", sample.outputs.angle))?;
    Ok(())
}
