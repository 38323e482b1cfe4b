//! Which velocities are taken as dependent ones, where a formulation works with independent ones.

use super::{Ancestry, Assembly, Point};
use crate::equations::Equations;
use crate::model::Mechanism;
use std::collections::{BTreeMap, BTreeSet};

/// The dependent velocity of each row, `None` of rows that are kept though redundant: at the start, row by row, what earlier rows
/// leave of a row is largest there. The runtime keeps the choice while it is good, and chooses in the same way where it is not.
pub fn dependent(mechanism: &Mechanism, equations: &Equations, assembly: &Assembly) -> Vec<Option<usize>> {
    let mut point = Point::at_defaults(mechanism, equations, &assembly.phases);
    point.set_q(&assembly.q);
    let columns = equations.rows.iter().flat_map(|row| row.jet.columns.values().copied());
    point.evaluate(&Ancestry::of(equations, columns));

    let mut eliminated: Vec<(usize, BTreeMap<usize, f64>)> = Vec::new();
    let mut taken = BTreeSet::new();
    let mut chosen = Vec::new();
    for (index, row) in equations.rows.iter().enumerate() {
        if equations.idle.contains(&index) {
            chosen.push(None);
            continue;
        }
        let mut rest: BTreeMap<usize, f64> =
            row.jet.columns.iter().map(|(column, node)| (*column, point.get(*node))).collect();
        for (pivot, upper) in &eliminated {
            let Some(entry) = rest.remove(pivot).filter(|entry| *entry != 0.0) else { continue };
            let factor = entry / upper[pivot];
            for (column, value) in upper.iter().filter(|(column, _)| *column != pivot) {
                *rest.entry(*column).or_default() -= factor * value;
            }
        }
        let free = rest.iter().filter(|(column, _)| !taken.contains(*column));
        let best = free.fold(None, |best: Option<(usize, f64)>, (column, value)| match best {
            Some((_, most)) if value.abs() <= most => best,
            _ => Some((*column, value.abs())),
        });
        chosen.push(best.map(|(column, _)| column));
        if let Some((column, _)) = best {
            taken.insert(column);
            eliminated.push((column, rest));
        }
    }
    chosen
}
