//! Links: frames that move one against the other by one elementary motion each.
//!
//! A vector with components x in the axes of a link has, in those of its parent,
//!   x′ = at + axes (slide + R x),
//! where `at` and `axes` are constant and the motion is a turn about the link's own z, a slide, or a ball. A joint with
//! several freedoms is a chain of links without mass; constant folding leaves nothing of what does not move.

use super::flexible::Flexible;
use super::vector::{self, Mat3, Vec3};
use crate::equations::jet::Moving;
use crate::symbolic::{Node, On, Sheet};

/// Index of a link in [`super::Kinematics::links`].
pub type LinkId = usize;
/// The link that does not move.
pub const GROUND: LinkId = 0;

/// How a link moves against its parent.
#[derive(Clone, Debug)]
pub enum Motion {
    None,
    /// R = Rz(θ) of (cos, sin), ω = sign · v\[rate\] along z.
    Turn {
        cos: Node,
        sin: Node,
        rate: usize,
        sign: Node,
    },
    /// By `travel` along `axis`, with the speed factor · v\[rate\].
    Slide {
        axis: Vec3,
        travel: Node,
        rate: usize,
        factor: Node,
    },
    /// R = `matrix`, ω = (v\[rate\], v\[rate + 1\], v\[rate + 2\]) along the link's own axes.
    Ball {
        matrix: Mat3,
        rate: usize,
    },
    /// By `offset`, with the velocity Σ axis · v\[rate\] of these, and `bias` its derivative at v̇ = 0: a place that moves as its body deforms.
    Shift {
        offset: Vec3,
        along: Vec<(usize, Vec3)>,
        bias: Vec3,
    },
    /// R = `matrix`, ω = Σ axis · v\[rate\] along the link's own axes, with `bias` the ω̇ of these at v̇ = 0: what turns there.
    Lean {
        matrix: Mat3,
        about: Vec<(usize, Vec3)>,
        bias: Vec3,
    },
}

#[derive(Clone, Debug)]
pub struct Link {
    pub parent: LinkId,
    pub at: Vec3,
    /// ∂at/∂t and ∂²at/∂t²: places of the ground may move. Zero unless the parent is the ground.
    pub at_drift: Vec3,
    pub at_bias: Vec3,
    /// Parent ← link before its motion; constant.
    pub axes: Mat3,
    pub motion: Motion,
}

/// Where a body is: on a link, its own axes turned and its origin shifted by constants.
#[derive(Clone, Debug)]
pub struct Placement {
    pub link: LinkId,
    /// Of the body's origin.
    pub at: Vec3,
    /// Link ← body.
    pub axes: Mat3,
    /// What deforms of it.
    pub flexible: Option<Flexible>,
}

impl Placement {
    pub fn of_ground(g: Sheet) -> Self {
        let (at, axes) = (vector::zero(g).bare, vector::identity(g).bare);
        Placement { link: GROUND, at, axes, flexible: None }
    }
}

impl Link {
    /// One that stays where it is on its parent.
    pub fn still(g: Sheet, parent: LinkId) -> Self {
        let (zero, axes) = (vector::zero(g).bare, vector::identity(g).bare);
        Link { parent, at: zero, at_drift: zero, at_bias: zero, axes, motion: Motion::None }
    }

    /// Whether its foot moves with time.
    pub fn is_carried_by_time(&self, g: Sheet) -> bool {
        !(g.on(self.at_drift).is_zero() && g.on(self.at_bias).is_zero())
    }

    /// How many velocities move it against its parent.
    pub fn freedoms(&self) -> usize {
        match &self.motion {
            Motion::None => 0,
            Motion::Turn { .. } | Motion::Slide { .. } => 1,
            Motion::Ball { .. } => 3,
            Motion::Shift { along, .. } => along.len(),
            Motion::Lean { about, .. } => about.len(),
        }
    }

    /// Puts the foot at a place of the ground that may move.
    pub fn at_place(&mut self, place: &[Moving; 3]) {
        self.at = [0, 1, 2].map(|k| place[k].jet.value);
        self.at_drift = [0, 1, 2].map(|k| place[k].jet.drift);
        self.at_bias = [0, 1, 2].map(|k| place[k].jet.bias);
    }
}

