//! Cam: a roller, or a knife edge of radius 0, stays on a closed curve about the first place: d(p) − r = 0.
//!
//! d is how far the second place p is out of the curve along its normal n, in the axes of the first body, ∂d/∂p = n and |n| = 1: −λ is the
//! force that presses curve and roller together. The foot of p on the curve is found in passes that are written out
//! (`equations/look_up/profile.rs`). That is exact to rounding, as the offset of a table is not, and needs no coordinate without mass, which formulations that
//! factorise M could not have. A curve whose curvature has no jumps gives accelerations without jumps.

use super::{Ends, JointRow, Pair, PlanarJoint, vector};
use crate::drawing::canvas::Pen;
use crate::drawing::plane::Symbol;
use crate::equations::laws::Laws;
use crate::equations::look_up;
use crate::forms::row::CURVE;
use crate::forms::{Alone, Argument, Form, JointAxes, JointForm, Need, OfParticle, PLACES, Spans, Value};
use crate::model::{Joint, LookUp};
use crate::symbolic::{On, Orders};
use crate::units::Dimension;

pub static JOINT: PlanarJoint = PlanarJoint {
    form: JointForm {
        call: Form {
            word: "cam",
            elsewhere: &[],
            positional: PLACES,
            named: &[
                Argument::of("lift", Need::Always, Value::Outline),
                Argument::scalar("base", Need::Never, Dimension::LENGTH),
                Argument::scalar("radius", Need::Never, Dimension::LENGTH).not_negative(),
            ],
        },
        holds: "the second place out of a curve about the first by the radius of a roller",
        angles: &[["angle", "rate"]],
        travels: &[],
        freedoms: 2,
        keeps_place: false,
        keeps_orientation: false,
        axes: JointAxes::None,
        spans: Spans::Outline,
        only_pulls: false,
        of_particle: OfParticle::Second,
        alone: Alone::Otherwise,
        freer: &[],
        bearing: None,
        refuses: None,
    },
    rows,
    attach: None,
    symbol,
};

pub fn rows(laws: &Laws, ends: &Ends) -> Vec<JointRow> {
    let Some(look_up) = curve(ends.joint, [0, 0]) else { return Vec::new() };
    let [x, y] = ends.in_first(laws);
    let [base, radius] = [0, 1].map(|which| laws.jet(ends.joint.scalar(which)));
    let distance = look_up::jet(&look_up, &[x, y, base], &[]);
    distance.map(|distance| JointRow::new(&CURVE, distance - radius)).into_iter().collect()
}

/// n, in world axes.
pub fn out_of_curve<'g>(laws: &Laws<'g>, joint: &'g Joint) -> On<'g, Pair> {
    let ends = Ends::of(laws, joint);
    let [x, y] = ends.in_first(laws).map(|way| way.value());
    let base = laws.value(joint.scalar(0));
    let along = |orders| {
        let look_up = curve(joint, orders);
        look_up.map_or_else(|| laws.g.zero(), |it| look_up::value(&it, &[x, y, base], &[], laws.g))
    };
    let normal = vector::pair(along([1, 0]), along([0, 1]));
    let (frame, normal) = laws.plane().carried_by(ends.first, normal);
    laws.plane().to_world(frame, normal)
}

/// How far a place is out of the curve of a joint, or a derivative of that by x and y.
fn curve(joint: &Joint, [x, y]: [u8; 2]) -> Option<LookUp> {
    let curve = joint.curve.clone()?;
    Some(LookUp { curve, orders: Orders::new(x, y), smoothness: 2, arguments: Vec::new() })
}

/// The pin of the roller; its rim and the curve are drawn as surfaces are.
fn symbol(s: &mut Symbol) {
    s.before.circle(s.second, 0.8 * s.unit, Pen::Solid);
}
