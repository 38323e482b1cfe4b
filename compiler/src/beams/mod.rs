//! Slender beams as numbers: shapes, and what their mass and stiffness make of them. Nothing here knows of graphs or definitions.
//!
//! A point of the axis at x, from the origin of the beam's frame, is at (x + Σ N_a p_a, Σ N_b p_b), in space with a third component of the
//! same kind and sections that twist by Σ N_t p_t, as Saint-Venant's shaft: Euler and Bernoulli's beam in a floating frame of reference (Shabana, *Dynamics of Multibody Systems*, 5.2–5.5; Géradin, Rixen,
//! *Mechanical Vibrations*, 4.2). With m the mass, all integrals of the inertia are m times a constant, because mass is spread evenly. Where
//! the axis keeps its length as it bends, places move along it too: `stiffening`. How pictures show the axis stands in `bow`.

mod bow;
mod gauss;
mod polynomial;
mod roots;
mod shape;
mod stiffening;
mod thick;

#[cfg(test)]
mod tests;

pub use bow::{Bow, Held, magnification};
pub use gauss::Rule;
pub use shape::{Shape, Wave};
pub use stiffening::Shortening;
pub use thick::{Beyond, Thick, Turning};

use crate::forms::Space;
use std::f64::consts::{FRAC_PI_2, PI};

/// Most modes of one kind.
pub const MOST_MODES: usize = 12;

/// ω h up to which the classical Runge–Kutta method is stable on the imaginary axis, 2 √2, and the explicit trapezoidal rule as it
/// stands for what is little damped (Hairer, Wanner, *Solving Ordinary Differential Equations II*, IV.2).
pub const RK4: f64 = 2.0 * std::f64::consts::SQRT_2;

/// Which functions the deformation is made of, and where the frame is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shapes {
    /// Of the beam that nothing holds; the frame has its origin in the centre of mass and the mean direction.
    Free,
    /// Of the beam that is held at its start, which has the frame.
    Clamped,
    /// Of the beam on two hinges; the frame is at its start, with x through both ends.
    Pinned,
    /// Polynomials for the beam that is held at its start, exact under moments and forces at its end.
    Static,
}

impl Shapes {
    /// As written, the default first.
    pub const ALL: [Self; 4] = [Self::Free, Self::Clamped, Self::Pinned, Self::Static];

    pub fn word(self) -> &'static str {
        match self {
            Self::Free => "free",
            Self::Clamped => "clamped",
            Self::Pinned => "pinned",
            Self::Static => "static",
        }
    }
}

/// What bending does to sections.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Theory {
    /// They stay across the axis, and their own rotary inertia is left out.
    EulerBernoulli,
    /// They shear, and have it.
    Timoshenko,
}

impl Theory {
    /// As written, the default first.
    pub const ALL: [Self; 2] = [Self::EulerBernoulli, Self::Timoshenko];

    pub fn word(self) -> &'static str {
        match self {
            Self::EulerBernoulli => "euler_bernoulli",
            Self::Timoshenko => "timoshenko",
        }
    }
}

/// How many modes there are of each way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Counts {
    pub axial: usize,
    pub bending: usize,
    /// Along z, of beams in space.
    pub bending_z: usize,
    /// About x, of beams in space.
    pub torsion: usize,
    /// Whether the axial ones are polynomials whatever the others are: with two of them the quadratic element of finite element codes.
    pub quadratic: bool,
}

impl Counts {
    pub fn of(&self, way: Way) -> usize {
        match way {
            Way::Axial => self.axial,
            Way::Bending => self.bending,
            Way::BendingZ => self.bending_z,
            Way::Torsion => self.torsion,
        }
    }

    /// Whether there are any across the axis.
    pub fn bends(&self) -> bool {
        self.bending + self.bending_z > 0
    }
}

/// Along the axis or across it, in space in two directions, and there about it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    Axial,
    /// Along y, about z.
    Bending,
    /// Along z, about y.
    BendingZ,
    /// About x: coordinates are angles, whose shapes turn the sections.
    Torsion,
}

impl Way {
    /// Those there are, in the order of their modes.
    pub fn of(space: Space) -> &'static [Self] {
        match space {
            Space::Planar => &[Self::Axial, Self::Bending],
            Space::Spatial => &[Self::Axial, Self::Bending, Self::BendingZ, Self::Torsion],
        }
    }

    pub fn word(self, space: Space) -> &'static str {
        match (self, space) {
            (Self::Axial, _) => "axial",
            (Self::Bending, Space::Planar) => "bending",
            (Self::Bending, Space::Spatial) => "bending_y",
            (Self::BendingZ, _) => "bending_z",
            (Self::Torsion, _) => "torsion",
        }
    }

    /// Whether it is across the axis.
    pub fn bends(self) -> bool {
        matches!(self, Self::Bending | Self::BendingZ)
    }

    /// Along which of the frame's axes, of torsion about which.
    pub fn axis(self) -> usize {
        match self {
            Self::Axial | Self::Torsion => 0,
            Self::Bending => 1,
            Self::BendingZ => 2,
        }
    }
}

