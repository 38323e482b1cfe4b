//! The coordinates of a spatial mechanism and where they put its bodies: every joint of the tree as a chain of links.

use super::axes;
use super::joints::{self, Elementary};
use super::kinematics::Kinematics;
use super::links::{GROUND, Link, LinkId, Motion, Placement};
use super::vector::{self, Mat3, Vec3};
use crate::equations::coordinates::{Ball, Layout, Linear, MultiTurn, Rotation, Symbols, symbols};
use crate::equations::{Attachment, Laws, SpanningTree};
use crate::model::{BodyId, BodyKind, Frame, JointId, Mechanism, Place, Rotor, fold};
use crate::symbolic::{Graph, Node};
use std::collections::BTreeMap;

/// Coordinates for a spanning tree: their layout, symbols for them, and the links.
pub fn coordinates(
    g: &mut Graph,
    mechanism: &Mechanism,
    tree: &SpanningTree,
    rotors: &[Rotor],
) -> (Layout, Symbols, Kinematics) {
    let mut layout = layout(mechanism, tree);
    layout.angles = rotors.iter().map(|rotor| counted(mechanism, &layout, *rotor)).collect();
    let symbols = symbols(g, mechanism, &layout);
    let ground = Link::ground(g);
    let mut builder = Builder {
        mechanism,
        layout: &layout,
        symbols: &symbols,
        kinematics: Kinematics {
            links: vec![ground],
            velocities: symbols.v.clone(),
            bodies: Vec::new(),
            angles: BTreeMap::new(),
            travels: BTreeMap::new(),
            balls: BTreeMap::new(),
        },
    };
    let mut placements: Vec<Option<Placement>> = vec![None; mechanism.bodies.len()];
    for Attachment { body, joint } in &tree.attachments {
        let placement = match joint {
            None => builder.free(g, *body),
            Some((joint, parent)) => {
                let parent = match parent {
                    Frame::Ground => None,
                    Frame::Body(parent) => placements[parent.0].clone(),
                };
                builder.attach(g, *joint, *body, parent)
            }
        };
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
        let rigid = mechanism.bodies[body.0].kind == BodyKind::Rigid;
        let Some((id, _)) = joint else {
            layout.linear.extend((0..3).map(|axis| Linear::Center(*body, axis)));
            if rigid {
                layout.quaternions.push(Ball::Body(*body));
            }
            continue;
        };
        for elementary in joints::motions(&mechanism.joints[id.0]).iter().copied() {
            match elementary {
                Elementary::Slide { which, .. } => layout.linear.push(Linear::Travel(*id, which)),
                Elementary::Turn { which, .. } => layout.rotations.push(Rotation::Joint(*id, which)),
                Elementary::Ball if rigid => layout.quaternions.push(Ball::Joint(*id)),
                Elementary::Ball | Elementary::Wind => {}
            }
        }
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
    // Known without parameters.
    let known = axis.iter().all(|component| fold::evaluate(component, &[]).is_some());
    if !known {
        return None;
    }
    let mut graph = Graph::new();
    let g = &mut graph;
    let none = SpanningTree { attachments: Vec::new() };
    let symbols = symbols(g, mechanism, &layout(mechanism, &none));
    let laws = Laws::constant(mechanism, &symbols);
    let matrix = axes::matrix(g, &laws, &place.axes);
    let axis = laws.vector(g, axis);
    let axis = axes::normalized(g, axis);
    let axis = vector::apply(g, &matrix, axis);
    let values: Vec<f64> = axis.iter().filter_map(|node| g.value(*node)).collect();
    values.try_into().ok()
}

struct Builder<'a> {
    mechanism: &'a Mechanism,
    layout: &'a Layout,
    symbols: &'a Symbols,
    kinematics: Kinematics,
}

/// Where a chain of links has got to: a point and axes on the last link.
struct Cursor {
    link: LinkId,
    at: Vec3,
    /// Link ← axes of the place, and which joint frame has been undone last.
    axes: Mat3,
}

