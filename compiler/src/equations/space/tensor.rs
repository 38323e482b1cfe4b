//! Distributions of mass: mass, first moments and inertia tensor about the origin of a link, in its axes.

use super::links::{Link, Motion};
use super::vector::{self, Mat3, Vec3};
use crate::symbolic::{Graph, Node};

/// m, h = Σ m r, I = Σ m (r² 1 − r rᵀ) + J.
#[derive(Clone, Copy, Debug)]
pub struct Distribution {
    pub mass: Node,
    pub first: Vec3,
    pub inertia: Symmetric,
}

/// xx, yy, zz, xy, xz, yz.
pub type Symmetric = [Node; 6];
/// Row and column of each.
pub const ENTRIES: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];

impl Distribution {
    pub fn none(g: &mut Graph) -> Self {
        let zero = g.constant(0.0);
        Distribution { mass: zero, first: [zero; 3], inertia: [zero; 6] }
    }

    pub fn is_none(&self, g: &Graph) -> bool {
        g.is_zero(self.mass) && vector::is_zero(g, self.first) && self.inertia.iter().all(|x| g.is_zero(*x))
    }

    pub fn add(&self, g: &mut Graph, other: &Self) -> Self {
        Distribution {
            mass: g.add(self.mass, other.mass),
            first: vector::add(g, self.first, other.first),
            inertia: std::array::from_fn(|k| g.add(self.inertia[k], other.inertia[k])),
        }
    }

    /// The same mass, about the point from which this origin lies at `d`:
    /// with k = h + ½ m d the tensor grows by 2 (d·k) 1 − d kᵀ − k dᵀ.
    pub fn shifted(&self, g: &mut Graph, d: Vec3) -> Self {
        if vector::is_zero(g, d) {
            return *self;
        }
        let carried = vector::scale(g, self.mass, d);
        let first = vector::add(g, self.first, carried);
        // 2 k = h + (h + m d).
        let twice = vector::add(g, self.first, first);
        let square: Vec3 = std::array::from_fn(|k| g.mul(d[k], twice[k]));
        let half = g.constant(0.5);
        let mut inertia = self.inertia;
        for k in 0..3 {
            let both = g.add(square[(k + 1) % 3], square[(k + 2) % 3]);
            inertia[k] = g.add(inertia[k], both);
        }
        for (at, (i, j)) in [(0, 1), (0, 2), (1, 2)].into_iter().enumerate() {
            let (a, b) = (g.mul(d[i], twice[j]), g.mul(d[j], twice[i]));
            let both = g.add(a, b);
            let mixed = g.mul(half, both);
            inertia[3 + at] = g.sub(inertia[3 + at], mixed);
        }
        Distribution { mass: self.mass, first, inertia }
    }

    /// In axes that `matrix` leads to: h′ = R h, I′ = R I Rᵀ.
    pub fn turned(&self, g: &mut Graph, matrix: &Mat3) -> Self {
        Distribution {
            mass: self.mass,
            first: vector::apply(g, matrix, self.first),
            inertia: turned(g, matrix, self.inertia),
        }
    }

    /// About the origin and in the axes of a link's parent.
    pub fn in_parent(&self, g: &mut Graph, link: &Link) -> Self {
        let moved = match &link.motion {
            Motion::None => *self,
            Motion::Slide { .. } => {
                let slide = link.slide(g);
                self.shifted(g, slide)
            }
            Motion::Turn { cos, sin, .. } => self.turned_about_z(g, *cos, *sin),
            Motion::Ball { matrix, .. } => self.turned(g, matrix),
        };
        let turned = moved.turned(g, &link.axes);
        turned.shifted(g, link.at)
    }

    fn turned_about_z(&self, g: &mut Graph, cos: Node, sin: Node) -> Self {
        let inertia = turned_about_z(g, cos, sin, self.inertia);
        Distribution { mass: self.mass, first: vector::turn_z(g, cos, sin, self.first), inertia }
    }
}

/// I a.
pub fn apply(g: &mut Graph, [xx, yy, zz, xy, xz, yz]: Symmetric, a: Vec3) -> Vec3 {
    vector::apply(g, &[[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]], a)
}

/// R I Rᵀ of a turn about z. With t = s (Ixx − Iyy) + 2 c Ixy:  Ixx′ = Ixx − s t, Iyy′ = Iyy + s t, Ixy′ = c t − Ixy.
pub fn turned_about_z(g: &mut Graph, cos: Node, sin: Node, [xx, yy, zz, xy, xz, yz]: Symmetric) -> Symmetric {
    let two = g.constant(2.0);
    let difference = g.sub(xx, yy);
    let doubled = g.mul(two, xy);
    let (a, b) = (g.mul(sin, difference), g.mul(cos, doubled));
    let t = g.add(a, b);
    let (st, ct) = (g.mul(sin, t), g.mul(cos, t));
    let [xz, yz, _] = vector::turn_z(g, cos, sin, [xz, yz, zz]);
    [g.sub(xx, st), g.add(yy, st), zz, g.sub(ct, xy), xz, yz]
}

/// R I Rᵀ.
pub fn turned(g: &mut Graph, matrix: &Mat3, [xx, yy, zz, xy, xz, yz]: Symmetric) -> Symmetric {
    let tensor = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
    let half = vector::product(g, matrix, &tensor);
    ENTRIES.map(|(i, j)| vector::dot(g, half[i], matrix[j]))
}
