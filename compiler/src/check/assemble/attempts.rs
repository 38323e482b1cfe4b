//! How often assembly is tried, and which of the positions found is the one. A few quick attempts close most mechanisms; what
//! they do not is searched for.

use super::initial::{Stated, Variation};
use super::point::{Ancestry, Point};
use super::search::Search;
use super::{Attempt, Problem, messages, refusals};
use crate::diagnostics::Diagnostics;
use crate::equations::Equations;
use crate::model::{Coordinate, Mechanism, Rotor};
use std::f64::consts::TAU;

/// Guesses met this well leave nothing to compare.
pub(super) const MET: f64 = 1e-18;

/// Half as far: the sum of squares is a quarter.
const CLEARLY: f64 = 0.25;
/// An assembly that is nearer by less than this part counts as equally near.
const NEARER: f64 = 1e-6;

/// The positions that were found.
#[derive(Default)]
pub struct Solutions {
    /// All different.
    found: Vec<Attempt>,
    /// A row on the wrong side of the best that was found on it.
    flipped: Option<usize>,
}

impl Solutions {
    /// Keeps it unless it is known; whether nothing can be nearer to the guesses, or there is nothing to compare.
    pub fn push(&mut self, problem: &Problem, point: &mut Point, attempt: Attempt) -> bool {
        if let Some(row) = problem.flipped(point, &attempt.q) {
            self.flipped = Some(row);
            return false;
        }
        let met = attempt.distance < MET && problem.has_guesses();
        // Coordinates that nothing decides come out anywhere; the guesses then tell one assembly from another.
        let decided = problem.is_decided(point, &attempt.q);
        let equations = point.equations;
        let known = |known: &Attempt| {
            same(equations, &known.q, &attempt.q) || (!decided && alike(known.distance, attempt.distance))
        };
        if !self.found.iter().any(known) {
            self.found.push(attempt);
        }
        met || problem.is_free(point, &self.found[0].q)
    }
}

impl Solutions {
    /// Whether the nearest could be nearer, or another that is not clearly further off.
    fn may_be_nearer(&self) -> bool {
        let Some(nearest) = self.found.iter().map(|own| own.distance).min_by(f64::total_cmp) else {
            return false;
        };
        let near = |own: &&Attempt| own.distance == nearest || CLEARLY * own.distance < nearest;
        self.found.iter().filter(near).any(Attempt::is_on_its_way)
    }
}

/// Bounded work: tries from `start` as written, then from a few positions spread over the circle; then a search.
pub fn closed(
    mechanism: &Mechanism,
    problem: &Problem,
    point: &mut Point,
    errors: &mut Diagnostics,
) -> Option<Attempt> {
    let equations = point.equations;
    let stated = Stated::of(equations, point);
    let attempts = (240 / (equations.symbols.v.len() + equations.rows.len()).max(1)).clamp(3, 8);
    let mut solutions = Solutions::default();
    let (mut led_on, mut enough) = (false, false);
    for number in 0..attempts {
        let q = stated.initial(mechanism, point, Variation::Few(number));
        let attempt = problem.solve(point, q);
        led_on |= number == 0 && attempt.closed;
        enough = attempt.closed && solutions.push(problem, point, attempt);
        if enough {
            break;
        }
    }
    let mut searched = 0;
    // Where the way from the guesses themselves led to nothing, what others found may not be the nearest.
    let lost = !enough && (!led_on || solutions.found.is_empty());
    if lost || solutions.may_be_nearer() {
        let mut search = Search::new(mechanism, problem, point, &stated);
        if lost {
            searched = search.closed(point, &mut solutions);
        }
        let Solutions { found, flipped } = std::mem::take(&mut solutions);
        solutions.flipped = flipped;
        for attempt in found {
            let attempt = if attempt.is_on_its_way() { search.nearer(point, attempt) } else { attempt };
            solutions.push(problem, point, attempt);
        }
    }
    let Solutions { mut found, flipped } = solutions;
    found.sort_by(|a, b| a.distance.total_cmp(&b.distance));
    match (found.as_slice(), flipped) {
        ([only], _) => Some(only.clone()),
        ([nearest, next, ..], _) => {
            // Guesses as many as freedoms, or fewer, choose where along its motion the mechanism stands; more of them have to tell one
            // assembly from another, and clearly.
            let choose = problem.guesses().len() <= problem.freedoms(point, &nearest.q);
            let clearly = if choose { 1.0 - NEARER } else { CLEARLY };
            if problem.has_guesses() && nearest.distance <= clearly * next.distance {
                return Some(nearest.clone());
            }
            refusals::second(mechanism, problem, point, nearest, next, errors);
            None
        }
        ([], Some(row)) => {
            let row = &equations.rows[row];
            errors.error(row.span, messages::flipped(&row.of));
            None
        }
        ([], None) => {
            refusals::open(mechanism, problem, &stated, point, attempts + searched, errors);
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

/// The angle that `start` or a driver states for a rotor.
fn stated_angle(equations: &Equations, point: &mut Point, rotor: Rotor) -> Option<f64> {
    let angle = Coordinate::Angle(rotor);
    let exact = equations.conditions.with_start();
    let exact = exact.filter_map(|(condition, start)| Some((condition, start.position?)));
    let guessed = equations.guesses.iter().map(|(condition, node)| (condition, *node));
    let driven = equations.driven.iter().map(|(condition, node)| (condition, *node));
    let (_, node) =
        driven.chain(exact).chain(guessed).find(|(condition, _)| condition.coordinate == angle)?;
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
