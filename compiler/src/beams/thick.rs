//! Timoshenko's beam: sections shear, so that they turn by ψ and not with the slope N′ of the axis, and have a rotary inertia of their own.
//!
//! In ξ = x/L, with r² = I/(A L²), s² = E I/(κ G A L²) and b² = ρ A L⁴ ω²/(E I), modes solve
//!   N″ − ψ′ + b² s² N = 0,  ψ″ + (N′ − ψ)/s² + b² r² ψ = 0.
//! Below the cut-off b r s = 1 they are sums of cos βξ, sin βξ, e^(−αξ), e^(αξ), where β² and −α² are the roots of
//!   z² − b² (r² + s²) z − b² (1 − b² r² s²) = 0.
//! ψ is (B/β) sin βξ turned by a quarter for the one kind, with B = β² − b² s², and ±(A/α) e^(±αξ), A = α² + b² s², for the other. Ends are free of
//! moments ψ′ and of shear N′ − ψ, clamped with N = ψ = 0, on hinges with N = ψ′ = 0 (Timoshenko, Phil. Mag. 41, 1921; Huang,
//! J. Appl. Mech. 28, 1961). Modes are across to one another in ∫ N_j N_k + r² L² ∫ ψ_j ψ_k.

use super::shape::{Shape, Wave};
use super::{Mode, Shapes, Slender, Way, gauss};
use std::f64::consts::PI;

/// Steps in β in which sign changes are looked for: roots are about π apart.
const STEP: f64 = PI / 64.0;
/// β from which on: the first of all, of a cantilever, is below 1.88, and of thick ones not below this.
const FROM: f64 = 0.1;

/// What a section adds for one way of bending.
#[derive(Clone, Copy, Debug)]
pub struct Thick {
    /// I/A, m².
    pub gyration: f64,
    /// E/(κ G).
    pub softness: f64,
}

/// Modes that were asked for and are above the cut-off, where sections shear to and fro by themselves.
#[derive(Clone, Copy, Debug)]
pub struct Beyond {
    pub way: Way,
    /// How many are below it.
    pub below: usize,
}

/// What turns with the sections, by the mass: ½ m (r_g² ω² + 2 ω Σ first ṗ + Σ second ṗ ṗ) about the axis across each way.
#[derive(Clone, Debug)]
pub struct Turning {
    /// I/A about y and about z, m².
    pub about_y: f64,
    pub about_z: f64,
    /// r_g² times the mean of ψ, m.
    pub first: Vec<f64>,
    /// r_g² times the mean of ψ_j ψ_k, of modes of one way.
    pub second: Vec<Vec<f64>>,
}

/// A mode by its numbers.
#[derive(Clone, Copy, Debug)]
struct Numbers {
    beta: f64,
    alpha: f64,
    /// b².
    square: f64,
    /// A and B.
    falling: f64,
    waving: f64,
}

impl Thick {
    fn numbers(&self, length: f64, beta: f64) -> Numbers {
        let r2 = self.gyration / (length * length);
        let s2 = r2 * self.softness;
        let p = 1.0 + beta * beta * (r2 + s2);
        let square = 2.0 * beta.powi(4) / (p + (p * p - 4.0 * r2 * s2 * beta.powi(4)).sqrt());
        let alpha = (square * (1.0 - square * r2 * s2)).max(0.0).sqrt() / beta;
        let (falling, waving) = (alpha * alpha + square * s2, beta * beta - square * s2);
        Numbers { beta, alpha, square, falling, waving }
    }

    /// β where b r s = 1.
    fn cut_off(&self, length: f64) -> f64 {
        length * ((1.0 + 1.0 / self.softness) / self.gyration).sqrt()
    }

    /// β of the first modes, as far as they are below the cut-off.
    fn roots(&self, length: f64, count: usize, value: impl Fn(&Numbers) -> f64) -> Vec<f64> {
        let at = |beta: f64| value(&self.numbers(length, beta));
        let (end, mut low, mut roots) = (self.cut_off(length), FROM, Vec::new());
        while roots.len() < count && low + STEP < end {
            let high = low + STEP;
            if at(low) * at(high) <= 0.0 {
                roots.push(halved(&at, low, high));
            }
            low = high;
        }
        roots
    }