impl Builder<'_> {
    fn push(&mut self, link: Link) -> LinkId {
        self.kinematics.links.push(link);
        self.kinematics.links.len() - 1
    }

    fn link(&self, g: &mut Graph, cursor: &Cursor, axes: Mat3, motion: Motion) -> Link {
        let zero = vector::zero(g);
        Link { parent: cursor.link, at: cursor.at, at_drift: zero, at_bias: zero, axes, motion }
    }

    fn ball(&self, g: &mut Graph, ball: Ball) -> Option<Motion> {
        let index = self.layout.quaternions.iter().position(|own| *own == ball)?;
        let at = self.layout.quaternion(index);
        let q: [Node; 4] = [0, 1, 2, 3].map(|k| self.symbols.q[at + k]);
        Some(Motion::Ball { matrix: rotation_matrix(g, q), rate: self.layout.omega(index) })
    }

    /// A free body: its coordinates are its centre of mass in world axes and the quaternion of its own axes.
    fn free(&mut self, g: &mut Graph, body: BodyId) -> Placement {
        let (zero, identity, one) = (vector::zero(g), vector::identity(g), g.constant(1.0));
        let mut cursor = Cursor { link: GROUND, at: zero, axes: identity };
        for (axis, direction) in identity.iter().enumerate() {
            let index = self.layout.linear.iter().position(|own| *own == Linear::Center(body, axis));
            let index = index.unwrap_or(0);
            let travel = self.symbols.q[index];
            let motion = Motion::Slide { axis: *direction, travel, rate: index, factor: one };
            let link = self.link(g, &cursor, identity, motion);
            cursor.link = self.push(link);
        }
        if let Some(motion) = self.ball(g, Ball::Body(body)) {
            let link = self.link(g, &cursor, identity, motion);
            cursor.link = self.push(link);
        }
        let laws = Laws::constant(self.mechanism, self.symbols);
        let center = laws.vector(g, &self.mechanism.bodies[body.0].center);
        Placement { link: cursor.link, at: vector::neg(g, center), axes: identity }
    }

    /// A body on the joint that carries it; `parent` is `None` for the ground.
    fn attach(&mut self, g: &mut Graph, id: JointId, child: BodyId, parent: Option<Placement>) -> Placement {
        let mechanism = self.mechanism;
        let laws = Laws::constant(mechanism, self.symbols);
        let joint = &mechanism.joints[id.0];
        let child_is_second = joint.second.frame == Frame::Body(child);
        let (near, far) =
            if child_is_second { (&joint.first, &joint.second) } else { (&joint.second, &joint.first) };

        // The near place on its link.
        let near_axes = axes::matrix(g, &laws, &near.axes);
        let mut foot = None;
        let mut cursor = match &parent {
            None => {
                foot = Some(laws.ground(g, &near.at));
                Cursor { link: GROUND, at: vector::zero(g), axes: near_axes }
            }
            Some(parent) => {
                let at = laws.vector(g, &near.at);
                let at = vector::apply(g, &parent.axes, at);
                let at = vector::add(g, parent.at, at);
                Cursor { link: parent.link, at, axes: vector::product(g, &parent.axes, &near_axes) }
            }
        };
        if let Some(place) = &foot {
            // A place of the ground: the foot of the first link, or a link of its own where nothing moves.
            let mut link = Link::ground(g);
            link.at_place(place);
            if link.is_carried_by_time(g) {
                cursor.link = self.push(link);
            } else {
                cursor.at = link.at;
            }
        }

        // Its motions, from the near place to the far one.
        let mut motions = joints::motions(joint).to_vec();
        if !child_is_second {
            motions.reverse();
        }
        let frames = joints::frames(g, &laws, joint);
        // The joint frame that the cursor's axes still have to undo.
        let mut undone: Option<usize> = None;
        let particle = mechanism.bodies[child.0].kind == BodyKind::Particle;
        for elementary in motions {
            let Some((frame, motion)) = self.motion(g, &laws, id, elementary, child_is_second) else {
                continue;
            };
            if particle && matches!(elementary, Elementary::Ball) {
                continue;
            }
            if undone != frame {
                if let Some(last) = undone {
                    cursor.axes = vector::product_transposed(g, &cursor.axes, &frames[last]);
                }
                if let Some(next) = frame {
                    cursor.axes = vector::product(g, &cursor.axes, &frames[next]);
                }
                undone = frame;
            }
            let link = self.link(g, &cursor, cursor.axes, motion);
            cursor = Cursor { link: self.push(link), at: vector::zero(g), axes: vector::identity(g) };
        }
        if let Some(last) = undone {
            cursor.axes = vector::product_transposed(g, &cursor.axes, &frames[last]);
        }

        // The body, whose far place is there.
        let far_axes = axes::matrix(g, &laws, &far.axes);
        self.kinematics.balls.insert(id, [near_axes, far_axes]);
        let axes = vector::product_transposed(g, &cursor.axes, &far_axes);
        let at = laws.vector(g, &far.at);
        let at = if particle { laws.vector(g, &mechanism.bodies[child.0].center) } else { at };
        let arm = vector::apply(g, &axes, at);
        Placement { link: cursor.link, at: vector::sub(g, cursor.at, arm), axes }
    }

    /// The motion of one link of a joint, and the joint frame whose z (or axes) it uses; registers its coordinate.
    fn motion(
        &mut self,
        g: &mut Graph,
        laws: &Laws,
        id: JointId,
        elementary: Elementary,
        child_is_second: bool,
    ) -> Option<(Option<usize>, Motion)> {
        let one = g.constant(1.0);
        let sign = if child_is_second { one } else { g.neg(one) };
        match elementary {
            Elementary::Turn { frame, which } => {
                let r = self.layout.rotations.iter().position(|own| *own == Rotation::Joint(id, which))?;
                let at = self.layout.pair(r);
                let [cos, sin] = [self.symbols.q[at], self.symbols.q[at + 1]];
                let rate = self.layout.linear.len() + r;
                self.kinematics.angles.insert((id, which), ([cos, sin], rate));
                let sin = g.mul(sign, sin);
                Some((Some(frame), Motion::Turn { cos, sin, rate, sign }))
            }
            Elementary::Slide { axis, which } => {
                let rate = self.layout.linear.iter().position(|own| *own == Linear::Travel(id, which))?;
                let travel = self.symbols.q[rate];
                self.kinematics.travels.insert((id, which), (travel, rate, one));
                let travel = g.mul(sign, travel);
                let axis = vector::unit(g, axis);
                Some((Some(0), Motion::Slide { axis, travel, rate, factor: sign }))
            }
            Elementary::Wind => {
                // travel = pitch/(2π) θ with the counted angle.
                let pitch = self.mechanism.joints[id.0].scalars.first()?;
                let r = self.layout.rotations.iter().position(|own| *own == Rotation::Joint(id, 0))?;
                let rate = self.layout.linear.len() + r;
                let pitch = laws.value(g, pitch);
                let turn = g.constant(std::f64::consts::TAU);
                let factor = g.div(pitch, turn);
                let a = self.layout.angles.iter().position(|angle| angle.rotor == Rotor::Joint(id, 0))?;
                let at = self.layout.turns(a);
                let whole = g.mul(turn, self.symbols.q[at]);
                let angle = g.add(whole, self.symbols.q[at + 1]);
                let travel = g.mul(factor, angle);
                self.kinematics.travels.insert((id, 0), (travel, rate, factor));
                let (travel, factor) = (g.mul(sign, travel), g.mul(sign, factor));
                Some((Some(0), Motion::Slide { axis: vector::unit(g, 2), travel, rate, factor }))
            }
            Elementary::Ball => Some((None, self.ball(g, Ball::Joint(id))?)),
        }
    }
}

/// A(q) of a unit quaternion: 1 + 2 w x̃ + 2 x̃².
pub fn rotation_matrix(g: &mut Graph, [w, x, y, z]: [Node; 4]) -> Mat3 {
    let (one, two) = (g.constant(1.0), g.constant(2.0));
    let [dx, dy, dz] = [x, y, z].map(|part| g.mul(two, part));
    let (wx, wy, wz) = (g.mul(w, dx), g.mul(w, dy), g.mul(w, dz));
    let (xx, xy, xz) = (g.mul(x, dx), g.mul(x, dy), g.mul(x, dz));
    let (yy, yz, zz) = (g.mul(y, dy), g.mul(y, dz), g.mul(z, dz));
    let diagonal = |g: &mut Graph, a: Node, b: Node| {
        let sum = g.add(a, b);
        g.sub(one, sum)
    };
    [
        [diagonal(g, yy, zz), g.sub(xy, wz), g.add(xz, wy)],
        [g.add(xy, wz), diagonal(g, xx, zz), g.sub(yz, wx)],
        [g.sub(xz, wy), g.add(yz, wx), diagonal(g, xx, yy)],
    ]
}
