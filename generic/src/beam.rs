//! Beams of the plane: shapes, and M, forces and energies slice by slice. Nothing is integrated over shapes beforehand; each slice is
//! a point mass whose velocity is that of its place on the deformed axis.
//!
//! Shapes in the forms of Blevins, *Formulas for Natural Frequency and Mode Shape*, tables 8-1 and 8-16, written so that large
//! hyperbolic functions are not subtracted.

use crate::kinematics::Frame;
use crate::vector::{V3, dot, plus, times, turned};
use std::f64::consts::{FRAC_PI_2, PI};

/// Points of Gauss's quadrature.
const SLICES: usize = 32;
/// Most modes of a beam, both kinds together.
pub(crate) const MOST: usize = 24;

#[derive(Clone, Debug)]
pub(crate) struct Beam {
    /// m.
    pub length: f64,
    /// x of its start.
    pub start: f64,
    modes: Vec<Mode>,
    slices: Vec<Slice>,
    /// kg.
    mass: f64,
    /// N/m and N s/m of each mode.
    stiffness: Vec<f64>,
    damping: Vec<f64>,
}

/// What a definition says of a beam.
pub(crate) struct Made<'a> {
    pub shapes: &'a str,
    pub length: f64,
    pub axial: usize,
    pub bending: usize,
    pub mass: f64,
    /// EA and EI.
    pub rigidity: [f64; 2],
    pub damping_ratio: f64,
}

#[derive(Clone, Debug)]
struct Mode {
    name: String,
    /// 0 along the axis, 1 across.
    axis: usize,
    shape: Shape,
}

#[derive(Clone, Copy, Debug)]
enum Shape {
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
}

#[derive(Clone, Debug)]
struct Slice {
    x: f64,
    /// Of the mass.
    share: f64,
    values: Vec<f64>,
}

impl Beam {
    /// `None` of shapes that are not known or too many modes.
    pub fn new(made: &Made) -> Option<Self> {
        let Made { shapes, length, axial, bending, .. } = *made;
        if axial + bending > MOST || !matches!(shapes, "free" | "clamped" | "pinned") {
            return None;
        }
        let mut modes = Vec::new();
        for number in 0..axial {
            let k = number as f64;
            let shape = match shapes {
                "free" => Shape::Wave { lambda: (k + 1.0) * PI, phase: FRAC_PI_2 },
                _ => Shape::Wave { lambda: (2.0 * k + 1.0) * FRAC_PI_2, phase: 0.0 },
            };
            modes.push(Mode { name: format!("axial[{number}]"), axis: 0, shape });
        }
        for number in 0..bending {
            let k = number as f64;
            let shape = match shapes {
                "free" => Shape::Free { lambda: root((k + 1.5) * PI, 1.0), even: number.is_multiple_of(2) },
                "clamped" => Shape::Clamped { lambda: root((k + 0.5) * PI, -1.0) },
                _ => Shape::Wave { lambda: (k + 1.0) * PI, phase: 0.0 },
            };
            modes.push(Mode { name: format!("bending[{number}]"), axis: 1, shape });
        }
        let start = if shapes == "free" { -0.5 * length } else { 0.0 };
        let mut beam = Beam {
            length,
            start,
            modes,
            slices: Vec::new(),
            mass: made.mass,
            stiffness: Vec::new(),
            damping: Vec::new(),
        };
        for (share_of_length, share) in gauss(SLICES) {
            let x = start + length * share_of_length;
            let values = (0..beam.modes.len()).map(|mode| beam.value(mode, x)).collect();
            beam.slices.push(Slice { x, share, values });
        }
        for (index, mode) in beam.modes.iter().enumerate() {
            let order = mode.axis + 1;
            let bent = |slice: &Slice| (beam.derivative(index, slice.x, order)).powi(2);
            let integral =
                |f: &dyn Fn(&Slice) -> f64| -> f64 { beam.slices.iter().map(|it| it.share * f(it)).sum() };
            let stiffness = made.rigidity[mode.axis] * length * integral(&bent);
            let moved = made.mass * integral(&|slice: &Slice| slice.values[index].powi(2));
            beam.stiffness.push(stiffness);
            beam.damping.push(2.0 * made.damping_ratio * (stiffness * moved).sqrt());
        }
        Some(beam)
    }

    /// Whether its frame is that of its mean motion.
    pub fn is_free(&self) -> bool {
        self.start < 0.0
    }

    pub fn count(&self) -> usize {
        self.modes.len()
    }

    /// Which mode has a name, `bending[0]`.
    pub fn mode(&self, name: &str) -> Option<usize> {
        self.modes.iter().position(|mode| mode.name == name)
    }

    /// N of a mode at x.
    pub fn value(&self, mode: usize, x: f64) -> f64 {
        self.derivative(mode, x, 0)
    }

    /// N′ of a mode at x, by which it turns the section there, 1/m.
    pub fn slope(&self, mode: usize, x: f64) -> f64 {
        if self.modes[mode].axis == 0 { 0.0 } else { self.derivative(mode, x, 1) }
    }

