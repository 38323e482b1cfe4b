//! Forces and torques that `expect` bounds, along the motion that drivers fix: one instant after another from time zero, until the mechanism is
//! where it began and as fast as there.
//!
//! ```text
//! Φ(q, t) = 0,   D q̇ = ν,   D q̈ = γ,   Dᵀ λ = Q − M q̈
//! ```
//! σ times as fast the same positions are passed with σ q̇ and σ² q̈: the σ at which an effort first reaches its bound is found beside it. Parameters
//! have their defaults, and inputs are zero.

use super::messages::{self, Unfollowed};
use super::path::Path;
use crate::check::assemble::{Ancestry, Assembly, Point, pins, retract};
use crate::diagnostics::Diagnostics;
use crate::equations::Equations;
use crate::model::{EffortBound, Mechanism, Side};
use crate::solve::table::{DEPENDENT, Numeric, Table};

/// How far an instant is from the next: rad, or lengths of the mechanism.
const STEP: f64 = 0.0175;
/// s, where nothing moves; so many of these in a row, and nothing will.
const PAUSE: f64 = 1e-2;
const PAUSES: usize = 200;
/// Instants before the walk gives up, of mechanisms with up to `SMALL` velocities and rows.
const MOST: usize = 4000;
const SMALL: usize = 40;
const CORRECTIONS: usize = 10;
/// A correction this short is the last: the next would be of its square.
const SETTLED: f64 = 1e-9;
/// Sections of an interval, by the golden ratio: 1e-12 of its width is left, which is rounding also where a table has a corner.
const SECTIONS: usize = 58;

/// Where an effort is nearest to its bound, or furthest beyond.
#[derive(Clone, Debug)]
pub struct Least {
    /// N or N m.
    pub value: f64,
    pub at: Moment,
    /// How many times as fast it first reaches the bound, and where; nothing if it does at no speed.
    pub fails: Option<(f64, Moment)>,
}

/// A position of the first driver's quantity: rad or m, and its rate.
#[derive(Clone, Copy, Debug)]
pub struct Moment {
    pub position: f64,
    pub rate: f64,
}

/// How a walk ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Walked {
    /// At the start again, or at rest.
    Whole,
    Bounded(usize),
    /// At this time there was no next position.
    Stuck(f64),
}

/// An error for each effort that reaches its bound.
pub fn check(mechanism: &Mechanism, equations: &Equations, assembly: &Assembly, errors: &mut Diagnostics) {
    let bounds = &mechanism.expect.motion.efforts;
    let Some(first) = bounds.first() else { return };
    let (found, walked) = match efforts(mechanism, equations, assembly) {
        Ok(found) => found,
        Err(unfollowed) => return errors.error(first.span, messages::unfollowed(&first.text, unfollowed)),
    };
    for (bound, least) in bounds.iter().zip(&found) {
        let margin = margin(bound, least.value);
        let message = match walked {
            _ if margin.is_nan() || margin <= 0.0 => messages::beyond_bound(mechanism, bound, least),
            Walked::Whole => continue,
            Walked::Bounded(instants) => messages::walk_without_end(&bound.text, instants),
            Walked::Stuck(time) => messages::walk_that_stops(&bound.text, time),
        };
        errors.error(bound.span, message);
    }
}

/// The bounded efforts in their order.
pub fn efforts(
    mechanism: &Mechanism,
    equations: &Equations,
    assembly: &Assembly,
) -> Result<(Vec<Least>, Walked), Unfollowed> {
    if let Some(left) =
        assembly.mobility.generic.checked_sub(mechanism.drivers.len()).filter(|left| *left > 0)
    {
        return Err(Unfollowed::Freedoms(left));
    }
    if !equations.friction.is_none() {
        return Err(Unfollowed::Friction);
    }
    let mut walk = Walk::new(mechanism, equations, assembly);
    let (instants, walked) = walk.whole(&assembly.q).ok_or(Unfollowed::NoStart)?;
    let bounds = mechanism.expect.motion.efforts.iter().enumerate();
    Ok((bounds.map(|(which, bound)| walk.least(&instants, which, bound)).collect(), walked))
}

/// How far an effort is from its bound, on the side that is meant.
fn margin(bound: &EffortBound, value: f64) -> f64 {
    match bound.side {
        Side::Above => value - bound.bound,
        Side::Below => bound.bound - value,
    }
}

