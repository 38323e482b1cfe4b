//! Shapes of beams over the length, ξ from 0 to 1, in the forms of Blevins, *Formulas for Natural Frequency and Mode Shape*, tables 8-1 and 8-16,
//! written so that large hyperbolic functions are not subtracted; and polynomials.

use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::OnceLock;

/// Points of Gauss's quadrature.
const SLICES: usize = 32;

/// A function over the length.
#[derive(Clone, Debug)]
pub(super) enum Shape {
    /// sin(λξ + phase).
    Wave {
        lambda: f64,
        phase: f64,
    },
    /// Even or odd about the middle.
    Free {
        lambda: f64,
        even: bool,
    },
    Clamped {
        lambda: f64,
    },
    /// Σ c_k P_k(2ξ − 1), integrated `order` times from the start.
    Polynomial {
        coefficients: Vec<f64>,
        order: usize,
    },
}

impl Shape {
    /// The derivative of an order by ξ.
    pub fn at(&self, xi: f64, order: usize) -> f64 {
        let quarter = order as f64 * FRAC_PI_2;
        let is_even = order.is_multiple_of(2);
        let sign = if is_even { 1.0 } else { -1.0 };
        let (value, lambda) = match *self {
            Shape::Polynomial { ref coefficients, order: all } => {
                return integrated(coefficients, xi, all.saturating_sub(order));
            }
            Shape::Wave { lambda, phase } => ((lambda * xi + phase + quarter).sin(), lambda),
            // cos λs/cos(λ/2) + cosh λs/cosh(λ/2) or with sines, s from the middle; 2 at the start.
            Shape::Free { lambda, even } => {
                let (s, half) = (lambda * (xi - 0.5), 0.5 * lambda);
                let hyperbolic = if even == is_even { s.cosh() } else { s.sinh() };
                let value = if even {
                    (s + FRAC_PI_2 + quarter).sin() / half.cos() + hyperbolic / half.cosh()
                } else {
                    -(s + quarter).sin() / half.sin() - hyperbolic / half.sinh()
                };
                (value, lambda)
            }
            // (cosh λ(1 − ξ) + cos λ cosh λξ + sin λ sinh λξ)/(cosh λ + cos λ) − cos λξ + σ sin λξ.
            Shape::Clamped { lambda } => {
                let (sinh, cosh, sin, cos) = (lambda.sinh(), lambda.cosh(), lambda.sin(), lambda.cos());
                let (near, far) = (lambda * xi, lambda * (1.0 - xi));
                let [even, odd, back] = if is_even {
                    [near.cosh(), near.sinh(), far.cosh()]
                } else {
                    [near.sinh(), near.cosh(), far.sinh()]
                };
                let hyperbolic = (sign * back + cos * even + sin * odd) / (cosh + cos);
                let sigma = (sinh - sin) / (cosh + cos);
                let value = hyperbolic - (near + FRAC_PI_2 + quarter).sin() + sigma * (near + quarter).sin();
                (value, lambda)
            }
        };
        lambda.powi(order as i32) * value
    }
}

/// cos λ cosh λ = s, by halving.
pub(super) fn root(guess: f64, s: f64) -> f64 {
    let value = |x: f64| x.cos() - s / x.cosh();
    let (mut low, mut high) = (guess - 0.5, guess + 0.5);
    for _ in 0..100 {
        let half = 0.5 * (low + high);
        if value(low) * value(half) > 0.0 { low = half } else { high = half }
    }
    0.5 * (low + high)
}

/// Σ c_k P_k(2ξ − 1) integrated from the start none, one or two times, ∫ (ξ − s)^(times − 1) f(s) ds after Cauchy.
fn integrated(coefficients: &[f64], xi: f64, times: usize) -> f64 {
    let sum = |at: f64| {
        let (x, mut before, mut legendre, mut sum) = (2.0 * at - 1.0, 0.0, 1.0, 0.0);
        for (k, coefficient) in coefficients.iter().enumerate() {
            sum += coefficient * legendre;
            let k = k as f64;
            (before, legendre) = (legendre, ((2.0 * k + 1.0) * x * legendre - k * before) / (k + 1.0));
        }
        sum
    };
    match times {
        0 => sum(xi),
        1 => slices().iter().map(|(s, weight)| xi * weight * sum(xi * s)).sum(),
        _ => slices().iter().map(|(s, weight)| xi * xi * weight * (1.0 - s) * sum(xi * s)).sum(),
    }
}

