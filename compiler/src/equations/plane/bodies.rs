//! What each body does and what each joint exerts, once v̇ and λ are known.
//!
//! In tree coordinates the joints that carry bodies have no multipliers; their reactions follow from the
//! Newton–Euler equations of the bodies, from the leaves of the tree inwards.

use super::flexible::{Flexible, ModalMotion, inertia_beyond_origin};
use super::inertia::Massive;
use super::joints::{self, Wrench};
use super::kinematics::{GROUND, Kinematics, LocalVector, Placement, Position, Travelled, TurningFrame};
use super::vector::{self, Pair};
use crate::equations::laws::Laws;
use crate::equations::loads::penalty;
use crate::equations::rows::multipliers_of_joints;
use crate::equations::spanning_tree::SpanningTree;
use crate::equations::{BodyMotion, Row, loads};
use crate::forms::RowForm;
use crate::model::{Frame, JointId};
use crate::symbolic::{Node, On, Scalar};

/// Motion of a body: centre of mass x, y; cos, sin of its orientation; their velocities and accelerations.
#[derive(Clone, Copy)]
pub struct Motion<'g> {
    pub position: On<'g, Pair>,
    pub orientation: On<'g, Pair>,
    pub velocity: On<'g, Pair>,
    pub rate: Scalar<'g>,
    pub acceleration: On<'g, Pair>,
    pub angular_acceleration: Scalar<'g>,
}

impl Motion<'_> {
    pub fn flat(&self) -> BodyMotion {
        BodyMotion {
            position: self.position.bare.to_vec(),
            orientation: self.orientation.bare.to_vec(),
            velocity: self.velocity.bare.to_vec(),
            rate: vec![self.rate.bare],
            acceleration: self.acceleration.bare.to_vec(),
            angular_acceleration: vec![self.angular_acceleration.bare],
        }
    }
}