impl<'g> On<'g, &Link> {
    /// R x.
    pub fn turn(self, x: On<'g, Vec3>) -> On<'g, Vec3> {
        match &self.bare.motion {
            Motion::None | Motion::Slide { .. } | Motion::Shift { .. } => x,
            Motion::Turn { cos, sin, .. } => x.turned_about_z(self.g.on(*cos), self.g.on(*sin)),
            Motion::Ball { matrix, .. } | Motion::Lean { matrix, .. } => *matrix * x,
        }
    }

    /// Rᵀ x.
    pub fn turn_back(self, x: On<'g, Vec3>) -> On<'g, Vec3> {
        match &self.bare.motion {
            Motion::None | Motion::Slide { .. } | Motion::Shift { .. } => x,
            Motion::Turn { cos, sin, .. } => x.turned_about_z(self.g.on(*cos), -self.g.on(*sin)),
            Motion::Ball { matrix, .. } | Motion::Lean { matrix, .. } => vector::transposed(matrix) * x,
        }
    }

    /// A free vector in the axes of the parent.
    pub fn up(self, x: On<'g, Vec3>) -> On<'g, Vec3> {
        self.bare.axes * self.turn(x)
    }

    /// A free vector of the parent in the axes of the link before its motion.
    pub fn before(self, x: On<'g, Vec3>) -> On<'g, Vec3> {
        vector::transposed(&self.bare.axes) * x
    }

    /// A free vector of the parent in the link's own axes.
    pub fn down(self, x: On<'g, Vec3>) -> On<'g, Vec3> {
        self.turn_back(self.before(x))
    }

    /// ω relative to the parent, in the link's own axes.
    pub fn omega(self, v: &[Node]) -> On<'g, Vec3> {
        let zero = self.g.zero().bare;
        self.g.on(match &self.bare.motion {
            Motion::None | Motion::Slide { .. } | Motion::Shift { .. } => [zero; 3],
            Motion::Lean { about, .. } => return self.sum(about, v),
            Motion::Turn { rate, sign, .. } => [zero, zero, (self.g.on(*sign) * v[*rate]).bare],
            Motion::Ball { rate, .. } => [v[*rate], v[rate + 1], v[rate + 2]],
        })
    }

    /// Index and axis of each velocity that turns the link, in its own axes.
    pub fn turning(self) -> Vec<(usize, On<'g, Vec3>)> {
        let g = self.g;
        match &self.bare.motion {
            Motion::None | Motion::Slide { .. } | Motion::Shift { .. } => Vec::new(),
            Motion::Lean { about, .. } => about.iter().map(|(rate, axis)| (*rate, g.on(*axis))).collect(),
            Motion::Turn { rate, sign, .. } => {
                let zero = g.zero().bare;
                vec![(*rate, g.on([zero, zero, *sign]))]
            }
            Motion::Ball { rate, .. } => (0..3).map(|k| (rate + k, vector::unit(g, k))).collect(),
        }
    }

    fn sum(self, axes: &[(usize, Vec3)], v: &[Node]) -> On<'g, Vec3> {
        let terms = axes.iter().map(|(rate, axis)| self.g.on(v[*rate]) * *axis);
        terms.fold(vector::zero(self.g), |sum, term| sum + term)
    }

    /// ω̇ relative to the parent at v̇ = 0, in the link's own axes.
    pub fn turning_bias(self) -> On<'g, Vec3> {
        match &self.bare.motion {
            Motion::Lean { bias, .. } => self.g.on(*bias),
            _ => vector::zero(self.g),
        }
    }

    /// The acceleration with which it slides at v̇ = 0 by itself, in its own axes.
    pub fn sliding_bias(self) -> On<'g, Vec3> {
        match &self.bare.motion {
            Motion::Shift { bias, .. } => self.g.on(*bias),
            _ => vector::zero(self.g),
        }
    }

    /// The velocity with which it slides, in its own axes, by v or by v̇; `None` of what does not slide.
    pub fn sliding_by(self, v: &[Node]) -> Option<On<'g, Vec3>> {
        let axes = self.sliding();
        let terms = axes.into_iter().map(|(rate, axis)| self.g.on(v[rate]) * axis);
        terms.reduce(|sum, term| sum + term)
    }

    /// The slide's part of the offset from the parent, in the axes of the link before its motion.
    pub fn slide(self) -> On<'g, Vec3> {
        match &self.bare.motion {
            Motion::Slide { axis, travel, .. } => self.g.on(*travel) * *axis,
            Motion::Shift { offset, .. } => self.g.on(*offset),
            _ => vector::zero(self.g),
        }
    }

    /// Index of each velocity that slides the link, and the way along which, in its own axes.
    pub fn sliding(self) -> Vec<(usize, On<'g, Vec3>)> {
        match &self.bare.motion {
            Motion::Slide { axis, rate, factor, .. } => vec![(*rate, self.g.on(*factor) * *axis)],
            Motion::Shift { along, .. } => {
                along.iter().map(|(rate, axis)| (*rate, self.g.on(*axis))).collect()
            }
            _ => Vec::new(),
        }
    }

    /// From the parent's origin to the link's, in the axes of the parent.
    pub fn offset(self) -> On<'g, Vec3> {
        self.g.on(self.bare.at) + self.bare.axes * self.slide()
    }
}
