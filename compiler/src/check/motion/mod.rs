//! The range of motion of a planar mechanism with one degree of freedom: it is moved at expansion, by interpreting its
//! graph, from the start until it returns there.
//!
//! Work is bounded ([`MOST_STEPS`]). Drivers are left out, parameters have their defaults, and places that move with
//! time stand where they are at time zero. Only what `expect` or a tool asks about is followed.

mod efforts;
mod expected;
mod linkage;
mod messages;
mod path;
mod reach;
mod reflected;
mod sweep;

pub use efforts::{Least, Moment, efforts};
pub use expected::check;
pub use linkage::{Linkage, TimeRatio, Transmission};
pub use reflected::{Reflected, reflected};

use super::assemble::{Assembly, Point, pins, rank};
use crate::equations::{Condition, Equations};
use crate::model::{Coordinate, JointId, Mechanism, Rotor, Space};
use path::{Path, Place};
use std::f64::consts::TAU;

/// Steps in either direction before the sweep gives up, of mechanisms with up to `SMALL` velocities and rows; of larger ones
/// so many fewer that the work is the same.
pub const MOST_STEPS: usize = 2000;
const SMALL: usize = 40;

/// A motion from the start until it returns there.
#[derive(Clone, Debug)]
pub struct Motion {
    pub end: End,
    /// Ranges of the coordinates asked about, and last that of the one by which positions are told, unless it is among
    /// them.
    pub ranges: Vec<Range>,
    /// Where coordinates turn back, in the order met: dead centres of a motor that acts there.
    pub limits: Vec<Limit>,
    /// Where the constraints lose rank, in the order met: change points, through which the motion was followed
    /// straight on.
    pub singular: Vec<Singular>,
    /// Index in `ranges` of the coordinate by which positions are told.
    pub reference: usize,
    pub steps: usize,
}

/// How following the motion ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// At the start again.
    Closed,
    /// A travel has no limit.
    Unlimited,
    /// Not at the start when the steps were used up.
    Bounded,
    /// At a position that the motion cannot be followed through: ranges are those up to there.
    Stuck,
}

/// The range that a coordinate goes through: rad or m, angles over several turns and counted from the value that `start` gives.
#[derive(Clone, Debug)]
pub struct Range {
    /// `crank_pin.angle`.
    pub of: String,
    pub coordinate: Coordinate,
    pub angular: bool,
    pub from: f64,
    pub to: f64,
    /// An angle that takes every value.
    pub turns: bool,
}

/// A coordinate turns back.
#[derive(Clone, Debug)]
pub struct Limit {
    /// Index in [`Motion::ranges`].
    pub of: usize,
    pub value: f64,
    /// The value of the reference coordinate.
    pub reference: f64,
    /// Those of all coordinates, in the order of [`Motion::ranges`].
    pub values: Vec<f64>,
    /// Links that lie in one line there, which is why.
    pub in_line: Vec<String>,
}

/// The constraints lose rank.
#[derive(Clone, Debug)]
pub struct Singular {
    /// The value of the reference coordinate.
    pub reference: f64,
    /// Joints and constraints whose rows repeat others there.
    pub lost: Vec<String>,
    pub in_line: Vec<String>,
}

/// Why there is no range of motion to find.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unswept {
    /// Not there yet.
    InSpace,
    /// Not there yet, or nothing moves.
    Freedoms(usize),
    /// No direction of motion was found at the start.
    NoDirection,
}

/// All angles and travels of joints.
pub fn of_joints(mechanism: &Mechanism) -> Vec<Coordinate> {
    let mut found = Vec::new();
    for (index, joint) in mechanism.joints.iter().enumerate() {
        let names = joint.form;
        let angles = if joint.has_particle(mechanism) { 0 } else { names.angles.len() };
        found.extend((0..angles).map(|which| Coordinate::Angle(Rotor::Joint(JointId(index), which))));
        found.extend((0..names.travels.len()).map(|which| Coordinate::Travel(JointId(index), which)));
    }
    found
}

/// Follows the motion and watches these coordinates.
pub fn sweep(
    mechanism: &Mechanism,
    equations: &Equations,
    assembly: &Assembly,
    coordinates: &[Coordinate],
) -> Result<Motion, Unswept> {
    follow(mechanism, equations, assembly, coordinates).map(|followed| followed.motion)
}

/// Follows the motion of all joints, and measures it as that of a linkage.
pub fn of_linkage(
    mechanism: &Mechanism,
    equations: &Equations,
    assembly: &Assembly,
) -> Result<(Motion, Linkage), Unswept> {
    let mut followed = follow(mechanism, equations, assembly, &of_joints(mechanism))?;
    let mut point = Point::at_defaults(mechanism, equations, &assembly.phases);
    let linkage = linkage::linkage(mechanism, &mut point, &mut followed);
    Ok((followed.motion, linkage))
}

/// A motion, and what it was followed with.
struct Followed<'a> {
    motion: Motion,
    path: Path<'a>,
    places: Vec<Place>,
    /// What the coordinates count beyond their values at a place.
    stated: Vec<f64>,
}

