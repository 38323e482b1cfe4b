//! The coordinates of a spatial mechanism and where they put its bodies: every joint of the tree as a chain of links.

use super::axes;
use super::flexible::{Flexible, Modal};
use super::joints::{self, Elementary};
use super::kinematics::Kinematics;
use super::links::{GROUND, Link, LinkId, Motion, Placement};
use super::shapes::{Shapes, Station};
use super::vector::{self, Mat3, Vec3};
use crate::equations::coordinates::{Ball, Layout, Linear, MultiTurn, Rotation, Symbols, symbols};
use crate::equations::{Attachment, Laws, SpanningTree};
use crate::model::{BodyId, Deforms, Frame, JointId, Mechanism, Place, Rotor, fold};
use crate::symbolic::{Growing, On, Scalar, Sheet};
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// Coordinates for a spanning tree: their layout, symbols for them, and the links.
pub fn coordinates(
    g: Sheet,
    mechanism: &Mechanism,
    tree: &SpanningTree,
    rotors: &[Rotor],
) -> (Layout, Symbols, Kinematics) {
    let mut layout = layout(mechanism, tree);
    layout.angles = rotors.iter().map(|rotor| counted(mechanism, &layout, *rotor)).collect();
    let symbols = symbols(g, mechanism, &layout);
    let mut builder = Builder {
        laws: Laws::constant(g, mechanism, &symbols),
        layout: &layout,
        kinematics: Kinematics {
            links: vec![Link::still(g, GROUND)],
            velocities: symbols.v.clone(),
            bodies: Vec::new(),
            angles: BTreeMap::new(),
            travels: BTreeMap::new(),
            balls: BTreeMap::new(),
            sections: BTreeMap::new(),
        },
    };
    let mut placements: Vec<Option<Placement>> = vec![None; mechanism.bodies.len()];
    for Attachment { body, joint } in &tree.attachments {
        let placement = match joint {
            None => builder.free(*body),
            Some((joint, parent)) => {
                let parent = match parent {
                    Frame::Ground => None,
                    Frame::Body(parent) => placements[parent.0].clone(),
                };
                builder.attach(*joint, *body, parent)
            }
        };
        builder.kinematics.add_sections(g, mechanism, *body, &placement);
        placements[body.0] = Some(placement);
    }
    let mut kinematics = builder.kinematics;
    kinematics.bodies = placements.into_iter().flatten().collect();
    (layout, symbols, kinematics)
}

/// What each entry of q and v is, counted angles left out.
fn layout(mechanism: &Mechanism, tree: &SpanningTree) -> Layout {
    let mut layout = Layout::default();
    for Attachment { body, joint } in &tree.attachments {
        let definition = &mechanism.bodies[body.0];
        let turns = definition.form.turns;
        let modes = definition.deforms.as_ref().map_or(0, Deforms::modes);
        let Some((id, _)) = joint else {
            layout.linear.extend((0..3).map(|axis| Linear::Center(*body, axis)));
            layout.linear.extend((0..modes).map(|mode| Linear::Mode(*body, mode)));
            if turns {
                layout.quaternions.push(Ball::Body(*body));
            }
            continue;
        };
        for elementary in joints::motions(&mechanism.joints[id.0]).iter().copied() {
            match elementary {
                Elementary::Slide { which, .. } => layout.linear.push(Linear::Travel(*id, which)),
                Elementary::Turn { which, .. } => layout.rotations.push(Rotation::Joint(*id, which)),
                Elementary::Ball if turns => layout.quaternions.push(Ball::Joint(*id)),
                Elementary::Ball | Elementary::Wind => {}
            }
        }
        layout.linear.extend((0..modes).map(|mode| Linear::Mode(*body, mode)));
    }
    layout
}

