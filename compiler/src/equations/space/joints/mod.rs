//! The joints, one file each with the same functions in the same order: `motions` (how a body moves that the joint
//! carries, from the first place to the second), `rows` (the constraint where it carries nothing).
//!
//! With E₁, E₂ the axes of the two places, turned so that z lies along the joint's axis, and Δ = p₂ − p₁. Directions are
//! seen from the link of the first place, so that what is fixed there needs no turning; p₁ − p₂ as `view` says. Reactions follow from the rows by
//! virtual work, for all joints alike (`bodies`).

mod constant_velocity;
mod cord;
mod cylindrical;
mod distance;
mod fixed;
mod parallel;
mod planar;
mod point_on_line;
mod point_on_plane;
mod prismatic;
mod revolute;
mod screw;
mod spherical;
mod universal;
mod view;

use super::axes;
use super::inertial::Inertial;
use super::kinematics::{Kinematics, Spot};
use super::links::GROUND;
use super::vector::{self, Mat3, Vec3};
use super::vector_jet::{Kind, VectorJet};
use crate::drawing::space::Symbol;
use crate::equations::jet::Moving;
use crate::equations::{JointRow, Laws, SpanningTree};
use crate::forms::row;
use crate::forms::{Argument, JointForm, Need};
use crate::model::{Frame, Joint, JointId};
use crate::symbolic::On;

/// One elementary motion of a joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Elementary {
    /// About z of a joint frame; which of the joint's angles.
    Turn { frame: usize, which: usize },
    /// Along an axis of the first joint frame; which of the joint's travels.
    Slide { axis: usize, which: usize },
    /// Along z of the first joint frame, by the pitch for each turn of the joint's angle.
    Wind,
    /// Any turn of the carried place's axes against those of the carrying place.
    Ball,
}

/// A kind of joint of space.
pub struct SpatialJoint {
    pub form: JointForm,
    /// How a body moves that it carries, from the first place to the second; `None`: it carries none.
    pub motions: Option<&'static [Elementary]>,
    /// Constraint rows where it carries nothing.
    pub rows: fn(&Laws, &Ends) -> Vec<JointRow>,
    pub symbol: fn(&mut Symbol),
}

/// The joints of space.
pub static JOINTS: &[&SpatialJoint] = &[
    &fixed::JOINT,
    &revolute::JOINT,
    &prismatic::JOINT,
    &cylindrical::JOINT,
    &screw::JOINT,
    &universal::JOINT,
    &spherical::JOINT,
    &planar::JOINT,
    &parallel::JOINT,
    &constant_velocity::JOINT,
    &point_on_line::JOINT,
    &point_on_plane::JOINT,
    &distance::JOINT,
    &cord::JOINT,
];

/// An axis that need not be written beside a marker.
const AXIS: Argument = Argument::direction("axis", Need::UnlessMarked);

/// The joint with a form, which is one of the list's own.
pub fn of(form: &'static JointForm) -> &'static SpatialJoint {
    let own = JOINTS.iter().find(|joint| std::ptr::eq(&joint.form, form));
    own.copied().expect("forms come from the list")
}

pub fn motions(joint: &Joint) -> &'static [Elementary] {
    of(joint.form).motions.unwrap_or_default()
}

/// The joint frames that the motions refer to, in the axes of the places: z along each direction.
pub fn frames<'g>(laws: &Laws<'g>, joint: &Joint) -> Vec<On<'g, Mat3>> {
    if joint.directions.is_empty() {
        return vec![vector::identity(laws.g)];
    }
    joint.directions.iter().map(|axis| axes::joint_frame(laws, axis)).collect()
}

/// Constraint rows of a joint that carries nothing: by how the ground sees the links move, if that is given, with cosines in either way
/// (`inertial`), else from link to link, with columns and with how each moves against the next (`vector_jet`). All give the same functions of the
/// motion; which takes fewest operations depends on what is computed anyway.
pub fn rows<'g>(
    laws: &Laws<'g>,
    tree: &SpanningTree,
    id: JointId,
    inertial: Option<&Inertial<'g>>,
) -> Vec<JointRow> {
    let joint = &laws.mechanism.joints[id.0];
    rows_seen_from(laws, id, view::seen_from(laws.mechanism, tree, joint), inertial)
}

/// The rows in whose place a load acts: seen from what the first place belongs to, or from the ground if that is a particle.
pub fn rows_that_yield<'g>(laws: &Laws<'g>, id: JointId) -> Vec<JointRow> {
    let first = laws.mechanism.joints[id.0].first.frame;
    let turns = |frame: Frame| match frame {
        Frame::Ground => true,
        Frame::Body(body) => laws.mechanism.bodies[body.0].form.turns,
    };
    rows_seen_from(laws, id, if turns(first) { first } else { Frame::Ground }, None)
}

