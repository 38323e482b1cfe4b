//! The joints, one file each with the same parts in the same order: `JOINT` (the record), `rows` (the constraint as jets), `attach`
//! (where the joint carries a body), `symbol`. Reactions follow from the rows.
//!
//! p₁, p₂ are the first and second place, θ₁, θ₂ the orientations of their bodies, Δ = p₂ − p₁. Kinds that need space do
//! not arrive here: the language has no words for them in the plane.

mod cam;
mod cord;
mod distance;
mod fixed;
mod parallel;
mod point_on_curve;
mod point_on_line;
mod prismatic;
mod revolute;

use super::angles::ground;
use super::flexible::Flexible;
use super::kinematics::{FrameId, GROUND, LocalVector, Placement, Position};
use super::vector::{self, Pair};
use crate::drawing::plane::Symbol;
use crate::equations::JointRow;
use crate::equations::Kinematics;
use crate::equations::jet::Moving;
use crate::equations::laws::Laws;
use crate::forms::{JointForm, RowForm, Spans};
use crate::model::{BodyId, Expr, Frame, Joint, JointId};
use crate::symbolic::{Node, On, Scalar};
pub use point_on_curve::{
    derivatives as derivatives_of_curve, point as point_of_curve, sliding as sliding_on_curve,
    tangent_and_parameter as tangent_of_curve, travel as travel_of_curve,
};

/// What a joint exerts on the second place's body: force (world axes) at the second place, and torque about it.
pub type Wrench<'g> = [Scalar<'g>; 3];

/// A kind of joint of the plane.
pub struct PlanarJoint {
    pub form: JointForm,
    /// Constraint rows where it carries nothing.
    pub rows: fn(&Laws, &Ends) -> Vec<JointRow>,
    /// Places the body that it carries; `None`: it carries none.
    pub attach: Option<for<'g> fn(&Laws<'g>, Carried<'g>) -> Placement>,
    pub symbol: fn(&mut Symbol),
}

/// The joints of the plane.
pub static JOINTS: &[&PlanarJoint] = &[
    &fixed::JOINT,
    &revolute::JOINT,
    &prismatic::JOINT,
    &parallel::JOINT,
    &point_on_line::JOINT,
    &distance::JOINT,
    &cord::JOINT,
    &cam::JOINT,
    &point_on_curve::JOINT,
];

/// The joint with a form, which is one of the list's own.
pub fn of(form: &'static JointForm) -> &'static PlanarJoint {
    let own = JOINTS.iter().find(|joint| std::ptr::eq(&joint.form, form));
    own.copied().expect("forms come from the list")
}

/// Constraint rows of a joint that carries nothing.
pub fn rows<'g>(laws: &Laws<'g>, joint: &'g Joint) -> Vec<JointRow> {
    (of(joint.form).rows)(laws, &Ends::of(laws, joint))
}

/// Along what a joint on a curve presses its places apart, in world axes.
pub fn out_of_curve<'g>(laws: &Laws<'g>, id: JointId) -> On<'g, Pair> {
    let joint = &laws.mechanism.joints[id.0];
    match joint.form.spans {
        Spans::Curve => point_on_curve::normal(laws, id),
        _ => cam::out_of_curve(laws, joint),
    }
}

/// The kinematics with three velocities more, of value zero, by which [`reaction`] moves a place alone.
pub fn with_room_for_reactions(laws: &Laws) -> Kinematics {
    let mut kinematics = laws.plane().bare.clone();
    kinematics.velocities.extend([laws.g.zero().bare; 3]);
    Kinematics::Plane(kinematics)
}

/// The wrench that a joint exerts on the second place's body, N and N m, from the multipliers of its rows:
/// −Σ λ ∂Φ/∂(x₂, y₂, θ₂), by virtual work, the second place and the axes that it carries being moved alone. `laws`: of
/// [`with_room_for_reactions`]; `lambda`: the multiplier of a kind of row, if it has one.
pub fn reaction<'g>(
    laws: &Laws<'g>,
    joint: &'g Joint,
    lambda: impl Fn(&RowForm) -> Option<Scalar<'g>>,
) -> Wrench<'g> {
    let g = laws.g;
    let moved = laws.plane().bare.velocities.len() - 3;
    let mut ends = Ends::of(laws, joint);
    let mut alone = LocalVector::fixed(vector::zero(g));
    alone.slide_freely(g, moved);
    ends.delta = ends.delta + Position::of(GROUND, alone);
    ends.moved = Some(moved);
    let rows = (of(joint.form).rows)(laws, &ends);
    [0, 1, 2].map(|component| {
        let columns = rows.iter().filter_map(|row| {
            let column = row.jet.columns.get(&(moved + component))?;
            Some(*column * lambda(row.form)?)
        });
        -columns.fold(g.zero(), |sum, term| sum + term)
    })
}

/// Places `child` where the joint carries it. `travels` are the joint's coordinates and the indices of their rates.
pub fn attach(
    laws: &Laws,
    joint: JointId,
    child: BodyId,
    parent: Placement,
    (frame, flexible): (FrameId, Option<Flexible>),
    travels: Vec<(Node, usize)>,
) -> Placement {
    let joint = &laws.mechanism.joints[joint.0];
    let child_is_second = joint.second.frame == Frame::Body(child);
    let (near, far) =
        if child_is_second { (&joint.first, &joint.second) } else { (&joint.second, &joint.first) };
    let pivot = match near.frame {
        Frame::Ground => ground(laws, &near.at),
        Frame::Body(_) => {
            let arm = laws.pair_of(&near.at).in_frame(&parent);
            laws.g.on(parent.origin.clone()) + arm
        }
    };
    let carried = Carried {
        joint,
        parent,
        pivot,
        at: laws.pair_of(&far.at),
        frame,
        flexible,
        travels,
        child_is_second,
        rigid: laws.mechanism.bodies[child.0].form.turns,
    };
    let attach = of(joint.form).attach.expect("the tree hangs bodies on joints that carry");
    attach(laws, carried)
}

