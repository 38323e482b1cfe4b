//! Screw: as cylindrical, and travel = pitch/(2π) · angle with the angle counted over its turns.

use super::{AXIS, Elementary, Ends, SpatialJoint, cylindrical};
use crate::drawing::canvas::Pen;
use crate::drawing::shapes::ring;
use crate::drawing::space::Symbol;
use crate::drawing::vector::along;
use crate::equations::{JointRow, Laws};
use crate::forms::{
    Alone, Argument, Bearing, Form, JointAxes, JointForm, Need, OfParticle, PLACES, RowForm, Spans,
};
use crate::messages;
use crate::model::Rotor;
use crate::units::Dimension;
use std::f64::consts::TAU;

pub static JOINT: SpatialJoint = SpatialJoint {
    form: JointForm {
        call: Form {
            word: "screw",
            elsewhere: &["helical"],
            positional: PLACES,
            named: &[AXIS, Argument::scalar("pitch", Need::Always, Dimension::LENGTH)],
        },
        holds: "as cylindrical, and travel to angle by the pitch for a turn",
        angles: &[["angle", "rate"]],
        travels: &[["travel", "speed"]],
        freedoms: 1,
        keeps_place: false,
        keeps_orientation: false,
        axes: JointAxes::Common,
        spans: Spans::Rail,
        only_pulls: false,
        of_particle: OfParticle::Neither,
        alone: Alone::Otherwise,
        freer: &[],
        bearing: Some(Bearing::Thread),
        refuses: Some(|given| {
            let pitch = given.scalars.first().copied().flatten()?;
            (pitch == 0.0).then(|| ("pitch", messages::zero_pitch()))
        }),
    },
    motions: Some(&[Elementary::Wind, Elementary::Turn { frame: 0, which: 0 }]),
    rows,
    symbol,
};

/// The travel is the pitch times the turns.
static SCREW: RowForm = RowForm::own("screw");

pub fn rows(laws: &Laws, ends: &Ends) -> Vec<JointRow> {
    let mut rows = cylindrical::rows(laws, ends);
    let lead = laws.value(ends.joint.scalar(0)) / TAU;
    let (travel, angle) = (laws.kinematics().travel(laws, ends.id, 0), laws.angle(Rotor::Joint(ends.id, 0)));
    rows.push(JointRow::new(&SCREW, travel - lead * angle));
    rows
}

fn symbol(s: &mut Symbol) {
    cylindrical::symbol(s);
    for k in [-1.5, 0.0, 1.5] {
        let center = along(s.hinge.at, k * s.unit / s.view.scale, s.hinge.axis);
        let ring = ring(s.view, center, s.hinge.axis, 1.4 * s.unit, 0.0, 3.2);
        s.before.path(&ring, false, Pen::Line(0.8));
    }
}
