//! Drivers that cannot be followed: that move what others move already, that have nothing to move, or that stand at a dead
//! centre.

use super::freedoms::Assembled;
use super::mobility::rank;
use super::point::Point;
use super::{messages, redundancy};
use crate::diagnostics::{Diagnostic, Diagnostics, Note, Severity};
use crate::equations::Equations;

/// A driver that moves nothing of its own, and the others from which its coordinate follows, rows of the equations.
pub struct Rivals {
    driver: usize,
    others: Vec<usize>,
}

/// Judges every driver at a position that the mechanism can have; `rows` are those of joints and couplings without the ones that repeat others.
pub fn judge(at: &Assembled, point: &mut Point, mut rows: Vec<usize>, errors: &mut Diagnostics) {
    let equations = point.equations;
    for driver in all(equations, at.mechanism.drivers.len()) {
        let row = &equations.rows[driver];
        match dependent(point, &rows, driver, at.q) {
            None => rows.push(driver),
            Some(rivals) if !rivals.others.is_empty() => report(point, &rivals, errors),
            Some(_) if freedoms(point, at.mechanism.drivers.len(), at.q) == 0 => {
                errors.error(row.span, messages::nothing_to_drive(&row.of));
                return;
            }
            Some(_) => {
                let nearby = redundancy::nearby(at.mechanism, point, at.problem, at.q);
                let joints: Vec<usize> = (0..first(equations, at.mechanism.drivers.len())).collect();
                let held = nearby.iter().all(|q| dependent(point, &joints, driver, q).is_some());
                let message = match held && !nearby.is_empty() {
                    true => messages::held_driver(&row.of, quantity(equations, driver)),
                    false => messages::stuck_driver(&row.of, quantity(equations, driver)),
                };
                errors.error(row.span, message);
            }
        }
    }
}

/// More drivers than the mechanism has freedoms, where no position has been found: they can only disagree. Whether that was it; of fewer
/// drivers nothing is known, since `q` may be an arm stretched out for what it cannot reach, where its drivers depend on each other.
pub fn too_many(point: &mut Point, drivers: usize, q: &[f64], errors: &mut Diagnostics) -> bool {
    let equations = point.equations;
    let freedoms = freedoms(point, drivers, q);
    if drivers <= freedoms {
        return false;
    }
    if freedoms == 0 {
        let row = &equations.rows[first(equations, drivers)];
        errors.error(row.span, messages::nothing_to_drive(&row.of));
        return true;
    }
    let mut rows: Vec<usize> = (0..first(equations, drivers)).collect();
    for driver in all(equations, drivers) {
        match dependent(point, &rows, driver, q) {
            Some(rivals) if !rivals.others.is_empty() => {
                report(point, &rivals, errors);
                return true;
            }
            _ => rows.push(driver),
        }
    }
    false
}

/// Degrees of freedom without drivers.
fn freedoms(point: &mut Point, drivers: usize, q: &[f64]) -> usize {
    let equations = point.equations;
    let undriven: Vec<usize> = (0..first(equations, drivers)).collect();
    equations.symbols.v.len() - rank(point, &undriven, q).rank
}

/// Whether a driver adds nothing to the rank of `rows`; with the least of the drivers among them that it takes for that.
fn dependent(point: &mut Point, rows: &[usize], driver: usize, q: &[f64]) -> Option<Rivals> {
    let adds = |point: &mut Point, rows: &[usize]| {
        let with: Vec<usize> = rows.iter().copied().chain([driver]).collect();
        rank(point, &with, q).rank > rank(point, rows, q).rank
    };
    if adds(point, rows) {
        return None;
    }
    let mut needed = rows.to_vec();
    let others = rows.iter().copied().filter(|row| is_driver(point.equations, *row));
    let mut others: Vec<usize> = others.collect();
    others.retain(|other| {
        let without: Vec<usize> = needed.iter().copied().filter(|row| row != other).collect();
        let holds = !adds(point, &without);
        if holds {
            needed = without;
        }
        !holds
    });
    Some(Rivals { driver, others })
}

fn report(point: &Point, rivals: &Rivals, errors: &mut Diagnostics) {
    let equations = point.equations;
    let named = |row: usize| (equations.rows[row].of.as_str(), quantity(equations, row));
    let others: Vec<_> = rivals.others.iter().map(|row| named(*row)).collect();
    let note = |row: &usize| Note {
        region: equations.rows[*row].span,
        message: messages::drives_too(named(*row), named(rivals.driver)),
    };
    errors.push(Diagnostic {
        severity: Severity::Error,
        region: equations.rows[rivals.driver].span,
        message: messages::drives_the_same(named(rivals.driver), &others),
        notes: rivals.others.iter().map(note).collect(),
    });
}

/// The row of the first driver; they are the last rows.
fn first(equations: &Equations, drivers: usize) -> usize {
    equations.rows.len() - drivers
}

fn all(equations: &Equations, drivers: usize) -> std::ops::Range<usize> {
    first(equations, drivers)..equations.rows.len()
}

fn is_driver(equations: &Equations, row: usize) -> bool {
    row >= first(equations, equations.driven.len())
}

/// The quantity that a driver moves, `crank_pin.angle`.
fn quantity(equations: &Equations, driver: usize) -> &str {
    &equations.driven[driver - first(equations, equations.driven.len())].0.of
}
