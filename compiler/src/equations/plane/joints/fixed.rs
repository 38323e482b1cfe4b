//! Fixed (bracket): p₁ − p₂ = 0 and sin(θ₂ − θ₁ − angle) = 0 on its upright root.

use super::{Carried, Ends, JointRow, PlanarJoint, Wrench, revolute};
use crate::drawing::canvas::Pen;
use crate::drawing::plane::Symbol;
use crate::drawing::shapes::rectangle;
use crate::equations::laws::Laws;
use crate::equations::plane::kinematics::Placement;
use crate::forms::{Alone, Argument, Form, Freer, JointAxes, JointForm, Need, OfParticle, PLACES, Spans};
use crate::symbolic::{Graph, Node};
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
        of_particle: OfParticle::Neither,
        alone: Alone::Otherwise,
        freer: &[Freer { turns: 1, shifts: 0, joint: "revolute" }],
        refuses: None,
    },
    rows,
    attach: Some(attach),
    reaction,
    symbol,
};

pub fn rows(g: &mut Graph, laws: &Laws, ends: &Ends) -> Vec<JointRow> {
    let mut rows = revolute::rows(g, laws, ends);
    rows.push(direction_row(g, laws, ends));
    rows
}

pub fn attach(g: &mut Graph, laws: &Laws, carried: Carried) -> Placement {
    let pair = laws.pair(g, carried.joint.scalar(0));
    let offset = carried.kept(g, pair);
    let pivot = carried.pivot.clone();
    carried.at(g, &pivot, offset)
}

pub fn reaction(g: &mut Graph, laws: &Laws, ends: &Ends, lambda: &[Node]) -> Wrench {
    [lambda[0], lambda[1], direction_torque(g, laws, ends, lambda[2])]
}

/// sin(θ₂ − θ₁ − angle), shared with the prismatic joint.
pub fn direction_row(g: &mut Graph, laws: &Laws, ends: &Ends) -> JointRow {
    let pair = laws.pair(g, ends.joint.scalar(0));
    let (sine, cosine) = laws.plane().sine_jet(g, laws, ends.first, ends.second, pair);
    JointRow { upright: Some(cosine), ..JointRow::new("angle", sine) }
}

/// Torque on the second from the multiplier of [`direction_row`]: −cos(Δθ) λ.
pub fn direction_torque(g: &mut Graph, laws: &Laws, ends: &Ends, lambda: Node) -> Node {
    let pair = laws.pair(g, ends.joint.scalar(0));
    let (_, cosine) = laws.plane().sine_jet(g, laws, ends.first, ends.second, pair);
    let torque = g.mul(cosine, lambda);
    g.neg(torque)
}

fn symbol(s: &mut Symbol) {
    if s.hinge.is_grounded() {
        s.floor();
    }
    s.before.path(&rectangle(s.second, [1.0, 0.0], 1.2 * s.unit, 1.2 * s.unit), true, Pen::Solid);
}
