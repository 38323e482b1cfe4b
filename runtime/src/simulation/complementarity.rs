//! The complementarity problem of a few contacts: which of them push, and how much; which of those that rub hold, and which slide.
//!
//! ```text
//! 0 ≤ x ⟂ G x + c ≥ 0                                               of each gap
//! |y| ≤ μ_s x where w = 0,   y = −μ_k x u where w = |w| u,   w = (G x + c) of its rows    of what slides in it (Coulomb)
//! ```
//! u is ±1 of what slides along a line, else a direction in a surface. All ways in which they may push and slide are tried, and the first that
//! is consistent is taken: fewest that push first, and what may hold before what slides (Pfeiffer and Glocker, Multibody Dynamics with Unilateral
//! Contacts, 1996, 5.3 and 8.3). Which direction something begins to slide in is sought by iteration (`which_way.rs`). Laws of impacts are such
//! problems.

use super::which_way::begun;
use crate::real::Real;
use crate::vector::{at, dot, put};

/// How many rigid contacts may touch at one time: all 2⁴ ways in which they may push are tried, and with dry friction in each all 4⁴ in which
/// they may push, hold and slide.
pub const RIGID_TOUCHING: usize = 4;

/// Along how many axes of the world something slides at most.
pub(super) const AXES: usize = 3;

/// Gaps, and what slides in each.
pub(super) const ROWS: usize = (1 + AXES) * RIGID_TOUCHING;

/// What is left of numbers that are zero, as a part of those that they come from.
const NOTHING: f64 = 1e-11;

/// What is added to the diagonal of forces that hold, as a part of it: where several hold the same, all of them do so alike.
const YIELDING: f64 = 1e-9;

/// What of a motion along an axis is none, as a part of that of the others.
const MOVES: f64 = 1e-9;

/// By how much what was so before has to push and hold to be so still without a look at anything else, as a part of what it may: what is about to change
/// changes.
const SURE: f64 = 1e-6;

/// How often what that leaves is taken away.
const REFINED: u32 = 2;

/// One number for each row.
pub(super) type Few<R> = [R; ROWS];

/// Which way a contact slides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Way<R> {
    /// It stands, and may go any way.
    Open,
    /// u.
    Along([R; AXES]),
}

/// What slides in a contact.
#[derive(Clone, Copy)]
pub(super) struct Rub<R> {
    /// The row of the gap that presses.
    pub pressed: usize,
    /// Its first row, and how many it has.
    pub row: usize,
    pub axes: usize,
    /// μ_s and μ_k.
    pub holding: R,
    pub sliding: R,
    pub way: Way<R>,
}

/// Contacts that touch, and how they depend on one another: the rows of their gaps first, then those of what slides in them.
#[derive(Clone)]
pub(super) struct Problem<R> {
    /// G.
    pub matrix: [Few<R>; ROWS],
    pub gaps: usize,
    /// Those of the rows behind the gaps, in their order.
    pub rubs: [Option<Rub<R>>; RIGID_TOUCHING],
}

/// Which way what slides in each contact goes.
pub(super) type Ways<R> = [Way<R>; RIGID_TOUCHING];

/// What solves it: forces, and of what slides which way.
pub(super) struct Found<R> {
    pub forces: Few<R>,
    pub ways: Ways<R>,
}

/// What is tried: the gaps that push, which way something slides, and what begins to slide some way, as bits.
#[derive(Clone, Copy)]
pub(super) struct Trial<R> {
    pub set: usize,
    pub ways: Ways<R>,
    pub begins: usize,
}

impl<R: Real> Way<R> {
    /// One component of u; 0 of what holds.
    pub fn along(&self, axis: usize) -> R {
        match self {
            Way::Open => R::ZERO,
            Way::Along(way) => at(way, axis),
        }
    }

    /// Along a line, with its direction or against it.
    fn one(way: R) -> Self {
        Way::Along([way, R::ZERO, R::ZERO])
    }
}

