//! Friction by reactions that presses harder by itself than it lets go, and friction that nothing presses.
//!
//! At the start, and at positions along the motion with speeds of up to 1 rad/s or m/s along some ways that joints admit, the loop for N is taken as often
//! as the generated functions take it. What it leaves open is little in sound mechanisms, and much where there is no solution, or two (Painlevé).

use super::admitted::Admitted;
use super::assemble::{Ancestry, Assembly, Point};
use super::messages;
use crate::diagnostics::{Diagnostics, Lint};
use crate::equations::Equations;
use crate::model::{Expr, Load, Mechanism};
use crate::solve::Solved;

/// What the loop may leave open, as a part of what presses.
const OPEN: f64 = 0.01;
/// What is pressed by less than so often ε is not pressed.
const NOTHING: f64 = 100.0;
/// Ways that are tried at each position, to and fro.
const WAYS: usize = 3;

/// Warns of the friction of which most is open, or of those that nothing presses. Parameters have their defaults, inputs are zero.
pub fn locks(
    mechanism: &Mechanism,
    equations: &Equations,
    solved: &Solved,
    assembly: &Assembly,
    warnings: &mut Diagnostics,
) {
    let (friction, left) = (&equations.friction, &solved.index1.left);
    if friction.is_none() || left.is_empty() {
        return;
    }
    let ancestry = Ancestry::of(equations, left.iter().flatten().copied());
    let mut point = Point::at_start(mechanism, equations, assembly);
    // Of each, what is open at most by what presses, and what presses at most.
    let mut found = vec![[0.0_f64; 2]; left.len()];
    let mut see = |point: &mut Point| {
        point.hold();
        point.evaluate(&ancestry);
        let values: Vec<[f64; 2]> =
            left.iter().map(|[start, _, last]| [point.get(*last).abs(), point.get(*start)]).collect();
        let largest = values.iter().fold(friction.smallest.sqrt(), |largest, [_, size]| largest.max(*size));
        for (found, [open, size]) in found.iter_mut().zip(values) {
            let part = open / largest;
            let part = if part.is_finite() { part } else { f64::INFINITY };
            *found = [found[0].max(part), found[1].max(size)];
        }
    };
    see(&mut point);
    let admitted = Admitted::new(equations, 0..equations.rows.len());
    for q in &assembly.along {
        let here = admitted.at(&mut point, q);
        for way in 1..=WAYS {
            let wish = |k: usize| libm::sin((way * (3 * k + 2)) as f64);
            let Some(v) = here.velocity(wish) else { continue };
            for sign in [1.0, -1.0] {
                point.set_v(&v.iter().map(|v| sign * v).collect::<Vec<_>>());
                see(&mut point);
            }
        }
    }
    let load = |which: usize| &mechanism.loads[friction.loads[which]];
    let worst = (0..found.len()).max_by(|a, b| found[*a][0].total_cmp(&found[*b][0]));
    if let Some(worst) = worst.filter(|worst| found[*worst][0] > OPEN) {
        let Load { name, .. } = load(worst);
        if !mechanism.allowed.covers(Lint::Locks, name.span) {
            let message = messages::friction_locks(&name.text, found[worst][0], friction.passes);
            warnings.warning(Lint::Locks, name.span, message);
        }
        return;
    }
    // What is given from outside may press, and what touches later.
    let is_given = mechanism.loads.iter().any(Load::is_contact)
        || mechanism.loads.iter().any(|load| load.arguments().any(|(_, it)| it.iter().any(Expr::is_given)));
    for (which, [_, size]) in found.iter().enumerate() {
        let load = load(which);
        let own =
            ["preload", "force", "torque"].iter().any(|name| !matches!(load.named(name), Expr::Number(0.0)));
        let is_judged = !is_given && !own && !mechanism.allowed.covers(Lint::NoEffect, load.name.span);
        if is_judged && *size < NOTHING * friction.smallest.sqrt() {
            warnings.warning(Lint::NoEffect, load.name.span, messages::nothing_presses(&load.name.text));
        }
    }
}
