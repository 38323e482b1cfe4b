//! What to say when no assembly is found, or a second one fits as well.

use super::initial::Stated;
use super::mobility::{independent, rank};
use super::point::{Ancestry, Point};
use super::{Attempt, Problem, messages};
use crate::diagnostics::Diagnostics;
use crate::equations::{Equations, Rotation};
use crate::model::{Frame, JointId, JointKind, Mechanism, Space};
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
        let turns = matches!(joint.kind, JointKind::Revolute { .. } | JointKind::PointOnLine { .. });
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
                messages::second_assembly(&joint.text, &format!("{}.angle", joint.text), a, b),
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
            errors.error(joint.span, messages::second_assembly(&joint.text, &angle, a, b));
        }
    }
}

/// No assembly: names the joint that stays open, and the loop it closes.
pub fn open(
    mechanism: &Mechanism,
    problem: &Problem,
    stated: &Stated,
    point: &mut Point,
    _searched: usize,
    errors: &mut Diagnostics,
) {
    let equations = point.equations;
    let q = stated.initial(mechanism, point, super::initial::Variation::Few(0));
    let failure = Some(problem.solve(point, q));
    let Some(failure) = failure else {
        errors.error(mechanism.name.span, messages::cannot_start());
        return;
    };
    if let Some(driver) = mechanism.drivers.first() {
        // More drivers than freedoms can only disagree.
        let undriven: Vec<usize> = (0..equations.rows.len() - mechanism.drivers.len()).collect();
        let freedoms = equations.symbols.v.len() - rank(point, &undriven, &failure.q).rank;
        if mechanism.drivers.len() > freedoms {
            let names = mechanism.drivers.iter().map(|driver| driver.name.text.clone()).collect();
            errors.error(driver.name.span, messages::too_many_drivers(names, freedoms));
            return;
        }
    }
    let first_driver = equations.rows.len() - mechanism.drivers.len();
    match failure.worst {
        Some(row) if row >= first_driver => {
            let (condition, node) = &equations.driven[row - first_driver];
            point.evaluate(&Ancestry::of(equations, [*node]));
            let row = &equations.rows[row];
            let message =
                messages::driver_against_rest(&row.of, &condition.of, point.get(*node), failure.amount);
            errors.error(row.span, message);
        }
        Some(row) => {
            let row = &equations.rows[row];
            if !failure.amount.is_finite() {
                errors.error(row.span, messages::no_value_at_start(&row.of));
                return;
            }
            let path = row.joint.map(|joint| loop_of(mechanism, equations, joint)).unwrap_or_default();
            // Of two points that should meet, the distance, not the larger component.
            let components =
                equations.rows.iter().filter(|own| own.joint.is_some() && own.joint == row.joint);
            let components: Vec<_> = components
                .filter(|own| matches!(own.what, "x" | "y" | "z"))
                .map(|own| own.jet.value)
                .collect();
            let apart = if matches!(row.what, "x" | "y" | "z") {
                point.set_q(&failure.q);
                point.evaluate(&Ancestry::of(equations, components.iter().copied()));
                components.iter().map(|node| point.get(*node).powi(2)).sum::<f64>().sqrt()
            } else {
                failure.amount
            };
            let start = overgiven(mechanism, point, &failure.q);
            errors.error(row.span, messages::cannot_close(&row.of, row.what, &path, apart, start));
        }
        None => {
            let span = mechanism.start.iter().find(|start| start.exact).map(|start| start.span);
            let span = span.unwrap_or(mechanism.name.span);
            if !failure.amount.is_finite() {
                errors.error(span, messages::no_value_at_start("start"));
                return;
            }
            let drivers =
                equations.driven.iter().zip(&mechanism.drivers).map(|((condition, node), driver)| {
                    point.evaluate(&Ancestry::of(equations, [*node]));
                    (driver.name.text.clone(), condition.of.clone(), point.get(*node))
                });
            let drivers = drivers.collect();
            let start = overgiven(mechanism, point, &failure.q);
            errors.error(span, messages::cannot_meet_start(failure.amount, drivers, start));
        }
    }
}

/// Whether `start` gives more coordinates than the joints leave free; drivers give theirs.
fn overgiven(mechanism: &Mechanism, point: &mut Point, q: &[f64]) -> Option<messages::Overgiven> {
    let equations = point.equations;
    let given = equations.conditions.iter().zip(&equations.start_targets);
    let given = given.filter(|(_, target)| target.position.is_some());
    let given: Vec<_> = given.map(|(condition, _)| condition.clone()).collect();
    let undriven: Vec<usize> = (0..equations.rows.len() - mechanism.drivers.len()).collect();
    let freedoms = equations.symbols.v.len() - rank(point, &undriven, q).rank;
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
