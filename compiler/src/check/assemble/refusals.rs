//! Messages for the case that no assembly is found, or a second one fits as well.

use super::gap::{Fault, Gaps, Open};
use super::initial::{Stated, Variation};
use super::mobility::{independent, rank};
use super::point::{Ancestry, Point};
use super::{Attempt, Problem, blame, drivers, messages};
use crate::diagnostics::{Diagnostics, Region};
use crate::equations::{Condition, Equations, Rotation};
use crate::model::{Frame, JointId, Mechanism, Space};
use std::f64::consts::TAU;

/// Two assemblies: names the coordinate in which they differ most.
pub fn second(
    mechanism: &Mechanism,
    problem: &Problem,
    point: &mut Point,
    nearest: &Attempt,
    next: &Attempt,
    errors: &mut Diagnostics,
) {
    if mechanism.space == Space::Spatial {
        second_in_space(mechanism, problem, nearest, next, errors);
        return;
    }
    let mut widest: Option<(f64, usize, f64, f64)> = None;
    for (index, joint) in mechanism.joints.iter().enumerate() {
        let ends = [joint.first.frame, joint.second.frame].map(|frame| match frame {
            Frame::Ground => None,
            Frame::Body(body) => Some(body.0),
        });
        let (a, b) =
            (problem.joint_angle(point, &nearest.q, ends), problem.joint_angle(point, &next.q, ends));
        let difference = (a - b - TAU * ((a - b) / TAU).round()).abs();
        let turns = !joint.form.angles.is_empty();
        if turns && difference > 1e-6 && widest.is_none_or(|(known, ..)| difference > known + 1e-9) {
            widest = Some((difference, index, a, b));
        }
    }
    match widest {
        None => errors.error(mechanism.name.span, messages::second_assembly_unnamed()),
        Some((_, index, a, b)) => {
            let joint = &mechanism.joints[index].name;
            errors.error(
                joint.span,
                messages::second_assembly(
                    &joint.text,
                    &format!("{}.angle", joint.text),
                    a,
                    b,
                    problem.has_guesses(),
                ),
            );
        }
    }
}

/// In space: by the coordinates of the tree.
fn second_in_space(
    mechanism: &Mechanism,
    problem: &Problem,
    nearest: &Attempt,
    next: &Attempt,
    errors: &mut Diagnostics,
) {
    let layout = &problem.equations().layout;
    let angle = |q: &[f64], r: usize| libm::atan2(q[layout.pair(r) + 1], q[layout.pair(r)]);
    let mut widest: Option<(f64, JointId, String, f64, f64)> = None;
    for (r, rotation) in layout.rotations.iter().enumerate() {
        let Rotation::Joint(joint, which) = rotation else { continue };
        let (a, b) = (angle(&nearest.q, r), angle(&next.q, r));
        let difference = (a - b - TAU * ((a - b) / TAU).round()).abs();
        if difference > 1e-6 && widest.as_ref().is_none_or(|(known, ..)| difference > known + 1e-9) {
            let name = crate::equations::coordinates::angle_name(mechanism, *joint, *which, 0);
            widest = Some((difference, *joint, name, a, b));
        }
    }
    match widest {
        None => errors.error(mechanism.name.span, messages::second_assembly_unnamed()),
        Some((_, joint, angle, a, b)) => {
            let joint = &mechanism.joints[joint.0].name;
            errors.error(
                joint.span,
                messages::second_assembly(&joint.text, &angle, a, b, problem.has_guesses()),
            );
        }
    }
}

/// No assembly: names what is in the way, after a search from so many positions.
pub fn open(
    mechanism: &Mechanism,
    problem: &Problem,
    stated: &Stated,
    point: &mut Point,
    searched: usize,
    errors: &mut Diagnostics,
) {
    let equations = point.equations;
    let initial = stated.initial(mechanism, point, Variation::Few(0));
    let first = problem.solve(point, initial.clone());
    if !first.amount.is_finite() {
        let row = first.worst.map(|row| &equations.rows[row]);
        let (of, span) = row.map_or(("start", stated_span(mechanism)), |row| (row.of.as_str(), row.span));
        errors.error(span, messages::no_value_at_start(of));
        return;
    }
    let mut gaps = Gaps::new(mechanism, problem, point, stated);
    let closed = gaps.closed(point);
    let at = closed.as_ref().unwrap_or(&initial);
    if drivers::too_many(point, mechanism.drivers.len(), at, errors) {
        return;
    }
    match gaps.fault(point, closed.as_ref()) {
        Fault::Loop(open) => {
            let row = &equations.rows[open.rows[0]];
            let blames = row.joint().map(|joint| blame::of_loop(mechanism, point, joint, &open.q));
            let path = row.joint().map(|joint| loop_of(mechanism, equations, joint)).unwrap_or_default();
            let open = stays_open(&row.of, &path, &open, searched);
            errors.error(row.span, messages::cannot_close(&open, &blames.unwrap_or_default()));
        }
        Fault::Driver { driver, miss } => {
            let (condition, node) = &equations.driven[driver];
            point.evaluate(&Ancestry::of(equations, [*node]));
            let (value, name) = (point.get(*node), &mechanism.drivers[driver].name);
            let message =
                messages::driver_against_rest(&name.text, &condition.of, value, miss, unit(condition));
            errors.error(name.span, message);
        }
        Fault::Start { nearest, open } => {
            let start = closed.as_ref().and_then(|closed| overgiven(mechanism, point, closed));
            let missed = missed(problem, point, &nearest);
            let drivers = equations.driven.iter().zip(&mechanism.drivers);
            let drivers = drivers.map(|((condition, node), driver)| {
                point.evaluate(&Ancestry::of(equations, [*node]));
                (driver.name.text.clone(), condition.of.clone(), point.get(*node))
            });
            let drivers: Vec<_> = drivers.collect();
            let row = open.as_ref().map(|open| &equations.rows[open.rows[0]]);
            let path = row.and_then(|row| row.joint()).map(|joint| loop_of(mechanism, equations, joint));
            let path = path.unwrap_or_default();
            let open = open.as_ref().zip(row).map(|(open, row)| stays_open(&row.of, &path, open, searched));
            let message = messages::cannot_meet_start(&missed, open.as_ref(), drivers, start.as_ref());
            errors.error(row.map_or(stated_span(mechanism), |row| row.span), message);
        }
        Fault::Unknown => errors.error(mechanism.name.span, messages::cannot_start(searched)),
    }
}

