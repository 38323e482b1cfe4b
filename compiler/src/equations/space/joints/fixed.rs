//! Fixed (bracket): p₁ = p₂ and E₁ = E₂.

use super::{Ends, SpatialJoint};
use crate::drawing::canvas::Pen;
use crate::drawing::space::Symbol;
use crate::equations::{JointRow, Laws};
use crate::forms::{Alone, Form, Freer, JointAxes, JointForm, OfParticle, PLACES, Spans};

pub static JOINT: SpatialJoint = SpatialJoint {
    form: JointForm {
        call: Form { word: "fixed", elsewhere: &["weld", "rigid"], positional: PLACES, named: &[] },
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
        freer: &[
            Freer { turns: 1, shifts: 0, joint: "revolute" },
            Freer { turns: 2, shifts: 0, joint: "universal" },
            Freer { turns: 3, shifts: 0, joint: "spherical" },
        ],
        bearing: None,
        refuses: None,
    },
    motions: Some(&[]),
    rows,
    symbol,
};

pub fn rows(_: &Laws, ends: &Ends) -> Vec<JointRow> {
    let mut rows = ends.together();
    rows.extend(ends.parallel());
    rows.push(ends.unturned());
    rows
}

fn symbol(s: &mut Symbol) {
    s.block([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|e| (1.1, e)), Pen::Solid);
}