/// Polynomials that vanish at the start with all derivatives below `order`, across to one another in ∫N² = 1 and in ∫ of the square of
/// that derivative, the slowest first, positive at the end: one-sided rotations (Hestenes) of their values at the slices make these orthogonal.
pub(super) fn polynomials(count: usize, order: usize) -> Vec<Shape> {
    let rule = slices();
    let mut coefficients: Vec<Vec<f64>> = (0..count)
        .map(|k| (0..count).map(|at| if at == k { (2.0 * k as f64 + 1.0).sqrt() } else { 0.0 }).collect())
        .collect();
    let values = |row: &Vec<f64>| -> Vec<f64> {
        rule.iter().map(|(at, weight)| weight.sqrt() * integrated(row, *at, order)).collect()
    };
    let product = |a: &[f64], b: &[f64]| -> f64 { a.iter().zip(b).map(|(a, b)| a * b).sum() };
    let mut columns: Vec<Vec<f64>> = coefficients.iter().map(values).collect();
    for _ in 0..40 {
        for p in 0..count {
            for q in p + 1..count {
                let off = product(&columns[p], &columns[q]);
                let (own, other) = (product(&columns[p], &columns[p]), product(&columns[q], &columns[q]));
                if off.abs() <= 1e-16 * (own * other).sqrt() {
                    continue;
                }
                let angle = 0.5 * (2.0 * off).atan2(own - other);
                let (sin, cos) = angle.sin_cos();
                for rows in [&mut columns, &mut coefficients] {
                    for k in 0..rows[p].len() {
                        let (a, b) = (rows[p][k], rows[q][k]);
                        (rows[p][k], rows[q][k]) = (cos * a + sin * b, cos * b - sin * a);
                    }
                }
            }
        }
    }
    let mut found: Vec<(f64, Vec<f64>)> =
        columns.iter().map(|column| product(column, column)).zip(coefficients).collect();
    found.sort_by(|one, other| other.0.total_cmp(&one.0));
    let scaled = |(square, mut coefficients): (f64, Vec<f64>)| {
        let sign = integrated(&coefficients, 1.0, order).signum();
        coefficients.iter_mut().for_each(|entry| *entry *= sign / square.sqrt());
        Shape::Polynomial { coefficients, order }
    };
    found.into_iter().map(scaled).collect()
}

/// The rule of [`SLICES`] points, made once.
pub(super) fn slices() -> &'static [(f64, f64)] {
    static RULE: OnceLock<Vec<(f64, f64)>> = OnceLock::new();
    RULE.get_or_init(|| gauss(SLICES))
}

/// Places in [0, 1] and weights: roots of Legendre's polynomial by Newton's iteration.
fn gauss(n: usize) -> Vec<(f64, f64)> {
    let legendre = |x: f64| {
        let (mut before, mut value) = (1.0, x);
        for k in 2..=n {
            let k = k as f64;
            (before, value) = (value, ((2.0 * k - 1.0) * x * value - (k - 1.0) * before) / k);
        }
        (value, n as f64 * (before - x * value) / (1.0 - x * x))
    };
    let point = |k: usize| {
        let mut x = (PI * (k as f64 + 0.75) / (n as f64 + 0.5)).cos();
        for _ in 0..8 {
            let (value, slope) = legendre(x);
            x -= value / slope;
        }
        let slope = legendre(x).1;
        (0.5 * (1.0 + x), 1.0 / ((1.0 - x * x) * slope * slope))
    };
    (0..n).map(point).collect()
}
