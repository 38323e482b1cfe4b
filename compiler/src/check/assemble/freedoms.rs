//! Degrees of freedom: as counted by Grübler and Kutzbach, at the start, and near it; and why they differ.
//!
//! A rank that is lost wherever the mechanism stands is redundancy, and adds to the count. One that is lost at the start
//! alone is a singular position (a change point, a dead centre of a driver). One that is lost at the start without a way to
//! leave it belongs to a structure that moves only infinitesimally.

use super::loose::Loose;
use super::mobility::{self, Rank};
use super::point::{Ancestry, Point};
use super::position::Problem;
use super::redundancy::{self, Finding, Redundancy};
use super::{drivers, geometry, loose, messages, pins};
use crate::diagnostics::{Diagnostic, Diagnostics, Note, Region, Severity};
use crate::equations::conditions;
use crate::forms::RowForm;
use crate::model::{Coordinate, Deforms, Mechanism, Redundant};
use crate::numbers::coordinate;
use std::fmt;

/// How a mechanism can move, drivers removed.
#[derive(Clone, Debug)]
pub struct Mobility {
    /// Freedoms of all bodies apart from each other.
    pub apart: usize,
    pub bodies: usize,
    /// Those that hold.
    pub joints: usize,
    /// Those that yield, and have no equations.
    pub yielding: Vec<String>,
    /// Gears, racks and equations.
    pub couplings: usize,
    /// Equations of all joints and couplings.
    pub equations: usize,
    /// At the start.
    pub at_start: usize,
    /// Near the start: the degrees of freedom.
    pub generic: usize,
    /// Rows that repeat what others fix all along the motion, by joint or coupling and direction.
    pub redundant: Vec<(String, &'static RowForm)>,
    /// The reason why they repeat, where it is known: "the axes of a, b and c are parallel".
    pub reasons: Vec<String>,
}

impl Mobility {
    /// The number of Grübler and Kutzbach, which knows nothing of where the joints are.
    pub fn counted(&self) -> isize {
        self.apart as isize - self.equations as isize
    }
}

/// In sentences.
impl fmt::Display for Mobility {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&messages::mobility(self))
    }
}

/// The mechanism put together.
pub struct Assembled<'a> {
    pub mechanism: &'a Mechanism,
    pub problem: &'a Problem<'a>,
    pub q: &'a [f64],
    pub phases: &'a [f64],
    pub independent: &'a [Coordinate],
}

/// Degrees of freedom against `expect`, and independence of the rows.
pub fn judge(at: &Assembled, point: &mut Point, errors: &mut Diagnostics) -> Option<(Mobility, Redundancy)> {
    let equations = point.equations;
    let undriven: Vec<usize> = (0..equations.rows.len() - at.mechanism.drivers.len()).collect();
    let rank = mobility::rank(point, &undriven, at.q);
    let finding = match rank.dependent.is_empty() {
        true => Finding::default(),
        false => redundancy::find(at.mechanism, point, at.problem, at.q),
    };
    let mobility = mobility(at, point, &rank, &finding);
    expected(at, point, &mobility, errors);
    if finding.coupled || finding.shaky {
        report_dependent(at, point, &rank.dependent, finding.shaky, errors);
        return None;
    }
    if !finding.repeated.is_empty() && at.mechanism.options.redundant == Redundant::Refuse {
        report_redundant(at, point, &mobility, &finding.repeated, errors);
        return None;
    }
    if finding.without_choice.is_some() {
        redundancy::report_no_choice(at.mechanism, finding.without_choice, errors);
        return None;
    }
    let left: Vec<usize> = undriven.into_iter().filter(|row| !finding.repeated.contains(row)).collect();
    let lost = match finding.repeated.is_empty() {
        true => rank.dependent,
        false => mobility::rank(point, &left, at.q).dependent,
    };
    if !lost.is_empty() {
        report_singular(at, point, &left, &lost, &finding.beyond, errors);
    } else if !at.mechanism.drivers.is_empty() {
        drivers::judge(at, point, left, errors);
    }
    errors.is_empty().then_some((mobility, finding.redundancy))
}

fn mobility(at: &Assembled, point: &mut Point, rank: &Rank, finding: &Finding) -> Mobility {
    let (mechanism, equations) = (at.mechanism, point.equations);
    let (velocities, rows) = (equations.symbols.v.len(), equations.rows.len() - mechanism.drivers.len());
    let apart: usize = mechanism
        .bodies
        .iter()
        .map(|body| body.form.freedoms(mechanism.space) + body.deforms.as_ref().map_or(0, Deforms::modes))
        .sum();
    let mut repeated = finding.repeated.clone();
    repeated.sort_unstable();
    let names = repeated.iter().map(|row| (equations.rows[*row].of.clone(), equations.rows[*row].form));
    let yielding = mechanism.joints.iter().filter(|joint| !joint.holds());
    let at_start = velocities - rank.rank;
    let generic = match () {
        _ if rank.dependent.is_empty() || finding.coupled => at_start,
        _ if finding.shaky => 0,
        _ => velocities + repeated.len() - rows,
    };
    Mobility {
        apart,
        bodies: mechanism.bodies.len(),
        joints: mechanism.joints.iter().filter(|joint| joint.holds()).count(),
        yielding: yielding.map(|joint| joint.name.text.clone()).collect(),
        couplings: mechanism.constraints.len(),
        // Joints of the tree have no rows any more.
        equations: apart + rows - velocities,
        at_start,
        generic,
        redundant: names.collect(),
        reasons: geometry::reasons(mechanism, point, at.q, &repeated),
    }
}

