//! Point on curve: the second place is at c(u) = (x(u), y(u)) in the axes of the first body, from the first place; u is the parameter.
//!
//! Where the joint carries a body, u is its coordinate: ∂Δ/∂u̇ = c′(u), and c″(u) u̇² is left of Δ̈ at ü = 0. Where it carries nothing, one of
//! x and y has to be u itself, so that u is Δₓ or Δᵧ and the row has a closed form: Δᵧ − y(Δₓ) = 0, or x(Δᵧ) − Δₓ = 0. So no coordinate
//! without mass is needed, which formulations that factorise M could not have, and no foot on the curve, which may have
//! several or, at the start of Newton's method, none that is known. What has neither form is hung on its curve in every spanning tree.

use super::{Carried, Ends, JointRow, Pair, PlanarJoint, Position, vector};
use crate::drawing::canvas::Pen;
use crate::drawing::plane::Symbol;
use crate::equations::jet::{Jet, Moving};
use crate::equations::laws::Laws;
use crate::equations::plane::kinematics::{Kinematics, LocalVector, Placement, Travelled};
use crate::forms::row::ON_CURVE;
use crate::forms::{
    Alone, Argument, Bearing, Form, JointAxes, JointForm, Need, OfParticle, PLACES, Spans, Value,
};
use crate::model::{Joint, JointId};
use crate::symbolic::{Node, On, Scalar};
use crate::units::Dimension;
use std::collections::BTreeMap;

pub static JOINT: PlanarJoint = PlanarJoint {
    form: JointForm {
        call: Form {
            word: "point_on_curve",
            elsewhere: &[],
            positional: PLACES,
            named: &[
                Argument::of("x", Need::Never, Value::OfParameter(Dimension::LENGTH)),
                Argument::of("y", Need::Always, Value::OfParameter(Dimension::LENGTH)),
            ],
        },
        holds: "the second place on a curve about the first",
        angles: &[["angle", "rate"]],
        travels: &[["parameter", "parameter_rate"]],
        freedoms: 2,
        keeps_place: false,
        keeps_orientation: false,
        axes: JointAxes::None,
        spans: Spans::Curve,
        only_pulls: false,
        of_particle: OfParticle::Second,
        alone: Alone::Otherwise,
        freer: &[],
        bearing: Some(Bearing::Curve),
        refuses: None,
    },
    rows,
    attach: Some(attach),
    symbol,
};

/// Positive to the left of the curve, as u grows.
pub fn rows(laws: &Laws, ends: &Ends) -> Vec<JointRow> {
    let Some(axis) = ends.joint.graph() else { return Vec::new() };
    let delta = ends.in_first(laws);
    let other = function(laws, ends.joint, 1 - axis, &delta[axis]);
    let left = if axis == 0 { &delta[1] - &other } else { &other - &delta[0] };
    vec![JointRow::new(&ON_CURVE, left)]
}

pub fn attach<'g>(laws: &Laws<'g>, carried: Carried<'g>) -> Placement {
    let g = laws.g;
    let unturned = vector::unturned(g);
    let Some(&(value, index)) = carried.travels.first() else { return carried.parent };
    let [x, y] = curve(laws, carried.joint, &parameter(laws, value, index));
    let column = |of: &Moving<'g>| of.jet.columns.get(&index).copied().unwrap_or(g.zero().bare);
    let at = LocalVector {
        at: [x.jet.value, y.jet.value],
        slides: BTreeMap::from([(index, [column(&x), column(&y)])]),
        drift: vector::zero(g).bare,
        drift_rate: [x.jet.bias, y.jet.bias],
    };
    // The curve's body is the parent, or else the carried body itself.
    let (frame, offset) = match carried.child_is_second {
        true => (carried.parent.frame, g.on(carried.parent.offset)),
        false => (carried.frame, unturned),
    };
    let out = Position::of(frame, at.turned(offset));
    let far = match carried.child_is_second {
        true => carried.pivot.clone() + out,
        false => carried.pivot.clone() - out,
    };
    carried.at(far, unturned)
}

/// u of a joint that is no graph, whose value is known: c′·Δ̇ = |c′|² u̇, c′·Δ̈ = |c′|² ü + c′·c″ u̇².
pub fn travel<'g>(
    laws: &Laws<'g>,
    kinematics: On<'g, &'g Kinematics>,
    joint: &'g Joint,
    known: Travelled,
) -> Moving<'g> {
    let (g, velocities) = (laws.g, &kinematics.bare.velocities);
    if let Some(index) = known.index {
        let columns = BTreeMap::from([(index, g.one().bare)]);
        return g.zero().moving(velocities, Jet { columns, ..Jet::constant(g.on(known.value)) });
    }
    let tangent = tangent(laws, joint, known.value);
    let inverse = tangent.dot(tangent.bare).reciprocal();
    let delta = Ends::of(laws, joint).in_first(laws);
    let [x, y] = tangent.parts();
    let mut moving = inverse * &(x * &delta[0] + y * &delta[1]);
    // c″ u̇², of what moves by itself.
    let alone = Jet { drift: known.rate, ..Jet::constant(g.on(known.value)) };
    let curved = curve(laws, joint, &g.zero().moving(velocities, alone)).map(|of| of.bias());
    moving.jet.value = known.value;
    moving.jet.bias = (moving.bias() - inverse * (x * curved[0] + y * curved[1])).bare;
    moving
}

