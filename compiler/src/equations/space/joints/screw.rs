//! Screw: as cylindrical, and travel = pitch/(2π) · angle with the angle counted over its turns.

use super::{Elementary, Ends, cylindrical};
use crate::equations::{JointRow, Laws};
use crate::model::{Expr, JointId, Rotor};
use crate::symbolic::Graph;

pub fn motions() -> Vec<Elementary> {
    vec![Elementary::Wind, Elementary::Turn { frame: 0, which: 0 }]
}

pub fn rows(g: &mut Graph, laws: &Laws, ends: &Ends, id: JointId, pitch: &Expr) -> Vec<JointRow> {
    let mut rows = cylindrical::rows(g, ends);
    let pitch = laws.value(g, pitch);
    let turn = g.constant(std::f64::consts::TAU);
    let lead = g.div(pitch, turn);
    let (travel, angle) = (laws.kinematics().travel(g, laws, id, 0), laws.angle(g, Rotor::Joint(id, 0)));
    let wound = angle.scale(g, lead);
    rows.push(JointRow::new("screw", travel.sub(g, &wound)));
    rows
}
