//! Why nothing was found that closes: which joint stays open and by how much at the least, or which driver or condition of
//! `start` the loops do not allow.
//!
//! Joints are asked first without drivers and `start`: each alone, then together with those before it. The gap of a joint is
//! the least distance of its places, whatever its axes do, with what else closes kept closed; if the places can meet, the least
//! angle by which its axes are off while they do. Neither depends on how metres and radians are weighed. The least of
//! descents from many positions (`descent.rs`) is taken.

use super::descent::{Descent, HOPELESS, Rest, Role};
use super::initial::{Stated, Variation};
use super::point::Point;
use super::position::Problem;
use crate::equations::Origin;
use crate::forms::row::Measures;
use crate::model::Mechanism;

/// The cause why a mechanism does not close.
pub enum Fault {
    /// A joint or coupling, wherever the mechanism stands.
    Loop(Open),
    /// A driver: the least by which its quantity misses its law.
    Driver { driver: usize, miss: f64 },
    /// Conditions of `start`: the nearest position that closes, and what stays open where all of them hold.
    Start { nearest: Vec<f64>, open: Option<Open> },
    /// The bounded work did not suffice to tell.
    Unknown,
}

/// The gap that stays open.
pub struct Open {
    /// Indices into `Equations::rows`, all of one joint or coupling.
    pub rows: Vec<usize>,
    pub gap: Gap,
    /// Where the gap is least.
    pub q: Vec<f64>,
    /// Whether joints before it were kept closed.
    pub with_others: bool,
}

/// The least that stays open.
#[derive(Clone, Copy, Debug)]
pub enum Gap {
    /// Between two places, m.
    Apart(f64),
    /// Between two directions, rad.
    Turned(f64),
    /// The residual of an equation between other quantities.
    Off(f64),
}

/// Positions that descents begin with, at most.
const BEGINNINGS: usize = 48;
/// Steps times unknowns of one question.
const WORK: usize = 12_000;
const LEAST_STEPS: usize = 120;
/// Sums of squares of what closes.
const CLOSED: f64 = 1e-20;
/// A step that takes less than this part of a sum away ends the descent.
const ACCURACY: f64 = 1e-6;
/// A least gap is believed where so many descents of so many have ended at it, and none below.
const AGREEING: usize = 6;
const OF: usize = 24;

pub struct Gaps<'a, 'p> {
    mechanism: &'a Mechanism,
    problem: &'a Problem<'p>,
    stated: &'a Stated,
    descent: Descent<'p>,
    length: f64,
    /// Steps for one question.
    steps: usize,
    residuals: usize,
}

impl<'a, 'p> Gaps<'a, 'p> {
    pub fn new(
        mechanism: &'a Mechanism,
        problem: &'a Problem<'p>,
        point: &mut Point,
        stated: &'a Stated,
    ) -> Self {
        let q = stated.initial(mechanism, point, Variation::Few(0));
        let (residuals, length) = problem.residuals(mechanism, point, &q);
        let count = residuals.len();
        let steps = (WORK / (point.equations.symbols.v.len() + count)).max(LEAST_STEPS);
        let descent = Descent::new(problem.equations(), residuals, steps);
        Gaps { mechanism, problem, stated, descent, length, steps, residuals: count }
    }

    /// A position in which all joints and couplings close, whatever drivers and `start` say.
    pub fn closed(&mut self, point: &mut Point) -> Option<Vec<f64>> {
        let joints = self.groups().concat();
        self.closing(point, &joints)
    }

    /// The cause, given where the joints close, if they do.
    pub fn fault(&mut self, point: &mut Point, closed: Option<&Vec<f64>>) -> Fault {
        let groups = self.groups();
        if closed.is_none() {
            let open = self.open(point, &groups, &[]);
            return open.map_or(Fault::Unknown, Fault::Loop);
        }
        let drivers = self.drivers();
        let conditions = self.conditions();
        let mut held = groups.concat();
        held.extend(&conditions);
        if !drivers.is_empty() && self.closing(point, &held).is_some() {
            let least = self.least(point, &drivers, &held);
            let Some(least) = least else { return Fault::Unknown };
            let misses = self.descent.amounts(point, &least.q);
            let worst = drivers.iter().max_by(|a, b| misses[**a].abs().total_cmp(&misses[**b].abs()));
            return worst.map_or(Fault::Unknown, |worst| Fault::Driver {
                driver: worst - drivers[0],
                miss: misses[*worst].abs(),
            });
        }
        if conditions.is_empty() && drivers.is_empty() {
            return Fault::Unknown;
        }
        let mut joints = groups.concat();
        joints.extend(&drivers);
        let Some(nearest) = self.least(point, &conditions, &joints) else { return Fault::Unknown };
        let mut given = conditions;
        given.extend(&drivers);
        let open = self.open(point, &groups, &given);
        Fault::Start { nearest: nearest.q, open }
    }

