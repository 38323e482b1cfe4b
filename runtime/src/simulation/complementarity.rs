//! The complementarity problem of a few contacts: which of them push, and how much; which of those that rub hold, and which slide.
//!
//! ```text
//! 0 ≤ x ⟂ G x + c ≥ 0                                               of each gap
//! |y| ≤ μ_s x where (G x + c) = 0,   y = −σ μ_k x where σ (G x + c) ≥ 0, σ = ±1        of what slides in it (Coulomb)
//! ```
//! All ways in which they may push and slide are tried, and the first that holds is taken: fewest that push first, and what may hold before what
//! slides (Pfeiffer and Glocker, Multibody Dynamics with Unilateral Contacts, 1996, 5.3 and 8.3). Laws of impacts are such problems.

use crate::real::Real;
use crate::vector::{at, dot, put};

/// How many rigid contacts may touch at one time: all 2⁴ ways in which they may push are tried, and with dry friction in each all 4⁴ in which
/// they may push, hold and slide.
pub const RIGID_TOUCHING: usize = 4;

/// Gaps, and what slides in each.
pub(super) const ROWS: usize = 2 * RIGID_TOUCHING;

/// What is left of numbers that are zero, as a part of those that they come from.
const NOTHING: f64 = 1e-11;

/// What is added to the diagonal of forces that hold, as a part of it: where several hold the same, all of them do so alike.
const YIELDING: f64 = 1e-9;

/// How often what that leaves is taken away.
const REFINED: u32 = 2;

/// One number for each row.
pub(super) type Few<R> = [R; ROWS];

/// Which way a contact slides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Way {
    /// It stands, and may go either way.
    Open,
    Forwards,
    Backwards,
}

/// What slides in a contact.
#[derive(Clone, Copy)]
pub(super) struct Rub<R> {
    /// The row of the gap that presses.
    pub pressed: usize,
    /// μ_s and μ_k.
    pub holding: R,
    pub sliding: R,
    pub way: Way,
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

/// What solves it: forces, and of what slides which way.
pub(super) struct Found<R> {
    pub forces: Few<R>,
    pub ways: [Way; RIGID_TOUCHING],
}

impl Way {
    /// σ; 0 of what holds.
    pub fn sign<R: Real>(self) -> R {
        match self {
            Way::Open => R::ZERO,
            Way::Forwards => R::ONE,
            Way::Backwards => -R::ONE,
        }
    }
}

impl<R: Real> Problem<R> {
    /// How many rows there are.
    pub fn count(&self) -> usize {
        self.gaps + self.rubs.iter().flatten().count()
    }

    /// All that slides, and in which row.
    pub fn rubbing(&self) -> impl Iterator<Item = (usize, Rub<R>)> {
        (self.gaps..).zip(self.rubs.into_iter().flatten())
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
        any.complementary(right, pressed, (1 << self.gaps) - 1).map(|found| found.forces)
    }

    /// The first way of all that solves it with gaps in `among`; other gaps have zero. `pressed` is what presses beside it.
    pub fn complementary(&self, right: &Few<R>, pressed: &Few<R>, among: usize) -> Option<Found<R>> {
        let largest = right.iter().fold(R::ZERO, |largest, c| largest.max(c.abs()));
        let nothing = R::from_f64(NOTHING).max(R::from_f64(1000.0) * R::EPSILON) * largest;
        let sets = (0..1_usize << self.gaps).filter(|set| set & !among == 0);
        sets.flat_map(|set| self.slides(set, pressed).map(move |ways| (set, ways))).find_map(|(set, ways)| {
            let forces = self.tried(right, pressed, set, &ways)?;
            let gaps = (0..self.gaps).filter(|place| among >> place & 1 == 1).all(|place| {
                if set >> place & 1 == 1 {
                    return at(&forces, place) >= R::ZERO;
                }
                self.row(place, &forces) + at(right, place) >= -nothing
            });
            let holds = |((row, rub), way): ((usize, Rub<R>), &Way)| {
                let bound = rub.holding * (at(&forces, rub.pressed) + at(pressed, rub.pressed));
                match way {
                    Way::Open => at(&forces, row).abs() <= bound,
                    // It goes on as it does.
                    _ if rub.way != Way::Open => true,
                    way => way.sign::<R>() * (self.row(row, &forces) + at(right, row)) >= -nothing,
                }
            };
            (gaps && self.rubbing().zip(&ways).all(holds)).then_some(Found { forces, ways })
        })
    }