/// The rate of an angle whose turns are counted: one velocity where its joint carries a body, else in absolute
/// coordinates z₂·ω₂ − z₁·ω₁ with axes that are known here. Whether one of both is so has been checked.
fn counted(mechanism: &Mechanism, layout: &Layout, rotor: Rotor) -> MultiTurn {
    let Rotor::Joint(id, which) = rotor else { return MultiTurn { rotor, rate: Vec::new() } };
    let own = layout.rotations.iter().position(|rotation| *rotation == Rotation::Joint(id, which));
    if let Some(own) = own {
        return MultiTurn { rotor, rate: vec![(layout.linear.len() + own, 1.0)] };
    }
    let joint = &mechanism.joints[id.0];
    let mut rate = Vec::new();
    for (place, sign) in [(&joint.first, -1.0), (&joint.second, 1.0)] {
        let Frame::Body(body) = place.frame else { continue };
        let Some(ball) = layout.quaternions.iter().position(|ball| *ball == Ball::Body(body)) else {
            continue;
        };
        let axis = constant_axis(mechanism, joint, place).unwrap_or_default();
        let weights = axis.into_iter().enumerate().filter(|(_, weight)| *weight != 0.0);
        rate.extend(weights.map(|(k, weight)| (layout.omega(ball) + k, sign * weight)));
    }
    rate.sort_by_key(|(index, _)| *index);
    MultiTurn { rotor, rate }
}

/// The unit vector of a joint's axis in the body of one of its places, if it is known at expansion.
pub fn constant_axis(mechanism: &Mechanism, joint: &crate::model::Joint, place: &Place) -> Option<[f64; 3]> {
    let axis = joint.common_axis()?;
    // The section of a beam turns within its body.
    if !mechanism.keeps_direction(place) {
        return None;
    }
    // Known without parameters.
    let known = axis.iter().all(|component| fold::evaluate(component, &[]).is_some());
    if !known {
        return None;
    }
    let none = SpanningTree { attachments: Vec::new() };
    let graph = Growing::default();
    let g = graph.sheet();
    let symbols = symbols(g, mechanism, &layout(mechanism, &none));
    let laws = Laws::constant(g, mechanism, &symbols);
    let matrix = axes::matrix(&laws, &place.axes);
    let axis = (matrix * laws.vector(axis).normalized()).parts().map(Scalar::value);
    let values: Vec<f64> = axis.into_iter().flatten().collect();
    values.try_into().ok()
}

struct Builder<'a> {
    laws: Laws<'a>,
    layout: &'a Layout,
    kinematics: Kinematics,
}

/// Where a chain of links has got to: a point and axes on the last link.
struct Cursor<'g> {
    link: LinkId,
    at: On<'g, Vec3>,
    /// Link ← axes of the place, and which joint frame has been undone last.
    axes: On<'g, Mat3>,
}

impl<'a> Builder<'a> {
    /// One more link at the cursor; the chain goes on from its origin.
    fn link(&mut self, cursor: Cursor<'a>, motion: Motion) -> Cursor<'a> {
        let g = self.laws.g;
        let foot = Link { at: cursor.at.bare, axes: cursor.axes.bare, ..Link::still(g, cursor.link) };
        let link = self.kinematics.push(Link { motion, ..foot });
        Cursor { link, at: vector::zero(g), axes: vector::identity(g) }
    }

    fn ball(&self, ball: Ball) -> Option<Motion> {
        let index = self.layout.quaternions.iter().position(|own| *own == ball)?;
        let at = self.layout.quaternion(index);
        let q = [0, 1, 2, 3].map(|k| self.q(at + k));
        Some(Motion::Ball { matrix: rotation_matrix(q).bare, rate: self.layout.omega(index) })
    }

    fn q(&self, index: usize) -> Scalar<'a> {
        self.laws.g.on(self.laws.symbols.q[index])
    }

    /// A free body: its coordinates are its centre of mass in world axes and the quaternion of its own axes.
    fn free(&mut self, body: BodyId) -> Placement {
        let g = self.laws.g;
        let (identity, one) = (vector::identity(g), g.one());
        let mut cursor = Cursor { link: GROUND, at: vector::zero(g), axes: identity };
        for (axis, direction) in identity.bare.iter().enumerate() {
            let index = self.layout.linear.iter().position(|own| *own == Linear::Center(body, axis));
            let rate = index.unwrap_or(0);
            let travel = self.q(rate).bare;
            cursor = self.link(cursor, Motion::Slide { axis: *direction, travel, rate, factor: one.bare });
        }
        if let Some(motion) = self.ball(Ball::Body(body)) {
            cursor = self.link(cursor, motion);
        }
        let center = self.laws.vector(&self.laws.mechanism.bodies[body.0].center);
        let flexible = self.flexible(body);
        Placement { link: cursor.link, at: (-center).bare, axes: identity.bare, flexible }
    }

