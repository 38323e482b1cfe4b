//! Revolute: p₁ − p₂ = 0.

use super::{Carried, Ends, JointRow, PlanarJoint, vector};
use crate::equations::laws::Laws;
use crate::equations::plane::kinematics::Placement;
use crate::forms::row::GAP;
use crate::forms::{Alone, Bearing, Form, Freer, JointAxes, JointForm, OfParticle, PLACES, Spans};

pub static JOINT: PlanarJoint = PlanarJoint {
    form: JointForm {
        call: Form {
            word: "revolute",
            elsewhere: &["hinge", "pin", "continuous"],
            positional: PLACES,
            named: &[],
        },
        holds: "position",
        angles: &[["angle", "rate"]],
        travels: &[],
        freedoms: 1,
        keeps_place: true,
        keeps_orientation: false,
        axes: JointAxes::None,
        spans: Spans::Nothing,
        only_pulls: false,
        of_particle: OfParticle::Any,
        alone: Alone::Turns,
        freer: &[Freer { turns: 0, shifts: 1, joint: "point_on_line" }],
        bearing: Some(Bearing::Pin),
        refuses: None,
    },
    rows,
    attach: Some(attach),
    symbol: |symbol| symbol.pin(),
};

pub fn rows(laws: &Laws, ends: &Ends) -> Vec<JointRow> {
    let [x, y] = ends.apart(laws);
    vec![JointRow::new(&GAP[0], -x), JointRow::new(&GAP[1], -y)]
}

pub fn attach<'g>(laws: &Laws<'g>, carried: Carried<'g>) -> Placement {
    let pivot = carried.pivot.clone();
    carried.at(pivot, vector::unturned(laws.g))
}
