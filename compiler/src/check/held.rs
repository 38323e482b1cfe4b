//! Contacts whose gaps no motion changes.
//!
//! The gradient J of a gap is split by the rows D of what holds: with W, which weighs lengths and angles alike, and K = [W, Dᵀ; D, 0],
//!
//! ```text
//! |J_N|² = (J, 0) K⁻¹ (J, 0)ᵀ,   |J|² = J W⁻¹ Jᵀ          J_N what is left of J along the velocities that D allows
//! ```
//! At a dead centre J_N vanishes for a moment, as where a slider turns back at a stop. So it is looked at along the motion, and a contact is named
//! where J_N vanishes at all positions.

use super::admitted::Admitted;
use super::assemble::{Ancestry, Assembly, Point};
use super::{contacts, messages};
use crate::diagnostics::{Diagnostics, Lint};
use crate::equations::{Equations, Jet};
use crate::model::{Load, Mechanism};

/// What of |J|² is rounding.
const ROUNDING: f64 = 1e-10;
/// Gaps that are closed, m or rad.
const CLOSED: f64 = 1e-9;

/// Warnings of contacts that joints hold, and of rigid ones that drivers do; errors of rigid ones that touch at the start and cannot part.
/// Gaps that inputs or time change are not judged.
pub fn held(
    mechanism: &Mechanism,
    equations: &Equations,
    assembly: &Assembly,
    errors: &mut Diagnostics,
    warnings: &mut Diagnostics,
) {
    let rows = equations.rows.len();
    if rows == 0 || assembly.along.len() < 2 || !mechanism.loads.iter().any(Load::is_contact) {
        return;
    }
    let gaps = contacts::gaps(mechanism, equations);
    let moves = |jet: &Jet, admitted: &Admitted| moves(mechanism, equations, assembly, jet, admitted);
    let by_joints = Admitted::new(equations, 0..rows - mechanism.drivers.len());
    let by_all = Admitted::new(equations, 0..rows);
    let mut point = Point::at_start(mechanism, equations, assembly);
    point.evaluate(&Ancestry::of(equations, gaps.iter().map(|(_, jet)| jet.value)));
    for load in mechanism.loads.iter().filter(|load| load.is_contact()) {
        let (name, at) = (&load.name.text, load.name.span);
        let own: Vec<&Jet> =
            gaps.iter().filter(|(of, _)| of.name.text == *name).map(|(_, jet)| jet).collect();
        let is_judged = |jet: &&Jet| {
            let stands = equations.graph.sheet().is_zero(jet.drift);
            !jet.columns.is_empty() && stands && !equations.takes_inputs(jet.value)
        };
        if own.is_empty() || !own.iter().all(is_judged) {
            continue;
        }
        let is_rigid = !load.restitutions.is_empty();
        let least = own.iter().map(|jet| point.get(jet.value)).fold(f64::INFINITY, f64::min);
        let is_allowed = mechanism.allowed.covers(Lint::NoEffect, at);
        if own.iter().all(|jet| !moves(jet, &by_joints)) {
            if is_rigid && least < CLOSED {
                errors.error(at, messages::never_parts(name));
            } else if !is_allowed {
                let message = messages::gap_is_held(name, least, contacts::is_angle(load));
                warnings.warning(Lint::NoEffect, at, message);
            }
        } else if is_rigid && !is_allowed && own.iter().all(|jet| !moves(jet, &by_all)) {
            warnings.warning(Lint::NoEffect, at, messages::gap_is_driven(name));
        }
    }
}

/// Whether some velocity that is admitted changes a gap, at one of the positions along the motion.
fn moves(
    mechanism: &Mechanism,
    equations: &Equations,
    assembly: &Assembly,
    gap: &Jet,
    admitted: &Admitted,
) -> bool {
    let ancestry = Ancestry::of_jets(equations, [gap]);
    let mut point = Point::at_defaults(mechanism, equations, &assembly.phases);
    assembly.along.iter().any(|q| {
        let here = admitted.at(&mut point, q);
        point.evaluate(&ancestry);
        let gradient: Vec<(usize, f64)> =
            gap.columns.iter().map(|(column, node)| (*column, point.get(*node))).collect();
        let [left, whole] = here.squares(&gradient);
        left > ROUNDING * whole || left.is_nan()
    })
}
