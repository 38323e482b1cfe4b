//! M⁻¹ Q of a tree without constraints by articulated bodies (Featherstone, Rigid Body Dynamics Algorithms, 2008, section 7.3),
//! whose work grows with the number of links and not with its cube.
//!
//! Here without velocities, which Q has in it already. A link and all that hangs on it answer an acceleration (α, a) of their
//! origin with the wrench  n = I α + H a + n₀,  f = Hᵀ α + A a + f₀,  in the axes of the link. Backwards, for
//! each of its velocities with the axis S: U = (I, H; Hᵀ, A) S, d = S·U, u = Q − S·(n₀, f₀); the answer of the rest is
//! that less U Uᵀ/d, plus U u/d. Forwards v̇ = (u − U·(α, a))/d. The masses are those of the mass matrix, regrouped.

use super::kinematics::Kinematics;
use super::links::{GROUND, Link, Motion};
use super::tensor::{Distribution, ENTRIES, Symmetric};
use super::vector::{self, Mat3, Vec3, vector};
use crate::symbolic::{Node, On, Scalar, Sheet};
use std::ops::{Add, Mul};

/// A spatial vector (Featherstone 2008, chapter 2) at the origin of a link, in its axes: a wrench, a motion or an axis of motion.
#[derive(Clone, Copy)]
struct SpatialVector<'g> {
    /// Moment, or angular acceleration.
    angular: On<'g, Vec3>,
    /// Force, or acceleration.
    linear: On<'g, Vec3>,
}

impl<'g> Add for SpatialVector<'g> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        SpatialVector { angular: self.angular + other.angular, linear: self.linear + other.linear }
    }
}

impl<'g> Mul<SpatialVector<'g>> for Scalar<'g> {
    type Output = SpatialVector<'g>;
    fn mul(self, vector: SpatialVector<'g>) -> SpatialVector<'g> {
        SpatialVector { angular: self * vector.angular, linear: self * vector.linear }
    }
}

impl<'g> SpatialVector<'g> {
    fn zero(g: Sheet<'g>) -> Self {
        SpatialVector { angular: vector::zero(g), linear: vector::zero(g) }
    }
    fn dot(self, other: SpatialVector<'g>) -> Scalar<'g> {
        self.angular.dot(other.angular) + self.linear.dot(other.linear)
    }
    /// The same wrench, whose part along an axis is known: S·f = `force`. That is an entry where S is an axis of coordinates.
    fn with(mut self, axis: SpatialVector<'g>, force: Scalar<'g>) -> SpatialVector<'g> {
        for (own, axis) in [(&mut self.angular, axis.angular), (&mut self.linear, axis.linear)] {
            if let Some(k) = coordinate(axis) {
                own.bare[k] = (force / axis.at(k)).bare;
            }
        }
        self
    }
    /// Wrench at the origin of the parent, in its axes.
    fn in_parent(self, link: On<'g, &Link>) -> SpatialVector<'g> {
        let (moment, force) = (link.up(self.angular), link.up(self.linear));
        let arm = link.offset().cross(force);
        SpatialVector { angular: moment + arm, linear: force }
    }
    /// Acceleration of the link's origin as part of its parent, in its own axes.
    fn in_child(self, link: On<'g, &Link>) -> SpatialVector<'g> {
        let swung = self.angular.cross(link.offset());
        let acceleration = self.linear + swung;
        SpatialVector { angular: link.down(self.angular), linear: link.down(acceleration) }
    }
}

/// I, H and A.
#[derive(Clone, Copy)]
struct Articulated<'g> {
    moments: On<'g, Symmetric>,
    mixed: On<'g, Mat3>,
    masses: On<'g, Symmetric>,
}

impl<'g> Add for Articulated<'g> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Articulated {
            moments: self.moments + other.moments,
            mixed: rows(self.moments.g, |k| self.mixed.row(k) + other.mixed.row(k)),
            masses: self.masses + other.masses,
        }
    }
}

impl<'g> Mul<SpatialVector<'g>> for Articulated<'g> {
    type Output = SpatialVector<'g>;
    fn mul(self, a: SpatialVector<'g>) -> SpatialVector<'g> {
        let turning = self.moments.bare * a.angular;
        let across = self.mixed * a.linear;
        let back = self.mixed.transposed() * a.angular;
        let sliding = self.masses.bare * a.linear;
        SpatialVector { angular: turning + across, linear: back + sliding }
    }
}

fn rows<'g>(g: Sheet<'g>, row: impl Fn(usize) -> On<'g, Vec3>) -> On<'g, Mat3> {
    g.on([0, 1, 2].map(|k| row(k).bare))
}

