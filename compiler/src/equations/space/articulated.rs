//! M⁻¹ Q of a tree without constraints by articulated bodies (Featherstone, Rigid Body Dynamics Algorithms, 2008, section 7.3),
//! whose work grows with the number of links and not with its cube.
//!
//! Here without velocities, which Q has in it already. A link and all that hangs on it answer an acceleration (α, a) of their
//! origin with the wrench  n = I α + H a + n₀,  f = Hᵀ α + A a + f₀,  in the axes of the link. Backwards, for
//! each of its velocities with the axis S: U = (I, H; Hᵀ, A) S, d = S·U, u = Q − S·(n₀, f₀); the answer of the rest is
//! that less U Uᵀ/d, plus U u/d. Forwards v̇ = (u − U·(α, a))/d. The masses are those of the mass matrix, regrouped.

use super::kinematics::Kinematics;
use super::links::{GROUND, Link, Motion};
use super::tensor::{self, Distribution, Symmetric};
use super::vector::{self, Mat3, Vec3};
use crate::symbolic::{Graph, Node, Unary};

/// A spatial vector (Featherstone 2008, chapter 2) at the origin of a link, in its axes: a wrench, a motion or an axis of motion.
#[derive(Clone, Copy)]
struct SpatialVector {
    /// Moment, or angular acceleration.
    angular: Vec3,
    /// Force, or acceleration.
    linear: Vec3,
}

impl SpatialVector {
    fn zero(g: &mut Graph) -> Self {
        SpatialVector { angular: vector::zero(g), linear: vector::zero(g) }
    }
    fn add(self, g: &mut Graph, other: SpatialVector) -> SpatialVector {
        SpatialVector {
            angular: vector::add(g, self.angular, other.angular),
            linear: vector::add(g, self.linear, other.linear),
        }
    }
    fn scale(self, g: &mut Graph, factor: Node) -> SpatialVector {
        SpatialVector {
            angular: vector::scale(g, factor, self.angular),
            linear: vector::scale(g, factor, self.linear),
        }
    }
    fn dot(self, g: &mut Graph, other: SpatialVector) -> Node {
        let (a, b) = (vector::dot(g, self.angular, other.angular), vector::dot(g, self.linear, other.linear));
        g.add(a, b)
    }
    /// The same wrench, whose part along an axis is known: S·f = `force`. That is an entry where S is an axis of coordinates.
    fn with(mut self, g: &mut Graph, axis: SpatialVector, force: Node) -> SpatialVector {
        for (own, axis) in [(&mut self.angular, axis.angular), (&mut self.linear, axis.linear)] {
            if let Some(k) = coordinate(g, axis) {
                own[k] = g.div(force, axis[k]);
            }
        }
        self
    }
    /// Wrench at the origin of the parent, in its axes.
    fn in_parent(self, g: &mut Graph, link: &Link) -> SpatialVector {
        let (moment, force) = (link.up(g, self.angular), link.up(g, self.linear));
        let offset = link.offset(g);
        let arm = vector::cross(g, offset, force);
        SpatialVector { angular: vector::add(g, moment, arm), linear: force }
    }
    /// Acceleration of the link's origin as part of its parent, in its own axes.
    fn in_child(self, g: &mut Graph, link: &Link) -> SpatialVector {
        let offset = link.offset(g);
        let swung = vector::cross(g, self.angular, offset);
        let acceleration = vector::add(g, self.linear, swung);
        SpatialVector { angular: link.down(g, self.angular), linear: link.down(g, acceleration) }
    }
}

/// I, H and A.
#[derive(Clone, Copy)]
struct Articulated {
    moments: Symmetric,
    mixed: Mat3,
    masses: Symmetric,
}

impl Articulated {
    fn of(g: &mut Graph, distribution: &Distribution) -> Self {
        let Distribution { mass, first: [x, y, z], inertia } = *distribution;
        let zero = g.constant(0.0);
        let [minus_x, minus_y, minus_z] = vector::neg(g, [x, y, z]);
        let mixed = [[zero, minus_z, y], [z, zero, minus_x], [minus_y, x, zero]];
        Articulated { moments: inertia, mixed, masses: [mass, mass, mass, zero, zero, zero] }
    }

    fn apply(&self, g: &mut Graph, a: SpatialVector) -> SpatialVector {
        let turning = tensor::apply(g, self.moments, a.angular);
        let across = vector::apply(g, &self.mixed, a.linear);
        let back = vector::apply_transposed(g, &self.mixed, a.angular);
        let sliding = tensor::apply(g, self.masses, a.linear);
        SpatialVector { angular: vector::add(g, turning, across), linear: vector::add(g, back, sliding) }
    }