#[derive(Clone, Debug)]
struct Instant {
    time: f64,
    q: Vec<f64>,
    v: Vec<f64>,
    a: Vec<f64>,
}

struct Walk<'a> {
    equations: &'a Equations,
    point: Point<'a>,
    /// Distances between positions.
    path: Path<'a>,
    rows: Vec<usize>,
    table: Table,
    geometry: Ancestry,
    gamma: Ancestry,
    forces: Ancestry,
    expected: Ancestry,
    most: usize,
}

impl<'a> Walk<'a> {
    fn new(mechanism: &Mechanism, equations: &'a Equations, assembly: &Assembly) -> Self {
        let mut point = Point::at_defaults(mechanism, equations, &assembly.phases);
        let length = pins::longest_link(&pins::pins(mechanism, &mut point, &assembly.q));
        let path = Path::new(mechanism, equations, &assembly.phases, Vec::new(), length, &assembly.q);
        let rows = 0..equations.rows.len();
        let rows: Vec<usize> = rows.filter(|row| !equations.idle.contains(row)).collect();
        let n = equations.symbols.v.len();
        let entries = rows.iter().enumerate().flat_map(|(at, row)| {
            equations.rows[*row].jet.columns.keys().map(move |column| (n + at, *column))
        });
        let table = Table::new(n, rows.len(), entries.collect::<Vec<_>>());
        let driven = equations.driven.iter().map(|(condition, _)| &condition.jet);
        let jets = rows.iter().map(|row| &equations.rows[*row].jet).chain(driven);
        let of_driven = equations.driven.iter().map(|(_, law)| *law);
        let nodes = jets.flat_map(|jet| jet.columns.values().copied().chain([jet.value, jet.drift]));
        let geometry = Ancestry::of(equations, nodes.chain(of_driven).collect::<Vec<_>>());
        let gamma = Ancestry::of(equations, equations.gamma.iter().copied());
        let forces = equations.mass.values().chain(&equations.forces);
        let forces = Ancestry::of(equations, forces.copied());
        let expected = Ancestry::of(equations, equations.expected.iter().copied());
        let most = MOST * SMALL / (n + rows.len()).max(SMALL);
        Walk { equations, point, path, rows, table, geometry, gamma, forces, expected, most }
    }

    /// All instants; `None` if there is no first.
    fn whole(&mut self, q: &[f64]) -> Option<(Vec<Instant>, Walked)> {
        let mut instants = vec![self.instant(0.0, q.to_vec())?];
        let (mut travelled, mut pauses) = (0.0, 0);
        while instants.len() < self.most {
            let here = &instants[instants.len() - 1];
            let (speed, acceleration) = (self.path.length(&here.v), self.path.length(&here.a));
            let rest = if pauses > 0 || speed == 0.0 { PAUSE } else { f64::INFINITY };
            let mut ahead = (STEP / speed).min((2.0 * STEP / acceleration).sqrt()).min(rest);
            let next = loop {
                if let Some(next) = self.instant(here.time + ahead, ahead_of(self.equations, here, ahead))
                    && self.apart(here, &next) < 2.0 * STEP
                {
                    break next;
                }
                ahead *= 0.5;
                if ahead * (speed + acceleration * ahead) < 1e-6 * STEP {
                    let walked = Walked::Stuck(here.time);
                    return Some((instants, walked));
                }
            };
            let moved = self.apart(here, &next);
            travelled += moved;
            pauses = if moved < 1e-9 * STEP { pauses + 1 } else { 0 };
            let start = &instants[0];
            let faster: Vec<f64> = next.v.iter().zip(&start.v).map(|(a, b)| a - b).collect();
            let most = self.path.length(&start.a).max(self.path.length(&next.a));
            let change = 2.0 * ahead * most + 1e-6 * self.path.length(&start.v);
            let back = travelled > 10.0 * STEP
                && self.apart(start, &next) <= moved
                && self.path.length(&faster) <= change;
            instants.push(next);
            if back || pauses >= PAUSES {
                return Some((instants, Walked::Whole));
            }
        }
        Some((instants, Walked::Bounded(self.most)))
    }

    fn apart(&self, from: &Instant, to: &Instant) -> f64 {
        self.path.length(&self.path.difference(&from.q, &to.q))
    }

