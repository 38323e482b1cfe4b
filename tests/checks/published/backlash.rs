//! Shafts with backlash, whose teeth touch, rebound and part: against a separate integration that stops at each change.

use linkwright::{Rk4, Simulation};
use linkwright_models::geared_shafts::{GearedShafts, GearedShaftsInputs};

fn drive(time: f64) -> f64 {
    if time < 0.1 {
        2.0
    } else if time < 0.2 {
        -2.0
    } else {
        0.5
    }
}

#[test]
fn geared_shafts_rattle_in_their_gap() {
    let model = GearedShafts::default();
    // What drives is the same over each step, which ends where it changes.
    let mut simulation = Simulation::new(&model, GearedShafts::START)
        .held(|time, _| GearedShaftsInputs { drive: drive(time + 1e-9) })
        .integrator(Rk4)
        .step(1e-5);
    let (mut changes, mut first) = (0, f64::NAN);
    let mut until = |end: f64| {
        let mut steps = 0;
        while simulation.time() < end - 1e-12 {
            let step = simulation.advance().expect("it turns");
            changes += step.gates_changed;
            if changes > 0 && first.is_nan() {
                first = simulation.time();
            }
            steps += 1;
            assert!(steps < 100_000, "it goes on");
        }
        let at = simulation.sample().outputs;
        [at.motor_angle, at.machine_angle, at.motor_rate, at.machine_rate]
    };
    let early = until(0.1);
    let late = until(0.4);
    assert!((first - 0.01).abs() <= 1e-5, "first touch by {first} s");
    // Of 12 touches 11 end, each where the force is zero; the source counts where the gap opens after that too.
    assert_eq!(changes, 12 + 11);
    for (found, expected) in [
        (early, [0.176_616_418_677_195, 0.164_676_716_264_561, 3.158_584_548_046_504, 3.368_283_090_390_699]),
        (late, [0.509_203_377_76, 0.498_159_324_45, 1.398_068_637_96, 1.720_386_272_41]),
    ] {
        for (found, expected) in found.iter().zip(expected) {
            println!("{found:.14}, {:.1e} off", (found - expected).abs());
            assert!((found - expected).abs() < 2e-9, "{found} in place of {expected}");
        }
    }
}