impl<'g> Articulated<'g> {
    fn of(g: Sheet<'g>, distribution: &Distribution) -> Self {
        let Distribution { mass, first, inertia } = *distribution;
        let zero = g.zero().bare;
        let ([x, y, z], [minus_x, minus_y, minus_z]) = (first, (-g.on(first)).bare);
        let mixed = [[zero, minus_z, y], [z, zero, minus_x], [minus_y, x, zero]];
        let masses = Symmetric([mass, mass, mass, zero, zero, zero]);
        Articulated { moments: g.on(inertia), mixed: g.on(mixed), masses: g.on(masses) }
    }

    /// Less U (U/d)ᵀ.
    fn less(self, u: SpatialVector<'g>, over: SpatialVector<'g>) -> Self {
        let g = u.angular.g;
        let symmetric = |from: On<'g, Symmetric>, a: On<'g, Vec3>, b: On<'g, Vec3>| {
            Symmetric::of(g, |k| from.at(k) - a.at(ENTRIES[k].0) * b.at(ENTRIES[k].1))
        };
        Articulated {
            moments: symmetric(self.moments, u.angular, over.angular),
            mixed: rows(g, |i| vector(|j| self.mixed.row(i).at(j) - u.angular.at(i) * over.linear.at(j))),
            masses: symmetric(self.masses, u.linear, over.linear),
        }
    }

    /// Nothing resists along an axis whose velocity has been eliminated. Where that is an axis of coordinates, entries are zero.
    fn free_along(mut self, axis: SpatialVector<'g>) -> Self {
        let zero = self.moments.g.zero().bare;
        let clear = |symmetric: &mut Symmetric, k: usize| {
            for (entry, (i, j)) in symmetric.0.iter_mut().zip(ENTRIES) {
                if i == k || j == k {
                    *entry = zero;
                }
            }
        };
        if let Some(k) = coordinate(axis.angular) {
            clear(&mut self.moments.bare, k);
            self.mixed.bare[k] = [zero; 3];
        }
        if let Some(k) = coordinate(axis.linear) {
            clear(&mut self.masses.bare, k);
            self.mixed.bare.iter_mut().for_each(|row| row[k] = zero);
        }
        self
    }

    /// At the origin of the parent, in its axes.
    fn in_parent(self, link: On<'g, &Link>) -> Self {
        let g = link.g;
        let turned = match &link.bare.motion {
            Motion::None | Motion::Slide { .. } | Motion::Shift { .. } => self,
            Motion::Turn { cos, sin, .. } => self.turned_about_z(g.on(*cos), g.on(*sin)),
            Motion::Ball { matrix, .. } | Motion::Lean { matrix, .. } => self.turned(g.on(*matrix)),
        };
        turned.turned(g.on(link.bare.axes)).shifted(link.offset())
    }

    fn turned(self, matrix: On<'g, Mat3>) -> Self {
        let half = matrix * self.mixed;
        Articulated {
            moments: self.moments.turned(matrix.bare),
            mixed: half * matrix.transposed(),
            masses: self.masses.turned(matrix.bare),
        }
    }

    fn turned_about_z(self, cos: Scalar<'g>, sin: Scalar<'g>) -> Self {
        let turn = |x: On<'g, Vec3>| x.turned_about_z(cos, sin);
        let mixed = self.mixed.map_columns(turn).map_rows(turn);
        Articulated {
            moments: self.moments.turned_about_z(cos, sin),
            mixed,
            masses: self.masses.turned_about_z(cos, sin),
        }
    }

    /// About the point from which this origin lies at `d`: α and a − d × α there are those here, so that
    ///   A′ = A,  H′ = H + d̃ A,  I′ = I + d̃ Hᵀ − H d̃ − d̃ A d̃ = I + d̃ Hᵀ − H′ d̃.
    fn shifted(self, d: On<'g, Vec3>) -> Self {
        if d.is_zero() {
            return self;
        }
        let g = d.g;
        let moved = g.on(self.masses.bare.matrix()).map_columns(|column| d.cross(column));
        let mixed = rows(g, |k| self.mixed.row(k) + moved.row(k));
        // (d̃ Hᵀ)ᵢⱼ = (d × row j of H)ᵢ,  (−H′ d̃)ᵢⱼ = (d × row i of H′)ⱼ.
        let near = self.mixed.map_rows(|row| d.cross(row));
        let far = mixed.map_rows(|row| d.cross(row));
        let moments = Symmetric::of(g, |k| {
            let (i, j) = ENTRIES[k];
            self.moments.at(k) + (near.row(j).at(i) + far.row(i).at(j))
        });
        Articulated { moments, mixed, masses: self.masses }
    }
}

