//! The example of the front page: a crank-rocker with a motor and a payload that is set at run time.
//!
//! ```text
//! cargo run --release --example crank_rocker
//! ```

use linkwright::{AssembleExt, Baumgarte, Sampled, Simulation, mechanism};

mechanism! {
    /// A crank that swings a rocker, with a payload on the rocker.
    pub planar CrankRocker {
        param payload [kg] = 2 in 0.5..10;              // may change at run time
        input drive [N*m];                              // changes at every call
        gravity [m/s^2] = (0, -9.81);

        rod  crank   { mass [kg] = 0.5; length [mm] = 200; }
        rod  coupler { mass [kg] = 1;   length [mm] = 600; }
        body rocker  { mass [kg] = payload; inertia [kg*m^2] = 0.05; center [m] = (0.3, 0);
                       point tip [m] = (0.4, 0); }

        joint crank_pin:  revolute(ground(0, 0) [m], crank.start);
        joint knee:       revolute(crank.end, coupler.start);
        joint wrist:      revolute(coupler.end, rocker.tip);
        joint rocker_pin: revolute(ground(0.5, 0) [m], rocker.origin);

        force motor: torque(crank_pin) = drive;

        start  { crank_pin.angle [deg] = 90; crank_pin.rate [rpm] = 60; rocker_pin.angle [deg] ~ 70; }
        expect { degrees_of_freedom = 1; rotates = crank_pin; no_singularity; }
        output swing [rad] = rocker_pin.angle;
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let model = CrankRocker::prepare(CrankRockerParameters { payload: 3.0 })?;
    let start = model.assemble(&CrankRocker::START)?;
    let mut simulation = Simulation::new(&model, start)
        .formulation(Baumgarte { alpha: 10.0, beta: 10.0 })
        .inputs(Sampled(|time: f64, _| CrankRockerInputs { drive: 2.0 * time.sin() }))
        .step(1e-3);
    for tenth in 0..=10 {
        simulation.advance_until(0.1 * f64::from(tenth))?;
        let sample = simulation.sample();
        println!("{:4.1} s  rocker at {:6.3} rad", sample.time, sample.outputs.swing);
    }
    println!("the loop is closed to {:.1e} m", simulation.constraint_residual().position);
    Ok(())
}