/// The two ends of a joint in motion.
pub struct Ends<'g> {
    joint: &'g Joint,
    first: Frame,
    second: Frame,
    /// Δ = p₂ − p₁.
    delta: On<'g, Position>,
    /// The first of three velocities of the second place alone, where it is moved alone.
    moved: Option<usize>,
}

impl<'g> Ends<'g> {
    fn of(laws: &Laws<'g>, joint: &'g Joint) -> Self {
        let (first, second) =
            (laws.plane().place(laws, &joint.first), laws.plane().place(laws, &joint.second));
        Ends {
            joint,
            first: joint.first.frame,
            second: joint.second.frame,
            delta: second - first,
            moved: None,
        }
    }

    /// sin(θ₂ − θ₁ − angle), and its cosine.
    fn sine(&self, laws: &Laws<'g>, angle: &Expr) -> (Moving<'g>, Scalar<'g>) {
        let plane = laws.plane();
        let (mut sine, mut cosine) = plane.sine_jet(laws, self.first, self.second, laws.pair(angle));
        let [one, other] = [&self.joint.first, &self.joint.second].map(|place| plane.slope(laws, place));
        if one.is_some() || other.is_some() {
            // Sections turned by small σ have the directions A (1, σ): σ₂ − σ₁ of them is across, 1 + σ₁ σ₂ along.
            let none = || laws.still(laws.g.zero());
            let (one, other) = (one.unwrap_or_else(none), other.unwrap_or_else(none));
            let along = plane.cosine_jet(laws, self.first, self.second, laws.pair(angle));
            let (across, product) = (&other - &one, &one * &other);
            let level = laws.still(laws.g.one()) + product;
            cosine = level.value() * along.value() - across.value() * sine.value();
            sine = &across * &along + &level * &sine;
        }
        sine.jet.columns.extend(self.moved.map(|moved| (moved + 2, cosine.bare)));
        (sine, cosine)
    }

    /// Δ along the axes of the world; where the joint yields, of what its first place belongs to.
    fn apart(&self, laws: &Laws<'g>) -> [Moving<'g>; 2] {
        if self.joint.holds() {
            return self.in_world(laws);
        }
        let (one, zero) = (laws.g.one().bare, laws.g.zero().bare);
        [[one, zero], [zero, one]].map(|axis| {
            let (frame, axis) = laws.plane().carried_by(self.first, laws.g.on(axis));
            laws.plane().project(frame, axis, &self.delta.bare)
        })
    }

    /// Δ along the axes of the first body.
    fn in_first(&self, laws: &Laws<'g>) -> [Moving<'g>; 2] {
        [0, 1].map(|axis| {
            let (frame, axis) = laws.plane().carried_by(self.first, vector::axis(laws.g, axis));
            laws.plane().project(frame, axis, &self.delta.bare)
        })
    }

    /// Δ in world axes.
    fn in_world(&self, laws: &Laws<'g>) -> [Moving<'g>; 2] {
        laws.plane().world(&self.delta.bare)
    }
}

/// A body about to be placed at the far end of a joint.
pub struct Carried<'g> {
    joint: &'g Joint,
    parent: Placement,
    /// The near place.
    pivot: On<'g, Position>,
    /// The far place in the body's own axes.
    at: On<'g, Pair>,
    /// The frame the body turns with.
    frame: FrameId,
    /// Its modes, if it has any.
    flexible: Option<Flexible>,
    travels: Vec<(Node, usize)>,
    child_is_second: bool,
    rigid: bool,
}

impl<'g> Carried<'g> {
    /// The placement that puts the far place at `p`, the body's orientation being `offset` within its frame.
    fn at(self, p: On<'g, Position>, offset: On<'g, Pair>) -> Placement {
        let Carried { at, frame, flexible, .. } = self;
        if !self.rigid {
            return Placement { origin: p.bare, frame: GROUND, offset: offset.bare, flexible: None };
        }
        let origin = p - at.arm(frame, offset, flexible.as_ref());
        Placement { origin: origin.bare, frame, offset: offset.bare, flexible }
    }

    /// `axis` times one of the travels, in the axes of `frame`, from the first place to the second, seen from the near place.
    fn slide(&self, which: usize, frame: FrameId, axis: On<'g, Pair>) -> Position {
        let axis = if self.child_is_second { axis } else { -axis };
        let Some(&(travel, rate)) = self.travels.get(which) else { return Position::default() };
        let mut vector = LocalVector::fixed(axis.g.on(travel) * axis);
        vector.slides.insert(rate, axis.bare);
        Position::of(frame, vector)
    }

    /// Orientation within the frame of a body that keeps the angle `pair` (second relative to first) to its parent.
    fn kept(&self, pair: On<'g, Pair>) -> On<'g, Pair> {
        let turn = if self.child_is_second { pair } else { pair.opposite() };
        turn.g.on(self.parent.offset).turned(turn)
    }
}
