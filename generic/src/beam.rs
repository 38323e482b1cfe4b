//! Beams of the plane: shapes, and M, forces and energies slice by slice. Nothing is integrated over shapes beforehand; each slice is
//! a point mass whose velocity is that of its place on the deformed axis, drawn in by bending or not.

mod shape;

use crate::kinematics::Frame;
use crate::vector::{V3, dot, plus, times, turned};
use shape::{Shape, polynomials, root, slices};
use std::f64::consts::{FRAC_PI_2, PI};

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
    /// Whether bending draws places in.
    stiffens: bool,
    /// ∫ N_j′ N_k′ from the start, meant over the length, row by row: the frame of free shapes stays in the centre of mass.
    drawn: Vec<f64>,
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
    pub stiffens: bool,
    /// Whether the axial functions are polynomials whatever the others are.
    pub quadratic: bool,
}

#[derive(Clone, Debug)]
struct Mode {
    name: String,
    /// 0 along the axis, 1 across.
    axis: usize,
    shape: Shape,
}

#[derive(Clone, Debug)]
struct Slice {
    x: f64,
    /// Of the mass.
    share: f64,
    values: Vec<f64>,
    /// Γ at x, row by row.
    gammas: Vec<f64>,
}

/// What a place of a slice does: from the frame's origin in world axes, the columns x, y, ω and modes of its velocity, its velocity, its
/// acceleration at v̇ = 0.
struct Moved {
    arm: V3,
    columns: [V3; 3 + MOST],
    velocity: V3,
    bias: V3,
}

