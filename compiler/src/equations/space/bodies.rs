//! What each body does and what each joint exerts, once v̇ and λ are known.
//!
//! Every body is laid over as a free one that moves as it does; the columns of rows and loads in its velocities then turn
//! multipliers and efforts into forces on it, by virtual work. The reactions of joints that carry bodies follow from the
//! Newton–Euler equations of the bodies, from the leaves of the tree inwards.

use super::dynamics::{self, inertia_in_body};
use super::kinematics::Kinematics;
use super::links::{GROUND, Link, Motion, Placement};
use super::tensor;
use super::vector::{self, Mat3, Vec3};
use crate::equations::{BodyMotion, Consequences, Dropped, Jet, Laws, Row, SpanningTree, loads};
use crate::model::{BodyKind, Frame};
use crate::symbolic::{Graph, Node};
use std::collections::BTreeMap;

/// Velocities of a body as laid over: three of its centre, world axes, and three of ω, body axes.
const FREEDOMS: usize = 6;

/// Motion of one body.
struct Moving {
    position: Vec3,
    /// World ← body.
    axes: Mat3,
    velocity: Vec3,
    omega: Vec3,
    acceleration: Vec3,
    alpha: Vec3,
}

/// Force and moment on a body, world axes, about its centre of mass.
#[derive(Clone, Copy)]
struct Load {
    force: Vec3,
    moment: Vec3,
}

/// Motions of the bodies and reactions of the joints.
pub fn consequences(
    g: &mut Graph,
    laws: &Laws,
    tree: &SpanningTree,
    rows: &[Row],
    lambda: &[Node],
    dropped: &[Dropped],
) -> Consequences {
    let crate::equations::Kinematics::Space(kinematics) = laws.kinematics() else {
        return Consequences { motions: Vec::new(), reactions: Vec::new() };
    };
    let moving = motions(g, laws, kinematics);
    let overlay = crate::equations::Kinematics::Space(overlay(g, laws, &moving));
    let absolute = Laws::moving(laws.mechanism, laws.symbols, laws.layout, &overlay);
    let absolute_rows = crate::equations::rows(g, &absolute, tree, &tree.carrying(laws.mechanism), dropped);
    let reactions = reactions(g, &absolute, tree, &moving, rows, lambda, &absolute_rows);
    Consequences { motions: moving.iter().map(Moving::flat).collect(), reactions }
}

impl Moving {
    fn flat(&self) -> BodyMotion {
        BodyMotion {
            position: self.position.to_vec(),
            orientation: self.axes.concat(),
            velocity: self.velocity.to_vec(),
            rate: self.omega.to_vec(),
            acceleration: self.acceleration.to_vec(),
            angular_acceleration: self.alpha.to_vec(),
        }
    }
}

/// Motion of all bodies, with v̇ taken as given.
fn motions(g: &mut Graph, laws: &Laws, kinematics: &Kinematics) -> Vec<Moving> {
    let zero = vector::zero(g);
    let links = dynamics::motions(g, kinematics, Some(&laws.symbols.acceleration), zero);
    // World ← link, and the link's origin in the world.
    let mut frames: Vec<(Mat3, Vec3)> = vec![(vector::identity(g), zero)];
    for link in kinematics.links.iter().skip(1) {
        let (axes, origin) = frames[link.parent];
        let offset = link.offset(g);
        let offset = vector::apply(g, &axes, offset);
        let turned = axes.map(|row| link.down(g, row));
        frames.push((turned, vector::add(g, origin, offset)));
    }
    let mut found = Vec::new();
    for (body, placement) in laws.mechanism.bodies.iter().zip(&kinematics.bodies) {
        let (axes, origin) = frames[placement.link];
        let link = links[placement.link];
        let center = laws.vector(g, &body.center);
        let center = vector::apply(g, &placement.axes, center);
        let center = vector::add(g, placement.at, center);
        let arm = vector::apply(g, &axes, center);
        let swept = vector::cross(g, link.omega, center);
        let velocity = vector::add(g, link.velocity, swept);
        let swung = vector::apply(g, &link.spin, center);
        let acceleration = vector::add(g, link.acceleration, swung);
        let rigid = body.kind == BodyKind::Rigid;
        let turned = |g: &mut Graph, x: Vec3| vector::apply_transposed(g, &placement.axes, x);
        found.push(Moving {
            position: vector::add(g, origin, arm),
            axes: if rigid { vector::product(g, &axes, &placement.axes) } else { vector::identity(g) },
            velocity: vector::apply(g, &axes, velocity),
            omega: if rigid { turned(g, link.omega) } else { zero },
            acceleration: vector::apply(g, &axes, acceleration),
            alpha: if rigid { turned(g, link.alpha) } else { zero },
        });
    }
    found
}

