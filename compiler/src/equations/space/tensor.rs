//! Distributions of mass: mass, first moments and inertia tensor about the origin of a link, in its axes.

use super::links::{Link, Motion};
use super::vector::{Mat3, Vec3, vector};
use crate::symbolic::{Bare, Node, On, Scalar, Sheet};
use std::ops::{Add, Mul};

/// m, h = Σ m r, I = Σ m (r² 1 − r rᵀ) + J.
#[derive(Clone, Copy, Debug)]
pub struct Distribution {
    pub mass: Node,
    pub first: Vec3,
    pub inertia: Symmetric,
}

/// xx, yy, zz, xy, xz, yz.
#[derive(Clone, Copy, Debug)]
pub struct Symmetric(pub [Node; 6]);
/// Row and column of each.
pub const ENTRIES: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];

impl Symmetric {
    /// By its entries.
    pub fn of<'g>(g: Sheet<'g>, entry: impl FnMut(usize) -> Scalar<'g>) -> On<'g, Symmetric> {
        let entries = [0, 1, 2, 3, 4, 5].map(entry);
        g.on(Symmetric(entries.map(|entry| entry.bare)))
    }

    pub fn matrix(self) -> Mat3 {
        let [xx, yy, zz, xy, xz, yz] = self.0;
        [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
    }
}

impl<'g> On<'g, Symmetric> {
    pub fn at(self, k: usize) -> Scalar<'g> {
        self.g.on(self.bare.0[k])
    }

    pub fn parts(self) -> [Scalar<'g>; 6] {
        self.bare.0.map(|part| self.g.on(part))
    }

    /// R I Rᵀ of a turn about z. With t = s (Ixx − Iyy) + 2 c Ixy:  Ixx′ = Ixx − s t, Iyy′ = Iyy + s t, Ixy′ = c t − Ixy.
    pub fn turned_about_z(self, cos: Scalar<'g>, sin: Scalar<'g>) -> Self {
        let [xx, yy, zz, xy, xz, yz] = self.parts();
        let (difference, doubled) = (xx - yy, 2.0 * xy);
        let t = sin * difference + cos * doubled;
        let (st, ct) = (sin * t, cos * t);
        let [xz, yz, _] = self.g.on([xz.bare, yz.bare, zz.bare]).turned_about_z(cos, sin).bare;
        self.g.on(Symmetric([(xx - st).bare, (yy + st).bare, zz.bare, (ct - xy).bare, xz, yz]))
    }

    /// R I Rᵀ.
    pub fn turned(self, matrix: Mat3) -> Self {
        let half = self.g.on(matrix) * self.bare.matrix();
        Symmetric::of(self.g, |k| {
            let (i, j) = ENTRIES[k];
            half.row(i).dot(matrix[j])
        })
    }
}

impl<'g, B: Bare<Symmetric>> Add<B> for On<'g, Symmetric> {
    type Output = Self;
    fn add(self, other: B) -> Self {
        let other = other.bare();
        Symmetric::of(self.g, |k| self.at(k) + other.0[k])
    }
}

impl<'g> Mul<On<'g, Vec3>> for Symmetric {
    type Output = On<'g, Vec3>;
    fn mul(self, vector: On<'g, Vec3>) -> On<'g, Vec3> {
        self.matrix() * vector
    }
}

impl Distribution {
    pub fn none(g: Sheet) -> Self {
        let zero = g.zero().bare;
        Distribution { mass: zero, first: [zero; 3], inertia: Symmetric([zero; 6]) }
    }

    pub fn is_none(&self, g: Sheet) -> bool {
        let Symmetric(inertia) = self.inertia;
        g.is_zero(self.mass) && g.on(self.first).is_zero() && inertia.iter().all(|x| g.is_zero(*x))
    }
}

impl<'g> On<'g, Distribution> {
    pub fn mass(self) -> Scalar<'g> {
        self.g.on(self.bare.mass)
    }
    pub fn first(self) -> On<'g, Vec3> {
        self.g.on(self.bare.first)
    }
    pub fn inertia(self) -> On<'g, Symmetric> {
        self.g.on(self.bare.inertia)
    }

    /// The same mass, about the point from which this origin lies at `d`:
    /// with k = h + ½ m d the tensor grows by 2 (d·k) 1 − d kᵀ − k dᵀ.
    pub fn shifted(self, d: On<'g, Vec3>) -> Self {
        if d.is_zero() {
            return self;
        }
        let first = self.first() + self.mass() * d;
        // 2 k = h + (h + m d).
        let twice = self.first() + first;
        let square = vector(|k| d.at(k) * twice.at(k));
        let inertia = Symmetric::of(self.g, |k| {
            let own = self.inertia().at(k);
            let (i, j) = ENTRIES[k];
            if i == j {
                own + (square.at((k + 1) % 3) + square.at((k + 2) % 3))
            } else {
                own - 0.5 * (d.at(i) * twice.at(j) + d.at(j) * twice.at(i))
            }
        });
        self.g.on(Distribution { mass: self.bare.mass, first: first.bare, inertia: inertia.bare })
    }

    /// In axes that `matrix` leads to: h′ = R h, I′ = R I Rᵀ.
    pub fn turned(self, matrix: Mat3) -> Self {
        let first = matrix * self.first();
        let inertia = self.inertia().turned(matrix);
        self.g.on(Distribution { mass: self.bare.mass, first: first.bare, inertia: inertia.bare })
    }

    fn turned_about_z(self, cos: Scalar<'g>, sin: Scalar<'g>) -> Self {
        let inertia = self.inertia().turned_about_z(cos, sin);
        let first = self.first().turned_about_z(cos, sin);
        self.g.on(Distribution { mass: self.bare.mass, first: first.bare, inertia: inertia.bare })
    }

    /// About the origin and in the axes of a link's parent.
    pub fn in_parent(self, link: &Link) -> Self {
        let g = self.g;
        let moved = match &link.motion {
            Motion::None => self,
            Motion::Slide { .. } | Motion::Shift { .. } => self.shifted(g.on(link).slide()),
            Motion::Turn { cos, sin, .. } => self.turned_about_z(g.on(*cos), g.on(*sin)),
            Motion::Ball { matrix, .. } | Motion::Lean { matrix, .. } => self.turned(*matrix),
        };
        moved.turned(link.axes).shifted(g.on(link.at))
    }
}

impl<'g, B: Bare<Distribution>> Add<B> for On<'g, Distribution> {
    type Output = Self;
    fn add(self, other: B) -> Self {
        let Distribution { mass, first, inertia } = other.bare();
        self.g.on(Distribution {
            mass: (self.mass() + mass).bare,
            first: (self.first() + first).bare,
            inertia: (self.inertia() + inertia).bare,
        })
    }
}