    /// The modes of a body, whose coordinates stand side by side.
    fn flexible(&self, body: BodyId) -> Option<Flexible> {
        let deforms = self.laws.mechanism.bodies[body.0].deforms.as_ref()?;
        let first = self.layout.linear.iter().position(|own| *own == Linear::Mode(body, 0))?;
        let modal = |velocity: usize| Modal { value: self.q(velocity).bare, velocity };
        let modes = (first..first + deforms.modes()).map(modal).collect();
        Some(Flexible { shapes: Shapes::of(deforms), modes })
    }

    /// A body on the joint that carries it; `parent` is `None` for the ground.
    fn attach(&mut self, id: JointId, child: BodyId, parent: Option<Placement>) -> Placement {
        let laws = self.laws;
        let (g, mechanism) = (laws.g, laws.mechanism);
        let joint = &mechanism.joints[id.0];
        let child_is_second = joint.second.frame == Frame::Body(child);
        let (near, far) =
            if child_is_second { (&joint.first, &joint.second) } else { (&joint.second, &joint.first) };

        // The near place on its link.
        let near_axes = axes::matrix(&laws, &near.axes);
        let mut cursor = match &parent {
            None => {
                // A place of the ground: the foot of the first link, or a link of its own where nothing moves.
                let mut foot = Link::still(g, GROUND);
                foot.at_place(&laws.ground(&near.at));
                if foot.is_carried_by_time(g) {
                    Cursor { link: self.kinematics.push(foot), at: vector::zero(g), axes: near_axes }
                } else {
                    Cursor { link: GROUND, at: g.on(foot.at), axes: near_axes }
                }
            }
            Some(parent) => match self.section(parent, near) {
                Some(link) => Cursor { link, at: vector::zero(g), axes: near_axes },
                None => {
                    let at = g.on(parent).point(laws.vector(&near.at));
                    Cursor { link: parent.link, at, axes: g.on(parent.axes) * near_axes }
                }
            },
        };

        // Its motions, from the near place to the far one.
        let mut motions = joints::motions(joint).to_vec();
        if !child_is_second {
            motions.reverse();
        }
        let frames = joints::frames(&laws, joint);
        // The joint frame that the cursor's axes still have to undo.
        let mut undone: Option<usize> = None;
        let particle = !mechanism.bodies[child.0].form.turns;
        for elementary in motions {
            let Some((frame, motion)) = self.motion(id, elementary, child_is_second) else {
                continue;
            };
            if particle && matches!(elementary, Elementary::Ball) {
                continue;
            }
            if undone != frame {
                if let Some(last) = undone {
                    cursor.axes = cursor.axes * frames[last].transposed();
                }
                if let Some(next) = frame {
                    cursor.axes = cursor.axes * frames[next];
                }
                undone = frame;
            }
            cursor = self.link(cursor, motion);
        }
        if let Some(last) = undone {
            cursor.axes = cursor.axes * frames[last].transposed();
        }

        // The body, whose far place is there.
        let far_axes = axes::matrix(&laws, &far.axes);
        self.kinematics.balls.insert(id, [near_axes.bare, far_axes.bare]);
        let axes = cursor.axes * far_axes.transposed();
        let at = laws.vector(&far.at);
        let at = if particle { laws.vector(&mechanism.bodies[child.0].center) } else { at };
        let flexible = self.flexible(child);
        if let Some(flexible) = &flexible
            && let Some(station) = flexible.shapes.station_of(&far.at)
        {
            cursor.axes = axes;
            cursor = self.back_from_section(cursor, flexible, station);
        }
        let axes = if flexible.is_some() { cursor.axes } else { axes };
        Placement { link: cursor.link, at: (cursor.at - axes * at).bare, axes: axes.bare, flexible }
    }