    fn add(&self, g: &mut Graph, other: &Self) -> Self {
        let symmetric = |g: &mut Graph, a: Symmetric, b: Symmetric| -> Symmetric {
            std::array::from_fn(|k| g.add(a[k], b[k]))
        };
        Articulated {
            moments: symmetric(g, self.moments, other.moments),
            mixed: std::array::from_fn(|k| vector::add(g, self.mixed[k], other.mixed[k])),
            masses: symmetric(g, self.masses, other.masses),
        }
    }

    /// Less U (U/d)ᵀ.
    fn less(&self, g: &mut Graph, u: SpatialVector, over: SpatialVector) -> Self {
        let entry = |g: &mut Graph, from: Node, a: Node, b: Node| {
            let product = g.mul(a, b);
            g.sub(from, product)
        };
        let symmetric = |g: &mut Graph, from: Symmetric, a: Vec3, b: Vec3| -> Symmetric {
            std::array::from_fn(|k| entry(g, from[k], a[tensor::ENTRIES[k].0], b[tensor::ENTRIES[k].1]))
        };
        Articulated {
            moments: symmetric(g, self.moments, u.angular, over.angular),
            mixed: std::array::from_fn(|i| {
                std::array::from_fn(|j| entry(g, self.mixed[i][j], u.angular[i], over.linear[j]))
            }),
            masses: symmetric(g, self.masses, u.linear, over.linear),
        }
    }

    /// Nothing resists along an axis whose velocity has been eliminated. Where that is an axis of coordinates, entries are zero.
    fn free_along(mut self, g: &mut Graph, axis: SpatialVector) -> Self {
        let zero = g.constant(0.0);
        let clear = |symmetric: &mut Symmetric, k: usize| {
            for (entry, (i, j)) in symmetric.iter_mut().zip(tensor::ENTRIES) {
                if i == k || j == k {
                    *entry = zero;
                }
            }
        };
        if let Some(k) = coordinate(g, axis.angular) {
            clear(&mut self.moments, k);
            self.mixed[k] = [zero; 3];
        }
        if let Some(k) = coordinate(g, axis.linear) {
            clear(&mut self.masses, k);
            self.mixed.iter_mut().for_each(|row| row[k] = zero);
        }
        self
    }

    /// At the origin of the parent, in its axes.
    fn in_parent(&self, g: &mut Graph, link: &Link) -> Self {
        let turned = match &link.motion {
            Motion::None | Motion::Slide { .. } => *self,
            Motion::Turn { cos, sin, .. } => self.turned_about_z(g, *cos, *sin),
            Motion::Ball { matrix, .. } => self.turned(g, matrix),
        };
        let turned = turned.turned(g, &link.axes);
        let offset = link.offset(g);
        turned.shifted(g, offset)
    }

    fn turned(&self, g: &mut Graph, matrix: &Mat3) -> Self {
        let half = vector::product(g, matrix, &self.mixed);
        Articulated {
            moments: tensor::turned(g, matrix, self.moments),
            mixed: vector::product_transposed(g, &half, matrix),
            masses: tensor::turned(g, matrix, self.masses),
        }
    }

    fn turned_about_z(&self, g: &mut Graph, cos: Node, sin: Node) -> Self {
        // Rows, then columns.
        let mut turn = |m: Mat3| {
            let columns = vector::transposed(&m).map(|column| vector::turn_z(g, cos, sin, column));
            vector::transposed(&columns)
        };
        let rows = turn(self.mixed);
        let mixed = vector::transposed(&turn(vector::transposed(&rows)));
        Articulated {
            moments: tensor::turned_about_z(g, cos, sin, self.moments),
            mixed,
            masses: tensor::turned_about_z(g, cos, sin, self.masses),
        }
    }

    /// About the point from which this origin lies at `d`: α and a − d × α there are those here, so that
    ///   A′ = A,  H′ = H + d̃ A,  I′ = I + d̃ Hᵀ − H d̃ − d̃ A d̃ = I + d̃ Hᵀ − H′ d̃.
    fn shifted(&self, g: &mut Graph, d: Vec3) -> Self {
        if vector::is_zero(g, d) {
            return *self;
        }
        let [xx, yy, zz, xy, xz, yz] = self.masses;
        // Columns of A and of H′: d × each column of A.
        let columns = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
        let moved = vector::transposed(&columns.map(|column| vector::cross(g, d, column)));
        let mixed: Mat3 = std::array::from_fn(|k| vector::add(g, self.mixed[k], moved[k]));
        // (d̃ Hᵀ)ᵢⱼ = (d × row j of H)ᵢ,  (−H′ d̃)ᵢⱼ = (d × row i of H′)ⱼ.
        let near = self.mixed.map(|row| vector::cross(g, d, row));
        let far = mixed.map(|row| vector::cross(g, d, row));
        let moments = std::array::from_fn(|k| {
            let (i, j) = tensor::ENTRIES[k];
            let both = g.add(near[j][i], far[i][j]);
            g.add(self.moments[k], both)
        });
        Articulated { moments, mixed, masses: self.masses }
    }
}

