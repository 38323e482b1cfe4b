//! The search for a position where the quick attempts find none: deterministic, bounded, from near the guesses to anywhere.
//!
//! From each of a sequence of positions the residuals' sum of squares is brought down, without regard to guesses, which
//! would hold it up where they cannot be met. A position that closes is then moved towards the guesses with all loops kept
//! closed. The descent is `descent.rs`, the positions to begin with are those of `initial`.

use super::attempts::Solutions;
use super::descent::{Descent, HOPELESS, Role, TO_THE_END};
use super::initial::{Stated, Variation};
use super::point::Point;
use super::position::{Attempt, Problem};
use crate::model::Mechanism;

/// Positions that a search begins with, at most.
const BEGINNINGS: usize = 48;
/// Beginnings after the first that closed: what is found from one may not be the nearest to the guesses.
const FURTHER: usize = 8;
/// Steps of descent times unknowns: some 0.1 s unoptimised for a four-bar, a second for hundreds of bodies.
const WORK: usize = 24_000;
const LEAST_STEPS: usize = 150;

pub struct Search<'a, 'p> {
    mechanism: &'a Mechanism,
    problem: &'a Problem<'p>,
    stated: &'a Stated,
    /// Rows of constraints, then conditions, then guesses.
    descent: Descent<'p>,
    roles: Vec<Role>,
    guesses: usize,
    length: f64,
}

impl<'a, 'p> Search<'a, 'p> {
    pub fn new(
        mechanism: &'a Mechanism,
        problem: &'a Problem<'p>,
        point: &mut Point,
        stated: &'a Stated,
    ) -> Self {
        let q = stated.initial(mechanism, point, Variation::Few(0));
        let (residuals, length) = problem.residuals(mechanism, point, &q);
        let held = residuals.len() - problem.guesses().len();
        let unknowns = point.equations.symbols.v.len() + residuals.len();
        let steps = (WORK / unknowns).max(LEAST_STEPS);
        let role = |at: usize| if at < held { Role::Soft } else { Role::Absent };
        Search {
            mechanism,
            problem,
            stated,
            roles: (0..residuals.len()).map(role).collect(),
            guesses: residuals.len() - held,
            descent: Descent::new(problem.equations(), residuals, steps),
            length,
        }
    }

    /// Adds the positions found to `solutions`; gives the number of beginnings.
    pub fn closed(&mut self, point: &mut Point, solutions: &mut Solutions) -> usize {
        let mut last = BEGINNINGS;
        let mut number = 0;
        while number < last && self.descent.steps > 0 {
            let q = self.beginning(point, number, false);
            number += 1;
            let roles = self.roles.clone();
            let Some(rest) = self.descent.descend(point, q, &roles, HOPELESS) else { continue };
            let attempt = self.problem.settled(point, rest.q);
            if !attempt.closed {
                continue;
            }
            let attempt = self.nearer(point, attempt);
            let enough = solutions.push(self.problem, point, attempt);
            if enough {
                break;
            }
            last = last.min(number + FURTHER);
        }
        number
    }

    /// The position nearest to the guesses that can be reached from a closed one.
    pub fn nearer(&mut self, point: &mut Point, closed: Attempt) -> Attempt {
        if self.guesses == 0 {
            return closed;
        }
        let held = self.roles.len() - self.guesses;
        let role = |at: usize| if at < held { Role::Hard } else { Role::Soft };
        let roles: Vec<Role> = (0..self.roles.len()).map(role).collect();
        let nearer = self.descent.descend(point, closed.q.clone(), &roles, TO_THE_END);
        let nearer = nearer.map(|rest| self.problem.settled(point, rest.q));
        let nearest = nearer.filter(|nearer| nearer.closed).unwrap_or(closed);
        Attempt { settled: true, ..nearest }
    }

    fn beginning(&self, point: &mut Point, number: usize, stated: bool) -> Vec<f64> {
        let dimensions = point.equations.symbols.v.len();
        let variation = Variation::Many { number, dimensions, length: self.length, stated };
        self.stated.initial(self.mechanism, point, variation)
    }
}
