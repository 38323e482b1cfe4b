//! The numeric rules: the mechanism is put together at expansion, by interpreting its graph.
//!
//! AFTER THIS POINT a consistent start state is known, its degrees of freedom are those expected, the constraint rows
//! are independent there, and M is positive definite on the velocities they admit.
//!
//! Assembly works in tree coordinates, which are few and cannot come apart along the tree; the state is carried over
//! to absolute coordinates where those are emitted.

mod active;
mod along;
mod attempts;
mod blame;
mod charts;
mod descent;
mod drivers;
mod freedoms;
mod gap;
mod geometry;
mod initial;
pub mod loose;
mod mobility;
mod pairs;
mod partition;
pub(crate) mod pins;
mod plays;
mod point;
mod position;
mod quaternion;
mod rates;
mod redundancy;
mod refusals;
mod residuals;
mod scales;
mod search;
mod statics;
mod teeth;
mod world;

pub use blame::Blame;
pub use freedoms::Mobility;
pub use gap::Gap;
pub use mobility::{full_squares, rank};
pub use partition::partitions;
pub use plays::taken_up;
pub use point::{Ancestry, Point, live, retract};
pub use scales::row_scales;
pub use statics::deflected;

use super::{curves, messages};
use crate::diagnostics::Diagnostics;
use crate::equations::{Ball, Condition, Conditions, Equations, Linear, Omitted, Rotation, RowOfJoint};
use crate::model::{BodyId, Coordinate, Deforms, JointId, Mechanism, Rotor, Space};
use crate::solve::Massless;
use crate::symbolic::Node;
use along::Walk;
use freedoms::Assembled;
use position::{Attempt, Problem};

/// The result of assembly.
#[derive(Clone, Debug)]
pub struct Assembly {
    pub q: Vec<f64>,
    pub v: Vec<f64>,
    /// Phases of couplings that take them from the start.
    pub phases: Vec<f64>,
    /// Degrees of freedom, counted and true.
    pub mobility: Mobility,
    /// Coordinates that fix the position together with the constraints.
    pub independent: Vec<Coordinate>,
    /// Rows that repeat what others fix, by joint and direction; as many are left out at each position.
    pub dropped: Vec<RowOfJoint>,
    /// The rows that are left out, and where.
    pub omitted: Omitted,
    /// Joints whose reactions are not unique, because of that.
    pub shared: Vec<JointId>,
    /// Positions along the motion that the joints admit.
    pub along: Vec<Vec<f64>>,
    /// How many of them are near the start; of redundant mechanisms.
    pub near: usize,
}

/// Puts the mechanism together, in a position if that is known; reports why if it cannot.
pub fn assemble(
    mechanism: &Mechanism,
    equations: &Equations,
    stand: Option<Vec<f64>>,
    errors: &mut Diagnostics,
) -> Option<Assembly> {
    let candidates = candidates(mechanism, equations);
    let mut point = Point::at_defaults(mechanism, equations, &[]);

    let problem = problem(mechanism, equations, &mut point);
    let assembled = match stand {
        Some(q) => problem.settled(&mut point, q),
        None => attempts::closed(mechanism, &problem, &mut point, errors)?,
    };
    let assembled = attempts::settle_turns(&problem, &mut point, assembled);
    let assembled = teeth::meet(mechanism, &problem, &mut point, assembled, errors)?;
    let q = assembled.q;
    curves::numbers(mechanism, equations, &q, errors)?;
    let phases = phases(mechanism, equations, &mut point, &q);
    point.set(&equations.symbols.phases, &phases);

    let independent = choose_independent(mechanism, &mut point, &candidates, &q, errors);
    let at = Assembled { mechanism, problem: &problem, q: &q, phases: &phases, independent: &independent };
    let (mobility, redundancy) = freedoms::judge(&at, &mut point, errors)?;
    let v = rates::rates(mechanism, equations, &mut point, &q, errors)?;
    let redundancy::Redundancy { dropped, omitted, shared, mut along, near } = redundancy;
    if along.is_empty() {
        let joints = problem.joints_only(mechanism);
        along = along::positions(&mut point, &joints, &q, Walk::far(equations));
    }
    Some(Assembly { q, v, phases, mobility, independent, dropped, omitted, shared, along, near })
}

/// The rows of absolute coordinates that repeat others, found at the positions along the motion; an error where no choice of
/// them holds there.
pub fn drop_redundant(
    mechanism: &Mechanism,
    absolute: &Equations,
    assembly: Assembly,
    errors: &mut Diagnostics,
) -> Assembly {
    let mut point = Point::at_defaults(mechanism, absolute, &assembly.phases);
    let found = redundancy::of_absolute(mechanism, &mut point, &assembly.along, assembly.near);
    match found {
        Ok(found) => {
            Assembly { dropped: found.dropped, omitted: found.omitted, shared: found.shared, ..assembly }
        }
        Err(joint) => {
            redundancy::report_no_choice(mechanism, joint, errors);
            assembly
        }
    }
}

