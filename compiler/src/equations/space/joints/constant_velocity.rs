//! Constant velocity (homokinetic): p₁ = p₂, and E₂ against E₁ only swung, not turned about the shafts:
//! x₁·y₂ = y₁·x₂, with x₁·x₂ + y₁·y₂ positive.

use super::{AXIS, Ends, SpatialJoint};
use crate::drawing::canvas::Pen;
use crate::drawing::shapes::THIN;
use crate::drawing::space::Symbol;
use crate::equations::{JointRow, Laws};
use crate::forms::{Alone, Bearing, Form, JointAxes, JointForm, OfParticle, PLACES, RowForm, Spans};

pub static JOINT: SpatialJoint = SpatialJoint {
    form: JointForm {
        call: Form {
            word: "constant_velocity",
            elsewhere: &["homokinetic"],
            positional: PLACES,
            named: &[AXIS],
        },
        holds: "position, and the turn about both shafts",
        angles: &[],
        travels: &[],
        freedoms: 2,
        keeps_place: true,
        keeps_orientation: false,
        axes: JointAxes::Common,
        spans: Spans::Nothing,
        only_pulls: false,
        of_particle: OfParticle::Neither,
        alone: Alone::Otherwise,
        freer: &[],
        bearing: Some(Bearing::Knuckle),
        refuses: None,
    },
    // Its two swings have no coordinates that stay regular.
    motions: None,
    rows,
    symbol,
};

/// The one body is not turned about the shafts against the other.
static TWIST: RowForm = RowForm::direction("twist", "turns along the shafts");

pub fn rows(_: &Laws, ends: &Ends) -> Vec<JointRow> {
    let mut rows = ends.together();
    let (x1, y1) = (ends.e1.column(0), ends.e1.column(1));
    let (x2, y2) = (ends.e2.column(0), ends.e2.column(1));
    let (left, right) = (ends.cosine(x1, y2), ends.cosine(y1, x2));
    let upright = x1.dot(ends.direction(x2).value()) + y1.dot(ends.direction(y2).value());
    rows.push(JointRow::upright(&TWIST, left - right, upright));
    rows
}

fn symbol(s: &mut Symbol) {
    s.before.circle(s.at, 1.9 * s.unit, Pen::Outline(THIN));
    s.disk(1.9, Pen::Line(0.8));
    let (from, to) = (s.beside(-2.6, s.hinge.axis), s.beside(2.6, s.hinge.axis));
    s.before.line(from, to, Pen::Line(2.0));
}
