//! M by composite rigid bodies, inertia and gravity forces by recursive Newton–Euler, both on the tree of links.
//!
//! Forwards, in the axes of each link and at its origin (Featherstone, Rigid Body Dynamics Algorithms, 2008, chapters 5
//! and 6; Luh, Walker, Paul 1980):
//!   ω = Rᵀ ω_p + ω_r,  α = Rᵀ α_p + (Rᵀ ω_p) × ω_r + α_r,  a = Rᵀ (a_p + U_p d) + …,  U = α̃ + ω̃ ω̃,
//! with d from the parent's origin, and a = −g on the ground. Backwards, for a distribution (m, h, I) about the origin:
//!   F = m a + U h,  N = I α + ω × I ω + h × a.
//! Before that, what a turn or a slide cannot tell from mass of the parent is given to the parent (base inertial
//! parameters: Gautier & Khalil, IEEE Trans. Robotics and Automation 6, 1990): behind a turn about z, the mass, h_z and
//! a disk of moments I_yy; behind a slide, the tensor; behind a ball, the mass.

use super::axes;
use super::kinematics::Kinematics;
use super::links::{GROUND, Link, LinkId, Motion};
use super::tensor::{self, Distribution, Symmetric};
use super::vector::{self, Mat3, Vec3};
use crate::equations::{Dynamics, Laws};
use crate::model::BodyKind;
use crate::symbolic::{Graph, Node};
use std::collections::BTreeMap;

/// M, gyroscopic and gravity forces, energies.
pub fn dynamics(g: &mut Graph, laws: &Laws) -> Dynamics {
    let crate::equations::Kinematics::Space(kinematics) = laws.kinematics() else {
        let zero = g.constant(0.0);
        let (forces, inverse, distributions) = (Vec::new(), Vec::new(), Vec::new());
        return Dynamics {
            mass: BTreeMap::new(),
            forces,
            inverse,
            distributions,
            kinetic_energy: zero,
            potential_energy: zero,
        };
    };
    let gravity = match &laws.mechanism.gravity {
        Some(gravity) => laws.vector(g, gravity),
        None => vector::zero(g),
    };
    let distributions = distributions(g, laws, kinematics);
    let regrouped = regrouped(g, kinematics, &distributions);
    let composite = composite(g, kinematics, &regrouped);
    let mass = mass_matrix(g, kinematics, &composite);
    let upwards = vector::neg(g, gravity);
    let at_rest = motions(g, kinematics, None, upwards);
    let bias = newton_euler(g, kinematics, &regrouped, &at_rest);
    let forces = bias.iter().map(|force| g.neg(*force)).collect();
    let moving = motions(g, kinematics, Some(&laws.symbols.acceleration), upwards);
    let inverse = newton_euler(g, kinematics, &regrouped, &moving);
    let kinetic_energy = kinetic_energy(g, kinematics, &regrouped);
    let height = vector::dot(g, gravity, composite[GROUND].first);
    let potential_energy = g.neg(height);
    Dynamics { mass, forces, inverse, kinetic_energy, potential_energy, distributions: regrouped }
}

/// What the bodies on each link weigh.
fn distributions(g: &mut Graph, laws: &Laws, kinematics: &Kinematics) -> Vec<Distribution> {
    let none = Distribution::none(g);
    let mut found = vec![none; kinematics.links.len()];
    for (body, placement) in laws.mechanism.bodies.iter().zip(&kinematics.bodies) {
        let mass = laws.value(g, &body.mass);
        let center = laws.vector(g, &body.center);
        let center = vector::apply(g, &placement.axes, center);
        let center = vector::add(g, placement.at, center);
        let inertia = match body.kind {
            BodyKind::Particle => none.inertia,
            BodyKind::Rigid => {
                let tensor = inertia_in_body(g, laws, &body.inertia);
                tensor::turned(g, &placement.axes, tensor)
            }
        };
        let about_center = Distribution { mass, first: vector::zero(g), inertia };
        let about_origin = about_center.shifted(g, center);
        found[placement.link] = found[placement.link].add(g, &about_origin);
    }
    found
}

