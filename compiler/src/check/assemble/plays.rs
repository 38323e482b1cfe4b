//! Loops that close only with the play of their joints: where the centres of all of these cannot be together, the start is where they are nearest
//! to one another, by their parts of the clearances: Σ (e/c)² is least, with e between the centres and c the clearance. There a loop is as long or
//! as short as it can be, so that nothing further is asked of these joints, neither where they start nor how fast.

use super::descent::{Descent, Rest, Role, TO_THE_END};
use super::initial::{Stated, Variation};
use super::{Ancestry, Point, attempts, messages, problem};
use crate::diagnostics::Diagnostics;
use crate::equations::{Condition, Equations, Jet, Laws, StartTarget};
use crate::model::{Coordinate, JointId, Mechanism};

/// Of a clearance: centres that are this near are together.
const TOGETHER: f64 = 1e-9;
/// Positions that descents begin with, and steps of all.
const BEGINNINGS: usize = 12;
const STEPS: usize = 600;

/// A joint with play whose centres the start has together.
struct Loose {
    joint: JointId,
    /// Its conditions, among those that have a position at the start.
    closings: Vec<usize>,
    /// How far its surfaces are apart.
    gap: Jet,
}

/// The mechanism and its equations, and the position where they start if these joints give what they can; `None` after an error.
pub fn taken_up(
    mut mechanism: Mechanism,
    mut equations: Equations,
    errors: &mut Diagnostics,
) -> Option<(Mechanism, Equations, Option<Vec<f64>>)> {
    let loose = centred(&mechanism, &equations);
    let Some(q) = nearest(&mechanism, &equations, &loose, errors) else {
        return errors.is_empty().then_some((mechanism, equations, None));
    };
    for it in &loose {
        mechanism.joints[it.joint.0].eased = true;
        let rows = equations.conditions.rows.iter().zip(&mut equations.conditions.start);
        let own = rows.filter(|(condition, _)| closes(condition, it.joint));
        own.for_each(|(_, start)| *start = StartTarget::default());
    }
    Some((mechanism, equations, Some(q)))
}

fn closes(condition: &Condition, joint: JointId) -> bool {
    matches!(condition.coordinate, Coordinate::Closing(of, _) if of == joint)
}

/// Where the centres are nearest, if they cannot be together.
fn nearest(
    mechanism: &Mechanism,
    equations: &Equations,
    loose: &[Loose],
    errors: &mut Diagnostics,
) -> Option<Vec<f64>> {
    // What is to be static is so where loops are closed.
    if loose.is_empty() || !mechanism.deflected.is_empty() {
        return None;
    }
    let mut point = Point::at_defaults(mechanism, equations, &[]);
    let firm = problem(mechanism, equations, &mut point);
    if attempts::closed(mechanism, &firm, &mut point, &mut Diagnostics::new()).is_some() {
        return None;
    }
    // Of each joint the distance of its centres, and its clearance.
    let stand = |point: &mut Point| -> Vec<(f64, f64)> {
        let closings = loose.iter().flat_map(|it| &it.closings).map(|at| &firm.conditions()[*at].0.jet);
        point.evaluate(&Ancestry::of_jets(equations, closings.chain(loose.iter().map(|it| &it.gap))));
        let apart = |it: &Loose| {
            let offsets = it.closings.iter().map(|at| point.get(firm.conditions()[*at].0.jet.value));
            let apart = offsets.map(|offset| offset * offset).sum::<f64>().sqrt();
            (apart, apart + point.get(it.gap.value))
        };
        loose.iter().map(apart).collect()
    };
    let stated = Stated::of(equations, &mut point);
    let begin = stated.initial(mechanism, &mut point, Variation::Few(0));
    let (mut residuals, length) = firm.residuals(mechanism, &mut point, &begin);
    let first = firm.rows().len();
    let mut roles = vec![Role::Hard; residuals.len()];
    roles[first + firm.conditions().len()..].fill(Role::Absent);
    point.set_q(&begin);
    for (it, (_, clearance)) in loose.iter().zip(stand(&mut point)) {
        for at in &it.closings {
            roles[first + at] = Role::Soft;
            residuals[first + at].size = clearance;
        }
    }
    let mut descent = Descent::new(equations, residuals, STEPS);
    let dimensions = equations.symbols.v.len();
    let near = (0..BEGINNINGS).filter_map(|number| {
        let variation = Variation::Many { number, dimensions, length, stated: false };
        let q = if number == 0 { begin.clone() } else { stated.initial(mechanism, &mut point, variation) };
        let rest = descent.descend(&mut point, q, &roles, TO_THE_END)?;
        point.set_q(&rest.q);
        let parts = stand(&mut point);
        Some((rest, parts))
    });
    // The first that is within reach is nearest to the guesses; where none is, the least tells what is missing.
    let mut best: Option<(Rest, Vec<(f64, f64)>)> = None;
    for (rest, parts) in near {
        let reaches = parts.iter().all(|(apart, clearance)| apart <= clearance);
        if reaches || best.as_ref().is_none_or(|(known, _)| rest.cost < known.cost) {
            best = Some((rest, parts));
        }
        if reaches {
            break;
        }
    }
    let (rest, parts) = best?;
    if parts.iter().all(|(apart, clearance)| *apart <= TOGETHER * clearance) {
        // It closes, and something else is wrong.
        return None;
    }
    let name = |it: &Loose| &mechanism.joints[it.joint.0].name;
    if let Some(at) = parts.iter().position(|(apart, clearance)| apart > clearance) {
        let of = loose.iter().zip(&parts).map(|(it, part)| (name(it).text.as_str(), *part));
        errors.error(name(&loose[at]).span, messages::loop_beyond_play(&of.collect::<Vec<_>>()));
        return None;
    }
    Some(rest.q)
}

/// The joints with play whose centres the start has together.
fn centred(mechanism: &Mechanism, equations: &Equations) -> Vec<Loose> {
    let laws = Laws::moving(
        equations.graph.sheet(),
        mechanism,
        &equations.symbols,
        &equations.layout,
        &equations.kinematics,
    );
    let joints = mechanism.joints.iter().enumerate();
    let found = joints.filter_map(|(index, joint)| {
        let contact = &mechanism.loads[joint.loose?.0];
        let gap = laws.jet(contact.along().next()?).jet;
        let joint = JointId(index);
        let stated = equations.conditions.with_start().filter(|(_, start)| start.position.is_some());
        let own = stated.enumerate().filter(|(_, (condition, _))| closes(condition, joint));
        let it = Loose { joint, closings: own.map(|(at, _)| at).collect(), gap };
        (!it.closings.is_empty()).then_some(it)
    });
    found.collect()
}
