//! From which positions assembly is tried, and what to say when it fails or when a second assembly fits as well.

use super::mobility::{independent, rank};
use super::point::{Ancestry, Point};
use super::{Attempt, Problem, initial, messages};
use crate::diagnostics::Diagnostics;
use crate::equations::{Attachment, Equations, Linear, Rotation};
use crate::model::{Frame, JointId, JointKind, Mechanism, Quantity, Rotor, Space};
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// Turns by multiples of the golden angle never repeat.
pub(super) const GOLDEN: f64 = 2.399963229728653;
/// Guesses met this well leave nothing to compare.
const MET: f64 = 1e-18;

/// Bounded work: tries from `start` as written, then from a few positions spread over the circle.
pub fn closed(
    mechanism: &Mechanism,
    problem: &Problem,
    point: &mut Point,
    errors: &mut Diagnostics,
) -> Option<Attempt> {
    let equations = point.equations;
    let stated = Stated::of(equations, point);
    let attempts = (240 / (equations.symbols.v.len() + equations.rows.len()).max(1)).clamp(3, 8);
    let mut solutions: Vec<Attempt> = Vec::new();
    let mut failure: Option<Attempt> = None;
    let mut flipped = None;
    for number in 0..attempts {
        let q = stated.initial(mechanism, equations, point, number);
        let attempt = problem.solve(point, q);
        if !attempt.closed {
            if failure.as_ref().is_none_or(|worst| attempt.residual < worst.residual) {
                failure = Some(attempt);
            }
            continue;
        }
        if let Some(row) = problem.flipped(point, &attempt.q) {
            flipped = Some(row);
            continue;
        }
        let met = attempt.distance < MET && problem.has_guesses();
        // Coordinates that nothing decides come out anywhere; the guesses then tell one assembly from another.
        let decided = problem.is_decided(point, &attempt.q);
        let known = |known: &Attempt| {
            same(equations, &known.q, &attempt.q) || (!decided && alike(known.distance, attempt.distance))
        };
        if !solutions.iter().any(known) {
            solutions.push(attempt);
        }
        // Nothing can be nearer to guesses than one that meets them; with nothing to find there is nothing to compare.
        if met || problem.is_free(point, &solutions[0].q) {
            break;
        }
    }
    solutions.sort_by(|a, b| a.distance.total_cmp(&b.distance));
    match (solutions.as_slice(), failure, flipped) {
        ([only], ..) => Some(only.clone()),
        ([nearest, next, ..], ..) => {
            if problem.has_guesses() && nearest.distance <= 0.25 * next.distance {
                return Some(nearest.clone());
            }
            report_second(mechanism, problem, point, nearest, next, errors);
            None
        }
        ([], _, Some(row)) => {
            let row = &equations.rows[row];
            errors.error(row.span, messages::flipped(&row.of));
            None
        }
        ([], failure, None) => {
            report_open(mechanism, point, failure, errors);
            None
        }
    }
}

/// Whole turns of the multi-turn angles. Those that `start` or a driver states come nearest to what is stated, the others
/// to zero, if the couplings allow it; then the rows that count turns are solved once more.
pub fn settle_turns(problem: &Problem, point: &mut Point, assembled: Attempt) -> Attempt {
    let equations = point.equations;
    if equations.layout.angles.is_empty() {
        return assembled;
    }
    let mut stated = assembled.q.clone();
    let mut all = assembled.q.clone();
    for (a, angle) in equations.layout.angles.iter().enumerate() {
        let at = equations.layout.turns(a);
        match stated_angle(equations, point, angle.rotor) {
            Some(value) => {
                stated[at] = ((value - assembled.q[at + 1]) / TAU).round();
                all[at] = stated[at];
            }
            None => all[at] = 0.0,
        }
    }
    [all, stated, assembled.q.clone()]
        .into_iter()
        .map(|q| problem.solve(point, q))
        .find(|attempt| attempt.closed && same(equations, &attempt.q, &assembled.q))
        .unwrap_or(assembled)
}

