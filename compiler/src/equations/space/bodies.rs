//! What each body does and what each joint exerts, once v̇ and λ are known.
//!
//! Every body is laid over as a free one that moves as it does; the columns of rows and loads in its velocities then turn
//! multipliers and efforts into forces on it, by virtual work. The reactions of joints that carry bodies follow from the
//! Newton–Euler equations of the bodies, from the leaves of the tree inwards.

use super::dynamics::{self, LinkMotion, inertia_in_body};
use super::flexible::{self, Flexible, Spread};
use super::kinematics::Kinematics;
use super::links::{GROUND, Link, Motion, Placement};
use super::vector::{self, Mat3, Vec3};
use crate::equations::loads::penalty;
use crate::equations::{BodyMotion, Consequences, Jet, Laws, Row, RowOfJoint, SpanningTree, loads};
use crate::model::{BodyId, Frame, JointId};
use crate::symbolic::{Node, On, Scalar};
use std::collections::BTreeMap;

/// Velocities of a body as laid over: three of its centre, world axes, and three of ω, body axes.
const FREEDOMS: usize = 6;

/// Motion of one body.
struct Moving<'g> {
    position: On<'g, Vec3>,
    /// World ← body.
    axes: On<'g, Mat3>,
    velocity: On<'g, Vec3>,
    omega: On<'g, Vec3>,
    acceleration: On<'g, Vec3>,
    alpha: On<'g, Vec3>,
}

/// Force and moment on a body, world axes, about its centre of mass.
#[derive(Clone, Copy)]
struct Load<'g> {
    force: On<'g, Vec3>,
    moment: On<'g, Vec3>,
}

/// Motions of the bodies and reactions of the joints.
pub fn consequences(
    laws: &Laws,
    tree: &SpanningTree,
    rows: &[Row],
    lambda: &[Node],
    dropped: &[RowOfJoint],
) -> Consequences {
    let Some(kinematics) = laws.space() else {
        return Consequences { motions: Vec::new(), reactions: Vec::new() };
    };
    let moving = motions(laws, kinematics);
    let overlay = crate::equations::Kinematics::Space(overlay(laws, &moving));
    let absolute = laws.of(&overlay);
    let absolute_rows =
        crate::equations::rows::rows(&absolute, tree, &tree.carrying(laws.mechanism), dropped, None);
    let reactions = reactions(laws, &absolute, tree, &moving, rows, lambda, &absolute_rows);
    Consequences { motions: moving.iter().map(Moving::flat).collect(), reactions }
}

impl Moving<'_> {
    fn flat(&self) -> BodyMotion {
        BodyMotion {
            position: self.position.bare.to_vec(),
            orientation: self.axes.bare.concat(),
            velocity: self.velocity.bare.to_vec(),
            rate: self.omega.bare.to_vec(),
            acceleration: self.acceleration.bare.to_vec(),
            angular_acceleration: self.alpha.bare.to_vec(),
        }
    }
}

/// Motion of all bodies, with v̇ taken as given.
fn motions<'g>(laws: &Laws<'g>, kinematics: On<'g, &Kinematics>) -> Vec<Moving<'g>> {
    let g = laws.g;
    let (zero, identity) = (vector::zero(g), vector::identity(g));
    let links = dynamics::motions(kinematics, Some(&laws.symbols.acceleration), zero);
    // World ← link, and the link's origin in the world.
    let mut frames = vec![(identity, zero)];
    for link in kinematics.bare.links.iter().skip(1) {
        let (axes, origin) = frames[link.parent];
        let offset = axes * g.on(link).offset();
        let turned = axes.map_rows(|row| g.on(link).down(row));
        frames.push((turned, origin + offset));
    }
    let mut found = Vec::new();
    for (body, placement) in laws.mechanism.bodies.iter().zip(&kinematics.bare.bodies) {
        let (axes, origin) = frames[placement.link];
        let link = links[placement.link];
        let center = g.on(placement).point(laws.vector(&body.center));
        let arm = axes * center;
        let velocity = link.velocity + link.omega.cross(center);
        let acceleration = link.acceleration + link.spin * center;
        let turns = body.form.turns;
        let in_body = |x: On<'g, Vec3>| if turns { vector::transposed(&placement.axes) * x } else { zero };
        found.push(Moving {
            position: origin + arm,
            axes: if turns { axes * placement.axes } else { identity },
            velocity: axes * velocity,
            omega: in_body(link.omega),
            acceleration: axes * acceleration,
            alpha: in_body(link.alpha),
        });
    }
    found
}