/// The same bodies, each free, with velocities that are those of `motions`.
fn overlay(g: &mut Graph, laws: &Laws, motions: &[Moving]) -> Kinematics {
    let (zero, identity, one) = (vector::zero(g), vector::identity(g), g.constant(1.0));
    let ground = Link::ground(g);
    let mut overlay = Kinematics {
        links: vec![ground],
        velocities: Vec::new(),
        bodies: Vec::new(),
        angles: BTreeMap::new(),
        travels: BTreeMap::new(),
        balls: BTreeMap::new(),
    };
    for (index, (motion, body)) in motions.iter().zip(&laws.mechanism.bodies).enumerate() {
        overlay.velocities.extend(motion.velocity);
        overlay.velocities.extend(motion.omega);
        let mut parent = GROUND;
        let mut push = |overlay: &mut Kinematics, motion: Motion| {
            let still = Link { parent, at: zero, at_drift: zero, at_bias: zero, axes: identity, motion };
            overlay.links.push(still);
            parent = overlay.links.len() - 1;
            parent
        };
        let mut last = GROUND;
        for (axis, direction) in identity.into_iter().enumerate() {
            let motion = Motion::Slide {
                axis: direction,
                travel: motion.position[axis],
                rate: FREEDOMS * index + axis,
                factor: one,
            };
            last = push(&mut overlay, motion);
        }
        if body.kind == BodyKind::Rigid {
            last = push(&mut overlay, Motion::Ball { matrix: motion.axes, rate: FREEDOMS * index + 3 });
        }
        let center = laws.vector(g, &body.center);
        overlay.bodies.push(Placement { link: last, at: vector::neg(g, center), axes: identity });
    }
    overlay
}

/// Force and torque that each joint exerts on its second place's body, world axes, about the second place.
fn reactions(
    g: &mut Graph,
    absolute: &Laws,
    tree: &SpanningTree,
    motions: &[Moving],
    rows: &[Row],
    multipliers: &[Node],
    absolute_rows: &[Row],
) -> Vec<Vec<Node>> {
    let mechanism = absolute.mechanism;
    let zero = g.constant(0.0);
    let mut wrenches = vec![vec![zero; FREEDOMS]; mechanism.joints.len()];
    for (joint, own_rows) in crate::equations::multipliers_of_joints(rows) {
        let definition = &mechanism.joints[joint];
        let (frame, sign) = match definition.second.frame {
            Frame::Ground => (definition.first.frame, false),
            second => (second, true),
        };
        let Frame::Body(body) = frame else { continue };
        let mut load = Load { force: [zero; 3], moment: [zero; 3] };
        for row in own_rows {
            let lambda = g.neg(multipliers[row]);
            load = add_row(g, load, &motions[body.0], body.0, &absolute_rows[row].jet, lambda);
        }
        wrenches[joint] = at_second(g, absolute, motions, joint, body.0, load, sign);
    }

    // What each body needs from the joint it hangs on: m a − applied + what its children need.
    let mut needed = inertia_less_applied(g, absolute, motions, absolute_rows, multipliers);
    for attachment in tree.attachments.iter().rev() {
        let Some((joint, parent)) = attachment.joint else { continue };
        let child = attachment.body.0;
        let need = needed[child];
        if let Frame::Body(parent) = parent {
            let arm = vector::sub(g, motions[child].position, motions[parent.0].position);
            let lever = vector::cross(g, arm, need.force);
            let moment = vector::add(g, need.moment, lever);
            let sum = &mut needed[parent.0];
            sum.force = vector::add(g, sum.force, need.force);
            sum.moment = vector::add(g, sum.moment, moment);
        }
        let child_is_second = mechanism.joints[joint.0].second.frame == Frame::Body(attachment.body);
        wrenches[joint.0] = at_second(g, absolute, motions, joint.0, child, need, child_is_second);
    }
    wrenches
}