    /// The matrix [W Dᵀ; D 0] where the point stands.
    fn entries(&self) -> Vec<(usize, usize, f64)> {
        let n = self.equations.symbols.v.len();
        let mut entries: Vec<_> = self.path.weights().enumerate().map(|(k, weight)| (k, k, weight)).collect();
        for (at, row) in self.rows.iter().enumerate() {
            let columns = self.equations.rows[*row].jet.columns.iter();
            entries.extend(columns.map(|(k, column)| (n + at, *k, self.point.get(*column))));
        }
        entries
    }

    fn stand(&mut self, time: f64, q: &[f64]) {
        self.point.set(&[self.equations.symbols.time], &[time]);
        self.point.set_q(q);
        self.point.evaluate(&self.geometry);
    }

    /// What the drivers make of this time, near `q`.
    fn instant(&mut self, time: f64, mut q: Vec<f64>) -> Option<Instant> {
        let (equations, n) = (self.equations, self.equations.symbols.v.len());
        let mut settled = false;
        for _ in 0..CORRECTIONS {
            self.stand(time, &q);
            let rows = self.rows.iter().map(|row| -self.point.get(equations.rows[*row].jet.value));
            let right: Vec<f64> = vec![0.0; n].into_iter().chain(rows).collect();
            let step = Numeric::factor(&self.table, self.entries()).solve(&right);
            let length = self.path.length(&step[..n]);
            q = retract(equations, &q, &step[..n]);
            if length < SETTLED {
                settled = true;
                break;
            }
        }
        self.stand(time, &q);
        let entries = self.entries();
        let factor = Numeric::factor(&self.table, entries.iter().copied());
        let of = |right: Vec<f64>| {
            let right: Vec<f64> = vec![0.0; n].into_iter().chain(right).collect();
            factor.solve(&right)[..n].to_vec()
        };
        let v = of(self.rows.iter().map(|row| -self.point.get(equations.rows[*row].jet.drift)).collect());
        self.point.set_v(&v);
        self.point.evaluate(&self.gamma);
        let a = of(self.rows.iter().map(|row| self.point.get(equations.gamma[*row])).collect());
        // Where rows are dependent the factors leave one out, and nothing holds what it would.
        let regular = factor.relative_pivots[n..].iter().all(|pivot| *pivot > DEPENDENT);
        let finite = v.iter().chain(&a).all(|x| x.is_finite());
        (settled && regular && finite).then_some(Instant { time, q, v, a })
    }

    /// One of the bounded efforts, σ times as fast.
    fn effort(&mut self, instant: &Instant, sigma: f64, which: usize) -> f64 {
        let (equations, n) = (self.equations, instant.v.len());
        let v: Vec<f64> = instant.v.iter().map(|v| sigma * v).collect();
        let a: Vec<f64> = instant.a.iter().map(|a| sigma * sigma * a).collect();
        self.stand(instant.time, &instant.q);
        self.point.set_v(&v);
        self.point.hold();
        self.point.evaluate(&self.geometry);
        let entries = self.entries();
        self.point.evaluate(&self.forces);
        let mut right: Vec<f64> = equations.forces.iter().map(|force| self.point.get(*force)).collect();
        for ((i, j), mass) in &equations.mass {
            let mass = self.point.get(*mass);
            right[*i] -= mass * a[*j];
            if i != j {
                right[*j] -= mass * a[*i];
            }
        }
        right.resize(n + self.rows.len(), 0.0);
        let solution = Numeric::factor(&self.table, entries).solve(&right);
        let mut lambda = vec![0.0; equations.rows.len()];
        self.rows.iter().zip(&solution[n..]).for_each(|(row, force)| lambda[*row] = *force);
        self.point.set(&equations.symbols.acceleration, &a);
        self.point.set(&equations.symbols.lambda, &lambda);
        self.point.evaluate(&self.expected);
        self.point.get(equations.expected[which])
    }

    fn least(&mut self, instants: &[Instant], which: usize, bound: &EffortBound) -> Least {
        let as_driven = |walk: &mut Self, instant: &Instant| margin(bound, walk.effort(instant, 1.0, which));
        let lowest = self.lowest(instants, as_driven);
        let value = self.effort(&lowest, 1.0, which);
        let limit = |walk: &mut Self, instant: &Instant| walk.limit(instant, which, bound);
        let first = self.lowest(instants, limit);
        let sigma = self.limit(&first, which, bound);
        let fails = sigma.is_finite().then(|| (sigma, self.moment(&first)));
        Least { value, at: self.moment(&lowest), fails }
    }

