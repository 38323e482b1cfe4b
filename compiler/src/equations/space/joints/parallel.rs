//! Parallel (Oldham coupling, pantograph): E₁ parallel to E₂; all translations are left.

use super::{Elementary, Ends, SpatialJoint};
use crate::drawing::canvas::Pen;
use crate::drawing::shapes::THIN;
use crate::drawing::space::Symbol;
use crate::equations::{JointRow, Laws};
use crate::forms::{Alone, Form, JointAxes, JointForm, OfParticle, PLACES, Spans};

pub static JOINT: SpatialJoint = SpatialJoint {
    form: JointForm {
        call: Form { word: "parallel", elsewhere: &["oldham"], positional: PLACES, named: &[] },
        holds: "orientation",
        angles: &[],
        travels: &[["travel_1", "speed_1"], ["travel_2", "speed_2"], ["travel_3", "speed_3"]],
        freedoms: 3,
        keeps_place: false,
        keeps_orientation: true,
        axes: JointAxes::None,
        spans: Spans::Nothing,
        only_pulls: false,
        of_particle: OfParticle::Neither,
        alone: Alone::Slides,
        freer: &[],
        bearing: None,
        refuses: None,
    },
    motions: Some(&[
        Elementary::Slide { axis: 0, which: 0 },
        Elementary::Slide { axis: 1, which: 1 },
        Elementary::Slide { axis: 2, which: 2 },
    ]),
    rows,
    symbol,
};

pub fn rows(_: &Laws, ends: &Ends) -> Vec<JointRow> {
    let mut rows = ends.parallel();
    rows.push(ends.unturned());
    rows
}

/// A block with three ways out of it.
fn symbol(s: &mut Symbol) {
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    s.block(axes.map(|e| (1.1, e)), Pen::Outline(THIN));
    for axis in axes {
        let (from, to) = (s.beside(-2.4, axis), s.beside(2.4, axis));
        s.before.line(from, to, Pen::Line(0.8));
    }
}