impl<R: Real> Rub<R> {
    /// Its rows.
    pub fn rows(&self) -> core::ops::Range<usize> {
        self.row..self.row + self.axes
    }

    /// Those of some numbers that belong to it.
    pub fn own(&self, of: &Few<R>) -> [R; AXES] {
        core::array::from_fn(|axis| if axis < self.axes { at(of, self.row + axis) } else { R::ZERO })
    }

    /// How large they are together.
    pub fn size(&self, of: &Few<R>) -> R {
        if self.axes == 1 {
            return at(of, self.row).abs();
        }
        let own = self.own(of);
        dot(&own, &own).sqrt()
    }

    /// What one unit of what presses it adds to a row of G by friction that way: −μ_k u·g, g the entries of its rows.
    pub fn drag(&self, way: &Way<R>, entries: &Few<R>) -> R {
        let Way::Along(way) = way else { return R::ZERO };
        -self.sliding * dot(way, &self.own(entries))
    }
}

impl<R: Real> Problem<R> {
    /// How many rows there are.
    pub fn count(&self) -> usize {
        self.gaps + self.rubbing().map(|rub| rub.axes).sum::<usize>()
    }

    /// All that slides.
    pub fn rubbing(&self) -> impl Iterator<Item = Rub<R>> {
        self.rubs.into_iter().flatten()
    }

    /// The impulses of contacts whose gaps close with `rates` ġ⁻, by restitutions e of speeds: 0 ≤ P ⟂ G P + (1 + e) ġ⁻ ≥ 0. What would part slower
    /// than `rests` does not bounce.
    pub fn newton(&self, rates: &Few<R>, shares: &Few<R>, rests: &Few<R>) -> Option<Few<R>> {
        let wanted = core::array::from_fn(|place| {
            let (rate, share) = (at(rates, place), at(shares, place));
            if -rate * share > at(rests, place) { (R::ONE + share) * rate } else { rate }
        });
        self.all(&wanted, &[R::ZERO; ROWS])
    }

    /// The same by restitutions of impulses: 0 ≤ P_c ⟂ G P_c + ġ⁻ ≥ 0 ends the approach, then P = (1 + e) P_c + X with 0 ≤ X ⟂ G P + ġ⁻ ≥ 0. How
    /// fast something parts is here the rate that its impulse alone gives. Friction is by P_c in the approach and by e P_c + X afterwards.
    pub fn poisson(&self, rates: &Few<R>, shares: &Few<R>, rests: &Few<R>) -> Option<Few<R>> {
        let mut given = self.all(rates, &[R::ZERO; ROWS])?;
        let mut back = [R::ZERO; ROWS];
        for (place, row) in self.matrix.iter().enumerate().take(self.gaps) {
            let (impulse, share) = (at(&given, place), at(shares, place));
            if share * impulse * at(row, place) > at(rests, place) {
                put(&mut back, place, share * impulse);
                put(&mut given, place, (R::ONE + share) * impulse);
            }
        }
        let left = core::array::from_fn(|place| at(rates, place) + self.row(place, &given));
        let more = self.all(&left, &back)?;
        Some(core::array::from_fn(|place| at(&given, place) + at(&more, place)))
    }

    /// All of them, which may go on any way.
    fn all(&self, right: &Few<R>, pressed: &Few<R>) -> Option<Few<R>> {
        let rubs = self.rubs.map(|rub| rub.map(|rub| Rub { way: Way::Open, ..rub }));
        let any = Problem { rubs, ..self.clone() };
        any.complementary(right, pressed, (1 << self.gaps) - 1, None).map(|found| found.forces)
    }