    /// The instant at which something is least: the least of all, then by sections of what lies around it.
    fn lowest(&mut self, instants: &[Instant], of: impl Fn(&mut Self, &Instant) -> f64) -> Instant {
        let values: Vec<f64> = instants.iter().map(|instant| of(self, instant)).collect();
        let least = (0..values.len()).min_by(|a, b| values[*a].total_cmp(&values[*b])).unwrap_or(0);
        let here = instants[least].clone();
        let before = instants[least.saturating_sub(1)].time;
        let after = match instants.get(least + 1) {
            Some(next) => next.time,
            None => 2.0 * here.time - before,
        };
        let golden = 0.5 * (5f64.sqrt() - 1.0);
        let at = |walk: &mut Self, time: f64| {
            let near = ahead_of(walk.equations, &here, time - here.time);
            let instant = walk.instant(time, near)?;
            let value = of(walk, &instant);
            value.is_finite().then_some((value, instant))
        };
        let (mut from, mut to) = (before, after);
        let mut best = (values[least], here.clone());
        for _ in 0..SECTIONS {
            let width = golden * (to - from);
            let (Some(low), Some(high)) = (at(self, to - width), at(self, from + width)) else { break };
            if low.0 < high.0 {
                to -= golden.powi(2) * (to - from)
            } else {
                from += golden.powi(2) * (to - from)
            }
            for found in [low, high] {
                if found.0 < best.0 {
                    best = found;
                }
            }
        }
        best.1
    }

    /// σ at which an effort reaches its bound; infinite if it does at none. Loads that go with speed and its square give margins A + B σ + C σ²,
    /// whose root is where others are looked for.
    fn limit(&mut self, instant: &Instant, which: usize, bound: &EffortBound) -> f64 {
        let mut of = |sigma: f64| margin(bound, self.effort(instant, sigma, which));
        let [rest, half, full] = [0.0, 0.5, 1.0].map(&mut of);
        if rest.is_nan() || rest <= 0.0 {
            return 0.0;
        }
        let (linear, square) = (4.0 * half - 3.0 * rest - full, 2.0 * (rest + full - 2.0 * half));
        let Some(guess) = root(rest, linear, square) else { return f64::INFINITY };
        // The secant method.
        let (mut older, mut newer) = ((0.0, rest), (guess, of(guess)));
        for _ in 0..8 {
            let next = newer.0 - newer.1 * (newer.0 - older.0) / (newer.1 - older.1);
            if !next.is_finite() || (next - newer.0).abs() <= 1e-15 * newer.0 {
                break;
            }
            (older, newer) = (newer, (next, of(next)));
        }
        if newer.0 > 0.0 && newer.1.abs() <= 1e-9 * rest { newer.0 } else { guess }
    }

    fn moment(&mut self, instant: &Instant) -> Moment {
        self.stand(instant.time, &instant.q);
        let Some((condition, law)) = self.equations.driven.first() else {
            return Moment { position: f64::NAN, rate: f64::NAN };
        };
        let columns = condition.jet.columns.iter();
        let rate: f64 = columns.map(|(k, column)| self.point.get(*column) * instant.v[*k]).sum();
        Moment { position: self.point.get(*law), rate: rate + self.point.get(condition.jet.drift) }
    }
}

/// The smallest positive root of A + B σ + C σ² with A > 0.
fn root(a: f64, b: f64, c: f64) -> Option<f64> {
    // What three numbers of about A leave of C and B is rounding where they are smaller.
    let rounding = 1e-13 * a.abs();
    let (b, c) = (if b.abs() < rounding { 0.0 } else { b }, if c.abs() < rounding { 0.0 } else { c });
    let square = b * b - 4.0 * a * c;
    if square < 0.0 {
        return None;
    }
    // 2 A/(−B ± √…): both roots without cancellation of the smaller.
    let roots = [1.0, -1.0].map(|sign| 2.0 * a / (-b + sign * square.sqrt()));
    roots.into_iter().filter(|root| root.is_finite() && *root > 0.0).min_by(f64::total_cmp)
}

/// q + q̇ δ + ½ q̈ δ².
fn ahead_of(equations: &Equations, instant: &Instant, delta: f64) -> Vec<f64> {
    let step: Vec<f64> =
        instant.v.iter().zip(&instant.a).map(|(v, a)| delta * (v + 0.5 * delta * a)).collect();
    retract(equations, &instant.q, &step)
}
