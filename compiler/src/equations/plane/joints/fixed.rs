//! Fixed (bracket): p₁ − p₂ = 0 and sin(θ₂ − θ₁ − angle) = 0 on its upright root.

use super::{Carried, Ends, JointRow, PlanarJoint, revolute};
use crate::drawing::canvas::Pen;
use crate::drawing::plane::Symbol;
use crate::drawing::shapes::rectangle;
use crate::equations::laws::Laws;
use crate::equations::plane::kinematics::Placement;
use crate::forms::row::ANGLE;
use crate::forms::{Alone, Argument, Form, Freer, JointAxes, JointForm, Need, OfParticle, PLACES, Spans};
use crate::units::Dimension;

pub static JOINT: PlanarJoint = PlanarJoint {
    form: JointForm {
        call: Form {
            word: "fixed",
            elsewhere: &["weld", "rigid"],
            positional: PLACES,
            named: &[Argument::scalar("angle", Need::Never, Dimension::ANGLE)],
        },
        holds: "position and orientation",
        angles: &[],
        travels: &[],
        freedoms: 0,
        keeps_place: true,
        keeps_orientation: true,
        axes: JointAxes::None,
        spans: Spans::Nothing,
        only_pulls: false,
        of_particle: OfParticle::Neither,
        alone: Alone::Otherwise,
        freer: &[Freer { turns: 1, shifts: 0, joint: "revolute" }],
        bearing: None,
        refuses: None,
    },
    rows,
    attach: Some(attach),
    symbol,
};

pub fn rows(laws: &Laws, ends: &Ends) -> Vec<JointRow> {
    let mut rows = revolute::rows(laws, ends);
    rows.push(direction_row(laws, ends));
    rows
}

pub fn attach<'g>(laws: &Laws<'g>, carried: Carried<'g>) -> Placement {
    let offset = carried.kept(laws.pair(carried.joint.scalar(0)));
    let pivot = carried.pivot.clone();
    carried.at(pivot, offset)
}

/// sin(θ₂ − θ₁ − angle), shared with the prismatic joint.
pub fn direction_row(laws: &Laws, ends: &Ends) -> JointRow {
    let (sine, cosine) = ends.sine(laws, ends.joint.scalar(0));
    JointRow::upright(&ANGLE, sine, cosine)
}

fn symbol(s: &mut Symbol) {
    if s.hinge.is_grounded() {
        s.floor();
    }
    s.before.path(&rectangle(s.second, [1.0, 0.0], 1.2 * s.unit, 1.2 * s.unit), true, Pen::Solid);
}
