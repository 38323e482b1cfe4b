//! Shapes over the length as a sum a cos λξ + b sin λξ + c e^(−μξ) + d e^(μ(ξ − 1)) with ξ from 0 to 1, μ = λ of slender beams: no hyperbolic functions, whose
//! differences lose all digits for high modes. Or polynomials.

use super::polynomial::Polynomial;

/// A function over the length.
#[derive(Clone, Debug)]
pub enum Shape {
    Wave(Wave),
    Polynomial(Polynomial),
}

impl Shape {
    /// The derivative of an order by ξ, of polynomials up to that of the stiffness; what is zero but for rounding, as at a clamp, is zero, and
    /// the value a whole number, as at the ends of waves.
    pub fn at(&self, share: f64, order: usize) -> f64 {
        match self {
            Shape::Wave(wave) => wave.at(share, order),
            Shape::Polynomial(polynomial) => polynomial.at(share, order),
        }
    }
}

/// Such a sum.
#[derive(Clone, Copy, Debug)]
pub struct Wave {
    lambda: f64,
    /// μ/λ.
    ratio: f64,
    cosine: f64,
    sine: f64,
    decay: f64,
    growth: f64,
    /// 1 of what is the same from both ends, −1 of what has the other sign, else nothing.
    mirrored: Option<f64>,
}

impl Wave {
    /// cos λξ.
    pub fn cosine(lambda: f64) -> Self {
        Wave { lambda, ratio: 1.0, cosine: 1.0, sine: 0.0, decay: 0.0, growth: 0.0, mirrored: None }
    }

    /// sin λξ.
    pub fn sine(lambda: f64) -> Self {
        Wave { lambda, ratio: 1.0, cosine: 0.0, sine: 1.0, decay: 0.0, growth: 0.0, mirrored: None }
    }

    /// cosh λξ + cos λξ − σ (sinh λξ + sin λξ), σ = (cosh λ − cos λ)/(sinh λ − sin λ). The mean of its square is 1.
    pub fn free_free(lambda: f64) -> Self {
        let (sin, cos, small) = (libm::sin(lambda), libm::cos(lambda), libm::exp(-lambda));
        let below = libm::sinh(lambda) - sin;
        let sigma = (libm::cosh(lambda) - cos) / below;
        // (1 − σ) e^λ/2.
        let growth = 0.5 * (cos - sin - small) / (below * small);
        let mirrored = Some(-sin.signum());
        Wave { lambda, ratio: 1.0, cosine: 1.0, sine: -sigma, decay: 0.5 * (1.0 + sigma), growth, mirrored }
    }

    /// cosh λξ − cos λξ − σ (sinh λξ − sin λξ), σ = (sinh λ − sin λ)/(cosh λ + cos λ). The mean of its square is 1.
    pub fn clamped_free(lambda: f64) -> Self {
        let (sin, cos, small) = (libm::sin(lambda), libm::cos(lambda), libm::exp(-lambda));
        let below = libm::cosh(lambda) + cos;
        let sigma = (libm::sinh(lambda) - sin) / below;
        let growth = 0.5 * (cos + sin + small) / (below * small);
        Wave {
            lambda,
            ratio: 1.0,
            cosine: -1.0,
            sine: sigma,
            decay: 0.5 * (1.0 + sigma),
            growth,
            mirrored: None,
        }
    }

    /// Of λ and μ, and a, b, c, d.
    pub fn sum(
        [lambda, mu]: [f64; 2],
        [cosine, sine, decay, growth]: [f64; 4],
        mirrored: Option<f64>,
    ) -> Self {
        Wave { lambda, ratio: mu / lambda, cosine, sine, decay, growth, mirrored }
    }

    /// Its parts differentiated by ξ, where one kind has `waves` in place of λ and the other `falls` in place of μ.
    pub fn turning(&self, waves: f64, falls: f64) -> Self {
        Wave {
            cosine: waves * self.sine,
            sine: -waves * self.cosine,
            decay: -falls * self.decay,
            growth: falls * self.growth,
            mirrored: self.mirrored.map(|sign| -sign),
            ..*self
        }
    }

    pub fn scaled(&self, by: f64) -> Self {
        Wave {
            cosine: by * self.cosine,
            sine: by * self.sine,
            decay: by * self.decay,
            growth: by * self.growth,
            ..*self
        }
    }

    pub fn at(&self, share: f64, order: usize) -> f64 {
        let Wave { lambda, ratio, cosine, sine, decay, growth, mirrored } = *self;
        let sign = if order.is_multiple_of(2) { 1.0 } else { -1.0 };
        // To the last digit, so that what one end has and the other takes away is nothing.
        if let Some(mirrored) = mirrored
            && share > 0.5
        {
            return sign * mirrored * self.at(1.0 - share, order);
        }
        let (sin, cos) = (libm::sin(lambda * share), libm::cos(lambda * share));
        let (sin, cos) = match order % 4 {
            0 => (sin, cos),
            1 => (cos, -sin),
            2 => (-sin, -cos),
            _ => (-cos, sin),
        };
        let mu = ratio * lambda;
        let falls = sign * decay * libm::exp(-mu * share);
        let grows = growth * libm::exp(mu * (share - 1.0));
        let sum = match ratio == 1.0 {
            true => cosine * cos + sine * sin + falls + grows,
            false => cosine * cos + sine * sin + ratio.powi(order as i32) * (falls + grows),
        };
        // The ends of these shapes are at 0, ±1 or ±2.
        let whole = sum.round();
        let is_whole = whole == 0.0 || order == 0;
        lambda.powi(order as i32) * if is_whole && (sum - whole).abs() < 1e-13 { whole } else { sum }
    }
}