/// The number of `expect`.
fn expected(at: &Assembled, point: &Point, mobility: &Mobility, errors: &mut Diagnostics) {
    let Some((expected, span)) = at.mechanism.expect.degrees_of_freedom else { return };
    if expected == mobility.generic {
        return;
    }
    let loose = match mobility.generic > expected {
        true => loose::find(at.mechanism, point.equations, at.q, at.phases),
        false => Vec::new(),
    };
    let independent: Vec<String> =
        at.independent.iter().map(|quantity| conditions::name(at.mechanism, quantity)).collect();
    let message =
        messages::wrong_freedoms(expected, mobility, &loose, &independent, at.mechanism.drivers.len());
    // A body that moves alone is shown where it should be held; the number where it stands.
    let mut places = loose.iter().map(|loose| (place(at.mechanism, loose), messages::loose(loose)));
    let Some((region, _)) = places.next() else { return errors.error(span, message) };
    let mut notes: Vec<Note> = places.map(|(region, message)| Note { region, message }).collect();
    notes.push(Note { region: span, message: messages::freedoms_expected(expected, mobility.generic) });
    errors.push(Diagnostic { severity: Severity::Error, region, message, notes });
}

/// The joint that a body hangs on; of what several joints hold, or none, the body.
fn place(mechanism: &Mechanism, loose: &Loose) -> Region {
    let name = match loose.joints.as_slice() {
        [only] => Some(only),
        _ => loose.bodies.first(),
    };
    name.unwrap_or(&mechanism.name).span
}

/// One message for each joint, not for each of its rows.
fn report_redundant(
    at: &Assembled,
    point: &Point,
    mobility: &Mobility,
    repeated: &[usize],
    errors: &mut Diagnostics,
) {
    let rows = &point.equations.rows;
    let mut repeated = repeated.to_vec();
    repeated.sort_unstable();
    for of_one in repeated.chunk_by(|a, b| rows[*a].origin == rows[*b].origin) {
        let row = &rows[of_one[0]];
        let repeated: Vec<&RowForm> = of_one.iter().map(|row| rows[*row].form).collect();
        let Some(joint) = row.joint() else { continue };
        let form = at.mechanism.joints[joint.0].form;
        let whole = repeated.len() == rows.iter().filter(|own| own.joint() == Some(joint)).count();
        let repeated = messages::Repeated { joint: &row.of, form, rows: &repeated, whole };
        errors.error(row.span, messages::redundant(&repeated, mobility));
    }
}

/// Rank that is lost wherever the mechanism can be: in a structure that shakes, or by couplings.
fn report_dependent(
    at: &Assembled,
    point: &mut Point,
    dependent: &[usize],
    shaky: bool,
    errors: &mut Diagnostics,
) {
    let equations = point.equations;
    let mut rows = dependent.iter().map(|row| &equations.rows[*row]);
    if shaky {
        let Some(row) = rows.next() else { return };
        let in_line = pins::in_line(at.mechanism, &pins::pins(at.mechanism, point, at.q), None);
        errors.error(row.span, messages::shaky(&row.of, &in_line));
    } else if let Some(row) = rows.find(|row| row.joint().is_none()).or(equations.rows.last()) {
        errors.error(row.span, messages::repeated_coupling(&row.of));
    }
}

/// The start is a singular position; where there is one nearby that is not, it is named.
fn report_singular(
    at: &Assembled,
    point: &mut Point,
    rows: &[usize],
    lost: &[usize],
    beyond: &[Vec<f64>],
    errors: &mut Diagnostics,
) {
    let equations = point.equations;
    let in_line = pins::in_line(at.mechanism, &pins::pins(at.mechanism, point, at.q), None);
    let mut of: Vec<String> = lost.iter().map(|row| equations.rows[*row].of.clone()).collect();
    of.dedup();
    let elsewhere = elsewhere(at, point, beyond);
    let stated = at.mechanism.start.iter().find(|start| !start.rate);
    let span = stated.map_or(equations.rows[lost[0]].span, |start| start.span);
    let rank = (rows.len() - lost.len(), rows.len());
    errors.error(span, messages::singular_start(rank, &of, &in_line, elsewhere));
}

/// A line for `start` that puts its first coordinate at another position, `crank_pin.angle [rad] = 0.09;`: of those
/// known the one where the coordinate has moved most.
fn elsewhere(at: &Assembled, point: &mut Point, beyond: &[Vec<f64>]) -> Option<String> {
    let equations = point.equations;
    let stated = equations.conditions.with_start();
    let stated = stated.filter(|(_, target)| target.position.is_some()).map(|(condition, _)| condition);
    let guessed = equations.guesses.iter().map(|(condition, _)| condition);
    let condition = stated.chain(guessed).find(|condition| condition.coordinate.has_value())?;
    let ancestry = Ancestry::of(equations, [condition.jet.value]);
    let mut value = |q: &[f64]| {
        point.set_q(q);
        point.evaluate(&ancestry);
        point.get(condition.jet.value)
    };
    let here = value(at.q);
    let values = beyond.iter().map(|q| value(q));
    let furthest = values.max_by(|a, b| (a - here).abs().total_cmp(&(b - here).abs()))?;
    let unit = if condition.angular { "rad" } else { "m" };
    let exact = at
        .mechanism
        .start
        .iter()
        .any(|start| start.exact && !start.rate && start.coordinate == condition.coordinate);
    let sign = if exact { '=' } else { '~' };
    Some(format!("{} [{unit}] {sign} {};", condition.of, coordinate(furthest, 3)))
}
