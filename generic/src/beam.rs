//! Beams: shapes, and M, forces and energies slice by slice. Nothing is integrated over shapes beforehand; each slice is
//! a point mass whose velocity is that of its place on the deformed axis, drawn in by bending or not, and a disc that turns about the axis,
//! or with shear about all axes.

mod shape;
mod thick;

use crate::kinematics::Frame;
use crate::vector::*;
use shape::{Shape, polynomials, root, slices};
use std::f64::consts::{FRAC_PI_2, PI};
use thick::Sheared;

/// Most modes of a beam, all kinds together.
pub(crate) const MOST: usize = 48;

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
    pub spatial: bool,
    /// What its sections turn with about each axis: in space about its own, kg m².
    spin: V3,
    /// N/m and N s/m of each mode.
    stiffness: Vec<f64>,
    damping: Vec<f64>,
}

/// What a definition says of a beam.
pub(crate) struct Made<'a> {
    pub shapes: &'a str,
    pub length: f64,
    pub axial: usize,
    /// Along y and along z.
    pub bending: [usize; 2],
    pub torsion: usize,
    pub spatial: bool,
    pub mass: f64,
    /// EA, EI of bending along y and along z, and G J_t.
    pub rigidity: [f64; 4],
    /// The square of the section's radius of gyration about the axis, m².
    pub polar: f64,
    pub damping_ratio: f64,
    pub stiffens: bool,
    /// Whether the axial functions are polynomials whatever the others are.
    pub quadratic: bool,
    /// Of sections that shear: I/A about z and about y, m², and E/(κ G).
    pub thick: Option<([f64; 2], f64)>,
}

#[derive(Clone, Debug)]
struct Mode {
    name: String,
    /// Along which axis of the frame: x is its own. Of torsion it moves nothing.
    axis: usize,
    twists: bool,
    shape: Shape,
    /// In place of the shape where sections shear.
    sheared: Option<Sheared>,
}

#[derive(Clone, Debug)]
struct Slice {
    x: f64,
    /// Of the mass.
    share: f64,
    values: Vec<f64>,
    /// How each mode turns the section as far as it has a moment of inertia.
    turns: Vec<V3>,
    /// Γ at x, row by row.
    gammas: Vec<f64>,
}

/// How a section is turned against the body, in the body's axes: the rotation, what the rate of each mode adds to its ω, ω, and ω̇ at v̇ = 0.
pub(crate) struct Turning {
    pub matrix: M3,
    pub columns: [V3; MOST],
    pub rate: V3,
    pub faster: V3,
}

/// What a place of a slice does: from the frame's origin in world axes, the columns of the frame and the modes of its velocity, its
/// velocity, its acceleration at v̇ = 0.
struct Moved {
    arm: V3,
    columns: [V3; 6 + MOST],
    velocity: V3,
    bias: V3,
}

