//! Follows the motion until it returns to the start, and notes where joints turn back and where the constraints lose
//! rank.
//!
//! Towards a singular position steps shrink with what is left of the way, as the smallest pivot foretells it, and one
//! that is only near is passed in steps as short as its bend asks for. One that is met is passed straight on, along the
//! tangent, which stays on the same branch.

use super::path::{Path, Place};
use super::{End, Limit};
use std::f64::consts::{PI, TAU};

/// Sizes of the first step and of the longest: no joint angle changes by half a turn in one.
const FIRST: f64 = 0.05;
const LONGEST: f64 = 0.2;
/// A step this short that still fails gives up.
const SHORTEST: f64 = 1e-9;
/// Tangents of neighbouring positions keep this cosine.
const BEND: f64 = 0.95;
/// Nearer than this a position counts as singular: the root of [`DEPENDENT`](crate::solve::table::DEPENDENT), rounded up.
const SINGULAR: f64 = 1e-5;
/// How far beyond a singular position the motion is taken up again.
const LEAP: f64 = 1e-3;
/// Rates below this are zero; t has its largest entry 1.
const STILL: f64 = 1e-9;
/// Travels beyond this many lengths of the mechanism have no limit.
const UNLIMITED: f64 = 50.0;

/// The ranges, limits and singular positions that were met on the way.
#[derive(Default)]
pub struct Swept {
    /// Least and largest values of the watched coordinates, angles over several turns.
    pub ranges: Vec<(f64, f64)>,
    pub limits: Vec<(Limit, Place)>,
    /// Singular positions, with the values of the watched coordinates.
    pub singular: Vec<(Vec<f64>, Vec<f64>)>,
    /// All positions, in the order met.
    pub places: Vec<Place>,
    pub steps: usize,
}

/// The whole motion: forward, and if that does not return to the start also backward.
pub fn sweep(path: &mut Path, start: Place, length: f64, most: usize) -> (Swept, End) {
    let ranges = start.values.iter().map(|value| (*value, *value)).collect();
    let mut swept = Swept { ranges, ..Swept::default() };
    let end = Sweep::new(path, &start, length, &mut swept).run(most);
    if end == End::Closed {
        return (swept, end);
    }
    let mut back = start;
    back.tangent.iter_mut().chain(&mut back.rates).for_each(|x| *x = -*x);
    let other = Sweep::new(path, &back, length, &mut swept).run(most);
    (swept, if other == End::Closed { other } else { end })
}

struct Sweep<'s, 'p> {
    path: &'s mut Path<'p>,
    start: &'s Place,
    length: f64,
    swept: &'s mut Swept,
    here: Place,
    /// The step that led here, and the regularity it came from.
    before: Option<(f64, f64)>,
    step: f64,
    travelled: f64,
}

impl<'s, 'p> Sweep<'s, 'p> {
    fn new(path: &'s mut Path<'p>, start: &'s Place, length: f64, swept: &'s mut Swept) -> Self {
        let here = start.clone();
        Sweep { path, start, length, swept, here, before: None, step: FIRST, travelled: 0.0 }
    }

    /// At most so many steps.
    fn run(mut self, most: usize) -> End {
        for _ in 0..most {
            self.swept.steps += 1;
            let left = self.way_left();
            if self.here.regularity < SINGULAR {
                if !self.leap(left.unwrap_or(SINGULAR)) {
                    return End::Stuck;
                }
                continue;
            }
            // Most of what is left, so that the regularity falls by a like factor each time.
            let cap = left.map_or(LONGEST, |left| 0.7 * left).min(4.0 * self.here.regularity);
            let distance = self.step.min(cap).min(LONGEST);
            let Some((next, cosine)) = self.acceptable(distance) else {
                self.step = 0.5 * distance;
                if self.step < SHORTEST {
                    return End::Stuck;
                }
                continue;
            };
            if let Some(closing) = self.closing(&next, distance) {
                self.arrive(self.start.clone(), closing);
                return End::Closed;
            }
            self.arrive(next, distance);
            self.step = distance * if cosine > 0.99 { 2.0 } else { 1.0 };
            if self.is_unlimited() {
                return End::Unlimited;
            }
        }
        End::Bounded
    }

    /// How far the nearest singular position ahead seems to be, where the regularity falls.
    fn way_left(&self) -> Option<f64> {
        let (step, regularity) = self.before?;
        let fall = (regularity - self.here.regularity) / step;
        (fall > 0.0).then(|| self.here.regularity / fall)
    }

    /// The next position, unless it is too far round a bend or on another branch.
    fn acceptable(&mut self, distance: f64) -> Option<(Place, f64)> {
        let next = self.path.step(&self.here, distance)?;
        let cosine = self.path.cosine(&self.here.tangent, &next.tangent);
        let moved = self.path.length(&self.path.difference(&self.here.q, &next.q));
        (cosine > BEND && moved < 1.5 * distance).then_some((next, cosine))
    }

