//! Screw: as cylindrical, and travel = pitch/(2π) · angle with the angle counted over its turns.

use super::{Elementary, Ends, cylindrical};
use crate::equations::{JointRow, Laws};
use crate::model::{Expr, JointId, Rotor};
use std::f64::consts::TAU;

pub fn motions() -> Vec<Elementary> {
    vec![Elementary::Wind, Elementary::Turn { frame: 0, which: 0 }]
}

pub fn rows(laws: &Laws, ends: &Ends, id: JointId, pitch: &Expr) -> Vec<JointRow> {
    let mut rows = cylindrical::rows(ends);
    let lead = laws.value(pitch) / TAU;
    let (travel, angle) = (laws.kinematics().travel(laws, id, 0), laws.angle(Rotor::Joint(id, 0)));
    rows.push(JointRow::new("screw", travel - lead * angle));
    rows
}