    /// From a section to where the place would be if nothing deformed.
    fn back_from_section(
        &mut self,
        mut cursor: Cursor<'a>,
        flexible: &Flexible,
        station: Station,
    ) -> Cursor<'a> {
        let (g, rows) = (self.laws.g, flexible.shapes.rows(station));
        if let Some(motion) = flexible.lean(g, &self.kinematics.velocities, &rows, -1.0) {
            cursor = self.link(cursor, motion);
        }
        if let Some(motion) = flexible.shift(g, &self.kinematics.velocities, &rows, -1.0) {
            cursor = self.link(cursor, motion);
        }
        cursor
    }

    fn section(&self, of: &Placement, place: &Place) -> Option<LinkId> {
        let Frame::Body(body) = place.frame else { return None };
        let station = of.flexible.as_ref()?.shapes.station_of(&place.at)?;
        self.kinematics.sections.get(&(body.0, station)).copied()
    }

    /// The motion of one link of a joint, and the joint frame whose z (or axes) it uses; registers its coordinate.
    fn motion(
        &mut self,
        id: JointId,
        elementary: Elementary,
        child_is_second: bool,
    ) -> Option<(Option<usize>, Motion)> {
        let laws = self.laws;
        let one = laws.g.one();
        let sign = if child_is_second { one } else { -one };
        match elementary {
            Elementary::Turn { frame, which } => {
                let r = self.layout.rotations.iter().position(|own| *own == Rotation::Joint(id, which))?;
                let at = self.layout.pair(r);
                let [cos, sin] = [self.q(at), self.q(at + 1)];
                let rate = self.layout.linear.len() + r;
                self.kinematics.angles.insert((id, which), ([cos.bare, sin.bare], rate));
                let sin = (sign * sin).bare;
                Some((Some(frame), Motion::Turn { cos: cos.bare, sin, rate, sign: sign.bare }))
            }
            Elementary::Slide { axis, which } => {
                let rate = self.layout.linear.iter().position(|own| *own == Linear::Travel(id, which))?;
                let travel = self.q(rate);
                self.kinematics.travels.insert((id, which), (travel.bare, rate, one.bare));
                let travel = (sign * travel).bare;
                let axis = vector::unit(laws.g, axis).bare;
                Some((Some(0), Motion::Slide { axis, travel, rate, factor: sign.bare }))
            }
            Elementary::Wind => {
                // travel = pitch/(2π) θ with the counted angle.
                let pitch = laws.mechanism.joints[id.0].scalars.first()?;
                let r = self.layout.rotations.iter().position(|own| *own == Rotation::Joint(id, 0))?;
                let rate = self.layout.linear.len() + r;
                let factor = laws.value(pitch) / TAU;
                let a = self.layout.angles.iter().position(|angle| angle.rotor == Rotor::Joint(id, 0))?;
                let at = self.layout.turns(a);
                let travel = factor * (TAU * self.q(at) + self.q(at + 1));
                self.kinematics.travels.insert((id, 0), (travel.bare, rate, factor.bare));
                let (travel, factor) = ((sign * travel).bare, (sign * factor).bare);
                Some((Some(0), Motion::Slide { axis: vector::unit(laws.g, 2).bare, travel, rate, factor }))
            }
            Elementary::Ball => Some((None, self.ball(Ball::Joint(id))?)),
        }
    }
}

/// A(q) of a unit quaternion: 1 + 2 w x̃ + 2 x̃².
pub fn rotation_matrix<'g>([w, x, y, z]: [Scalar<'g>; 4]) -> On<'g, Mat3> {
    let [dx, dy, dz] = [x, y, z].map(|part| 2.0 * part);
    let (wx, wy, wz) = (w * dx, w * dy, w * dz);
    let (xx, xy, xz) = (x * dx, x * dy, x * dz);
    let (yy, yz, zz) = (y * dy, y * dz, z * dz);
    let rows = [
        [1.0 - (yy + zz), xy - wz, xz + wy],
        [xy + wz, 1.0 - (xx + zz), yz - wx],
        [xz - wy, yz + wx, 1.0 - (xx + yy)],
    ];
    w.g.on(rows.map(|row| row.map(|entry| entry.bare)))
}