fn rows_seen_from<'g>(
    laws: &Laws<'g>,
    id: JointId,
    seen_from: Frame,
    inertial: Option<&Inertial<'g>>,
) -> Vec<JointRow> {
    let Some(ends) = Ends::of(laws, id, seen_from, inertial) else { return Vec::new() };
    (of(laws.mechanism.joints[id.0].form).rows)(laws, &ends)
}

/// The two ends of a joint in motion.
pub struct Ends<'a, 'g> {
    id: JointId,
    joint: &'g Joint,
    kinematics: On<'g, &'g Kinematics>,
    first: Spot<'g>,
    second: Spot<'g>,
    /// E₁ and E₂ in the axes of their links.
    e1: On<'g, Mat3>,
    e2: On<'g, Mat3>,
    /// The axes along which components of p₁ − p₂ are taken, and by which link they are seen.
    seen_from: Frame,
    /// Where rows are derived by it.
    inertial: Option<&'a Inertial<'g>>,
}

impl<'a, 'g> Ends<'a, 'g> {
    fn of(
        laws: &Laws<'g>,
        id: JointId,
        seen_from: Frame,
        inertial: Option<&'a Inertial<'g>>,
    ) -> Option<Self> {
        let joint = &laws.mechanism.joints[id.0];
        let kinematics = laws.space()?;
        let (first, second) = (kinematics.spot(laws, &joint.first), kinematics.spot(laws, &joint.second));
        let frame = frames(laws, joint)[0];
        let (e1, e2) = (first.axes * frame, second.axes * frame);
        Some(Ends { id, joint, kinematics, first, second, e1, e2, seen_from, inertial })
    }

    /// p₁ − p₂ along the axes of the body, or of the ground, by which it is seen.
    fn gap(&self) -> [Moving<'g>; 3] {
        let (link, axes) = match self.seen_from {
            Frame::Ground => (GROUND, vector::identity(self.e1.g).bare),
            Frame::Body(body) => {
                let placement = &self.kinematics.bare.bodies[body.0];
                (placement.link, placement.axes)
            }
        };
        let [first, second] = [&self.first, &self.second].map(|spot| match self.inertial {
            Some(inertial) if link == GROUND => inertial.point(spot.at.clone(), spot.link),
            _ => self.kinematics.carry(spot.at.clone(), spot.link, link, Kind::Point),
        });
        // Body ← link.
        (first - second).along(vector::transposed(&axes)).components()
    }

    /// Rows `x`, `y`, `z`: the two places coincide.
    fn together(&self) -> Vec<JointRow> {
        let components = row::GAP.iter().zip(self.gap());
        components
            .map(|(form, jet)| JointRow { axes: Some(self.seen_from), ..JointRow::new(form, jet) })
            .collect()
    }

    /// Δ as seen from the link of the first place.
    fn delta(&self) -> Moving<'g, VectorJet> {
        self.kinematics.delta(&self.first, &self.second)
    }

    /// Rows `normal_1`, `normal_2`: x₁·Δ and y₁·Δ.
    fn on_axis(&self) -> Vec<JointRow> {
        let delta = self.delta();
        let components = row::OFFSET.iter().enumerate();
        components.map(|(k, form)| JointRow::new(form, delta.project(self.e1.column(k)))).collect()
    }

    /// Row `normal`: z₁·Δ.
    fn on_plane(&self) -> JointRow {
        JointRow::new(&row::NORMAL, self.delta().project(self.e1.column(2)))
    }

    /// A direction on the second link as seen from the first.
    fn direction(&self, w: On<'g, Vec3>) -> Moving<'g, VectorJet> {
        self.kinematics.direction(&self.first, &self.second, w)
    }

    /// u·w of a direction on the first link and one on the second.
    fn cosine(&self, u: On<'g, Vec3>, w: On<'g, Vec3>) -> Moving<'g> {
        match self.inertial {
            Some(inertial) => inertial.cosine([&self.first, &self.second], u, w),
            None => self.direction(w).project(u),
        }
    }

    /// Rows `axis_1`, `axis_2`: x₁·z₂ and y₁·z₂, with z₁·z₂ positive.
    fn parallel(&self) -> Vec<JointRow> {
        let z = self.e2.column(2);
        let upright = self.e1.column(2).dot(self.direction(z).value());
        let components = row::AXIS.iter().enumerate();
        components
            .map(|(k, form)| JointRow::upright(form, self.cosine(self.e1.column(k), z), upright))
            .collect()
    }

    /// Row `angle`: x₁·y₂, with y₁·y₂ positive.
    fn unturned(&self) -> JointRow {
        let y = self.e2.column(1);
        let upright = self.e1.column(1).dot(self.direction(y).value());
        JointRow::upright(&row::ANGLE, self.cosine(self.e1.column(0), y), upright)
    }
}
