//! Records a batch of pendulums, one of which cannot be prepared, as a file of Arrow, and as text for those who compare.

use arrow_ipc::writer::FileWriter;
use linkwright::{Rk4, mechanism};
use linkwright_batch::{Batch, Constant};
use std::error::Error;
use std::fs::File;

mechanism! {
    /// A pendulum.
    planar Pendulum {
        param length [m] = 1 in 0.1..2;
        gravity [m/s^2] = (0, -9.81);
        rod arm { mass [kg] = 1; length [m] = length; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
        start { pivot.angle [deg] = 0; }
        output height [m] = arm.end.y;
        output across [m] = arm.end.x;
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args().nth(1).ok_or("write a file")?;
    let length = |member: usize| 0.05 + 0.1 * member as f64;
    let mut batch =
        Batch::<Pendulum, _>::prepare(13, Rk4, |member| PendulumParameters { length: length(member) })?;
    let recording = batch.record(&Constant(()), 1e-3, 300, 100);
    let table = recording.record_batch()?;
    let mut writer = FileWriter::try_new(File::create(path)?, &table.schema())?;
    writer.write(&table)?;
    writer.finish()?;
    for (step, sample) in recording.steps.iter().zip(&recording.samples) {
        let (height, across) =
            (sample.column("height").ok_or("none")?, sample.column("across").ok_or("none")?);
        for (member, (height, across)) in height.iter().zip(across).enumerate() {
            println!("{step},{member},{height},{across}");
        }
    }
    Ok(())
}