    /// All ways in which what is pressed by the gaps in `set` may hold or slide; what is not pressed holds nothing.
    fn slides(&self, set: usize, pressed: &Few<R>) -> impl Iterator<Item = [Way; RIGID_TOUCHING]> {
        let presses = |rub: &Rub<R>| set >> rub.pressed & 1 == 1 || at(pressed, rub.pressed) > R::ZERO;
        let choices = self.rubs.map(|rub| match rub {
            Some(rub) if presses(&rub) => Some(rub.way),
            _ => None,
        });
        let many = choices.iter().map(|choice| if *choice == Some(Way::Open) { 3 } else { 1 });
        (0..many.product()).map(move |mut which: usize| {
            choices.map(|choice| match choice {
                Some(Way::Open) => {
                    let digit = which % 3;
                    which /= 3;
                    [Way::Open, Way::Forwards, Way::Backwards].get(digit).copied().unwrap_or(Way::Open)
                }
                Some(way) => way,
                None => Way::Open,
            })
        })
    }

    /// The forces where the gaps in `set` stay closed and what rubs goes these ways; nothing where they are not defined.
    fn tried(
        &self,
        right: &Few<R>,
        pressed: &Few<R>,
        set: usize,
        ways: &[Way; RIGID_TOUCHING],
    ) -> Option<Few<R>> {
        let (mut matrix, mut right, mut held) = (self.matrix, *right, set);
        for ((row, rub), way) in self.rubbing().zip(ways) {
            let beside = at(pressed, rub.pressed);
            if *way == Way::Open {
                let presses = set >> rub.pressed & 1 == 1 || beside > R::ZERO;
                held |= usize::from(presses) << row;
                continue;
            }
            // What slides goes with what presses.
            let share = -way.sign::<R>() * rub.sliding;
            for (entries, right) in matrix.iter_mut().zip(&mut right) {
                let along = share * at(entries, row);
                *right = *right + along * beside;
                let folded = at(entries, rub.pressed) + along;
                put(entries, rub.pressed, folded);
            }
        }
        let mut forces = solved(&matrix, &right, self.gaps, self.count(), held)?;
        for ((row, rub), way) in self.rubbing().zip(ways).filter(|(_, way)| **way != Way::Open) {
            let pressing = at(&forces, rub.pressed) + at(pressed, rub.pressed);
            put(&mut forces, row, -way.sign::<R>() * rub.sliding * pressing);
        }
        Some(forces)
    }

    /// What takes away `rates` of the rows in `set`; nothing where it is not defined.
    pub fn against(&self, rates: &Few<R>, set: usize) -> Option<Few<R>> {
        solved(&self.matrix, rates, self.gaps, self.count(), set)
    }

    /// One entry of G x.
    pub fn row(&self, place: usize, x: &Few<R>) -> R {
        self.matrix.get(place).map_or(R::ZERO, |row| dot(row, x))
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
        let left = core::array::from_fn(|row| {
            at(right, row) + matrix.get(row).map_or(R::ZERO, |entries| dot(entries, &x))
        });
        let more = eliminated(matrix, &left, gaps, count, set)?;
        x = core::array::from_fn(|row| at(&x, row) + at(&more, row));
    }
    Some(x)
}

fn eliminated<R: Real>(
    matrix: &[Few<R>; ROWS],
    right: &Few<R>,
    gaps: usize,
    count: usize,
    set: usize,
) -> Option<Few<R>> {
    let (mut left, mut x) = (*matrix, right.map(|c| -c));
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
            for (entry, above) in target.iter_mut().zip(&row) {
                *entry = *entry - factor * *above;
            }
            let value = at(&x, below) - factor * at(&x, pivot);
            put(&mut x, below, value);
        }
    }
    for place in 0..ROWS {
        let value = match left.get(place) {
            Some(row) if held(place) => at(&x, place) / at(row, place),
            _ => R::ZERO,
        };
        put(&mut x, place, value);
    }
    Some(x)
}