    /// The first way of all that solves it with gaps in `among`; other gaps have zero. `pressed` is what presses beside it, `likely` is tried before
    /// all others.
    pub fn complementary(
        &self,
        right: &Few<R>,
        pressed: &Few<R>,
        among: usize,
        likely: Option<Trial<R>>,
    ) -> Option<Found<R>> {
        let largest = right.iter().fold(R::ZERO, |largest, c| largest.max(c.abs()));
        let nothing = R::from_f64(NOTHING).max(R::from_f64(1000.0) * R::EPSILON) * largest;
        let sets = (0..1_usize << self.gaps).filter(|set| set & !among == 0);
        let all = sets.flat_map(|set| self.trials(set, pressed)).map(|trial| (trial, R::ZERO));
        let likely = likely.into_iter().map(|trial| (trial, R::from_f64(SURE)));
        likely.chain(all).find_map(|(trial, sure)| {
            let found = self.found(right, pressed, &trial)?;
            let Found { forces, ways } = &found;
            let most = forces.iter().fold(R::ZERO, |most, x| most.max(x.abs()));
            let gaps = (0..self.gaps).filter(|place| among >> place & 1 == 1).all(|place| {
                if trial.set >> place & 1 == 1 {
                    return at(forces, place) >= sure * most;
                }
                self.row(place, forces) + at(right, place) >= -nothing
            });
            let is_consistent = |(rub, way): (Rub<R>, &Way<R>)| match way {
                Way::Open => {
                    let bound = rub.holding * (at(forces, rub.pressed) + at(pressed, rub.pressed));
                    rub.size(forces) <= (R::ONE - sure) * bound
                }
                // It goes on as it does.
                _ if rub.way != Way::Open => true,
                Way::Along(way) => dot(way, &self.rates(&rub, forces, right)) >= -nothing,
            };
            (gaps && self.rubbing().zip(ways).all(is_consistent)).then_some(found)
        })
    }

    /// All ways in which what is pressed by the gaps in `set` may hold or slide; what is not pressed holds nothing.
    fn trials(&self, set: usize, pressed: &Few<R>) -> impl Iterator<Item = Trial<R>> {
        let presses = |rub: &Rub<R>| set >> rub.pressed & 1 == 1 || at(pressed, rub.pressed) > R::ZERO;
        let choices = self.rubs.map(|rub| rub.filter(presses));
        let of = |rub: &Option<Rub<R>>| match rub {
            Some(rub) if rub.way != Way::Open => 1,
            Some(rub) if rub.axes > 1 => 2,
            Some(_) => 3,
            None => 1,
        };
        (0..choices.iter().map(of).product()).map(move |mut which: usize| {
            let mut trial = Trial { set, ways: [Way::Open; RIGID_TOUCHING], begins: 0 };
            for (place, (way, rub)) in trial.ways.iter_mut().zip(&choices).enumerate() {
                let Some(rub) = rub else { continue };
                if rub.way != Way::Open {
                    *way = rub.way;
                    continue;
                }
                let digit = which % of(&Some(*rub));
                which /= of(&Some(*rub));
                match digit {
                    0 => {}
                    1 if rub.axes > 1 => trial.begins |= 1 << place,
                    1 => *way = Way::one(R::ONE),
                    _ => *way = Way::one(-R::ONE),
                }
            }
            trial
        })
    }

    /// The forces of what is tried, and all its ways; nothing where they are not defined.
    fn found(&self, right: &Few<R>, pressed: &Few<R>, trial: &Trial<R>) -> Option<Found<R>> {
        if trial.begins != 0 {
            return begun(self, right, pressed, trial);
        }
        Some(Found { forces: self.tried(right, pressed, trial.set, &trial.ways)?, ways: trial.ways })
    }