    /// Along which axis of the frame a mode moves.
    pub fn axis(&self, mode: usize) -> usize {
        self.modes[mode].axis
    }

    fn derivative(&self, mode: usize, x: f64, order: usize) -> f64 {
        let xi = (x - self.start) / self.length;
        self.modes[mode].shape.at(xi, order) / self.length.powi(order as i32)
    }

    /// Where the axis at a slice is, from the frame's origin in its axes, and how fast it moves there.
    fn at(&self, slice: &Slice, modal: &[[f64; 2]]) -> [V3; 2] {
        let (mut place, mut rate) = ([slice.x, 0.0, 0.0], [0.0; 3]);
        for ((mode, value), [p, p_rate]) in self.modes.iter().zip(&slice.values).zip(modal) {
            place[mode.axis] += value * p;
            rate[mode.axis] += value * p_rate;
        }
        [place, rate]
    }

    /// The columns of a slice's velocity: x, y, ω, then the modes.
    fn columns(&self, frame: &Frame, slice: &Slice, arm: V3, columns: &mut [V3; 3 + MOST]) {
        columns[0] = [1.0, 0.0, 0.0];
        columns[1] = [0.0, 1.0, 0.0];
        columns[2] = [-arm[1], arm[0], 0.0];
        for (column, (mode, value)) in columns[3..].iter_mut().zip(self.modes.iter().zip(&slice.values)) {
            let k = mode.axis;
            *column = times(*value, [frame.axes[0][k], frame.axes[1][k], 0.0]);
        }
    }

    /// M of the body, full, row by row.
    pub fn mass(&self, frame: &Frame, modal: &[[f64; 2]], mut put: impl FnMut(usize, usize, f64)) {
        let width = 3 + self.modes.len();
        for slice in &self.slices {
            let mut columns = [[0.0; 3]; 3 + MOST];
            let [place, _] = self.at(slice, modal);
            self.columns(frame, slice, turned(&frame.axes, place), &mut columns);
            let mass = slice.share * self.mass;
            for i in 0..width {
                for j in 0..width {
                    put(i, j, mass * dot(columns[i], columns[j]));
                }
            }
        }
    }

    /// Gravity, elasticity, damping, and what the slices' accelerations at v̇ = 0 take.
    pub fn forces(&self, frame: &Frame, modal: &[[f64; 2]], gravity: V3, forces: &mut [f64]) {
        let width = 3 + self.modes.len();
        let omega = frame.spin[2];
        for slice in &self.slices {
            let mut columns = [[0.0; 3]; 3 + MOST];
            let [place, rate] = self.at(slice, modal);
            let (arm, moved) = (turned(&frame.axes, place), turned(&frame.axes, rate));
            self.columns(frame, slice, arm, &mut columns);
            // −ω² A d + 2 ω × A ḋ.
            let bias = plus(times(-omega * omega, arm), times(2.0 * omega, [-moved[1], moved[0], 0.0]));
            let pull = times(slice.share * self.mass, plus(gravity, times(-1.0, bias)));
            for (force, column) in forces[..width].iter_mut().zip(&columns) {
                *force += dot(*column, pull);
            }
        }
        for (mode, [p, rate]) in modal.iter().enumerate() {
            forces[3 + mode] -= self.stiffness[mode] * p + self.damping[mode] * rate;
        }
    }

    pub fn kinetic(&self, frame: &Frame, modal: &[[f64; 2]]) -> f64 {
        let of = self.slices.iter().map(|slice| {
            let [place, rate] = self.at(slice, modal);
            let arm = turned(&frame.axes, place);
            let swept = [-frame.spin[2] * arm[1], frame.spin[2] * arm[0], 0.0];
            let velocity = plus(frame.velocity, plus(swept, turned(&frame.axes, rate)));
            0.5 * slice.share * self.mass * dot(velocity, velocity)
        });
        of.sum()
    }

    pub fn potential(&self, frame: &Frame, modal: &[[f64; 2]], gravity: V3) -> f64 {
        let weights = self.slices.iter().map(|slice| {
            let [place, _] = self.at(slice, modal);
            -slice.share * self.mass * dot(gravity, plus(frame.position, turned(&frame.axes, place)))
        });
        let stored = self.stiffness.iter().zip(modal).map(|(k, [p, _])| 0.5 * k * p * p);
        weights.chain(stored).sum()
    }
}

impl Shape {
    /// The derivative of an order by ξ.
    fn at(self, xi: f64, order: usize) -> f64 {
        let quarter = order as f64 * FRAC_PI_2;
        let is_even = order.is_multiple_of(2);
        let sign = if is_even { 1.0 } else { -1.0 };
        let (value, lambda) = match self {
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
fn root(guess: f64, s: f64) -> f64 {
    let value = |x: f64| x.cos() - s / x.cosh();
    let (mut low, mut high) = (guess - 0.5, guess + 0.5);
    for _ in 0..100 {
        let half = 0.5 * (low + high);
        if value(low) * value(half) > 0.0 { low = half } else { high = half }
    }
    0.5 * (low + high)
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