/// What slides along the curve, with its lever: of a graph the second place along the tangent, else u with |c′|.
pub fn sliding<'g>(laws: &Laws<'g>, id: JointId) -> (Moving<'g>, Scalar<'g>) {
    let joint = &laws.mechanism.joints[id.0];
    let travel = laws.plane().travel(laws, id, 0);
    let tangent = tangent(laws, joint, travel.jet.value);
    if joint.graph().is_none() {
        return (travel, tangent.dot(tangent.bare).sqrt());
    }
    let (delta, [x, y]) = (Ends::of(laws, joint).in_first(laws), tangent.normalized().parts());
    (x * &delta[0] + y * &delta[1], laws.g.one())
}

/// The normal to the left of the curve at the second place, of length one, in world axes.
pub fn normal<'g>(laws: &Laws<'g>, id: JointId) -> On<'g, Pair> {
    let joint = &laws.mechanism.joints[id.0];
    let parameter = laws.plane().travel(laws, id, 0).jet.value;
    let normal = tangent(laws, joint, parameter).normalized().perpendicular();
    let (frame, normal) = laws.plane().carried_by(joint.first.frame, normal);
    laws.plane().to_world(frame, normal)
}

/// c′(u) in the axes of the first body, and u.
pub fn tangent_and_parameter(laws: &Laws, id: JointId) -> (Pair, Node) {
    let parameter = laws.plane().travel(laws, id, 0).jet.value;
    (tangent(laws, &laws.mechanism.joints[id.0], parameter).bare, parameter)
}

/// c′(u).
fn tangent<'g>(laws: &Laws<'g>, joint: &Joint, parameter: Node) -> On<'g, Pair> {
    let g = laws.g;
    let velocities = laws.kinematics().bare.velocities();
    let jet = Jet { columns: BTreeMap::from([(0, g.one().bare)]), ..Jet::constant(g.on(parameter)) };
    let [x, y] = curve(laws, joint, &g.zero().moving(velocities, jet))
        .map(|of| of.jet.columns.get(&0).map_or(g.zero(), |column| g.on(*column)));
    vector::pair(x, y)
}

/// c(u) at a number, in the axes of the first body.
pub fn point(laws: &Laws, id: JointId, parameter: f64) -> Pair {
    let parameter = laws.still(laws.g.number(parameter));
    curve(laws, &laws.mechanism.joints[id.0], &parameter).map(|of| of.jet.value)
}

/// u and, of x and of y, the value and the first two derivatives by u.
pub fn derivatives(laws: &Laws, id: JointId) -> (Node, [[Node; 3]; 2]) {
    let g = laws.g;
    let parameter = laws.plane().travel(laws, id, 0).jet.value;
    // Of what moves by itself at the rate of one.
    let alone = Jet { drift: g.one().bare, ..Jet::constant(g.on(parameter)) };
    let moving = g.zero().moving(laws.kinematics().bare.velocities(), alone);
    let curve = curve(laws, &laws.mechanism.joints[id.0], &moving);
    (parameter, curve.map(|of| [of.jet.value, of.jet.drift, of.jet.bias]))
}

/// c(u), in the axes of the first body.
fn curve<'g>(laws: &Laws<'g>, joint: &Joint, parameter: &Moving<'g>) -> [Moving<'g>; 2] {
    [0, 1].map(|axis| function(laws, joint, axis, parameter))
}

/// x(u) or y(u).
fn function<'g>(laws: &Laws<'g>, joint: &Joint, axis: usize, parameter: &Moving<'g>) -> Moving<'g> {
    let Moving { jet, .. } = laws.along(parameter).jet(joint.scalar(axis));
    laws.g.zero().moving(parameter.velocities, jet)
}

/// u as a coordinate.
fn parameter<'g>(laws: &Laws<'g>, value: Node, index: usize) -> Moving<'g> {
    let g = laws.g;
    let value: Scalar = g.on(value);
    let columns = BTreeMap::from([(index, g.one().bare)]);
    g.zero().moving(&laws.symbols.v, Jet { columns, ..Jet::constant(value) })
}

/// The pin; the curve is drawn as surfaces are.
fn symbol(s: &mut Symbol) {
    s.before.circle(s.second, 0.8 * s.unit, Pen::Solid);
}