/// The axis of coordinates along which a vector points.
fn coordinate(axis: On<Vec3>) -> Option<usize> {
    let mut along = (0..3).filter(|k| !axis.at(*k).is_zero());
    along.next().filter(|_| along.next().is_none())
}

/// A velocity that has been eliminated.
struct Step<'g> {
    velocity: usize,
    axis: SpatialVector<'g>,
    /// U/d and u/d.
    over: SpatialVector<'g>,
    rest: Scalar<'g>,
}

/// Whether every velocity moves one link only: those of a screw move two, and those of beams more than links.
pub fn applies(kinematics: &Kinematics) -> bool {
    if kinematics.bodies.iter().any(|body| body.flexible.is_some()) {
        return false;
    }
    let moved: usize = kinematics.links.iter().map(Link::freedoms).sum();
    moved == kinematics.velocities.len()
}

impl<'g> Step<'g> {
    /// v̇, and the motion with it.
    fn accelerated(&self, motion: SpatialVector<'g>) -> (Scalar<'g>, SpatialVector<'g>) {
        // Along an axis of coordinates S·U/d = 1 lets the motion so far cancel from what it becomes.
        let mut others = motion;
        let zero = self.rest.g.zero().bare;
        let taken_out = |axis: On<'g, Vec3>, part: &mut On<'g, Vec3>| {
            let k = coordinate(axis)?;
            let own = part.at(k);
            part.bare[k] = zero;
            Some(own / axis.at(k))
        };
        let before = taken_out(self.axis.angular, &mut others.angular)
            .or_else(|| taken_out(self.axis.linear, &mut others.linear));
        if let Some(before) = before {
            let free = self.rest - self.over.dot(others);
            let along = free * self.axis;
            return (free - before, others + along);
        }
        let acceleration = self.rest - self.over.dot(motion);
        (acceleration, motion + acceleration * self.axis)
    }
}

/// v̇ of M v̇ = Q, where [it applies](applies).
pub fn accelerations<'g>(
    kinematics: On<'g, &Kinematics>,
    distributions: &[Distribution],
    forces: &[Node],
) -> Vec<Scalar<'g>> {
    let g = kinematics.g;
    let links = &kinematics.bare.links;
    let mut answers: Vec<Articulated> =
        distributions.iter().map(|distribution| Articulated::of(g, distribution)).collect();
    let none = SpatialVector::zero(g);
    let mut wrenches = vec![none; links.len()];
    let mut steps: Vec<Vec<Step>> = links.iter().map(|_| Vec::new()).collect();
    for (at, link) in links.iter().enumerate().skip(1).rev() {
        let link = g.on(link);
        let (mut answer, mut wrench) = (answers[at], wrenches[at]);
        for (velocity, axis) in axes(link) {
            let force = g.on(forces[velocity]);
            let u = answer * axis;
            let inverse = axis.dot(u).reciprocal();
            let over = inverse * u;
            let rest = force - axis.dot(wrench);
            let carried = rest * over;
            answer = answer.less(u, over).free_along(axis);
            wrench = (wrench + carried).with(axis, force);
            steps[at].push(Step { velocity, axis, over, rest: rest * inverse });
        }
        let parent = link.bare.parent;
        if parent != GROUND {
            answers[parent] = answers[parent] + answer.in_parent(link);
            wrenches[parent] = wrenches[parent] + wrench.in_parent(link);
        }
    }
    let mut found = vec![g.zero(); forces.len()];
    let mut motions = vec![none; links.len()];
    for (at, link) in links.iter().enumerate().skip(1) {
        let mut motion = motions[link.parent].in_child(g.on(link));
        for step in steps[at].iter().rev() {
            (found[step.velocity], motion) = step.accelerated(motion);
        }
        motions[at] = motion;
    }
    found
}

/// Velocities of a link and their axes, at its origin and in its axes.
fn axes<'g>(link: On<'g, &Link>) -> Vec<(usize, SpatialVector<'g>)> {
    let none = vector::zero(link.g);
    let mut found = Vec::new();
    for (velocity, axis) in link.turning() {
        found.push((velocity, SpatialVector { angular: axis, linear: none }));
    }
    for (velocity, axis) in link.sliding() {
        found.push((velocity, SpatialVector { angular: none, linear: axis }));
    }
    found
}