/// Which velocities carry no mass, at the assembled position; an error if the constraints admit one of them.
pub fn massless(
    mechanism: &Mechanism,
    equations: &Equations,
    assembly: &Assembly,
    errors: &mut Diagnostics,
) -> Massless {
    rates::massless(mechanism, equations, assembly, errors)
}

/// Masses and inertias that depend on parameters, and whether their default is positive and must stay so.
pub fn positive_masses(mechanism: &Mechanism, equations: &Equations) -> Vec<(String, bool)> {
    let mut point = Point::at_defaults(mechanism, equations, &[]);
    point.evaluate(&Ancestry::of(equations, equations.masses.iter().map(|(_, node)| *node)));
    equations.masses.iter().map(|(what, node)| (what.clone(), point.get(*node) > 0.0)).collect()
}

/// The assembled state in another set of coordinates of the same mechanism.
pub fn carry_over(mechanism: &Mechanism, from: &Equations, assembly: &Assembly, to: &Equations) -> Assembly {
    let mut point = Point::at_defaults(mechanism, from, &assembly.phases);
    point.set_q(&assembly.q);
    point.set_v(&assembly.v);
    let ancestry = Ancestry::of(from, from.motions.iter().flat_map(|motion| motion.flat()));
    let (q, v) = carry_state(from, to, &mut point, &ancestry, &assembly.q, &assembly.v);
    let rest = vec![0.0; assembly.v.len()];
    let carry = |place: &Vec<f64>| carry_state(from, to, &mut point, &ancestry, place, &rest).0;
    let along: Vec<Vec<f64>> = assembly.along.iter().map(carry).collect();
    Assembly { q, v, along, ..assembly.clone() }
}

/// One state in other coordinates.
fn carry_state(
    from: &Equations,
    to: &Equations,
    point: &mut Point,
    ancestry: &Ancestry,
    q: &[f64],
    v: &[f64],
) -> (Vec<f64>, Vec<f64>) {
    point.set_q(q);
    point.set_v(v);
    point.evaluate(ancestry);
    let values = |nodes: &[Node]| -> Vec<f64> { nodes.iter().map(|node| point.get(*node)).collect() };
    let motion = |body: BodyId| &from.motions[body.0];
    let layout = &to.layout;
    let (mut moved, mut rates) = (vec![0.0; layout.positions()], vec![0.0; layout.velocities()]);
    for (index, linear) in layout.linear.iter().enumerate() {
        if let Linear::Center(body, axis) = linear {
            moved[index] = values(&motion(*body).position)[*axis];
            rates[index] = values(&motion(*body).velocity)[*axis];
        }
        if let Linear::Mode(..) = linear
            && let Some(own) = from.layout.linear.iter().position(|own| own == linear)
        {
            (moved[index], rates[index]) = (q[own], v[own]);
        }
    }
    for (r, rotation) in layout.rotations.iter().enumerate() {
        let Rotation::Body(body) = rotation else { continue };
        moved[layout.pair(r)..layout.pair(r) + 2].copy_from_slice(&values(&motion(*body).orientation));
        rates[layout.linear.len() + r] = values(&motion(*body).rate)[0];
    }
    for (b, ball) in layout.quaternions.iter().enumerate() {
        let Ball::Body(body) = ball else { continue };
        let axes = values(&motion(*body).orientation);
        let axes = [0, 1, 2].map(|i| [0, 1, 2].map(|j| axes[3 * i + j]));
        let at = layout.quaternion(b);
        moved[at..at + 4].copy_from_slice(&quaternion::of_matrix(axes));
        rates[layout.omega(b)..layout.omega(b) + 3].copy_from_slice(&values(&motion(*body).rate));
    }
    for a in 0..layout.angles.len() {
        let (at, own) = (layout.turns(a), from.layout.turns(a));
        moved[at..at + 2].copy_from_slice(&q[own..own + 2]);
    }
    (moved, rates)
}

fn problem<'a>(mechanism: &Mechanism, equations: &'a Equations, point: &mut Point) -> Problem<'a> {
    let open = equations.open_rows(mechanism);
    let rows = (0..equations.rows.len()).filter(|row| !open.contains(row)).collect();
    let mut conditions = Vec::new();
    let mut guesses = Vec::new();
    for (condition, target) in equations.conditions.with_start() {
        if let Some(node) = target.position {
            point.evaluate(&Ancestry::of(equations, [node]));
            conditions.push((condition.clone(), point.get(node)));
        }
    }
    for (guess, node) in &equations.guesses {
        point.evaluate(&Ancestry::of(equations, [*node]));
        guesses.push((guess.clone(), point.get(*node)));
    }
    Problem::new(equations, rows, conditions, guesses)
}

/// Residuals of open couplings at the assembled position, their phases being zero there.
fn phases(mechanism: &Mechanism, equations: &Equations, point: &mut Point, q: &[f64]) -> Vec<f64> {
    let rows: Vec<_> = equations.open_rows(mechanism).iter().map(|row| &equations.rows[*row]).collect();
    point.set_q(q);
    point.evaluate(&Ancestry::of(equations, rows.iter().map(|row| row.jet.value)));
    let of_rows: Vec<f64> = rows.iter().map(|row| point.get(row.jet.value)).collect();
    of_rows.into_iter().chain(teeth::phases(mechanism, equations, point, q)).collect()
}

