//! The roots λ = βL of the frequency equations of beams in bending, by Newton's iteration. Divided by cosh λ the equations stay of
//! order one, and the roots have all digits.

use std::f64::consts::PI;

/// cos λ cosh λ = 1, the rigid motions left out.
pub fn free_free(number: usize) -> f64 {
    root((number as f64 + 1.5) * PI, 1.0)
}

/// cos λ cosh λ = −1.
pub fn clamped_free(number: usize) -> f64 {
    root((number as f64 + 0.5) * PI, -1.0)
}

/// cos λ = s/cosh λ near a guess.
fn root(guess: f64, s: f64) -> f64 {
    let mut lambda = guess;
    for _ in 0..16 {
        let cosh = libm::cosh(lambda);
        let value = libm::cos(lambda) - s / cosh;
        let slope = -libm::sin(lambda) + s * libm::tanh(lambda) / cosh;
        lambda -= value / slope;
    }
    lambda
}