/// One mode: a coordinate, m, of torsion rad, that its shape carries along the axis.
#[derive(Clone, Debug)]
pub struct Mode {
    pub way: Way,
    /// Which of its way.
    pub number: usize,
    pub shape: Shape,
    /// ψ L, by which a section is turned that shears; of all others it is N′ L.
    pub turn: Option<Shape>,
    /// ∫ (N″)² dx of bending, 1/m³, with shear ∫ (ψ′)² + (κ G A/E I) (N′ − ψ)² dx; ∫ (N′)² dx of what is axial or torsion, 1/m. The shapes of one way are across to one another in it.
    pub stiffness: f64,
}

/// A beam by its length and its modes.
#[derive(Clone, Debug)]
pub struct Slender {
    pub shapes: Shapes,
    /// m.
    pub length: f64,
    /// x of its start.
    pub from: f64,
    /// Axial ones first, torsion last.
    pub modes: Vec<Mode>,
    /// How far bending draws places in, pair by pair of modes; nothing where that is left out.
    pub shortenings: Vec<Shortening>,
    /// Mean over the length of the functions x, N₁, N₂, …, and behind these the Γ of `shortenings`.
    pub first: Vec<f64>,
    /// Mean of their products, two by two.
    pub second: Vec<Vec<f64>>,
    /// Of sections that shear.
    pub turning: Option<Turning>,
}

impl Slender {
    pub fn new(shapes: Shapes, length: f64, counts: Counts) -> Self {
        let bending = |way: Way, count: usize| bending_modes(shapes, length, way, count);
        let across = [bending(Way::Bending, counts.bending), bending(Way::BendingZ, counts.bending_z)];
        Self::of(shapes, length, counts, across.concat())
    }

    /// Timoshenko's, of sections along y and along z.
    pub fn thick(shapes: Shapes, length: f64, counts: Counts, thick: [Thick; 2]) -> Result<Self, Beyond> {
        let [along_y, along_z] = thick;
        let mut bending = along_y.modes(shapes, length, Way::Bending, counts.bending)?;
        bending.extend(along_z.modes(shapes, length, Way::BendingZ, counts.bending_z)?);
        Ok(Self::of(shapes, length, counts, bending).turning(thick))
    }

    fn of(shapes: Shapes, length: f64, counts: Counts, bending: Vec<Mode>) -> Self {
        let from = if shapes == Shapes::Free { -0.5 * length } else { 0.0 };
        let axial = if counts.quadratic { Shapes::Static } else { shapes };
        let mut modes = axial_modes(axial, length, Way::Axial, counts.axial);
        modes.extend(bending);
        // A shaft's twist has the equation of a bar's stretch.
        modes.extend(axial_modes(shapes, length, Way::Torsion, counts.torsion));
        let (first, second) = means(shapes, from, length, &modes);
        Slender { shapes, length, from, modes, shortenings: Vec::new(), first, second, turning: None }
    }

    /// Whether a place at x is on the axis.
    pub fn reaches(&self, x: f64) -> bool {
        let slack = 1e-9 * self.length;
        x >= self.from - slack && x <= self.from + self.length + slack
    }

    /// By how much each mode moves the point of the axis at x: N, of torsion nothing.
    pub fn values(&self, x: f64) -> Vec<f64> {
        let value = |mode: &Mode| match mode.way {
            Way::Torsion => 0.0,
            Way::Axial | Way::Bending | Way::BendingZ => mode.shape.at(self.share(x), 0),
        };
        self.modes.iter().map(value).collect()
    }

    /// By how much each mode turns the section at x: N′ of bending, or ψ, 1/m, N of torsion, 1, of what is axial nothing.
    pub fn slopes(&self, x: f64) -> Vec<f64> {
        let slope = |mode: &Mode| match mode.way {
            Way::Axial => 0.0,
            Way::Torsion => mode.shape.at(self.share(x), 0),
            Way::Bending | Way::BendingZ => match &mode.turn {
                Some(turn) => turn.at(self.share(x), 0) / self.length,
                None => mode.shape.at(self.share(x), 1) / self.length,
            },
        };
        self.modes.iter().map(slope).collect()
    }

    /// Whether the axis keeps its direction at x.
    pub fn keeps_direction(&self, x: f64) -> bool {
        self.slopes(x).iter().all(|slope| *slope == 0.0)
    }

    /// Whether the point of the axis at x keeps its place and its direction.
    pub fn stays(&self, x: f64) -> bool {
        self.keeps_direction(x) && self.values(x).iter().all(|value| *value == 0.0)
    }

    /// ω² of a mode by EA or EI and the mass, of torsion by G J_t and the moment of inertia about the axis, (rad/s)²: its stiffness by what
    /// it moves.
    pub fn square_of_rate(&self, mode: usize, rigidity: f64, mass: f64) -> f64 {
        self.modes[mode].stiffness * rigidity / (mass * self.moved(mode))
    }