impl Beam {
    /// `None` of shapes that are not known or too many modes.
    pub fn new(made: &Made) -> Option<Self> {
        let Made { shapes, length, axial, bending, .. } = *made;
        if axial + bending > MOST || !matches!(shapes, "free" | "clamped" | "pinned" | "static") {
            return None;
        }
        let mut modes = Vec::new();
        let stretched = if made.quadratic || shapes == "static" { polynomials(axial, 1) } else { Vec::new() };
        let bent = if shapes == "static" { polynomials(bending, 2) } else { Vec::new() };
        for number in 0..axial {
            let k = number as f64;
            let shape = match (stretched.get(number), shapes) {
                (Some(shape), _) => shape.clone(),
                (None, "free") => Shape::Wave { lambda: (k + 1.0) * PI, phase: FRAC_PI_2 },
                _ => Shape::Wave { lambda: (2.0 * k + 1.0) * FRAC_PI_2, phase: 0.0 },
            };
            modes.push(Mode { name: format!("axial[{number}]"), axis: 0, shape });
        }
        for number in 0..bending {
            let k = number as f64;
            let shape = match (bent.get(number), shapes) {
                (Some(shape), _) => shape.clone(),
                (None, "free") => {
                    Shape::Free { lambda: root((k + 1.5) * PI, 1.0), even: number.is_multiple_of(2) }
                }
                (None, "clamped") => Shape::Clamped { lambda: root((k + 0.5) * PI, -1.0) },
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
            stiffens: made.stiffens,
            drawn: Vec::new(),
            mass: made.mass,
            stiffness: Vec::new(),
            damping: Vec::new(),
        };
        for (share_of_length, share) in slices().iter().copied() {
            let x = start + length * share_of_length;
            let values = (0..beam.modes.len()).map(|mode| beam.value(mode, x)).collect();
            let gammas = beam.gammas(x);
            beam.slices.push(Slice { x, share, values, gammas });
        }
        if beam.is_free() {
            let count = beam.slices[0].gammas.len();
            let mean = |at: usize| beam.slices.iter().map(|slice| slice.share * slice.gammas[at]).sum();
            beam.drawn = (0..count).map(mean).collect();
            for slice in &mut beam.slices {
                slice.gammas.iter_mut().zip(&beam.drawn).for_each(|(gamma, mean)| *gamma -= mean);
            }
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

    /// Γ_jk = ∫ N_j′ N_k′ up to x, row by row; nothing of a beam whose places move across alone.
    pub fn gammas(&self, x: f64) -> Vec<f64> {
        let count = if self.stiffens { self.modes.len() } else { 0 };
        let span = x - self.start;
        let mut gammas = vec![0.0; count * count];
        for (at, weight) in slices().iter().filter(|_| count > 0) {
            let slopes: Vec<f64> = (0..count).map(|mode| self.slope(mode, self.start + span * at)).collect();
            for (k, gamma) in gammas.iter_mut().enumerate() {
                *gamma += span * weight * slopes[k / count] * slopes[k % count];
            }
        }
        gammas.iter_mut().zip(&self.drawn).for_each(|(gamma, mean)| *gamma -= mean);
        gammas
    }

    /// By how much bending draws a place in, how fast, and faster by itself, along the axis: −½ pᵀ Γ p, −pᵀ Γ ṗ, −ṗᵀ Γ ṗ; and the
    /// columns −Γ p of the modes.
    pub fn drawn_in(&self, gammas: &[f64], modal: &[[f64; 2]]) -> ([f64; 3], [f64; MOST]) {
        let (mut drawn, mut columns, count) = ([0.0; 3], [0.0; MOST], self.modes.len());
        for (k, gamma) in gammas.iter().enumerate() {
            let ([p, p_rate], [other, other_rate]) = (modal[k / count], modal[k % count]);
            columns[k / count] -= gamma * other;
            drawn[0] -= 0.5 * gamma * p * other;
            drawn[1] -= gamma * p_rate * other;
            drawn[2] -= gamma * p_rate * other_rate;
        }
        (drawn, columns)
    }

    /// A slice in motion: its columns and its acceleration at v̇ = 0.
    fn moved(&self, frame: &Frame, slice: &Slice, modal: &[[f64; 2]]) -> Moved {
        let ([drawn, drawn_rate, faster], along) = self.drawn_in(&slice.gammas, modal);
        let (mut bent, mut rate) = ([slice.x + drawn, 0.0, 0.0], [drawn_rate, 0.0, 0.0]);
        for ((mode, value), [p, p_rate]) in self.modes.iter().zip(&slice.values).zip(modal) {
            bent[mode.axis] += value * p;
            rate[mode.axis] += value * p_rate;
        }
        let (arm, rate) = (turned(&frame.axes, bent), turned(&frame.axes, rate));
        let mut columns = [[0.0; 3]; 3 + MOST];
        (columns[0], columns[1]) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]);
        columns[2] = [-arm[1], arm[0], 0.0];
        for ((column, mode), (value, along)) in
            columns[3..].iter_mut().zip(&self.modes).zip(slice.values.iter().zip(along))
        {
            let mut local = [along, 0.0, 0.0];
            local[mode.axis] += value;
            *column = turned(&frame.axes, local);
        }
        let omega = frame.spin[2];
        // −ω² A d + 2 ω × A ḋ + A d̈.
        let turning = plus(times(-omega * omega, arm), times(2.0 * omega, [-rate[1], rate[0], 0.0]));
        let swept = plus(times(omega, [-arm[1], arm[0], 0.0]), rate);
        let bias = plus(turning, turned(&frame.axes, [faster, 0.0, 0.0]));
        Moved { arm, columns, velocity: plus(frame.velocity, swept), bias }
    }

    /// M of the body, full, row by row.
    pub fn mass(&self, frame: &Frame, modal: &[[f64; 2]], mut put: impl FnMut(usize, usize, f64)) {
        let width = 3 + self.modes.len();
        for slice in &self.slices {
            let Moved { columns, .. } = self.moved(frame, slice, modal);
            for (i, one) in columns[..width].iter().enumerate() {
                for (j, other) in columns[..width].iter().enumerate() {
                    put(i, j, slice.share * self.mass * dot(*one, *other));
                }
            }
        }
    }

    /// Gravity, elasticity, damping, and what the slices' accelerations at v̇ = 0 take.
    pub fn forces(&self, frame: &Frame, modal: &[[f64; 2]], gravity: V3, forces: &mut [f64]) {
        for slice in &self.slices {
            let Moved { columns, bias, .. } = self.moved(frame, slice, modal);
            let pull = times(slice.share * self.mass, plus(gravity, times(-1.0, bias)));
            for (force, column) in forces[..3 + self.modes.len()].iter_mut().zip(&columns) {
                *force += dot(*column, pull);
            }
        }
        for (mode, [p, rate]) in modal.iter().enumerate() {
            forces[3 + mode] -= self.stiffness[mode] * p + self.damping[mode] * rate;
        }
    }

    pub fn kinetic(&self, frame: &Frame, modal: &[[f64; 2]]) -> f64 {
        let of = self.slices.iter().map(|slice| {
            let Moved { velocity, .. } = self.moved(frame, slice, modal);
            0.5 * slice.share * self.mass * dot(velocity, velocity)
        });
        of.sum()
    }

    pub fn potential(&self, frame: &Frame, modal: &[[f64; 2]], gravity: V3) -> f64 {
        let weights = self.slices.iter().map(|slice| {
            let Moved { arm, .. } = self.moved(frame, slice, modal);
            -slice.share * self.mass * dot(gravity, plus(frame.position, arm))
        });
        let stored = self.stiffness.iter().zip(modal).map(|(k, [p, _])| 0.5 * k * p * p);
        weights.chain(stored).sum()
    }
}
