//! The clock over many ticks: what is integrated is what it shows, and what it shows is exact.
//!
//! A balanced body turns with 1 rad/s, so that its angle is the time that was integrated.

use crate::double_pendulum::{DoublePendulum, Torque};
use linkwright_runtime::{Real, Simulation, State};

/// Both bodies at 0 rad, 1 rad/s.
fn turning<R: Real>() -> State<[R; 8], [R; 2]> {
    let (zero, one) = (R::ZERO, R::ONE);
    State { q: [one, zero, one, zero, zero, zero, zero, zero], v: [one, one] }
}

/// Steps and the angle turned, of ticks that are advanced by naming their ends.
fn ticked<R: Real>(begin: f64, tick: f64, h: f64, ticks: u32) -> (u32, f64) {
    let model = DoublePendulum::<R>::balanced();
    let mut steps = 0;
    let mut simulation = Simulation::new(&model, turning::<R>())
        .held(|_, _| {
            steps += 1;
            Torque { shoulder: R::ZERO }
        })
        .start_time(R::from_f64(begin))
        .step(R::from_f64(h));
    for k in 1..=ticks {
        simulation.advance_until(R::from_f64(begin + f64::from(k) * tick)).unwrap();
    }
    let angle = simulation.state().q[5].to_f64();
    (steps, angle)
}

#[test]
fn no_motion_is_skipped_in_single_precision() {
    for (begin, tick, h) in [(300.0, 1e-3, 1e-4), (1000.0, 1e-3, 1e-4), (3600.0, 1e-2, 1e-3)] {
        let (steps, angle) = ticked::<f32>(begin, tick, h, 100);
        // What lies between the two times that the clock showed, as `f32` has them.
        let elapsed = f64::from((begin + 100.0 * tick) as f32) - f64::from(begin as f32);
        println!("from {begin} s: {steps} steps, {angle} s of {elapsed} s");
        assert!((angle - elapsed).abs() < 1e-3 * elapsed, "{angle} {elapsed}");
        assert!(f64::from(steps) >= elapsed / h && f64::from(steps) < elapsed / h + 101.0, "{steps}");
    }
}

#[test]
fn no_motion_is_skipped_at_large_times() {
    // Times near 1e17 s are 16 s apart.
    let (steps, angle) = ticked::<f64>(1e17, 16.0, 0.5, 2);
    assert!(steps == 64 && (angle - (32.0 - 10.0 * core::f64::consts::PI)).abs() < 1e-9, "{steps} {angle}");
}