    /// Across a singular position that is `left` ahead, straight on.
    fn leap(&mut self, left: f64) -> bool {
        let left = left.min(10.0 * SINGULAR);
        for beyond in [LEAP, 0.2 * LEAP, 10.0 * LEAP] {
            let distance = left + beyond;
            let Some((next, _)) = self.acceptable(distance) else { continue };
            if next.regularity > self.here.regularity {
                let moved = self.here.values.iter().zip(&self.here.rates);
                let values = moved.map(|(value, rate)| value + rate * left).collect();
                self.swept.singular.push((values, self.path.moved(&self.here, left)));
                self.arrive(next, distance);
                self.step = LEAP;
                self.before = None;
                return true;
            }
        }
        false
    }

    /// The length of the last step, if the start lies on the way to `next`.
    fn closing(&mut self, next: &Place, distance: f64) -> Option<f64> {
        if self.travelled < LONGEST {
            return None;
        }
        let tangent = &self.start.tangent;
        let square = self.path.inner(tangent, tangent);
        let ahead = |path: &Path, q: &[f64]| path.inner(tangent, &path.difference(&self.start.q, q)) / square;
        let near =
            |path: &Path, q: &[f64], bound: f64| path.length(&path.difference(&self.start.q, q)) < bound;
        let missing = -ahead(self.path, &self.here.q);
        if missing <= 0.0 || ahead(self.path, &next.q) < 0.0 || !near(self.path, &next.q, 2.0 * distance) {
            return None;
        }
        let mut last = missing.min(distance);
        for _ in 0..20 {
            let there = self.path.step(&self.here, last)?;
            let miss = ahead(self.path, &there.q);
            if miss.abs() < 1e-9 {
                return near(self.path, &there.q, 1e-6).then_some(last);
            }
            last -= miss;
        }
        None
    }

    /// Notes what lies between here and the next position, and goes there.
    fn arrive(&mut self, mut next: Place, distance: f64) {
        next.values = self.unwrapped(&next);
        for i in 0..next.values.len() {
            let (from, to) = (self.here.rates[i], next.rates[i]);
            self.widen(i, next.values[i]);
            if from.abs() > STILL && to.abs() > STILL && (from > 0.0) != (to > 0.0) {
                self.limit(i, distance);
            }
        }
        self.before = Some((distance, self.here.regularity));
        self.travelled += distance;
        self.swept.places.push(next.clone());
        self.here = next;
    }

    /// Values that continue those of here.
    fn unwrapped(&self, next: &Place) -> Vec<f64> {
        let watched = self.path.watched.iter().map(|condition| condition.angular);
        let change = |((to, from), angular): ((&f64, &f64), bool)| {
            let change = to - from;
            from + if angular { change - TAU * ((change + PI) / TAU).floor() } else { change }
        };
        next.values.iter().zip(&self.here.values).zip(watched).map(change).collect()
    }

    /// Coordinate `i` turns back within `distance` of here: by the Illinois method.
    fn limit(&mut self, i: usize, distance: f64) {
        let Some(far) = self.path.step(&self.here, distance) else { return };
        let (mut older, mut newer) = ((0.0, self.here.rates[i]), (distance, far.rates[i]));
        let mut best: Option<Place> = None;
        for _ in 0..40 {
            let at = newer.0 - newer.1 * (newer.0 - older.0) / (newer.1 - older.1);
            let Some(place) = self.path.step(&self.here, at) else { break };
            let rate = place.rates[i];
            best = Some(place);
            if rate.abs() < 1e-12 || (newer.0 - older.0).abs() < 1e-12 {
                break;
            }
            if (rate > 0.0) == (newer.1 > 0.0) {
                older.1 *= 0.5;
            } else {
                older = newer;
            }
            newer = (at, rate);
        }
        if let Some(mut place) = best {
            place.values = self.unwrapped(&place);
            self.widen(i, place.values[i]);
            let limit = Limit {
                of: i,
                value: place.values[i],
                reference: 0.0,
                values: Vec::new(),
                in_line: Vec::new(),
            };
            self.swept.limits.push((limit, place));
        }
    }

    fn widen(&mut self, i: usize, value: f64) {
        let (from, to) = &mut self.swept.ranges[i];
        (*from, *to) = (from.min(value), to.max(value));
    }

    fn is_unlimited(&self) -> bool {
        let lengths = self.here.q.iter().zip(&self.start.q).take(self.path.lengths());
        lengths.map(|(here, start)| here - start).any(|way| way.abs() > UNLIMITED * self.length)
    }
}
