//! Parallel (Oldham coupling, pantograph): sin(θ₂ − θ₁) = 0 on its upright root; both translations are left.

use super::{Carried, Ends, JointRow, PlanarJoint, vector};
use crate::drawing::canvas::Pen;
use crate::drawing::plane::Symbol;
use crate::drawing::shapes::{THIN, rectangle, shifted};
use crate::equations::laws::Laws;
use crate::equations::plane::kinematics::Placement;
use crate::forms::row::ANGLE;
use crate::forms::{Alone, Form, JointAxes, JointForm, OfParticle, PLACES, Spans};
use crate::model::Expr;

pub static JOINT: PlanarJoint = PlanarJoint {
    form: JointForm {
        call: Form { word: "parallel", elsewhere: &["oldham"], positional: PLACES, named: &[] },
        holds: "orientation",
        angles: &[],
        travels: &[["travel_1", "speed_1"], ["travel_2", "speed_2"]],
        freedoms: 2,
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
    rows,
    attach: Some(attach),
    symbol,
};

pub fn rows(laws: &Laws, ends: &Ends) -> Vec<JointRow> {
    let (sine, cosine) = ends.sine(laws, &Expr::Number(0.0));
    vec![JointRow::upright(&ANGLE, sine, cosine)]
}

pub fn attach<'g>(laws: &Laws<'g>, carried: Carried<'g>) -> Placement {
    let offset = carried.kept(vector::unturned(laws.g));
    // The travels are along the first body's axes; parent and child share one frame.
    let first = if carried.child_is_second { carried.parent.offset } else { offset.bare };
    let far = [0, 1].into_iter().fold(carried.pivot.clone(), |far, which| {
        let along = vector::axis(laws.g, which).turned(first);
        far + carried.slide(which, carried.parent.frame, along)
    });
    carried.at(far, offset)
}

/// A cross-slide.
fn symbol(s: &mut Symbol) {
    if s.hinge.is_grounded() {
        s.floor();
    }
    let block = rectangle(s.second, [1.0, 0.0], 1.6 * s.unit, 1.6 * s.unit);
    s.before.path(&block, true, Pen::Outline(THIN));
    for way in [[1.0, 0.0], [0.0, 1.0]] {
        let (from, to) = (shifted(s.second, -2.6 * s.unit, way), shifted(s.second, 2.6 * s.unit, way));
        s.before.line(from, to, Pen::Line(0.8));
    }
}
