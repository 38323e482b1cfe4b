//! Friction of contacts, against closed forms: what slides comes to roll, with the speed and after the way that follow from its gyration.

use linkwright::{Rk4, Simulation};
use linkwright_models::rolling::{SlidingBall, SlidingDisk};

fn close(found: f64, expected: f64, within: f64, what: &str) {
    println!("{what}: {found:.15}, {:.1e} off", (found - expected).abs());
    assert!((found - expected).abs() <= within, "{what}: {found} in place of {expected}");
}

/// kg.
const MASS: f64 = 2.0;
/// m.
const RADIUS: f64 = 0.1;
const GRIP: f64 = 0.2;
/// m/s².
const G: f64 = 9.81;
/// How deep the floor is pressed in, of which the point of contact is half below it, m.
const DEPTH: f64 = 1e-6;

/// v/v₀ at last and the sliding's deceleration, J = k m r²: with the arm s from the centre to the point of contact
/// s m (v₀ − v) = J ω, v = s ω, and u' = −(1/m + s²/J) μ N.
fn rolling(k: f64) -> [f64; 2] {
    let arm = RADIUS - 0.5 * DEPTH;
    let share = k * (RADIUS / arm).powi(2);
    [1.0 / (1.0 + share), (1.0 + 1.0 / share) * GRIP * G]
}

/// When the sliding is u, from u₀: ∫ √(u² + v_s²)/u du over the deceleration.
fn time(u0: f64, u: f64, smooth: f64, deceleration: f64) -> f64 {
    let of = |u: f64| u.hypot(smooth) - smooth * (smooth / u).asinh();
    (of(u0) - of(u)) / deceleration
}

#[test]
fn a_disk_comes_to_roll() {
    let model = SlidingDisk::default();
    let smooth = model.parameters().smooth;
    let [share, deceleration] = rolling(0.5);
    let mut simulation = Simulation::new(&model, SlidingDisk::START).integrator(Rk4).step(5e-5);
    simulation.advance_until(0.3).expect("it slides");
    let sliding = simulation.sample().outputs;
    close(time(3.0, sliding.sliding, smooth, deceleration), 0.3, 1e-9, "when it slides like this");
    close(sliding.pressed, MASS * G, 1e-6, "what presses");
    close(sliding.gripping, -GRIP * MASS * G / 1.0_f64.hypot(smooth / sliding.sliding), 1e-6, "friction");
    close(sliding.lost, -sliding.gripping * sliding.sliding, 1e-9, "power");
    // The closed form without smoothness: 0.509683995922528 s and 1.27420998990632 m.
    simulation.advance_until(0.509_683_995_922_528).expect("it slides");
    close(simulation.sample().outputs.place, 1.274_209_989_906_32, 3e-3, "where it begins to roll");
    simulation.advance_until(0.8).expect("it rolls");
    let rolled = simulation.sample().outputs;
    close(rolled.speed, 3.0 * share, 1e-8, "speed");
    close(rolled.speed, 2.0, 1e-5, "speed, two thirds");
    close(rolled.speed + rolled.rate * (RADIUS - 0.5 * DEPTH), 0.0, 1e-8, "rolls");
}

/// In a direction of its own, so that all three components count.
#[test]
fn a_ball_comes_to_roll() {
    let model = SlidingBall::default();
    let smooth = model.parameters().smooth;
    let [share, deceleration] = rolling(0.4);
    let mut simulation = Simulation::new(&model, SlidingBall::START).integrator(Rk4).step(5e-5);
    simulation.advance_until(0.25).expect("it slides");
    let sliding = simulation.sample().outputs;
    let speed = sliding.sliding_x.hypot(sliding.sliding_y);
    close(time(3.0, speed, smooth, deceleration), 0.25, 1e-9, "when it slides like this");
    close(sliding.sliding_x / sliding.sliding_y, 0.75, 1e-9, "direction");
    close(sliding.sliding_z, 0.0, 1e-9, "nothing along the normal");
    close(sliding.pressed, MASS * G, 1e-6, "what presses");
    simulation.advance_until(0.436_871_996_505_024).expect("it slides");
    let place = simulation.sample().outputs;
    close(place.place_x.hypot(place.place_y), 1.123_385_133_870_06, 3e-3, "where it begins to roll");
    simulation.advance_until(0.8).expect("it rolls");
    let rolled = simulation.sample().outputs;
    close(rolled.speed_x, 1.8 * share, 1e-8, "speed along x");
    close(rolled.speed_y, 2.4 * share, 1e-8, "speed along y");
    close(rolled.speed_x.hypot(rolled.speed_y), 2.142_857_142_857_143, 1e-5, "speed, five sevenths");
}