/// The tensor about the centre of mass in body axes.
pub fn inertia_in_body(g: &mut Graph, laws: &Laws, inertia: &crate::model::Inertia) -> Symmetric {
    let ([xx, yy, zz], [xy, xz, yz]) = (laws.vector(g, &inertia.moments), laws.vector(g, &inertia.products));
    let matrix = axes::matrix(g, laws, &inertia.axes);
    tensor::turned(g, &matrix, [xx, yy, zz, xy, xz, yz])
}

/// The same dynamics with fewer numbers, from the leaves inwards.
fn regrouped(g: &mut Graph, kinematics: &Kinematics, distributions: &[Distribution]) -> Vec<Distribution> {
    let zero = g.constant(0.0);
    let none = Distribution::none(g);
    let mut found = distributions.to_vec();
    for (at, link) in kinematics.links.iter().enumerate().skip(1).rev() {
        let own = found[at];
        // A foot that moves by itself makes mass at rest in the moving place do work.
        if own.is_none(g) || link.is_carried_by_time(g) {
            continue;
        }
        let [xx, yy, zz, xy, xz, yz] = own.inertia;
        let (given, kept) = match &link.motion {
            Motion::None => (own, none),
            Motion::Turn { .. } => (
                Distribution {
                    mass: own.mass,
                    first: [zero, zero, own.first[2]],
                    inertia: [yy, yy, zero, zero, zero, zero],
                },
                Distribution {
                    mass: zero,
                    first: [own.first[0], own.first[1], zero],
                    inertia: [g.sub(xx, yy), zero, zz, xy, xz, yz],
                },
            ),
            Motion::Slide { .. } => {
                (Distribution { inertia: own.inertia, ..none }, Distribution { inertia: none.inertia, ..own })
            }
            Motion::Ball { .. } => {
                (Distribution { mass: own.mass, ..none }, Distribution { mass: zero, ..own })
            }
        };
        found[at] = kept;
        let given = given.turned(g, &link.axes);
        let given = given.shifted(g, link.at);
        found[link.parent] = found[link.parent].add(g, &given);
    }
    found
}

/// What hangs on each link, itself included.
fn composite(g: &mut Graph, kinematics: &Kinematics, distributions: &[Distribution]) -> Vec<Distribution> {
    let mut composite = distributions.to_vec();
    for (at, link) in kinematics.links.iter().enumerate().skip(1).rev() {
        let carried = composite[at].in_parent(g, link);
        composite[link.parent] = composite[link.parent].add(g, &carried);
    }
    composite
}

/// Moment about a link's origin, and force, in its axes.
#[derive(Clone, Copy)]
struct Wrench {
    moment: Vec3,
    force: Vec3,
}

impl Wrench {
    fn in_parent(&self, g: &mut Graph, link: &Link) -> Wrench {
        let (mut moment, force) = (link.turn(g, self.moment), link.turn(g, self.force));
        let slide = link.slide(g);
        let arm = vector::cross(g, slide, force);
        moment = vector::add(g, moment, arm);
        let (moment, force) = (vector::apply(g, &link.axes, moment), vector::apply(g, &link.axes, force));
        let arm = vector::cross(g, link.at, force);
        Wrench { moment: vector::add(g, moment, arm), force }
    }

    /// Power on each velocity of the link: its index, and Sᵀ of the wrench.
    fn projections(&self, g: &mut Graph, link: &Link) -> Vec<(usize, Node)> {
        let mut found = Vec::new();
        for (velocity, axis) in link.turning(g) {
            found.push((velocity, vector::dot(g, axis, self.moment)));
        }
        if let Some((velocity, axis)) = link.sliding(g) {
            found.push((velocity, vector::dot(g, axis, self.force)));
        }
        found
    }
}

