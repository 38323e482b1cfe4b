//! What each body does and what each joint exerts, once v̇ and λ are known.
//!
//! In tree coordinates the joints that carry bodies have no multipliers; their reactions follow from the
//! Newton–Euler equations of the bodies, from the leaves of the tree inwards.

use super::inertia::Massive;
use super::joints::{self, Wrench};
use super::kinematics::{GROUND, Kinematics, LocalVector, Placement, Position, TurningFrame};
use crate::equations::coordinates::Symbols;
use crate::equations::laws::Laws;
use crate::equations::spanning_tree::SpanningTree;
use crate::equations::{BodyMotion, Row, loads, multipliers_of_joints};
use crate::model::{BodyKind, Frame, Mechanism};
use crate::symbolic::{Graph, Node};

/// Motion of a body: centre of mass x, y; cos, sin of its orientation; their velocities and accelerations.
#[derive(Clone, Copy, Debug)]
pub struct Motion {
    pub position: [Node; 2],
    pub orientation: [Node; 2],
    pub velocity: [Node; 2],
    pub rate: Node,
    pub acceleration: [Node; 2],
    pub angular_acceleration: Node,
}

impl Motion {
    pub fn flat(&self) -> BodyMotion {
        BodyMotion {
            position: self.position.to_vec(),
            orientation: self.orientation.to_vec(),
            velocity: self.velocity.to_vec(),
            rate: vec![self.rate],
            acceleration: self.acceleration.to_vec(),
            angular_acceleration: vec![self.angular_acceleration],
        }
    }
}

/// Motion of all bodies, with v̇ taken as given.
pub fn motions(g: &mut Graph, kinematics: &Kinematics, bodies: &[Massive], symbols: &Symbols) -> Vec<Motion> {
    let zero = g.constant(0.0);
    let mut motions = Vec::new();
    for (index, body) in bodies.iter().enumerate() {
        let [x, y] = kinematics.world(g, &body.center);
        let rate = kinematics.frames[body.frame].rate.filter(|_| body.inertia.is_some());
        motions.push(Motion {
            position: [x.value, y.value],
            orientation: kinematics.orientation(g, index),
            velocity: [x.rate(g, &symbols.v), y.rate(g, &symbols.v)],
            rate: rate.map_or(zero, |rate| symbols.v[rate]),
            acceleration: [
                x.acceleration(g, &symbols.acceleration),
                y.acceleration(g, &symbols.acceleration),
            ],
            angular_acceleration: rate.map_or(zero, |rate| symbols.acceleration[rate]),
        });
    }
    motions
}

/// The same bodies in absolute coordinates, whose values are those of `motions`.
pub fn overlay(g: &mut Graph, laws: &Laws, motions: &[Motion]) -> Kinematics {
    let (zero, one) = (g.constant(0.0), g.constant(1.0));
    let mut overlay = Kinematics {
        frames: vec![TurningFrame { cos: one, sin: zero, rate: None }],
        velocities: Vec::new(),
        bodies: Vec::new(),
    };
    for (index, (motion, body)) in motions.iter().zip(&laws.mechanism.bodies).enumerate() {
        overlay.velocities.extend([motion.velocity[0], motion.velocity[1], motion.rate]);
        let mut vector = LocalVector::fixed(g, motion.position);
        vector.slides.insert(3 * index, [one, zero]);
        vector.slides.insert(3 * index + 1, [zero, one]);
        let center = Position::of(GROUND, vector);
        let placement = match body.kind {
            BodyKind::Particle => Placement { origin: center, frame: GROUND, offset: [one, zero] },
            BodyKind::Rigid => {
                let [cos, sin] = motion.orientation;
                overlay.frames.push(TurningFrame { cos, sin, rate: Some(3 * index + 2) });
                let frame = overlay.frames.len() - 1;
                let at = laws.pair_of(g, &body.center);
                let arm = Position::fixed(g, frame, at);
                Placement { origin: center.sub(g, &arm), frame, offset: [one, zero] }
            }
        };
        overlay.bodies.push(placement);
    }
    overlay
}