/// A load about a body's centre, about the second place of a joint; reversed where the body is that of the first.
fn at_second(
    g: &mut Graph,
    absolute: &Laws,
    motions: &[Moving],
    joint: usize,
    body: usize,
    load: Load,
    is_second: bool,
) -> Vec<Node> {
    let second = &absolute.mechanism.joints[joint].second;
    let at: Vec<Jet> = absolute.kinematics().world(g, absolute, second);
    let at = [at[0].value, at[1].value, at[2].value];
    let arm = vector::sub(g, motions[body].position, at);
    let lever = vector::cross(g, arm, load.force);
    let torque = vector::add(g, load.moment, lever);
    let wrench = [load.force, torque].concat();
    if is_second { wrench } else { wrench.into_iter().map(|node| g.neg(node)).collect() }
}

/// Adds effort·column of a coordinate in the velocities of one body.
fn add_row(g: &mut Graph, load: Load, motion: &Moving, body: usize, jet: &Jet, effort: Node) -> Load {
    let zero = g.constant(0.0);
    let entry = |k: usize| jet.columns.get(&(FREEDOMS * body + k)).copied().unwrap_or(zero);
    let (linear, angular) = ([0, 1, 2].map(entry), [3, 4, 5].map(entry));
    let force = vector::scale(g, effort, linear);
    let moment = vector::scale(g, effort, angular);
    let moment = vector::apply(g, &motion.axes, moment);
    Load { force: vector::add(g, load.force, force), moment: vector::add(g, load.moment, moment) }
}

/// m a and J α + ω × J ω, less loads, gravity and the forces of the multipliers, per body.
fn inertia_less_applied(
    g: &mut Graph,
    absolute: &Laws,
    motions: &[Moving],
    rows: &[Row],
    multipliers: &[Node],
) -> Vec<Load> {
    let mechanism = absolute.mechanism;
    let gravity = mechanism.gravity.as_ref().map(|gravity| absolute.vector(g, gravity));
    let mut needed = Vec::new();
    for (body, motion) in mechanism.bodies.iter().zip(motions) {
        let mass = absolute.value(g, &body.mass);
        let mut acceleration = motion.acceleration;
        if let Some(gravity) = gravity {
            acceleration = vector::sub(g, acceleration, gravity);
        }
        let moment = match body.kind {
            BodyKind::Particle => vector::zero(g),
            BodyKind::Rigid => {
                let tensor = inertia_in_body(g, absolute, &body.inertia);
                let (spun, accelerated) =
                    (tensor::apply(g, tensor, motion.omega), tensor::apply(g, tensor, motion.alpha));
                let gyration = vector::cross(g, motion.omega, spun);
                let moment = vector::add(g, accelerated, gyration);
                vector::apply(g, &motion.axes, moment)
            }
        };
        needed.push(Load { force: vector::scale(g, mass, acceleration), moment });
    }
    let minus_one = g.constant(-1.0);
    for load in &mechanism.loads {
        let mut columns = Jet::constant(g, minus_one);
        for (index, force) in loads::terms(g, absolute, load).forces {
            let zero = g.constant(0.0);
            let own = columns.columns.get(&index).copied().unwrap_or(zero);
            columns.columns.insert(index, g.add(own, force));
        }
        for (body, motion) in motions.iter().enumerate() {
            needed[body] = add_row(g, needed[body], motion, body, &columns, minus_one);
        }
    }
    for (row, lambda) in rows.iter().zip(multipliers) {
        for (body, motion) in motions.iter().enumerate() {
            needed[body] = add_row(g, needed[body], motion, body, &row.jet, *lambda);
        }
    }
    needed
}