    /// The forces where the gaps in `set` stay closed and what rubs goes these ways; nothing where they are not defined.
    pub fn tried(&self, right: &Few<R>, pressed: &Few<R>, set: usize, ways: &Ways<R>) -> Option<Few<R>> {
        let (matrix, held) = self.folded(pressed, set, ways);
        let mut right = *right;
        for (rub, way) in self.rubbing().zip(ways) {
            let beside = at(pressed, rub.pressed);
            for (entries, right) in self.matrix.iter().zip(&mut right).take(self.count()) {
                *right = *right + rub.drag(way, entries) * beside;
            }
        }
        let mut forces = solved(&matrix, &right, self.gaps, self.count(), held)?;
        for (rub, way) in self.rubbing().zip(ways).filter(|(_, way)| **way != Way::Open) {
            let pressing = at(&forces, rub.pressed) + at(pressed, rub.pressed);
            for (axis, row) in rub.rows().enumerate() {
                put(&mut forces, row, -way.along(axis) * rub.sliding * pressing);
            }
        }
        Some(forces)
    }

    /// G where what slides goes with what presses, and the rows that are solved for.
    pub fn folded(&self, pressed: &Few<R>, set: usize, ways: &Ways<R>) -> ([Few<R>; ROWS], usize) {
        let (mut matrix, mut held) = (self.matrix, set);
        for (rub, way) in self.rubbing().zip(ways) {
            if *way == Way::Open {
                if set >> rub.pressed & 1 == 1 || at(pressed, rub.pressed) > R::ZERO {
                    held |= rub.rows().fold(0, |rows, row| rows | 1 << row);
                }
                continue;
            }
            for entries in matrix.iter_mut().take(self.count()) {
                let folded = at(entries, rub.pressed) + rub.drag(way, entries);
                put(entries, rub.pressed, folded);
            }
        }
        (matrix, held)
    }

    /// w of what slides.
    pub fn rates(&self, rub: &Rub<R>, forces: &Few<R>, right: &Few<R>) -> [R; AXES] {
        core::array::from_fn(|axis| match axis < rub.axes {
            true => self.row(rub.row + axis, forces) + at(right, rub.row + axis),
            false => R::ZERO,
        })
    }

    /// Completes the blocks of what slides in space.
    pub fn completed(mut self) -> Self {
        for rub in self.rubs.into_iter().flatten().filter(|rub| rub.axes > 1) {
            complete(&mut self.matrix, rub.row);
        }
        self
    }

    /// tr G of its rows.
    pub fn trace(&self, rub: &Rub<R>) -> R {
        let own = |row: usize| self.matrix.get(row).map_or(R::ZERO, |entries| at(entries, row));
        rub.rows().fold(R::ZERO, |sum, row| sum + own(row))
    }

    /// What takes away `rates` of the rows in `set`; nothing where it is not defined.
    pub fn against(&self, rates: &Few<R>, set: usize) -> Option<Few<R>> {
        solved(&self.matrix, rates, self.gaps, self.count(), set)
    }

    /// One entry of G x.
    pub fn row(&self, place: usize, x: &Few<R>) -> R {
        self.matrix.get(place).map_or(R::ZERO, |row| along(row, x, self.count()))
    }
}

/// Adds to the block B of the rows along the axes of the world what they leave out, along the normal at least, as if it moved by itself as much as
/// they do on average: B + tr B/3 (I − P), P the projector on the range of B. Since nothing acts there, nothing moves, but the block is regular.
pub(super) fn complete<R: Real>(matrix: &mut [Few<R>; ROWS], row: usize) {
    let block: [[R; AXES]; AXES] = core::array::from_fn(|i| {
        core::array::from_fn(|j| matrix.get(row + i).map_or(R::ZERO, |entries| at(entries, row + j)))
    });
    let trace = block.iter().enumerate().fold(R::ZERO, |sum, (i, entries)| sum + at(entries, i));
    let own = if R::any(trace.greater(R::ZERO)) { trace / R::from_f64(AXES as f64) } else { R::ONE };
    let least = R::from_f64(MOVES).max(R::from_f64(256.0) * R::EPSILON) * own;
    let mut left: [[R; AXES]; AXES] =
        core::array::from_fn(|i| core::array::from_fn(|j| if i == j { R::ONE } else { R::ZERO }));
    let mut moves = block;
    for _ in 0..AXES {
        let size = |entries: &[R; AXES]| dot(entries, entries);
        let first = |most: [R; AXES], entries: &[R; AXES]| {
            if R::any(size(entries).greater(size(&most))) { *entries } else { most }
        };
        let largest = moves.iter().fold([R::ZERO; AXES], first);
        let length = size(&largest).sqrt();
        if !R::any(length.greater(least)) {
            break;
        }
        let along = largest.map(|x| x / length);
        for entries in moves.iter_mut().chain(&mut left) {
            let part = dot(entries, &along);
            for (entry, along) in entries.iter_mut().zip(along) {
                *entry = *entry - part * along;
            }
        }
    }
    for (i, left) in left.iter().enumerate() {
        let Some(entries) = matrix.get_mut(row + i) else { continue };
        for (entry, left) in entries.iter_mut().skip(row).zip(left) {
            *entry = *entry + own * *left;
        }
    }
}