fn follow<'a>(
    mechanism: &Mechanism,
    equations: &'a Equations,
    assembly: &Assembly,
    coordinates: &[Coordinate],
) -> Result<Followed<'a>, Unswept> {
    if mechanism.space == Space::Spatial {
        return Err(Unswept::InSpace);
    }
    if assembly.mobility.generic != 1 {
        return Err(Unswept::Freedoms(assembly.mobility.generic));
    }
    let (watched, reference) = watched(mechanism, equations, assembly, coordinates);
    let q = assembly.q.as_slice();
    let length = pins::longest_link(&pins::pins(
        mechanism,
        &mut Point::at_defaults(mechanism, equations, &assembly.phases),
        q,
    ));
    let mut path = Path::new(mechanism, equations, &assembly.phases, watched.clone(), length, q);
    let start = start(&mut path, equations, q, reference).ok_or(Unswept::NoDirection)?;
    let stated = stated(mechanism, &watched, &start);
    let size = equations.symbols.v.len() + equations.rows.len();
    let most = MOST_STEPS * SMALL / size.max(SMALL);
    let (swept, end) = sweep::sweep(&mut path, start, length, most);
    let range = |((condition, (from, to)), turns): ((&Condition, &(f64, f64)), &f64)| Range {
        of: condition.of.clone(),
        coordinate: condition.coordinate.clone(),
        angular: condition.angular,
        from: from + turns,
        to: to + turns,
        turns: condition.angular && to - from > TAU - 1e-6,
    };
    let ranges = watched.iter().zip(&swept.ranges).zip(&stated).map(range).collect();
    let mut point = Point::at_defaults(mechanism, equations, &assembly.phases);
    let limits = swept.limits.into_iter().map(|(limit, place)| Limit {
        value: limit.value + stated[limit.of],
        reference: place.values[reference] + stated[reference],
        values: place.values.iter().zip(&stated).map(|(value, turns)| value + turns).collect(),
        in_line: in_line(mechanism, &mut point, &place.q, &watched[limit.of].coordinate),
        ..limit
    });
    let limits = limits.collect();
    let mut singular: Vec<Singular> = Vec::new();
    for (values, q) in &swept.singular {
        let lost = rank(&mut point, path.rows(), q).dependent;
        let mut lost: Vec<String> = lost.iter().map(|row| equations.rows[*row].of.clone()).collect();
        lost.dedup();
        let in_line = pins::in_line(mechanism, &pins::pins(mechanism, &mut point, q), None);
        singular.push(Singular { reference: values[reference] + stated[reference], lost, in_line });
    }
    let motion = Motion { end, ranges, limits, singular, reference, steps: swept.steps };
    Ok(Followed { motion, path, places: swept.places, stated })
}

/// The rows of the coordinates, and the index of the one by which positions are told: the independent one.
fn watched(
    mechanism: &Mechanism,
    equations: &Equations,
    assembly: &Assembly,
    coordinates: &[Coordinate],
) -> (Vec<Condition>, usize) {
    let mut watched: Vec<Condition> = Vec::new();
    let mut reference = 0;
    for (index, coordinate) in coordinates.iter().chain(assembly.independent.first()).enumerate() {
        let (condition, _) = equations.condition(mechanism, coordinate);
        let known = watched.iter().position(|known| known.coordinate == condition.coordinate);
        reference = known.unwrap_or(watched.len());
        if known.is_none() || index < coordinates.len() {
            watched.push(condition);
        }
    }
    (watched, reference)
}

/// The start, and t so that the reference coordinate grows.
fn start(path: &mut Path, equations: &Equations, q: &[f64], reference: usize) -> Option<Place> {
    let n = equations.symbols.v.len();
    // Any direction; a second one where the first is across the motion.
    let wish = |number: usize| (0..n).map(|k| libm::sin((number * (3 * k + 2)) as f64)).collect::<Vec<f64>>();
    let mut place = (1..=4).find_map(|number| path.at(q.to_vec(), &wish(number)))?;
    if place.rates.get(reference).is_some_and(|rate| *rate < 0.0) {
        place.tangent.iter_mut().chain(&mut place.rates).for_each(|x| *x = -*x);
    }
    Some(place)
}

/// Whole turns (rad) by which `start` counts further than the place does.
fn stated(mechanism: &Mechanism, watched: &[Condition], place: &Place) -> Vec<f64> {
    let defaults = mechanism.defaults();
    let turns = |(condition, value): (&Condition, &f64)| {
        let stated = mechanism
            .start
            .iter()
            .filter(|start| condition.angular && !start.rate && start.coordinate == condition.coordinate);
        let mut stated = stated.filter_map(|start| crate::model::fold::evaluate(&start.value, &defaults));
        stated.next().map_or(0.0, |stated| TAU * ((stated - value) / TAU).round())
    };
    watched.iter().zip(&place.values).map(turns).collect()
}

/// The links in one line where a coordinate turns back, but for those that its own joint brings there.
fn in_line(mechanism: &Mechanism, point: &mut Point, q: &[f64], of: &Coordinate) -> Vec<String> {
    let own = match of {
        Coordinate::Angle(Rotor::Joint(joint, _)) | Coordinate::Travel(joint, _) => Some(*joint),
        Coordinate::Angle(Rotor::Body(_))
        | Coordinate::Position(..)
        | Coordinate::Distance(..)
        | Coordinate::Way(..)
        | Coordinate::Square(..)
        | Coordinate::Direction(..)
        | Coordinate::Turn(..)
        | Coordinate::Mode(..)
        | Coordinate::Closing(..)
        | Coordinate::Deviation(..) => None,
    };
    pins::in_line(mechanism, &pins::pins(mechanism, point, q), own)
}