/// What `start` or a driver states of a rotor's angle.
fn stated_angle(equations: &Equations, point: &mut Point, rotor: Rotor) -> Option<f64> {
    let is = |quantity: &Quantity| match (quantity, rotor) {
        (Quantity::BodyAngle(body), Rotor::Body(own)) => *body == own,
        (Quantity::JointAngle(joint, which), Rotor::Joint(own, angle)) => *joint == own && *which == angle,
        _ => false,
    };
    let exact = equations.conditions.iter().zip(&equations.start_targets);
    let exact = exact.filter_map(|(condition, start)| Some((condition, start.position?)));
    let guessed = equations.guesses.iter().map(|(condition, node)| (condition, *node));
    let driven = equations.driven.iter().map(|(condition, node)| (condition, *node));
    let (_, node) = driven.chain(exact).chain(guessed).find(|(condition, _)| is(&condition.quantity))?;
    point.evaluate(&Ancestry::of(equations, [node]));
    Some(point.get(node))
}

/// Whether two positions are one, whatever turns their angles have counted.
fn same(equations: &Equations, a: &[f64], b: &[f64]) -> bool {
    let layout = &equations.layout;
    let plain = layout.quaternion(0);
    let quaternions = (0..layout.quaternions.len()).map(|index| layout.quaternion(index));
    // A quaternion and its negative are one orientation.
    let same_quaternion = |at: usize| {
        let product: f64 = (at..at + 4).map(|k| a[k] * b[k]).sum();
        let sign = if product < 0.0 { -1.0 } else { 1.0 };
        (at..at + 4).all(|k| alike(a[k], sign * b[k]))
    };
    a.iter().zip(b).take(plain).all(|(a, b)| alike(*a, *b)) && quaternions.into_iter().all(same_quaternion)
}

fn alike(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-6 * (1.0 + a.abs())
}

/// Values that `start` and the drivers give to coordinates.
pub(super) struct Stated {
    pub angles: BTreeMap<(JointId, usize), f64>,
    bodies: BTreeMap<usize, f64>,
    pub travels: BTreeMap<(JointId, usize), f64>,
    pub centers: BTreeMap<(usize, usize), f64>,
}

impl Stated {
    fn of(equations: &Equations, point: &mut Point) -> Self {
        let mut stated = Stated {
            angles: BTreeMap::new(),
            bodies: BTreeMap::new(),
            travels: BTreeMap::new(),
            centers: BTreeMap::new(),
        };
        let exact = equations.conditions.iter().zip(&equations.start_targets);
        let exact = exact.filter_map(|(condition, start)| Some((condition, start.position?)));
        let guessed = equations.guesses.iter().chain(&equations.driven);
        let guessed = guessed.map(|(condition, node)| (condition, *node));
        for (condition, node) in guessed.chain(exact) {
            point.evaluate(&Ancestry::of(equations, [node]));
            let value = point.get(node);
            match &condition.quantity {
                Quantity::JointAngle(joint, which) => {
                    stated.angles.insert((*joint, *which), value);
                }
                Quantity::BodyAngle(body) => {
                    stated.bodies.insert(body.0, value);
                }
                Quantity::JointTravel(joint, which) => {
                    stated.travels.insert((*joint, *which), value);
                }
                Quantity::Position(place, axis) => {
                    if let Frame::Body(body) = place.frame {
                        stated.centers.insert((body.0, *axis), value);
                    }
                }
                _ => {}
            }
        }
        stated
    }