fn stays_open<'a>(of: &'a str, path: &'a [String], open: &Open, searched: usize) -> messages::StaysOpen<'a> {
    messages::StaysOpen { of, path, gap: open.gap, with_others: open.with_others, searched }
}

fn stated_span(mechanism: &Mechanism) -> Region {
    let stated = mechanism.start.iter().find(|start| start.exact);
    stated.map_or(mechanism.name.span, |start| start.span)
}

fn unit(condition: &Condition) -> &'static str {
    if condition.angular { "rad" } else { "m" }
}

/// The conditions of `start` that `q` misses.
fn missed(problem: &Problem, point: &mut Point, q: &[f64]) -> Vec<messages::Missed> {
    point.set_q(q);
    point.evaluate(&Ancestry::of_jets(
        point.equations,
        problem.conditions().iter().map(|(condition, _)| &condition.jet),
    ));
    let values = problem.conditions().iter().map(|(condition, stated)| {
        let value = point.get(condition.jet.value);
        // Half a turn off is one thing from either side.
        let turns = if condition.angular { ((value - stated) / TAU * (1.0 - 1e-9)).round() } else { 0.0 };
        let (of, unit) = (condition.of.clone(), unit(condition));
        messages::Missed { of, stated: *stated, nearest: value - TAU * turns, unit }
    });
    values.filter(|missed| (missed.nearest - missed.stated).abs() > 1e-6).collect()
}

/// Freedoms that the joints leave at `q`.
fn freedoms(mechanism: &Mechanism, point: &mut Point, q: &[f64]) -> usize {
    let equations = point.equations;
    let undriven: Vec<usize> = (0..equations.rows.len() - mechanism.drivers.len()).collect();
    equations.symbols.v.len() - rank(point, &undriven, q).rank
}

/// Whether `start` gives more coordinates than the joints leave free; drivers give theirs.
fn overgiven(mechanism: &Mechanism, point: &mut Point, q: &[f64]) -> Option<messages::Overgiven> {
    let equations = point.equations;
    let given = equations.conditions.with_start();
    let given = given.filter(|(_, target)| target.position.is_some());
    let given: Vec<_> = given.map(|(condition, _)| condition.clone()).collect();
    let freedoms = freedoms(mechanism, point, q);
    let kept = independent(point, &given, q);
    let names = |keep: bool| -> Vec<String> {
        let named = given.iter().enumerate().filter(|(at, _)| kept.contains(at) == keep);
        named.map(|(_, condition)| condition.of.clone()).collect()
    };
    let guess = names(false);
    (given.len() > freedoms && !guess.is_empty()).then(|| messages::Overgiven {
        freedoms,
        keep: names(true),
        guess,
    })
}

/// The bodies on the loop that a cut joint closes, by the tree.
fn loop_of(mechanism: &Mechanism, equations: &Equations, joint: JointId) -> Vec<String> {
    let path = |frame: Frame| {
        let mut path = Vec::new();
        let mut at = frame;
        while let Frame::Body(body) = at {
            path.push(body);
            let attachment = equations.tree.attachments.iter().find(|own| own.body == body);
            at = attachment.and_then(|own| own.joint).map_or(Frame::Ground, |(_, parent)| parent);
        }
        path
    };
    let joint = &mechanism.joints[joint.0];
    let (first, second) = (path(joint.first.frame), path(joint.second.frame));
    let mut bodies: Vec<_> = first.iter().filter(|body| !second.contains(body)).copied().collect();
    bodies.reverse();
    // The body where both ways meet belongs to the loop as well.
    if let Some(meeting) = first.iter().find(|body| second.contains(body)) {
        bodies.insert(0, *meeting);
    }
    bodies.extend(second.iter().filter(|body| !first.contains(body)));
    bodies.iter().map(|body| mechanism.bodies[body.0].name.text.clone()).collect()
}