/// The same bodies, each free, with velocities that are those of `motions`.
fn overlay<'g>(laws: &Laws<'g>, motions: &[Moving<'g>]) -> Kinematics {
    let g = laws.g;
    let (identity, one) = (vector::identity(g).bare, g.one().bare);
    let mut overlay = Kinematics {
        links: vec![Link::still(g, GROUND)],
        velocities: Vec::new(),
        bodies: Vec::new(),
        angles: BTreeMap::new(),
        travels: BTreeMap::new(),
        balls: BTreeMap::new(),
        sections: BTreeMap::new(),
    };
    for motion in motions {
        overlay.velocities.extend(motion.velocity.bare);
        overlay.velocities.extend(motion.omega.bare);
    }
    for (index, (motion, body)) in motions.iter().zip(&laws.mechanism.bodies).enumerate() {
        let mut last = GROUND;
        let mut push = |motion: Motion| {
            overlay.links.push(Link { motion, ..Link::still(g, last) });
            last = overlay.links.len() - 1;
        };
        for (k, axis) in identity.into_iter().enumerate() {
            let travel = motion.position.bare[k];
            push(Motion::Slide { axis, travel, rate: FREEDOMS * index + k, factor: one });
        }
        if body.form.turns {
            push(Motion::Ball { matrix: motion.axes.bare, rate: FREEDOMS * index + 3 });
        }
        let at = (-laws.vector(&body.center)).bare;
        let flexible = flexible_behind(laws, index, &mut overlay.velocities);
        let placement = Placement { link: last, at, axes: identity, flexible };
        overlay.add_sections(g, laws.mechanism, BodyId(index), &placement);
        overlay.bodies.push(placement);
    }
    overlay
}

/// The modes of a body with velocities of their own, behind those of the bodies.
fn flexible_behind(laws: &Laws, body: usize, velocities: &mut Vec<Node>) -> Option<Flexible> {
    let own = laws.space()?.bare;
    let mut flexible = own.bodies[body].flexible.clone()?;
    for modal in &mut flexible.modes {
        velocities.push(own.velocities[modal.velocity]);
        modal.velocity = velocities.len() - 1;
    }
    Some(flexible)
}