impl Beam {
    /// `None` of shapes that are not known or too many modes.
    pub fn new(made: &Made) -> Option<Self> {
        let Made { shapes, length, axial, bending, torsion, .. } = *made;
        if axial + bending[0] + bending[1] + torsion > MOST
            || !matches!(shapes, "free" | "clamped" | "pinned" | "static")
        {
            return None;
        }
        let mut modes = Vec::new();
        let stretched = if made.quadratic || shapes == "static" { polynomials(axial, 1) } else { Vec::new() };
        let twisted = if shapes == "static" { polynomials(torsion, 1) } else { Vec::new() };
        // Those of a bar and of a shaft, which have one equation.
        let wave = |polynomial: Option<&Shape>, number: usize| match (polynomial, shapes) {
            (Some(shape), _) => shape.clone(),
            (None, "free") => Shape::Wave { lambda: (number as f64 + 1.0) * PI, phase: FRAC_PI_2 },
            _ => Shape::Wave { lambda: (2.0 * number as f64 + 1.0) * FRAC_PI_2, phase: 0.0 },
        };
        for number in 0..axial {
            let shape = wave(stretched.get(number), number);
            modes.push(Mode {
                name: format!("axial[{number}]"),
                axis: 0,
                twists: false,
                shape,
                sheared: None,
            });
        }
        for (axis, number) in
            [1, 2].into_iter().flat_map(|axis| (0..bending[axis - 1]).map(move |k| (axis, k)))
        {
            let k = number as f64;
            let bent = if shapes == "static" { polynomials(bending[axis - 1], 2) } else { Vec::new() };
            let shape = match (bent.get(number), shapes) {
                (Some(shape), _) => shape.clone(),
                (None, "free") => {
                    Shape::Free { lambda: root((k + 1.5) * PI, 1.0), even: number.is_multiple_of(2) }
                }
                (None, "clamped") => Shape::Clamped { lambda: root((k + 0.5) * PI, -1.0) },
                _ => Shape::Wave { lambda: (k + 1.0) * PI, phase: 0.0 },
            };
            let way = match (made.spatial, axis) {
                (false, _) => "bending",
                (true, 1) => "bending_y",
                _ => "bending_z",
            };
            let sheared = match made.thick {
                Some((gyration, softness)) => {
                    let r2 = gyration[axis - 1] / (length * length);
                    Some(thick::modes(shapes, bending[axis - 1], r2, r2 * softness).get(number)?.clone())
                }
                None => None,
            };
            modes.push(Mode { name: format!("{way}[{number}]"), axis, twists: false, shape, sheared });
        }
        for number in 0..torsion {
            let shape = wave(twisted.get(number), number);
            modes.push(Mode {
                name: format!("torsion[{number}]"),
                axis: 0,
                twists: true,
                shape,
                sheared: None,
            });
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
            spatial: made.spatial,
            spin: match (made.thick, made.spatial) {
                (None, true) => [made.mass * made.polar, 0.0, 0.0],
                (None, false) => ZERO,
                (Some(([z, y], _)), true) => times(made.mass, [made.polar, y, z]),
                (Some(([z, _], _)), false) => [0.0, 0.0, made.mass * z],
            },
            stiffness: Vec::new(),
            damping: Vec::new(),
        };
        for (share_of_length, share) in slices().iter().copied() {
            let x = start + length * share_of_length;
            let values = (0..beam.modes.len()).map(|mode| beam.derivative(mode, x, 0)).collect();
            let gammas = beam.gammas(x);
            let turns = (0..beam.modes.len()).map(|mode| beam.about(mode, x));
            let turns = turns.map(|turn| [0, 1, 2].map(|k| if beam.spin[k] == 0.0 { 0.0 } else { turn[k] }));
            let turns = turns.collect();
            beam.slices.push(Slice { x, share, values, turns, gammas });
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
            let order = if mode.axis == 0 { 1 } else { 2 };
            let bent = |slice: &Slice| (beam.derivative(index, slice.x, order)).powi(2);
            let integral =
                |f: &dyn Fn(&Slice) -> f64| -> f64 { beam.slices.iter().map(|it| it.share * f(it)).sum() };
            let rigidity = if mode.twists { made.rigidity[3] } else { made.rigidity[mode.axis] };
            let mut stiffness = rigidity * length * integral(&bent);
            let whole = if mode.twists { beam.spin[0] } else { made.mass };
            let mut moved = whole * integral(&|slice: &Slice| slice.values[index].powi(2));
            if let (Some(sheared), Some((gyration, softness))) = (&mode.sheared, made.thick) {
                let gyration = gyration[mode.axis - 1];
                // ∫ EI ψ′² + κ G A (N′ − ψ)² dx, with κ G A = E A/softness.
                let squares = |slice: &Slice| {
                    let xi = (slice.x - start) / length;
                    let ([_, psi], [slope, bend]) = (sheared.at(xi, 0), sheared.at(xi, 1));
                    let (shear, bend) = ((slope - psi) / length, bend / (length * length));
                    rigidity * (bend * bend + shear * shear / (softness * gyration))
                };
                stiffness = length * integral(&squares);
                moved += made.mass
                    * gyration
                    * integral(&|slice: &Slice| dot(slice.turns[index], slice.turns[index]));
            }
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

    /// N of a mode at x, by which it moves the axis there.
    pub fn value(&self, mode: usize, x: f64) -> f64 {
        if self.modes[mode].twists { 0.0 } else { self.derivative(mode, x, 0) }
    }

    /// N′ of a mode at x, or ψ of sections that shear, by which it turns the section there by bending, 1/m.
    pub fn slope(&self, mode: usize, x: f64) -> f64 {
        match &self.modes[mode].sheared {
            Some(sheared) => sheared.at((x - self.start) / self.length, 0)[1] / self.length,
            None => self.rise(mode, x),
        }
    }

    /// N′ of what is across the axis.
    fn rise(&self, mode: usize, x: f64) -> f64 {
        if self.modes[mode].axis == 0 { 0.0 } else { self.derivative(mode, x, 1) }
    }

    /// How a mode turns the section at x, 1/m, of torsion 1.
    fn about(&self, mode: usize, x: f64) -> V3 {
        match self.modes[mode].axis {
            0 if self.modes[mode].twists => [self.derivative(mode, x, 0), 0.0, 0.0],
            0 => ZERO,
            1 => [0.0, 0.0, self.slope(mode, x)],
            _ => [0.0, -self.slope(mode, x), 0.0],
        }
    }

    /// In space: Cayley's rotation by r = (Σ N_t p_t, −Σ N′ p_z, Σ N′ p_y), as the Euler parameters (1, r/2) of no particular length. With n their
    /// square and e the vector of r/2, ω′ = (ṙ + e × ṙ)/n in the axes of the body, so that ω̇′ at v̇ = 0 is −(n˙/n) ω′.
    pub fn turning(&self, x: f64, modal: &[[f64; 2]]) -> Turning {
        let about = |mode: usize| self.about(mode, x);
        let (mut half, mut half_rate) = (ZERO, ZERO);
        for (mode, [p, rate]) in modal.iter().enumerate() {
            half = plus(half, times(0.5 * p, about(mode)));
            half_rate = plus(half_rate, times(0.5 * rate, about(mode)));
        }
        let square = 1.0 + dot(half, half);
        let swept = |r: V3| times(1.0 / square, plus(r, cross(half, r)));
        let mut columns = [ZERO; MOST];
        columns.iter_mut().enumerate().take(modal.len()).for_each(|(mode, to)| *to = swept(about(mode)));
        let length = square.sqrt();
        let [x, y, z] = half.map(|part| part / length);
        let rate = swept(times(2.0, half_rate));
        let faster = times(-2.0 * dot(half, half_rate) / square, rate);
        Turning { matrix: rotation([1.0 / length, x, y, z]), columns, rate, faster }
    }

    /// Along which axis of the frame a mode moves.
    pub fn axis(&self, mode: usize) -> usize {
        self.modes[mode].axis
    }

    fn derivative(&self, mode: usize, x: f64, order: usize) -> f64 {
        let (xi, mode) = ((x - self.start) / self.length, &self.modes[mode]);
        let value = match &mode.sheared {
            Some(sheared) => sheared.at(xi, order)[0],
            None => mode.shape.at(xi, order),
        };
        value / self.length.powi(order as i32)
    }

    /// Γ_jk = ∫ N_j′ N_k′ up to x, row by row; nothing of a beam whose places move across alone.
    pub fn gammas(&self, x: f64) -> Vec<f64> {
        let count = if self.stiffens { self.modes.len() } else { 0 };
        let span = x - self.start;
        let mut gammas = vec![0.0; count * count];
        for (at, weight) in slices().iter().filter(|_| count > 0) {
            let slopes: Vec<f64> = (0..count).map(|mode| self.rise(mode, self.start + span * at)).collect();
            for (k, gamma) in gammas.iter_mut().enumerate() {
                // What moves across two ways has slopes across one another.
                if self.modes[k / count].axis == self.modes[k % count].axis {
                    *gamma += span * weight * slopes[k / count] * slopes[k % count];
                }
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
        let moving = self.modes.iter().zip(&slice.values).zip(modal).filter(|((mode, _), _)| !mode.twists);
        for ((mode, value), [p, p_rate]) in moving {
            bent[mode.axis] += value * p;
            rate[mode.axis] += value * p_rate;
        }
        let (arm, rate) = (turned(&frame.axes, bent), turned(&frame.axes, rate));
        let mut columns = [[0.0; 3]; 6 + MOST];
        if self.spatial {
            for k in 0..3 {
                columns[k] = unit_axis(k);
                columns[3 + k] = cross(column(&frame.axes, k), arm);
            }
        } else {
            (columns[0], columns[1]) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]);
            columns[2] = [-arm[1], arm[0], 0.0];
        }
        for ((column, mode), (value, along)) in
            columns[self.pose()..].iter_mut().zip(&self.modes).zip(slice.values.iter().zip(along))
        {
            let mut local = [along, 0.0, 0.0];
            local[mode.axis] += if mode.twists { 0.0 } else { *value };
            *column = turned(&frame.axes, local);
        }
        // ω × (ω × A d) + 2 ω × A ḋ + A d̈.
        let around = cross(frame.spin, arm);
        let turning = plus(cross(frame.spin, around), times(2.0, cross(frame.spin, rate)));
        let swept = plus(around, rate);
        let bias = plus(turning, turned(&frame.axes, [faster, 0.0, 0.0]));
        Moved { arm, columns, velocity: plus(frame.velocity, swept), bias }
    }

    /// M of the body, full, row by row.
    pub fn mass(&self, frame: &Frame, modal: &[[f64; 2]], mut put: impl FnMut(usize, usize, f64)) {
        let width = self.pose() + self.modes.len();
        for slice in &self.slices {
            let Moved { columns, .. } = self.moved(frame, slice, modal);
            for axis in (0..3).filter(|axis| self.spin[*axis] != 0.0) {
                let about = self.about_axis(slice, axis);
                for (i, one) in about.iter().enumerate().filter(|(_, one)| **one != 0.0) {
                    for (j, other) in about.iter().enumerate().filter(|(_, other)| **other != 0.0) {
                        put(i, j, slice.share * self.spin[axis] * one * other);
                    }
                }
            }
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
            for (force, column) in forces[..self.pose() + self.modes.len()].iter_mut().zip(&columns) {
                *force += dot(*column, pull);
            }
        }
        if self.spatial {
            let omega = turned_back(&frame.axes, frame.spin);
            for slice in &self.slices {
                let turning = self.turning_of(slice, omega, modal);
                let momentum = [0, 1, 2].map(|axis| slice.share * self.spin[axis] * turning[axis]);
                let gyroscopic = cross(momentum, omega);
                (0..3).for_each(|k| forces[3 + k] += gyroscopic[k]);
            }
        }
        for (mode, [p, rate]) in modal.iter().enumerate() {
            forces[self.pose() + mode] -= self.stiffness[mode] * p + self.damping[mode] * rate;
        }
    }

    pub fn kinetic(&self, frame: &Frame, modal: &[[f64; 2]]) -> f64 {
        let omega = turned_back(&frame.axes, frame.spin);
        let of = self.slices.iter().map(|slice| {
            let Moved { velocity, .. } = self.moved(frame, slice, modal);
            let turning = self.turning_of(slice, omega, modal).map(|rate| rate * rate);
            0.5 * slice.share * (self.mass * dot(velocity, velocity) + dot(self.spin, turning))
        });
        of.sum()
    }

    /// The rates at which a slice turns, in the axes of the body.
    fn turning_of(&self, slice: &Slice, frame: V3, modal: &[[f64; 2]]) -> V3 {
        slice.turns.iter().zip(modal).fold(frame, |sum, (turn, [_, rate])| plus(sum, times(*rate, *turn)))
    }

    /// The columns of one of them, by the velocities of the frame and the modes.
    fn about_axis(&self, slice: &Slice, axis: usize) -> [f64; 6 + MOST] {
        let mut columns = [0.0; 6 + MOST];
        columns[if self.spatial { 3 + axis } else { 2 }] = 1.0;
        let own = columns[self.pose()..].iter_mut().zip(&slice.turns);
        own.for_each(|(column, turn)| *column = turn[axis]);
        columns
    }

    /// Velocities of the frame.
    fn pose(&self) -> usize {
        if self.spatial { 6 } else { 3 }
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