/// G x = −c of the rows in `set`, the others zero; nothing where G is singular. Rows from `gaps` on may repeat each other.
pub(super) fn solved<R: Real>(
    matrix: &[Few<R>; ROWS],
    right: &Few<R>,
    gaps: usize,
    count: usize,
    set: usize,
) -> Option<Few<R>> {
    let mut x = eliminated(matrix, right, gaps, count, set)?;
    if set >> gaps == 0 {
        return Some(x);
    }
    for _ in 0..REFINED {
        let mut left = *right;
        for (left, entries) in left.iter_mut().zip(matrix).take(count) {
            *left = *left + along(entries, &x, count);
        }
        let more = eliminated(matrix, &left, gaps, count, set)?;
        for (x, more) in x.iter_mut().zip(more).take(count) {
            *x = *x + more;
        }
    }
    Some(x)
}

/// The product of a row and as many numbers.
fn along<R: Real>(row: &Few<R>, x: &Few<R>, count: usize) -> R {
    row.iter().zip(x).take(count).fold(R::ZERO, |sum, (entry, x)| entry.mul_add(*x, sum))
}

fn eliminated<R: Real>(
    matrix: &[Few<R>; ROWS],
    right: &Few<R>,
    gaps: usize,
    count: usize,
    set: usize,
) -> Option<Few<R>> {
    let (mut left, mut x) = (*matrix, [R::ZERO; ROWS]);
    for (x, c) in x.iter_mut().zip(right).take(count) {
        *x = -*c;
    }
    let yielding = R::from_f64(YIELDING).max(R::from_f64(256.0) * R::EPSILON);
    for (place, row) in left.iter_mut().enumerate().take(count).skip(gaps) {
        let diagonal = at(row, place) * (R::ONE + yielding);
        put(row, place, diagonal);
    }
    let held = |place: usize| place < count && set >> place & 1 == 1;
    let least = R::from_f64(1e-10).max(R::from_f64(16.0) * R::EPSILON);
    for pivot in (0..count).filter(|pivot| held(*pivot)) {
        let row = left.get(pivot).copied()?;
        let diagonal = at(&row, pivot);
        let whole = matrix.get(pivot).map_or(R::ZERO, |row| at(row, pivot));
        // Written so that a NaN is singular.
        if !R::any(diagonal.greater(least * whole.abs())) {
            return None;
        }
        for below in (0..count).filter(|below| held(*below) && *below != pivot) {
            let target = left.get_mut(below)?;
            let factor = at(target, pivot) / diagonal;
            // What is before the pivot is zero, or not solved for.
            for (entry, above) in target.iter_mut().zip(&row).take(count).skip(pivot) {
                *entry = *entry - factor * *above;
            }
            let value = at(&x, below) - factor * at(&x, pivot);
            put(&mut x, below, value);
        }
    }
    for place in 0..count {
        let value = match left.get(place) {
            Some(row) if held(place) => at(&x, place) / at(row, place),
            _ => R::ZERO,
        };
        put(&mut x, place, value);
    }
    Some(x)
}