/// Force and torque that each joint exerts on its second place's body, world axes, about the second place.
fn reactions<'g>(
    laws: &Laws<'g>,
    absolute: &Laws<'g>,
    tree: &SpanningTree,
    motions: &[Moving<'g>],
    rows: &[Row],
    multipliers: &[Node],
    absolute_rows: &[Row],
) -> Vec<Vec<Node>> {
    let (g, mechanism) = (absolute.g, absolute.mechanism);
    let zero = vector::zero(g);
    let mut wrenches = vec![vec![zero.bare[0]; FREEDOMS]; mechanism.joints.len()];
    let mut exerts = |joint: usize, rows: &[(&Jet, Scalar<'g>)]| {
        let definition = &mechanism.joints[joint];
        let (frame, sign) = match definition.second.frame {
            Frame::Ground => (definition.first.frame, false),
            second => (second, true),
        };
        let Frame::Body(body) = frame else { return };
        let mut load = Load { force: zero, moment: zero };
        for (jet, multiplier) in rows {
            load.add_row(&motions[body.0], body.0, jet, -*multiplier);
        }
        wrenches[joint] = load.at_second(absolute, motions, joint, body.0, sign);
    };
    for (joint, own) in crate::equations::rows::multipliers_of_joints(rows) {
        let rows = own.iter().map(|row| (&absolute_rows[*row].jet, g.on(multipliers[*row])));
        exerts(joint, &rows.collect::<Vec<_>>());
    }
    for index in (0..mechanism.joints.len()).filter(|joint| !mechanism.joints[*joint].holds()) {
        let yielding = penalty::yielding(absolute, JointId(index));
        exerts(index, &yielding.iter().map(|it| (&it.row.jet, it.multiplier)).collect::<Vec<_>>());
    }

    // What each body needs from the joint it hangs on: m a − applied + what its children need.
    let mut needed = inertia_less_applied(laws, absolute, motions, absolute_rows, multipliers);
    for attachment in tree.attachments.iter().rev() {
        let Some((joint, parent)) = attachment.joint else { continue };
        let child = attachment.body.0;
        let need = needed[child];
        if let Frame::Body(parent) = parent {
            let moment = need.moment_about(motions[child].position - motions[parent.0].position);
            let sum = &mut needed[parent.0];
            sum.force += need.force;
            sum.moment += moment;
        }
        let child_is_second = mechanism.joints[joint.0].second.frame == Frame::Body(attachment.body);
        wrenches[joint.0] = need.at_second(absolute, motions, joint.0, child, child_is_second);
    }
    wrenches
}

impl<'g> Load<'g> {
    /// The moment about the foot of an arm whose tip is the centre of mass.
    fn moment_about(self, arm: On<'g, Vec3>) -> On<'g, Vec3> {
        self.moment + arm.cross(self.force)
    }

    /// About the second place of a joint; reversed where the body is that of the first.
    fn at_second(
        self,
        absolute: &Laws<'g>,
        motions: &[Moving<'g>],
        joint: usize,
        body: usize,
        is_second: bool,
    ) -> Vec<Node> {
        let second = &absolute.mechanism.joints[joint].second;
        let at = absolute.kinematics().world(absolute, second);
        let arm = motions[body].position - [0, 1, 2].map(|k| at[k].jet.value);
        let (force, torque) = (self.force, self.moment_about(arm));
        let (force, torque) = if is_second { (force, torque) } else { (-force, -torque) };
        [force.bare, torque.bare].concat()
    }

    /// Adds effort·column of a coordinate in the velocities of one body.
    fn add_row(&mut self, motion: &Moving<'g>, body: usize, jet: &Jet, effort: Scalar<'g>) {
        let zero = effort.g.zero().bare;
        let entry = |k: usize| jet.columns.get(&(FREEDOMS * body + k)).copied().unwrap_or(zero);
        let (force, moment) = (effort * [0, 1, 2].map(entry), effort * [3, 4, 5].map(entry));
        let moment = motion.axes * moment;
        self.force += force;
        self.moment += moment;
    }
}

/// m a of a beam less its weight, and what that has about the origin of its frame.
fn inertia_of_beam<'g>(
    laws: &Laws<'g>,
    index: usize,
    motion: &Moving<'g>,
    gravity: Option<On<'g, Vec3>>,
) -> Option<Load<'g>> {
    let (g, kinematics) = (laws.g, laws.space()?);
    let flexible = kinematics.bare.bodies[index].flexible.as_ref()?;
    let body = &laws.mechanism.bodies[index];
    let mass = laws.value(&body.mass);
    let turning = flexible::turning_factor(laws, mass, body.deforms.as_ref()?);
    let frame = Placement::of_ground(g);
    let beam = Spread::new(kinematics, &frame, flexible, mass, turning);
    let acceleration = gravity.map_or(motion.acceleration, |gravity| motion.acceleration - gravity);
    let back = motion.axes.transposed();
    let moved = LinkMotion::new(motion.omega, motion.alpha, back * motion.velocity, back * acceleration);
    let rigid = dynamics::needed(beam.distribution(), &moved);
    let [moment, force] = beam.beyond(&moved, Some(&laws.symbols.acceleration));
    Some(Load { force: motion.axes * (rigid.force + force), moment: motion.axes * (rigid.moment + moment) })
}

/// m a and J α + ω × J ω, less loads, gravity and the forces of the multipliers, per body.
fn inertia_less_applied<'g>(
    laws: &Laws<'g>,
    absolute: &Laws<'g>,
    motions: &[Moving<'g>],
    rows: &[Row],
    multipliers: &[Node],
) -> Vec<Load<'g>> {
    let (g, mechanism) = (absolute.g, absolute.mechanism);
    let gravity = mechanism.gravity.as_ref().map(|gravity| absolute.vector(gravity));
    let mut needed = Vec::new();
    for (index, (body, motion)) in mechanism.bodies.iter().zip(motions).enumerate() {
        let mass = absolute.value(&body.mass);
        if let Some(load) = inertia_of_beam(laws, index, motion, gravity) {
            needed.push(load);
            continue;
        }
        let acceleration = gravity.map_or(motion.acceleration, |gravity| motion.acceleration - gravity);
        let moment = if body.form.turns {
            let tensor = inertia_in_body(absolute, &body.inertia).bare;
            let (spun, accelerated) = (tensor * motion.omega, tensor * motion.alpha);
            let gyration = motion.omega.cross(spun);
            motion.axes * (accelerated + gyration)
        } else {
            vector::zero(g)
        };
        needed.push(Load { force: mass * acceleration, moment });
    }
    let minus_one = g.number(-1.0);
    for load in &mechanism.loads {
        let mut columns = Jet::constant(minus_one);
        for (index, force) in loads::terms(absolute, load).forces {
            let own = columns.columns.get(&index).map_or_else(|| g.zero(), |own| g.on(*own));
            columns.columns.insert(index, (own + force).bare);
        }
        for (body, motion) in motions.iter().enumerate() {
            needed[body].add_row(motion, body, &columns, minus_one);
        }
    }
    for (row, lambda) in rows.iter().zip(multipliers) {
        for (body, motion) in motions.iter().enumerate() {
            needed[body].add_row(motion, body, &row.jet, g.on(*lambda));
        }
    }
    needed
}
