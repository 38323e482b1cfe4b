//! The modes of beams: what they are, how fast they are by themselves, and the step that they allow.

use super::table::{Table, code};
use crate::beams::RK4;
use crate::compiled::Compiled;
use crate::numbers::significant;
use std::f64::consts::TAU;

pub fn beams(page: &mut String, compiled: &Compiled) {
    let mechanism = &compiled.mechanism;
    let rates = mechanism.modes();
    let mut rates = rates.iter();
    let mut table = Table::new(&["mode", "shapes", "by itself, Hz", "steps of RK4 up to, µs"]);
    for body in &mechanism.bodies {
        let Some(beam) = &body.beam else { continue };
        for (name, rate) in rates.by_ref().take(beam.slender.modes.len()) {
            table.row(vec![
                code(name),
                beam.slender.shapes.word().to_string(),
                significant(rate / TAU, 6),
                significant(1e6 * RK4 / rate, 3),
            ]);
        }
    }
    table.write(page, "Modes of beams");
}