    /// Modes of one way of bending.
    pub(super) fn modes(
        &self,
        shapes: Shapes,
        length: f64,
        way: Way,
        count: usize,
    ) -> Result<Vec<Mode>, Beyond> {
        let found: Vec<(Numbers, Wave)> = match shapes {
            Shapes::Free => {
                let [even, odd] = [1, 0].map(|more| (count + more) / 2);
                let even = self.roots(length, even, symmetric).into_iter();
                let odd = self.roots(length, odd, antisymmetric).into_iter();
                let even = even.map(|beta| (beta, true));
                let mut betas: Vec<(f64, bool)> = even.chain(odd.map(|beta| (beta, false))).collect();
                betas.sort_by(|one, other| one.0.total_cmp(&other.0));
                let wave = |(beta, even): (f64, bool)| {
                    let numbers = self.numbers(length, beta);
                    (numbers, free(&numbers, even))
                };
                betas.into_iter().map(wave).collect()
            }
            Shapes::Clamped | Shapes::Static => {
                let betas = self.roots(length, count, cantilever).into_iter();
                let numbers = betas.map(|beta| self.numbers(length, beta));
                numbers.map(|numbers| (numbers, clamped(&numbers))).collect()
            }
            Shapes::Pinned => {
                let numbers = (0..count).map(|k| self.numbers(length, (k as f64 + 1.0) * PI));
                numbers.map(|numbers| (numbers, Wave::sine(numbers.beta))).collect()
            }
        };
        if found.len() < count {
            return Err(Beyond { way, below: found.len() });
        }
        let mode = |(number, (numbers, wave)): (usize, (Numbers, Wave))| {
            // Those of two hinges have waves alone, and α no part, which is not real above the cut-off.
            let falls = if shapes == Shapes::Pinned { 0.0 } else { numbers.falling / numbers.alpha };
            let turn = wave.turning(numbers.waving / numbers.beta, falls);
            let squared = |wave: &Wave| -> f64 {
                gauss::finest().points().map(|(share, weight)| weight * wave.at(share, 0).powi(2)).sum()
            };
            let square = squared(&wave) + self.gyration / (length * length) * squared(&turn);
            // As of slender beams: a mean of 1, and a sine of the amplitude 1 on two hinges.
            let (scale, mean) =
                if shapes == Shapes::Pinned { (1.0, square) } else { (1.0 / square.sqrt(), 1.0) };
            Mode {
                way,
                number,
                shape: Shape::Wave(wave.scaled(scale)),
                turn: Some(Shape::Wave(turn.scaled(scale))),
                stiffness: numbers.square * mean / length.powi(3),
            }
        };
        Ok(found.into_iter().enumerate().map(mode).collect())
    }
}

impl Slender {
    /// Adds what turns with the sections; for beams that bend along y and along z.
    pub(super) fn turning(mut self, thick: [Thick; 2]) -> Self {
        let count = self.modes.len();
        let gyration = |way: Way| thick[usize::from(way == Way::BendingZ)].gyration;
        let (mut first, mut second) = (vec![0.0; count], vec![vec![0.0; count]; count]);
        for (share, weight) in gauss::finest().points() {
            let psi = self.psi(share);
            for j in 0..count {
                let own = weight * gyration(self.modes[j].way) * psi[j];
                first[j] += own;
                for k in (0..count).filter(|k| self.modes[*k].way == self.modes[j].way) {
                    second[j][k] += own * psi[k];
                }
            }
        }
        // What the sums are by the orthogonality and the parity of modes they are to the last digit.
        for j in (0..count).filter(|j| self.modes[*j].way.bends()) {
            if first[j].abs() < 1e-13 * (gyration(self.modes[j].way) * second[j][j]).sqrt() {
                first[j] = 0.0;
            }
            if self.shapes == Shapes::Free {
                first[j] = -self.second[0][1 + j];
            }
            for k in (0..count).filter(|k| *k != j && self.modes[*k].way == self.modes[j].way) {
                second[j][k] = -self.second[1 + j][1 + k];
            }
        }
        let [about_z, about_y] = thick.map(|thick| thick.gyration);
        self.turning = Some(Turning { about_y, about_z, first, second });
        self
    }

