//! Gauss–Legendre quadrature on [0, 1]; n points are exact for polynomials of degree 2n − 1 (Golub, Welsch, Math. Comp. 23, 1969).

use std::f64::consts::PI;
use std::sync::OnceLock;

/// As many points as integrate the product of two shapes of the highest number to rounding.
const MOST: usize = 64;

/// Points and weights.
#[derive(Clone, Debug)]
pub struct Rule {
    points: Vec<(f64, f64)>,
}

impl Rule {
    /// With n points: the roots of Legendre's polynomial, by Newton's iteration from Tricomi's approximation.
    pub fn new(n: usize) -> Self {
        let mut points = Vec::new();
        for k in 0..n {
            let mut x = libm::cos(PI * (k as f64 + 0.75) / (n as f64 + 0.5));
            let mut slope = 1.0;
            for _ in 0..8 {
                let (value, derivative) = legendre(n, x);
                slope = derivative;
                x -= value / derivative;
            }
            // On [−1, 1] the weight is 2/((1 − x²) P′²).
            points.push((0.5 * (1.0 - x), 1.0 / ((1.0 - x * x) * slope * slope)));
        }
        Rule { points }
    }

    /// Each place between 0 and 1 with its weight; these sum up to 1.
    pub fn points(&self) -> impl Iterator<Item = (f64, f64)> {
        self.points.iter().copied()
    }
}

/// With [`MOST`] points, made once.
pub fn finest() -> &'static Rule {
    static FINEST: OnceLock<Rule> = OnceLock::new();
    FINEST.get_or_init(|| Rule::new(MOST))
}

/// P and P′.
fn legendre(n: usize, x: f64) -> (f64, f64) {
    let (mut before, mut value) = (1.0, x);
    for k in 2..=n {
        let k = k as f64;
        (before, value) = (value, ((2.0 * k - 1.0) * x * value - (k - 1.0) * before) / k);
    }
    (value, n as f64 * (x * value - before) / (x * x - 1.0))
}