/// Motion of all bodies, with v̇ taken as given.
pub fn motions<'g>(laws: &Laws<'g>, bodies: &[Massive<'g>]) -> Vec<Motion<'g>> {
    let (g, kinematics) = (laws.g, laws.plane());
    let zero = g.zero();
    let mut motions = Vec::new();
    for (index, body) in bodies.iter().enumerate() {
        let center = kinematics.world(&body.center);
        let [x, y] = &center;
        let rate = kinematics.bare.frames[body.frame].rate.filter(|_| body.inertia.is_some());
        let a = &laws.symbols.acceleration;
        motions.push(Motion {
            position: g.on([x.jet.value, y.jet.value]),
            orientation: kinematics.orientation(index),
            velocity: g.on([x.rate().bare, y.rate().bare]),
            rate: rate.map_or(zero, |rate| g.on(laws.symbols.v[rate])),
            acceleration: g.on([x.acceleration(a).bare, y.acceleration(a).bare]),
            angular_acceleration: rate.map_or(zero, |rate| g.on(a[rate])),
        });
    }
    motions
}

/// The same bodies in absolute coordinates, whose values are those of `motions`.
pub fn overlay<'g>(laws: &Laws<'g>, motions: &[Motion<'g>]) -> Kinematics {
    let g = laws.g;
    let offset = vector::unturned(g).bare;
    let travels = laws.plane().bare.travels.iter();
    let travels = travels.map(|(joint, travel)| (*joint, Travelled { index: None, ..*travel })).collect();
    let mut overlay = Kinematics {
        frames: vec![TurningFrame::still(g)],
        velocities: Vec::new(),
        bodies: Vec::new(),
        travels,
    };
    for (index, (motion, body)) in motions.iter().zip(&laws.mechanism.bodies).enumerate() {
        overlay.velocities.extend(motion.velocity.bare);
        overlay.velocities.push(motion.rate.bare);
        let mut center = LocalVector::fixed(motion.position);
        center.slide_freely(g, 3 * index);
        let center = Position::of(GROUND, center);
        let placement = if body.form.turns {
            let [cos, sin] = motion.orientation.bare;
            overlay.frames.push(TurningFrame { cos, sin, rate: Some(3 * index + 2) });
            let frame = overlay.frames.len() - 1;
            let origin = g.on(center) - laws.pair_of(&body.center).fixed_in(frame);
            Placement { origin: origin.bare, frame, offset, flexible: given(laws, index) }
        } else {
            Placement { origin: center, frame: GROUND, offset, flexible: None }
        };
        overlay.bodies.push(placement);
    }
    overlay
}

/// The modes of a body with the motion that they have.
fn given(laws: &Laws, body: usize) -> Option<Flexible> {
    let mut flexible = laws.plane().bare.bodies[body].flexible.clone()?;
    for modal in &mut flexible.modes {
        if let ModalMotion::Free(index) = modal.motion {
            modal.motion = ModalMotion::Given(laws.symbols.acceleration[index]);
        }
    }
    Some(flexible)
}

/// Wrench that each joint exerts on its second place's body, in the order of the joints.
#[allow(clippy::too_many_arguments)]
pub fn reactions<'g>(
    laws: &Laws<'g>,
    absolute: &Laws<'g>,
    tree: &SpanningTree,
    bodies: &[Massive<'g>],
    motions: &[Motion<'g>],
    cut_rows: &[Row],
    multipliers: &[Node],
    absolute_rows: &[Row],
) -> Vec<Wrench<'g>> {
    let (g, mechanism) = (laws.g, laws.mechanism);
    let zero = g.zero();
    let mut wrenches = vec![[zero; 3]; mechanism.joints.len()];
    let moved = joints::with_room_for_reactions(laws);
    for (joint, rows) in multipliers_of_joints(cut_rows) {
        // A row that was left out has no multiplier.
        let lambda = |form: &RowForm| {
            let row = rows.iter().find(|row| cut_rows[**row].form == form)?;
            Some(g.on(multipliers[*row]))
        };
        let wrench = joints::reaction(&laws.of(&moved), &mechanism.joints[joint], lambda);
        wrenches[joint] = wrench.map(|part| g.on(part.bare));
    }

    for (index, joint) in mechanism.joints.iter().enumerate().filter(|(_, joint)| !joint.holds()) {
        let yielding = penalty::yielding(laws, JointId(index));
        let lambda = |form: &RowForm| Some(yielding.iter().find(|it| it.row.form == form)?.multiplier);
        let wrench = joints::reaction(&laws.of(&moved), joint, lambda);
        wrenches[index] = wrench.map(|part| g.on(part.bare));
    }

    // What each body needs from the joint it hangs on: m a − applied + what its children need.
    let mut needed = inertia_less_applied(laws, absolute, bodies, motions, absolute_rows, multipliers);
    for attachment in tree.attachments.iter().rev() {
        let Some((joint, parent)) = attachment.joint else { continue };
        let child = attachment.body.0;
        let need = needed[child];
        if let Frame::Body(parent) = parent {
            let arm = motions[child].position - motions[parent.0].position;
            let moment = moment(arm, need);
            let [x, y, torque] = &mut needed[parent.0];
            *x += need[0];
            *y += need[1];
            *torque += moment;
        }
        let joint_definition = &mechanism.joints[joint.0];
        let second = laws.plane().place_in_world(laws, &joint_definition.second);
        let arm = motions[child].position - second.map(|component| component.jet.value);
        // What turns freely exerts no torque, by construction.
        let torque = if joint_definition.form.keeps_orientation { moment(arm, need) } else { zero };
        let wrench = [need[0], need[1], torque];
        let child_is_second = joint_definition.second.frame == Frame::Body(attachment.body);
        wrenches[joint.0] = if child_is_second { wrench } else { wrench.map(|part| -part) };
    }
    wrenches
}

/// m a − (loads + gravity + forces of the multipliers), per body, moments about its centre.
fn inertia_less_applied<'g>(
    laws: &Laws<'g>,
    absolute: &Laws<'g>,
    bodies: &[Massive<'g>],
    motions: &[Motion<'g>],
    absolute_rows: &[Row],
    multipliers: &[Node],
) -> Vec<Wrench<'g>> {
    let (g, mechanism) = (absolute.g, absolute.mechanism);
    let gravity = mechanism.gravity.as_ref().map(|gravity| absolute.pair_of(gravity));
    let mut needed: Vec<Wrench> = Vec::new();
    for (index, (body, motion)) in bodies.iter().zip(motions).enumerate() {
        let acceleration = gravity.map_or(motion.acceleration, |gravity| motion.acceleration - gravity);
        let [x, y] = (body.mass * acceleration).parts();
        let mut need = [x, y, body.inertia.unwrap_or(g.zero()) * motion.angular_acceleration];
        if let Some(beyond) = inertia_beyond_origin(laws, bodies, index, acceleration) {
            need.iter_mut().zip(beyond).for_each(|(need, part)| *need += part);
        }
        needed.push(need);
    }
    for load in &mechanism.loads {
        for (index, force) in loads::terms(absolute, load).forces {
            needed[index / 3][index % 3] -= force;
        }
    }
    for (row, lambda) in absolute_rows.iter().zip(multipliers) {
        for (index, column) in &row.jet.columns {
            needed[index / 3][index % 3] += g.on(*column) * *lambda;
        }
    }
    needed
}

/// Moment of a wrench, given about the tip of `arm`, about its foot.
fn moment<'g>(arm: On<'g, Pair>, [x, y, torque]: Wrench<'g>) -> Scalar<'g> {
    torque + arm.cross([x.bare, y.bare])
}