/// Coordinates that may serve as independent ones: as written, else `start`'s, else those of the tree.
fn candidates(mechanism: &Mechanism, equations: &Equations) -> Vec<Condition> {
    let mut coordinates: Vec<Coordinate> = Vec::new();
    coordinates.extend(mechanism.options.independent.iter().map(|(coordinate, _)| coordinate.clone()));
    if coordinates.is_empty() {
        let exact = mechanism.start.iter().filter(|start| start.exact);
        let stated = exact.map(|start| &start.coordinate).filter(|coordinate| coordinate.has_value());
        coordinates.extend(stated.cloned());
        for attachment in &equations.tree.attachments {
            coordinates.extend(match attachment.joint {
                None if mechanism.space == Space::Spatial => Vec::new(),
                None => vec![Coordinate::Angle(Rotor::Body(attachment.body))],
                Some((joint, _)) => of_joint(mechanism, joint),
            });
        }
    }
    let mut found: Vec<Condition> = Vec::new();
    for coordinate in &coordinates {
        let (condition, _) = equations.condition(mechanism, coordinate);
        let is_known = found.iter().any(|known| known.coordinate == *coordinate);
        if !condition.jet.columns.is_empty() && !is_known {
            found.push(condition);
        }
    }
    // The centres of free bodies complete the set; they are coordinates themselves.
    for (index, linear) in equations.layout.linear.clone().iter().enumerate() {
        if let (Linear::Center(body, axis), true) = (linear, mechanism.options.independent.is_empty()) {
            let place = center_place(mechanism, *body);
            let coordinate = Coordinate::Position(Box::new(place), *axis);
            let (condition, _) = equations.condition(mechanism, &coordinate);
            debug_assert!(condition.jet.columns.contains_key(&index));
            found.push(condition);
        }
    }
    found
}

/// The coordinates of a joint in space.
fn of_joint(mechanism: &Mechanism, joint: JointId) -> Vec<Coordinate> {
    let names = mechanism.joints[joint.0].form;
    let travels = (0..names.travels.len()).map(|which| Coordinate::Travel(joint, which));
    travels
        .chain((0..names.angles.len()).map(|which| Coordinate::Angle(Rotor::Joint(joint, which))))
        .collect()
}

/// Quantities that complete the `independent` conditions to one for each degree of freedom: coordinates first, then, for
/// what turns on balls and has none, rates. In the coordinates of `equations`.
pub fn completion(
    mechanism: &Mechanism,
    equations: &Equations,
    conditions: &Conditions,
    assembly: &Assembly,
    independent: &[usize],
) -> Vec<Coordinate> {
    let mut given: Vec<Condition> = independent.iter().map(|index| conditions.rows[*index].clone()).collect();
    let mut free = mechanism.clone();
    free.options.independent.clear();
    given.extend(candidates(&free, equations));
    let carried = |joint: JointId| {
        let mut attachments = equations.tree.attachments.iter();
        attachments.find(|attachment| attachment.joint.as_ref().is_some_and(|(own, _)| *own == joint))
    };
    let turning = equations.layout.quaternions.iter().filter_map(|ball| match ball {
        Ball::Body(body) => Some(*body),
        Ball::Joint(joint) => carried(*joint).map(|attachment| attachment.body),
    });
    for body in turning.collect::<Vec<_>>() {
        for axis in 0..3 {
            given.push(equations.condition(mechanism, &Coordinate::Turn(body, axis)).0);
        }
    }
    let mut point = Point::at_defaults(mechanism, equations, &assembly.phases);
    let chosen = mobility::independent(&mut point, &given, &assembly.q);
    let further = chosen.into_iter().filter(|at| *at >= independent.len());
    further.map(|at| given[at].coordinate.clone()).collect()
}

fn center_place(mechanism: &Mechanism, body: BodyId) -> crate::model::Place {
    let definition = &mechanism.bodies[body.0];
    crate::model::Place {
        frame: crate::model::Frame::Body(body),
        at: definition.center.clone(),
        axes: crate::model::Axes::Parallel,
        of_mean: definition.deforms.as_ref().is_some_and(Deforms::has_mean_frame),
        text: format!(
            "{}.{}",
            definition.name.text,
            if definition.form.bends() { "origin" } else { "center" }
        ),
        span: definition.name.span,
    }
}

fn choose_independent(
    mechanism: &Mechanism,
    point: &mut Point,
    candidates: &[Condition],
    q: &[f64],
    errors: &mut Diagnostics,
) -> Vec<Coordinate> {
    let chosen = mobility::independent(point, candidates, q);
    let names: Vec<&str> = chosen.iter().map(|at| candidates[*at].of.as_str()).collect();
    for (at, (_, span)) in mechanism.options.independent.iter().enumerate() {
        if !chosen.contains(&at) && at < candidates.len() {
            errors.error(*span, messages::not_independent(&candidates[at].of, &names));
        }
    }
    chosen.into_iter().map(|at| candidates[at].coordinate.clone()).collect()
}