/// The axis of coordinates along which a vector points.
fn coordinate(g: &Graph, axis: Vec3) -> Option<usize> {
    let mut along = (0..3).filter(|k| !g.is_zero(axis[*k]));
    along.next().filter(|_| along.next().is_none())
}

/// A velocity that has been eliminated.
struct Step {
    velocity: usize,
    axis: SpatialVector,
    /// U/d and u/d.
    over: SpatialVector,
    rest: Node,
}

/// Whether every velocity moves one link only: those of a screw move two.
pub fn applies(kinematics: &Kinematics) -> bool {
    let moved: usize = kinematics.links.iter().map(Link::freedoms).sum();
    moved == kinematics.velocities.len()
}

impl Step {
    /// v̇, and the motion with it.
    fn accelerated(&self, g: &mut Graph, motion: SpatialVector) -> (Node, SpatialVector) {
        // Along an axis of coordinates S·U/d = 1 lets the motion so far cancel from what it becomes.
        let mut others = motion;
        let zero = g.constant(0.0);
        let taken_out = |g: &Graph, axis: Vec3, part: &mut Vec3| {
            let k = coordinate(g, axis)?;
            Some((std::mem::replace(&mut part[k], zero), axis[k]))
        };
        let own = taken_out(g, self.axis.angular, &mut others.angular)
            .or_else(|| taken_out(g, self.axis.linear, &mut others.linear));
        if let Some((own, factor)) = own {
            let before = g.div(own, factor);
            let taken = self.over.dot(g, others);
            let free = g.sub(self.rest, taken);
            let along = self.axis.scale(g, free);
            return (g.sub(free, before), others.add(g, along));
        }
        let taken = self.over.dot(g, motion);
        let acceleration = g.sub(self.rest, taken);
        let own = self.axis.scale(g, acceleration);
        (acceleration, motion.add(g, own))
    }
}

/// v̇ of M v̇ = Q, where [it applies](applies).
pub fn accelerations(
    g: &mut Graph,
    kinematics: &Kinematics,
    distributions: &[Distribution],
    forces: &[Node],
) -> Vec<Node> {
    let links = &kinematics.links;
    let mut answers: Vec<Articulated> =
        distributions.iter().map(|distribution| Articulated::of(g, distribution)).collect();
    let none = SpatialVector::zero(g);
    let mut wrenches = vec![none; links.len()];
    let mut steps: Vec<Vec<Step>> = links.iter().map(|_| Vec::new()).collect();
    for (at, link) in links.iter().enumerate().skip(1).rev() {
        let (mut answer, mut wrench) = (answers[at], wrenches[at]);
        for (velocity, axis) in axes(g, link) {
            let u = answer.apply(g, axis);
            let d = axis.dot(g, u);
            let inverse = g.unary(Unary::Reciprocal, d);
            let over = u.scale(g, inverse);
            let resisted = axis.dot(g, wrench);
            let rest = g.sub(forces[velocity], resisted);
            let carried = over.scale(g, rest);
            answer = answer.less(g, u, over).free_along(g, axis);
            wrench = wrench.add(g, carried).with(g, axis, forces[velocity]);
            let rest = g.mul(rest, inverse);
            steps[at].push(Step { velocity, axis, over, rest });
        }
        if link.parent != GROUND {
            let carried = answer.in_parent(g, link);
            answers[link.parent] = answers[link.parent].add(g, &carried);
            let carried = wrench.in_parent(g, link);
            wrenches[link.parent] = wrenches[link.parent].add(g, carried);
        }
    }
    let zero = g.constant(0.0);
    let mut found = vec![zero; forces.len()];
    let mut motions = vec![none; links.len()];
    for (at, link) in links.iter().enumerate().skip(1) {
        let mut motion = motions[link.parent].in_child(g, link);
        for step in steps[at].iter().rev() {
            let (acceleration, moved) = step.accelerated(g, motion);
            found[step.velocity] = acceleration;
            motion = moved;
        }
        motions[at] = motion;
    }
    found
}

/// Velocities of a link and their axes, at its origin and in its axes.
fn axes(g: &mut Graph, link: &Link) -> Vec<(usize, SpatialVector)> {
    let none = vector::zero(g);
    let mut found = Vec::new();
    for (velocity, axis) in link.turning(g) {
        found.push((velocity, SpatialVector { angular: axis, linear: none }));
    }
    if let Some((velocity, axis)) = link.sliding(g) {
        found.push((velocity, SpatialVector { angular: none, linear: axis }));
    }
    found
}
