//! Contacts that the motion never closes.

use super::{End, Followed};
use crate::check::assemble::{Ancestry, Assembly, Point};
use crate::check::{contacts, messages};
use crate::diagnostics::{Diagnostics, Lint};
use crate::equations::Equations;
use crate::model::Mechanism;

/// m or rad.
const ROUNDING: f64 = 1e-9;

/// A warning of each contact whose gaps stay open all along a motion that returns to its start. Parameters have their defaults; gaps that inputs or
/// time change are not judged.
pub fn warn(
    mechanism: &Mechanism,
    equations: &Equations,
    assembly: &Assembly,
    followed: &Followed,
    warnings: &mut Diagnostics,
) {
    if followed.motion.end != End::Closed {
        return;
    }
    let gaps = contacts::gaps(mechanism, equations);
    if gaps.is_empty() {
        return;
    }
    let stands = |drift| equations.graph.sheet().is_zero(drift);
    let moved: Vec<&str> =
        gaps.iter().filter(|(_, jet)| !stands(jet.drift)).map(|(load, _)| load.name.text.as_str()).collect();
    let gaps: Vec<_> = gaps.iter().map(|(load, jet)| (*load, jet.value)).collect();
    let mut point = Point::at_defaults(mechanism, equations, &assembly.phases);
    let ancestry = Ancestry::of(equations, gaps.iter().map(|(_, gap)| *gap));
    let mut along: Vec<Vec<f64>> = vec![Vec::with_capacity(followed.places.len()); gaps.len()];
    for place in &followed.places {
        point.set_q(&place.q);
        point.evaluate(&ancestry);
        along.iter_mut().zip(&gaps).for_each(|(along, (_, gap))| along.push(point.get(*gap)));
    }
    for load in mechanism.loads.iter().filter(|load| load.is_contact()) {
        let own = gaps.iter().zip(&along).filter(|((of, _), _)| of.name.text == load.name.text);
        let own: Vec<(_, &Vec<f64>)> = own.map(|((_, gap), along)| (*gap, along)).collect();
        let is_decided = own.iter().all(|(gap, _)| !equations.takes_inputs(*gap))
            && !moved.contains(&load.name.text.as_str());
        if own.is_empty() || !is_decided || mechanism.allowed.covers(Lint::NoEffect, load.name.span) {
            continue;
        }
        let least = own.iter().map(|(_, along)| least_between(along)).fold(f64::INFINITY, f64::min);
        if least > ROUNDING {
            let message = messages::never_closes(&load.name.text, least, contacts::is_angle(load));
            warnings.warning(Lint::NoEffect, load.name.span, message);
        }
    }
}

/// The least of values, and of what may lie between two neighbours that were looked at.
fn least_between(values: &[f64]) -> f64 {
    let between = values.windows(2).map(|pair| 0.5 * (pair[0] + pair[1]) - (pair[1] - pair[0]).abs());
    values.iter().copied().chain(between).fold(f64::INFINITY, f64::min)
}