    /// What a mode moves, by the mass, of torsion by the moment of inertia about the axis: the mean of its square, with what turns.
    pub fn moved(&self, mode: usize) -> f64 {
        let turning = self.turning.as_ref().map_or(0.0, |turning| turning.second[mode][mode]);
        self.second[mode + 1][mode + 1] + turning
    }

    /// The part of the length before x.
    fn share(&self, x: f64) -> f64 {
        ((x - self.from) / self.length).clamp(0.0, 1.0)
    }
}

/// cos(kπξ), sin((2k − 1)πξ/2): Géradin, Rixen, 4.1.
fn axial_modes(shapes: Shapes, length: f64, way: Way, count: usize) -> Vec<Mode> {
    let wave = |number: usize| {
        let k = number as f64 + 1.0;
        let (lambda, shape) = match shapes {
            Shapes::Free => (k * PI, Wave::cosine(k * PI)),
            _ => {
                let lambda = (2.0 * k - 1.0) * FRAC_PI_2;
                (lambda, Wave::sine(lambda))
            }
        };
        // The mean of a squared sine or cosine over whole quarters is a half.
        let stiffness = 0.5 * lambda * lambda / length;
        Mode { way, number, shape: Shape::Wave(shape), turn: None, stiffness }
    };
    match shapes {
        Shapes::Static => polynomial_modes(way, count, 1, length),
        _ => (0..count).map(wave).collect(),
    }
}

/// Géradin, Rixen, 4.2: N⁗ = (λ/L)⁴ N, so that ∫ (N″)² = (λ/L)⁴ ∫ N².
fn bending_modes(shapes: Shapes, length: f64, way: Way, count: usize) -> Vec<Mode> {
    let wave = |number: usize| {
        let (lambda, shape, square) = match shapes {
            Shapes::Free => {
                let lambda = roots::free_free(number);
                (lambda, Wave::free_free(lambda), 1.0)
            }
            Shapes::Pinned => {
                let lambda = (number as f64 + 1.0) * PI;
                (lambda, Wave::sine(lambda), 0.5)
            }
            Shapes::Clamped | Shapes::Static => {
                let lambda = roots::clamped_free(number);
                (lambda, Wave::clamped_free(lambda), 1.0)
            }
        };
        let stiffness = square * lambda.powi(4) / length.powi(3);
        Mode { way, number, shape: Shape::Wave(shape), turn: None, stiffness }
    };
    match shapes {
        Shapes::Static => polynomial_modes(way, count, 2, length),
        _ => (0..count).map(wave).collect(),
    }
}

fn polynomial_modes(way: Way, count: usize, order: usize, length: f64) -> Vec<Mode> {
    let modes = polynomial::shapes(count, order).into_iter().enumerate();
    let scale = length.powi(1 - 2 * order as i32);
    let mode = |(number, found): (usize, polynomial::Found)| Mode {
        way,
        number,
        shape: Shape::Polynomial(found.shape),
        turn: None,
        stiffness: scale * found.stiffness,
    };
    modes.map(mode).collect()
}

/// Means of x, N₁, … and of their products. That of x alone is closed; what is zero or a half by the orthogonality of modes and the
/// parity of shapes is that to the last digit, all else is Gauss's quadrature, exact to 1e-15 for [`MOST_MODES`] modes.
fn means(shapes: Shapes, from: f64, length: f64, modes: &[Mode]) -> (Vec<f64>, Vec<Vec<f64>>) {
    let middle = from + 0.5 * length;
    let count = modes.len() + 1;
    let (mut first, mut second) = (vec![0.0; count], vec![vec![0.0; count]; count]);
    for (share, weight) in gauss::finest().points() {
        let mut values = vec![from + length * share];
        values.extend(modes.iter().map(|mode| mode.shape.at(share, 0)));
        for i in 0..count {
            first[i] += weight * values[i];
            for j in 0..count {
                second[i][j] += weight * values[i] * values[j];
            }
        }
    }
    for i in 0..count {
        first[i] = crisp(first[i]);
        for j in 0..count {
            second[i][j] = crisp(second[i][j]);
            // With the rotary inertia of sections only the sum is.
            let orthogonal =
                i > 0 && j > 0 && modes[i - 1].way == modes[j - 1].way && modes[i - 1].turn.is_none();
            if orthogonal && i != j {
                second[i][j] = 0.0;
            }
        }
    }
    if shapes == Shapes::Free {
        // The frame is that of the mean motion: neither momentum nor moment of momentum in bending.
        for (index, mode) in modes.iter().enumerate() {
            first[index + 1] = 0.0;
            if mode.way.bends() && mode.turn.is_none() {
                (second[0][index + 1], second[index + 1][0]) = (0.0, 0.0);
            }
        }
    }
    first[0] = middle;
    second[0][0] = middle * middle + length * length / 12.0;
    (first, second)
}

/// What is a whole multiple of a half but for rounding.
fn crisp(value: f64) -> f64 {
    let near = 0.5 * (2.0 * value).round();
    if (value - near).abs() < 1e-13 { near } else { value }
}