/// M_kl = S_l · (I^c S_k), carried from the link of k inwards.
fn mass_matrix(
    g: &mut Graph,
    kinematics: &Kinematics,
    composite: &[Distribution],
) -> BTreeMap<(usize, usize), Node> {
    let mut mass: BTreeMap<(usize, usize), Node> = BTreeMap::new();
    let mut accumulate = |g: &mut Graph, k: usize, l: usize, entry: Node| {
        let zero = g.constant(0.0);
        let own = mass.entry((k.max(l), k.min(l))).or_insert(zero);
        *own = g.add(*own, entry);
    };
    for (at, link) in kinematics.links.iter().enumerate().skip(1) {
        let Distribution { mass, first, inertia } = composite[at];
        let mut columns: Vec<(usize, Wrench)> = Vec::new();
        for (velocity, axis) in link.turning(g) {
            let moment = tensor::apply(g, inertia, axis);
            columns.push((velocity, Wrench { moment, force: vector::cross(g, axis, first) }));
        }
        if let Some((velocity, axis)) = link.sliding(g) {
            let moment = vector::cross(g, first, axis);
            columns.push((velocity, Wrench { moment, force: vector::scale(g, mass, axis) }));
        }
        for (k, wrench) in columns {
            for (l, entry) in wrench.projections(g, link).into_iter().filter(|(l, _)| *l <= k) {
                accumulate(g, k, l, entry);
            }
            let (mut wrench, mut below) = (wrench, link);
            loop {
                wrench = wrench.in_parent(g, below);
                if below.parent == GROUND {
                    break;
                }
                below = &kinematics.links[below.parent];
                for (l, entry) in wrench.projections(g, below) {
                    // One velocity that moves two links, as of a screw, meets itself both ways.
                    let entry = if l == k {
                        let two = g.constant(2.0);
                        g.mul(two, entry)
                    } else {
                        entry
                    };
                    accumulate(g, k, l, entry);
                }
            }
        }
    }
    mass.retain(|_, entry| !g.is_zero(*entry));
    mass
}

/// Motion of a link, in its axes and at its origin.
#[derive(Clone, Copy, Debug)]
pub struct LinkMotion {
    pub omega: Vec3,
    pub alpha: Vec3,
    pub velocity: Vec3,
    pub acceleration: Vec3,
    /// α̃ + ω̃ ω̃.
    pub spin: Mat3,
}

/// Motions of all links, with the accelerations given or zero, the ground's being `ground`.
pub fn motions(
    g: &mut Graph,
    kinematics: &Kinematics,
    accelerations: Option<&[Node]>,
    ground: Vec3,
) -> Vec<LinkMotion> {
    let zero = vector::zero(g);
    let rest = LinkMotion { omega: zero, alpha: zero, velocity: zero, acceleration: ground, spin: [zero; 3] };
    let mut motions = vec![rest];
    for link in kinematics.links.iter().skip(1) {
        let motion = moved(g, kinematics, link, &motions[link.parent], accelerations);
        motions.push(motion);
    }
    motions
}

fn moved(
    g: &mut Graph,
    kinematics: &Kinematics,
    link: &Link,
    parent: &LinkMotion,
    accelerations: Option<&[Node]>,
) -> LinkMotion {
    let v = &kinematics.velocities;
    let offset = link.offset(g);
    // At the link's origin, in the axes of the parent.
    let carried = vector::cross(g, parent.omega, offset);
    let carried = vector::add(g, carried, link.at_drift);
    let velocity = vector::add(g, parent.velocity, carried);
    let swung = vector::apply(g, &parent.spin, offset);
    let swung = vector::add(g, swung, link.at_bias);
    let acceleration = vector::add(g, parent.acceleration, swung);

    let (mut velocity, mut acceleration) = (link.down(g, velocity), link.down(g, acceleration));
    let (base_omega, base_alpha) = (link.down(g, parent.omega), link.down(g, parent.alpha));
    let relative = link.omega(g, v);
    let gyration = vector::cross(g, base_omega, relative);
    let omega = vector::add(g, base_omega, relative);
    let mut alpha = vector::add(g, base_alpha, gyration);
    if let Some(a) = accelerations {
        let own = link.omega(g, a);
        alpha = vector::add(g, alpha, own);
    }
    if let Some((rate, axis)) = link.sliding(g) {
        let speed = vector::scale(g, v[rate], axis);
        velocity = vector::add(g, velocity, speed);
        let two = g.constant(2.0);
        let coriolis = vector::cross(g, omega, speed);
        let coriolis = vector::scale(g, two, coriolis);
        acceleration = vector::add(g, acceleration, coriolis);
        if let Some(a) = accelerations {
            let own = vector::scale(g, a[rate], axis);
            acceleration = vector::add(g, acceleration, own);
        }
    }
    LinkMotion { omega, alpha, velocity, acceleration, spin: spin(g, omega, alpha) }
}