    /// The first joint that does not close while `held` and those before it do; alone, if it does not even then.
    fn open(&mut self, point: &mut Point, groups: &[Vec<usize>], held: &[usize]) -> Option<Open> {
        // One alone is known not to close.
        let mut found = (groups.len() == 1).then(|| (0, held.to_vec()));
        for (at, group) in groups.iter().enumerate() {
            let alone = [held, group].concat();
            if found.is_none() && self.closing(point, &alone).is_none() {
                found = Some((at, held.to_vec()));
            }
        }
        let mut before = held.to_vec();
        for (at, group) in groups.iter().enumerate() {
            let together = [before.as_slice(), group].concat();
            // The first was asked alone.
            if found.is_none() && at > 0 && self.closing(point, &together).is_none() {
                found = Some((at, before.clone()));
            }
            before = together;
        }
        let (at, hard) = found?;
        let (gap, q) = self.gap(point, &groups[at], &hard)?;
        let rows = groups[at].iter().map(|row| self.problem.rows()[*row]).collect();
        Some(Open { rows, gap, q, with_others: hard.len() > held.len() })
    }

    fn gap(&mut self, point: &mut Point, group: &[usize], hard: &[usize]) -> Option<(Gap, Vec<f64>)> {
        let rows = &self.problem.equations().rows;
        let measures = |at: &usize| rows[self.problem.rows()[*at]].form.measures;
        let is_length = |at: &usize| matches!(measures(at), Measures::Length | Measures::Squares);
        let is_direction = |at: &usize| measures(at) == Measures::Direction;
        let (places, others): (Vec<usize>, Vec<usize>) = group.iter().partition(|at| is_length(at));
        let directions = others.iter().all(is_direction);
        let mut hard = hard.to_vec();
        if !places.is_empty() {
            let least = self.least(point, &places, &hard)?;
            if least.cost > CLOSED {
                return Some((Gap::Apart((2.0 * least.cost).sqrt() * self.length), least.q));
            }
            hard.extend(&places);
        }
        let least = self.least(point, &others, &hard)?;
        let amounts = self.descent.amounts(point, &least.q);
        let amount = others.iter().map(|at| amounts[*at].powi(2)).sum::<f64>().sqrt();
        let gap = if directions { Gap::Turned(libm::asin(amount.min(1.0))) } else { Gap::Off(amount) };
        Some((gap, least.q))
    }

    /// A position where all of these vanish.
    fn closing(&mut self, point: &mut Point, soft: &[usize]) -> Option<Vec<f64>> {
        let least = self.best(point, soft, &[], false)?;
        (least.cost < CLOSED).then_some(least.q)
    }

    /// The least sum of squares of some residuals while others vanish.
    fn least(&mut self, point: &mut Point, soft: &[usize], hard: &[usize]) -> Option<Rest> {
        self.best(point, soft, hard, true)
    }

    /// The best of many descents; only one to zero will do if it is not `least` that is asked for.
    fn best(&mut self, point: &mut Point, soft: &[usize], hard: &[usize], least: bool) -> Option<Rest> {
        let accuracy = if least { ACCURACY } else { HOPELESS };
        let mut roles = vec![Role::Absent; self.residuals];
        soft.iter().for_each(|at| roles[*at] = Role::Soft);
        hard.iter().for_each(|at| roles[*at] = Role::Hard);
        self.descent.steps = self.steps;
        let mut best: Option<Rest> = None;
        let mut agreeing = 0;
        for number in 0..BEGINNINGS {
            let dimensions = point.equations.symbols.v.len();
            let variation = Variation::Many { number, dimensions, length: self.length, stated: true };
            let q = self.stated.initial(self.mechanism, point, variation);
            let Some(rest) = self.descent.descend(point, q, &roles, accuracy) else { continue };
            let known = best.as_ref().map_or(f64::INFINITY, |best| best.cost);
            agreeing = match () {
                _ if rest.cost < known * (1.0 - 1e-6) => 1,
                _ if rest.cost < known * (1.0 + 1e-6) => agreeing + 1,
                _ => agreeing,
            };
            if rest.cost < known {
                best = Some(rest);
            }
            let closed = best.as_ref().is_some_and(|best| best.cost < CLOSED);
            let believed = least && agreeing >= AGREEING && number >= OF;
            if closed || believed || self.descent.steps == 0 {
                break;
            }
        }
        best
    }

    /// Rows of joints and couplings, those of one together.
    fn groups(&self) -> Vec<Vec<usize>> {
        let rows = &self.problem.equations().rows;
        let own: Vec<usize> = (0..self.problem.rows().len()).filter(|at| !self.is_driver(*at)).collect();
        let of = |at: &usize| rows[self.problem.rows()[*at]].origin;
        own.chunk_by(|a, b| of(a) == of(b)).map(<[usize]>::to_vec).collect()
    }

    fn is_driver(&self, at: usize) -> bool {
        let row = &self.problem.equations().rows[self.problem.rows()[at]];
        matches!(row.origin, Origin::Driver(_))
    }

    fn drivers(&self) -> Vec<usize> {
        (0..self.problem.rows().len()).filter(|at| self.is_driver(*at)).collect()
    }

    fn conditions(&self) -> Vec<usize> {
        let first = self.problem.rows().len();
        (first..self.residuals - self.problem.guesses().len()).collect()
    }
}