/// Wrench that each joint exerts on its second place's body, in the order of the joints.
#[allow(clippy::too_many_arguments)]
pub fn reactions(
    g: &mut Graph,
    laws: &Laws,
    absolute: &Laws,
    tree: &SpanningTree,
    bodies: &[Massive],
    motions: &[Motion],
    cut_rows: &[Row],
    multipliers: &[Node],
    absolute_rows: &[Row],
) -> Vec<Wrench> {
    let mechanism = laws.mechanism;
    let zero = g.constant(0.0);
    let mut wrenches = vec![[zero; 3]; mechanism.joints.len()];
    for (joint, rows) in multipliers_of_joints(cut_rows) {
        let definition = &mechanism.joints[joint];
        // A row that was left out has no multiplier.
        let lambda: Vec<Node> = joints::rows(g, laws, definition)
            .iter()
            .map(|own| rows.iter().find(|row| cut_rows[**row].what == own.what))
            .map(|row| row.map_or(zero, |row| multipliers[*row]))
            .collect();
        wrenches[joint] = joints::reaction(g, laws, definition, &lambda);
    }

    // What each body needs from the joint it hangs on: m a − applied + what its children need.
    let mut needed = inertia_less_applied(g, absolute, bodies, motions, absolute_rows, multipliers);
    for attachment in tree.attachments.iter().rev() {
        let Some((joint, parent)) = attachment.joint else { continue };
        let child = attachment.body.0;
        let need = needed[child];
        if let Frame::Body(parent) = parent {
            let arm = difference(g, motions[child].position, motions[parent.0].position);
            let moment = moment(g, arm, need);
            let sum = &mut needed[parent.0];
            sum[0] = g.add(sum[0], need[0]);
            sum[1] = g.add(sum[1], need[1]);
            sum[2] = g.add(sum[2], moment);
        }
        let joint_definition = &mechanism.joints[joint.0];
        let second = laws.plane().place(g, laws, &joint_definition.second);
        let [x, y] = laws.plane().world(g, &second);
        let arm = difference(g, motions[child].position, [x.value, y.value]);
        // What turns freely exerts no torque, by construction.
        let torque = if joint_definition.form.keeps_orientation { moment(g, arm, need) } else { zero };
        let wrench = [need[0], need[1], torque];
        let child_is_second = joint_definition.second.frame == Frame::Body(attachment.body);
        wrenches[joint.0] = if child_is_second { wrench } else { wrench.map(|node| g.neg(node)) };
    }
    wrenches
}

/// m a − (loads + gravity + forces of the multipliers), per body, moments about its centre.
fn inertia_less_applied(
    g: &mut Graph,
    absolute: &Laws,
    bodies: &[Massive],
    motions: &[Motion],
    absolute_rows: &[Row],
    multipliers: &[Node],
) -> Vec<Wrench> {
    let mechanism: &Mechanism = absolute.mechanism;
    let zero = g.constant(0.0);
    let gravity = mechanism.gravity.as_ref().map(|gravity| absolute.pair_of(g, gravity));
    let mut needed = Vec::new();
    for (body, motion) in bodies.iter().zip(motions) {
        let mut acceleration = motion.acceleration;
        if let Some(gravity) = gravity {
            acceleration = difference(g, acceleration, gravity);
        }
        let inertia = body.inertia.unwrap_or(zero);
        needed.push([
            g.mul(body.mass, acceleration[0]),
            g.mul(body.mass, acceleration[1]),
            g.mul(inertia, motion.angular_acceleration),
        ]);
    }
    for load in &mechanism.loads {
        for (index, force) in loads::terms(g, absolute, load).forces {
            let entry = &mut needed[index / 3][index % 3];
            *entry = g.sub(*entry, force);
        }
    }
    for (row, lambda) in absolute_rows.iter().zip(multipliers) {
        for (index, column) in &row.jet.columns {
            let force = g.mul(*column, *lambda);
            let entry = &mut needed[index / 3][index % 3];
            *entry = g.add(*entry, force);
        }
    }
    needed
}

fn difference(g: &mut Graph, a: [Node; 2], b: [Node; 2]) -> [Node; 2] {
    [g.sub(a[0], b[0]), g.sub(a[1], b[1])]
}

/// Moment of a wrench, given about the tip of `arm`, about its foot.
fn moment(g: &mut Graph, arm: [Node; 2], wrench: Wrench) -> Node {
    let (xy, yx) = (g.mul(arm[0], wrench[1]), g.mul(arm[1], wrench[0]));
    let cross = g.sub(xy, yx);
    g.add(wrench[2], cross)
}