/// U = α̃ + ω̃ ω̃.
fn spin(g: &mut Graph, omega: Vec3, alpha: Vec3) -> Mat3 {
    let square = omega.map(|x| g.mul(x, x));
    let mut matrix = [vector::zero(g); 3];
    for k in 0..3 {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        let sum = g.add(square[i], square[j]);
        matrix[k][k] = g.neg(sum);
        let product = g.mul(omega[i], omega[j]);
        matrix[i][j] = g.sub(product, alpha[k]);
        matrix[j][i] = g.add(product, alpha[k]);
    }
    matrix
}

/// Forces that the motions need, per velocity.
fn newton_euler(
    g: &mut Graph,
    kinematics: &Kinematics,
    distributions: &[Distribution],
    motions: &[LinkMotion],
) -> Vec<Node> {
    let zero = g.constant(0.0);
    let mut forces = vec![zero; kinematics.velocities.len()];
    let mut wrenches: Vec<Wrench> = distributions
        .iter()
        .zip(motions)
        .map(|(distribution, motion)| needed(g, distribution, motion))
        .collect();
    for (at, link) in kinematics.links.iter().enumerate().skip(1).rev() {
        let wrench = wrenches[at];
        for (velocity, force) in wrench.projections(g, link) {
            forces[velocity] = g.add(forces[velocity], force);
        }
        let carried = wrench.in_parent(g, link);
        let parent: LinkId = link.parent;
        wrenches[parent] = Wrench {
            moment: vector::add(g, wrenches[parent].moment, carried.moment),
            force: vector::add(g, wrenches[parent].force, carried.force),
        };
    }
    forces
}

/// F = m a + U h, N = I α + ω × I ω + h × a. With U at hand the second is, component by component,
///   N_x = Ixx α_x + (Izz − Iyy) ω_y ω_z − Ixy U_zx + Ixz U_yx + Iyz (U_yy − U_zz) + …
fn needed(g: &mut Graph, distribution: &Distribution, motion: &LinkMotion) -> Wrench {
    let Distribution { mass, first, inertia } = *distribution;
    let LinkMotion { omega, alpha, acceleration, spin, .. } = *motion;
    let pushed = vector::scale(g, mass, acceleration);
    let swung = vector::apply(g, &spin, first);
    let force = vector::add(g, pushed, swung);
    // Products of inertia by the pair of axes they belong to: opposite x stands yz, and so on.
    let across = |a: usize, b: usize| inertia[2 + a + b];
    let lever = vector::cross(g, first, acceleration);
    let moment = std::array::from_fn(|x| {
        let (y, z) = ((x + 1) % 3, (x + 2) % 3);
        let product = g.mul(omega[y], omega[z]);
        let difference = g.sub(inertia[z], inertia[y]);
        let diagonal = g.sub(spin[y][y], spin[z][z]);
        let terms = [
            g.mul(inertia[x], alpha[x]),
            g.mul(difference, product),
            g.mul(across(x, z), spin[y][x]),
            g.mul(across(y, z), diagonal),
        ];
        let sum = g.sum(terms);
        let last = g.mul(across(x, y), spin[z][x]);
        let sum = g.sub(sum, last);
        g.add(sum, lever[x])
    });
    Wrench { moment, force }
}

/// T = Σ ½ (m v² + 2 v·(ω × h) + ω·I ω).
fn kinetic_energy(g: &mut Graph, kinematics: &Kinematics, distributions: &[Distribution]) -> Node {
    let zero = vector::zero(g);
    let motions = motions(g, kinematics, None, zero);
    let mut twice = g.constant(0.0);
    let two = g.constant(2.0);
    for (distribution, motion) in distributions.iter().zip(&motions) {
        let Distribution { mass, first, inertia } = *distribution;
        let square = vector::dot(g, motion.velocity, motion.velocity);
        let translation = g.mul(mass, square);
        let sweep = vector::cross(g, motion.omega, first);
        let mixed = vector::dot(g, motion.velocity, sweep);
        let mixed = g.mul(two, mixed);
        let spin = tensor::apply(g, inertia, motion.omega);
        let rotation = vector::dot(g, motion.omega, spin);
        let part = g.sum([translation, mixed, rotation]);
        twice = g.add(twice, part);
    }
    let half = g.constant(0.5);
    g.mul(half, twice)
}