    /// By how much each mode of bending turns the section at a part of the length, 1/m.
    fn psi(&self, share: f64) -> Vec<f64> {
        let psi = |mode: &Mode| mode.turn.as_ref().map_or(0.0, |turn| turn.at(share, 0) / self.length);
        self.modes.iter().map(psi).collect()
    }
}

/// Ends without shear and moment, of what is the same from both ends.
fn symmetric(it: &Numbers) -> f64 {
    let (near, far) = (0.5 * it.beta, 0.5 * it.alpha);
    it.falling * libm::sin(near) / it.beta + it.waving * libm::cos(near) * libm::tanh(far) / it.alpha
}

/// Of what has the other sign.
fn antisymmetric(it: &Numbers) -> f64 {
    let (near, far) = (0.5 * it.beta, 0.5 * it.alpha);
    it.falling * libm::tanh(far) * libm::cos(near) / it.beta - it.waving * libm::sin(near) / it.alpha
}

/// 2 + (A/B + B/A) cosh α cos β − (β/α − α/β) sinh α sin β, by cosh α.
fn cantilever(it: &Numbers) -> f64 {
    let Numbers { alpha, beta, falling, waving, .. } = *it;
    let (sin, cos) = (libm::sin(beta), libm::cos(beta));
    2.0 / libm::cosh(alpha) + (falling / waving + waving / falling) * cos
        - (beta / alpha - alpha / beta) * libm::tanh(alpha) * sin
}

/// −(sin(β/2)/β) cosh αη/cosh(α/2) + (tanh(α/2)/α) cos βη with η from the middle, or B sin(β/2) sinh αη/sinh(α/2) + A sin βη, positive at the start.
fn free(it: &Numbers, even: bool) -> Wave {
    let Numbers { alpha, beta, falling, waving, .. } = *it;
    let (sin, cos, small) = (libm::sin(0.5 * beta), libm::cos(0.5 * beta), libm::exp(-alpha));
    let wave = if even {
        let (far, near) = (-sin / beta / (1.0 + small), libm::tanh(0.5 * alpha) / alpha);
        Wave::sum([beta, alpha], [near * cos, near * sin, far, far], Some(1.0))
    } else {
        let (far, near) = (waving * sin / (1.0 - small), falling);
        Wave::sum([beta, alpha], [-near * sin, near * cos, -far, far], Some(-1.0))
    };
    let sign = wave.at(0.0, 0).signum();
    wave.scaled(sign)
}

/// cosh αξ − cos βξ + C (α sinh αξ/A − β sin βξ/B), C = −(A cosh α + B cos β)/(α sinh α + β sin β), where what grows is a small
/// difference.
fn clamped(it: &Numbers) -> Wave {
    let Numbers { alpha, beta, falling, waving, .. } = *it;
    let (sin, cos, small) = (libm::sin(beta), libm::cos(beta), libm::exp(-alpha));
    let below = alpha * libm::sinh(alpha) + beta * sin;
    let c = -(falling * libm::cosh(alpha) + waving * cos) / below;
    let growth = 0.5 * (falling * beta / alpha * sin - waving * cos - falling * small) * alpha
        / falling
        / (below * small);
    Wave::sum([beta, alpha], [-1.0, -c * beta / waving, 0.5 * (1.0 - c * alpha / falling), growth], None)
}

/// Where a function changes its sign, to rounding.
fn halved(value: &impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    let start = value(low);
    for _ in 0..60 {
        let half = 0.5 * (low + high);
        if value(half) * start > 0.0 { low = half } else { high = half }
    }
    0.5 * (low + high)
}
