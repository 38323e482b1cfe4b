//! Revolute: p₁ − p₂ = 0.

use super::{Carried, Ends, JointRow, PlanarJoint, Wrench};
use crate::equations::laws::Laws;
use crate::equations::plane::kinematics::Placement;
use crate::forms::{Alone, Form, Freer, JointAxes, JointForm, OfParticle, PLACES, Spans};
use crate::symbolic::{Graph, Node};

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
        of_particle: OfParticle::Any,
        alone: Alone::Turns,
        freer: &[Freer { turns: 0, shifts: 1, joint: "point_on_line" }],
        refuses: None,
    },
    rows,
    attach: Some(attach),
    reaction,
    symbol: |symbol| symbol.pin(),
};

pub fn rows(g: &mut Graph, laws: &Laws, ends: &Ends) -> Vec<JointRow> {
    let [x, y] = laws.plane().world(g, &ends.delta);
    vec![JointRow::new("x", x.neg(g)), JointRow::new("y", y.neg(g))]
}

pub fn attach(g: &mut Graph, _: &Laws, carried: Carried) -> Placement {
    let pivot = carried.pivot.clone();
    let offset = [g.constant(1.0), g.constant(0.0)];
    carried.at(g, &pivot, offset)
}

/// −Dᵀλ with ∂Φ/∂p₂ = −1: the force on the second is λ.
pub fn reaction(g: &mut Graph, _: &Laws, _: &Ends, lambda: &[Node]) -> Wrench {
    [lambda[0], lambda[1], g.constant(0.0)]
}
