//! The walking linkages: positions over one turn of the crank, and the power that walking takes.

use super::{Table, Worst, baumgarte};
use linkwright::{AssembleExt, Mechanism, Motion, Simulation};
use linkwright_models::jansen_leg::JansenLeg;
use linkwright_models::klann_leg::{KlannLeg, KlannLegInputs};

fn reference() -> Table {
    Table::new(include_str!("../../data/linkage_positions_computed.csv"))
}

/// Steps between two rows of the table, so that the branch is kept.
const PARTS: u32 = 5;

#[test]
fn jansen_leg() {
    let reference = reference();
    let model = JansenLeg::<f64>::default();
    let speed = model.parameters().speed;
    let mut near = JansenLeg::START.q;
    let mut worst = Worst::default();
    for row in 0..reference.rows.len() {
        for part in 0..PARTS {
            let degrees =
                reference.get(row, "theta_deg") - 15.0 * f64::from(PARTS - 1 - part) / f64::from(PARTS);
            let time = degrees.to_radians() / speed;
            let found = model.kinematics(time, &near, &[]).expect("the leg walks");
            near = found.q;
            if part + 1 == PARTS {
                let outputs = model.outputs(time, &found.state(), &());
                // The table's unit is Jansen's, here the centimetre.
                worst.see(100.0 * outputs.toe_x, reference.get(row, "jansen_Fx"));
                worst.see(100.0 * outputs.toe_y, reference.get(row, "jansen_Fy"));
                worst.see(100.0 * outputs.knee_x, reference.get(row, "jansen_J5x"));
                worst.see(100.0 * outputs.knee_y, reference.get(row, "jansen_J5y"));
            }
        }
    }
    worst.below(1e-10, "Jansen leg, positions in cm");
}

#[test]
fn klann_leg() {
    let reference = reference();
    let model = KlannLeg::<f64>::default();
    let mut near = KlannLeg::START.q;
    let mut worst = Worst::default();
    for row in 0..reference.rows.len() {
        for part in 0..PARTS {
            let degrees =
                reference.get(row, "theta_deg") - 15.0 * f64::from(PARTS - 1 - part) / f64::from(PARTS);
            let motion = Motion { position: degrees.to_radians(), rate: 1.0, acceleration: 0.0 };
            let found = model.kinematics(0.0, &near, &[motion]).expect("the leg walks");
            near = found.q;
            if part + 1 == PARTS {
                let outputs = model.outputs(0.0, &found.state(), &KlannLegInputs { torque: 0.0 });
                worst.see(outputs.foot_x, reference.get(row, "klann_P33x"));
                worst.see(outputs.foot_y, reference.get(row, "klann_P33y"));
                worst.see(outputs.hip_x, reference.get(row, "klann_P37x"));
                worst.see(outputs.hip_y, reference.get(row, "klann_P37y"));
            }
        }
    }
    worst.below(1e-11, "Klann leg, positions");
}

/// Over one turn of the driven crank the motor's work is nothing but the change of energy, which is none.
#[test]
fn a_turn_of_the_jansen_leg_costs_no_work() {
    let model = JansenLeg::<f64>::default();
    let speed = model.parameters().speed;
    let turn = core::f64::consts::TAU / speed;
    let steps = 4000;
    let h = turn / f64::from(steps);
    let mut simulation = Simulation::new(&model, JansenLeg::START).formulation(baumgarte(20.0)).step(h);
    let first = simulation.energy();
    let mut worst = Worst::default();
    let (mut work, mut before) = (0.0, None);
    simulation
        .run_until(turn, |sample| {
            let power = sample.outputs.torque * speed;
            if let Some(before) = before {
                work += 0.5 * h * (before + power);
            }
            before = Some(power);
            // The trapezoidal rule's error is that of its ends.
            worst.see(sample.energy() - first, work);
        })
        .expect("the leg walks");
    worst.below(1e-4, "Jansen leg, work of the driver against energy");
    let mut whole = Worst::default();
    whole.see(work, 0.0);
    whole.below(1e-6, "Jansen leg, work of a whole turn");
}