    /// Tree coordinates for attempt `number`: stated values where there are any, else zero at first and later turned
    /// by the golden angle, a different multiple for each body.
    fn initial(
        &self,
        mechanism: &Mechanism,
        equations: &Equations,
        point: &mut Point,
        number: usize,
    ) -> Vec<f64> {
        if mechanism.space == Space::Spatial {
            return initial::in_space(self, mechanism, point, number);
        }
        let layout = &equations.layout;
        let mut q = vec![0.0; layout.positions()];
        let mut angles = vec![0.0; mechanism.bodies.len()];
        let mut free = 0;
        for Attachment { body, joint } in &equations.tree.attachments {
            let rotation = layout.rotations.iter().position(|own| *own == Rotation::Body(*body));
            let parent = match joint {
                Some((_, Frame::Body(parent))) => angles[parent.0],
                _ => 0.0,
            };
            let relative = joint.and_then(|(id, _)| {
                let second = mechanism.joints[id.0].second.frame == Frame::Body(*body);
                self.angles.get(&(id, 0)).map(|angle| if second { *angle } else { -angle })
            });
            let stated = relative.map(|relative| parent + relative).or(self.bodies.get(&body.0).copied());
            let closing = || self.through_another_joint(mechanism, equations, *body, &angles);
            let angle = match (rotation, stated.or_else(closing)) {
                (None, _) => parent,
                (Some(_), Some(angle)) => angle,
                (Some(_), None) => {
                    free += 1;
                    GOLDEN * (number * free) as f64
                }
            };
            // What is only guessed is varied too, so that other assemblies are found.
            let angle = if number > 0
                && stated.is_some()
                && rotation.is_some()
                && !self.is_exact(equations, *joint, body.0)
            {
                free += 1;
                angle + GOLDEN * (number * free) as f64
            } else {
                angle
            };
            angles[body.0] = angle;
            if let Some(r) = rotation {
                q[layout.pair(r)] = libm::cos(angle);
                q[layout.pair(r) + 1] = libm::sin(angle);
            }
        }
        for (index, linear) in layout.linear.iter().enumerate() {
            let stated = match linear {
                Linear::Center(body, axis) => self.centers.get(&(body.0, *axis)),
                Linear::Travel(joint, which) => self.travels.get(&(*joint, *which)),
            };
            q[index] = stated.copied().unwrap_or(0.0);
        }
        for (a, angle) in layout.angles.iter().enumerate() {
            let orientation = |frame: Frame| match frame {
                Frame::Ground => 0.0,
                Frame::Body(body) => angles[body.0],
            };
            let value = match angle.rotor {
                Rotor::Body(body) => angles[body.0],
                Rotor::Joint(joint, _) => {
                    let joint = &mechanism.joints[joint.0];
                    orientation(joint.second.frame) - orientation(joint.first.frame)
                }
            };
            let turns = (value / TAU).round();
            q[layout.turns(a)] = turns;
            q[layout.turns(a) + 1] = value - turns * TAU;
        }
        q
    }

    /// Orientation of a body from the stated angle of a joint that the tree does not use.
    fn through_another_joint(
        &self,
        mechanism: &Mechanism,
        equations: &Equations,
        body: crate::model::BodyId,
        angles: &[f64],
    ) -> Option<f64> {
        let carrying = equations.tree.carrying(mechanism);
        let own = Frame::Body(body);
        self.angles.iter().filter(|((id, _), _)| !carrying[id.0]).find_map(|((id, _), angle)| {
            let joint = &mechanism.joints[id.0];
            let orientation = |frame: Frame| match frame {
                Frame::Ground => 0.0,
                Frame::Body(body) => angles[body.0],
            };
            if joint.second.frame == own {
                Some(orientation(joint.first.frame) + angle)
            } else if joint.first.frame == own {
                Some(orientation(joint.second.frame) - angle)
            } else {
                None
            }
        })
    }

    /// Whether `start` states an angle of a joint, and not only guesses it.
    pub fn is_exact_angle(equations: &Equations, joint: JointId, which: usize) -> bool {
        let exact = equations.conditions.iter().zip(&equations.start_targets);
        exact.filter(|(_, start)| start.position.is_some()).any(|(condition, _)| {
            matches!(condition.quantity, Quantity::JointAngle(own, angle) if own == joint && angle == which)
        })
    }

    fn is_exact(&self, equations: &Equations, joint: Option<(JointId, Frame)>, body: usize) -> bool {
        let exact = equations.conditions.iter().zip(&equations.start_targets);
        exact.filter(|(_, start)| start.position.is_some()).any(|(condition, _)| match &condition.quantity {
            Quantity::JointAngle(own, _) => joint.is_some_and(|(joint, _)| joint == *own),
            Quantity::BodyAngle(own) => own.0 == body,
            _ => false,
        })
    }
}

/// Two assemblies: names the coordinate in which they differ most.
fn report_second(
    mechanism: &Mechanism,
    problem: &Problem,
    point: &mut Point,
    nearest: &Attempt,
    next: &Attempt,
    errors: &mut Diagnostics,
) {
    if mechanism.space == Space::Spatial {
        report_second_in_space(mechanism, problem, nearest, next, errors);
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
fn report_second_in_space(
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
fn report_open(mechanism: &Mechanism, point: &mut Point, failure: Option<Attempt>, errors: &mut Diagnostics) {
    let equations = point.equations;
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
