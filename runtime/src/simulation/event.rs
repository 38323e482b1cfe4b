//! Events: named outputs that cross a level.

use crate::error::{SettingError, SimulationError};
use crate::fields::Fields;
use crate::formulation::positive;
use crate::real::Real;
use crate::vector::Vector;

/// The most events that are watched at once.
const MOST: usize = 64;

/// An output that crosses a level, for [`Simulation::run_until_event`](crate::Simulation::run_until_event).
///
/// ```text
/// let lifted = Event::of("stroke").level(0.1).rising().tolerance(1e-9);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Event<R = f64> {
    /// The output's name in the definition.
    pub output: &'static str,
    /// The level, in the output's own SI unit.
    pub level: R,
    /// Which crossings count.
    pub direction: Direction,
    /// How far the time found may lie after the crossing, s.
    pub tolerance: R,
}

/// Which crossings of a level count.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Direction {
    /// From below the level.
    Rising,
    /// From above the level.
    Falling,
    /// Both.
    #[default]
    Either,
}

impl<R: Real> Event<R> {
    /// The output named `output` crosses zero, in either direction, found to 1e-9 s.
    pub fn of(output: &'static str) -> Self {
        Event { output, level: R::ZERO, direction: Direction::Either, tolerance: R::from_f64(1e-9) }
    }

    /// Crosses this level, in the output's own SI unit. Angles count on over several turns, as in samples.
    pub fn level(self, level: R) -> Self {
        Event { level, ..self }
    }

    /// Only from below.
    pub fn rising(self) -> Self {
        Event { direction: Direction::Rising, ..self }
    }

    /// Only from above.
    pub fn falling(self) -> Self {
        Event { direction: Direction::Falling, ..self }
    }

    /// In both directions, as without a word.
    pub fn either(self) -> Self {
        Event { direction: Direction::Either, ..self }
    }

    /// How far the time found may lie after the crossing, s; what is less than four roundings of the step is that. The
    /// time that is told of it is rounded as times are.
    pub fn tolerance(self, seconds: R) -> Self {
        Event { tolerance: seconds, ..self }
    }

    /// Output − level; NaN for a name that does not exist.
    fn value<O: Fields<R>>(&self, names: &[&str], outputs: &O) -> R {
        let values = outputs.to_array();
        let value = index(names, self.output).and_then(|index| values.as_slice().get(index).copied());
        value.map_or(R::from_f64(f64::NAN), |value| value - self.level)
    }
}

/// An event that happened. The simulation stands at it: at most [`Event::tolerance`] after the crossing, on its far side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Occurrence<R = f64> {
    /// The index of the event among those given; if several are within one tolerance, the earliest by linear interpolation.
    pub event: usize,
    /// The output's name.
    pub output: &'static str,
    /// The time at which the simulation stands, s: the exact one, rounded once.
    pub time: R,
    /// Whether the output rose.
    pub rising: bool,
    /// One bit for each of the given events.
    crossed: u64,
}

impl<R> Occurrence<R> {
    /// Whether the given event of this index happened too, within the tolerance. It will not be found again when the
    /// simulation goes on.
    pub fn includes(&self, event: usize) -> bool {
        event < MOST && self.crossed >> event & 1 == 1
    }
}

/// The events of one run, checked.
pub(super) struct Watched<'e, R> {
    events: &'e [Event<R>],
    /// The names of the outputs.
    names: &'static [&'static str],
    /// The least of their tolerances, s.
    pub tolerance: R,
}

impl<'e, R: Real> Watched<'e, R> {
    /// The first mistake in the events, if there is one.
    pub fn new(events: &'e [Event<R>], names: &'static [&'static str]) -> Result<Self, SimulationError> {
        if events.len() > MOST {
            let value = events.len() as f64;
            return Err(SettingError { what: "the number of events", value, must_be: "at most 64" }.into());
        }
        let mut least = None;
        for event in events {
            if index(names, event.output).is_none() {
                let (name, known) = (event.output, names);
                let nearest = nearest(name, known);
                return Err(SimulationError::NoSuchOutput { name, known, nearest });
            }
            positive("the tolerance of an event", event.tolerance, "positive and finite (s), such as 1e-9")?;
            if !event.level.is_finite() {
                let (what, value) = ("the level of an event", event.level.to_f64());
                return Err(SettingError { what, value, must_be: "finite" }.into());
            }
            least = Some(least.map_or(event.tolerance, |least| event.tolerance.min(least)));
        }
        Ok(Watched { events, names, tolerance: least.unwrap_or(R::ONE) })
    }

    /// Whether an event lies between two times with these outputs.
    pub fn any<O: Fields<R>>(&self, before: &O, after: &O) -> bool {
        self.crossings(before, after).next().is_some()
    }

    /// The part of the time between at which the first event is to be expected, from 0 to 1.
    pub fn expected<O: Fields<R>>(&self, before: &O, after: &O) -> Option<R> {
        self.crossings(before, after).map(|(_, part, _)| part).reduce(|first, part| part.min(first))
    }

    /// The events between two times, the second of which is `time`.
    pub fn occurrence<O: Fields<R>>(&self, time: R, before: &O, after: &O) -> Option<Occurrence<R>> {
        let crossed = self.crossings(before, after).fold(0, |crossed, (event, ..)| crossed | 1 << event);
        let first = self.crossings(before, after);
        let (event, _, rising) = first.reduce(|first, next| if next.1 < first.1 { next } else { first })?;
        Some(Occurrence { event, output: self.events.get(event)?.output, time, rising, crossed })
    }

    /// Index, linearly interpolated part of the time, and whether the output rose, of each event between.
    fn crossings<O: Fields<R>>(&self, before: &O, after: &O) -> impl Iterator<Item = (usize, R, bool)> {
        self.events.iter().enumerate().filter_map(|(index, event)| {
            let (a, b) = (event.value(self.names, before), event.value(self.names, after));
            // An output that begins at the level has crossed it already; one that ends there crosses now.
            let (rises, falls) = (a < R::ZERO && b >= R::ZERO, a > R::ZERO && b <= R::ZERO);
            let counts = match event.direction {
                Direction::Rising => rises,
                Direction::Falling => falls,
                Direction::Either => rises || falls,
            };
            counts.then(|| (index, a / (a - b), rises))
        })
    }
}

/// The index of an output.
fn index(names: &[&str], name: &str) -> Option<usize> {
    names.iter().position(|known| *known == name)
}

/// The known name with the fewest letters to change, add or leave out, if these are at most a third of the name's.
#[cold]
fn nearest(name: &str, known: &'static [&'static str]) -> Option<&'static str> {
    let (distance, nearest) = known.iter().map(|known| (distance(name, known), *known)).min()?;
    (distance * 3 <= name.len().max(3)).then_some(nearest)
}

/// Levenshtein's distance of two names, by bytes; names beyond 64 bytes are far from all others.
fn distance(a: &str, b: &str) -> usize {
    let mut row = [0; MOST + 1];
    if b.len() > MOST {
        return usize::MAX / 4;
    }
    let row = &mut row[..=b.len()];
    for (j, entry) in row.iter_mut().enumerate() {
        *entry = j;
    }
    for (i, letter) in a.bytes().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, other) in b.bytes().enumerate() {
            let changed = diagonal + usize::from(letter != other);
            diagonal = row[j + 1];
            row[j + 1] = changed.min(row[j] + 1).min(diagonal + 1);
        }
    }
    row[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_name_is_near() {
        const KNOWN: &[&str] = &["stroke", "crank", "rate_x", "rate_y"];
        assert_eq!(nearest("strike", KNOWN), Some("stroke"));
        assert_eq!(nearest("rate", KNOWN), None);
        assert_eq!(nearest("rate_z", KNOWN), Some("rate_x"));
        assert_eq!(nearest("energy", KNOWN), None);
        assert_eq!((nearest("x", &[]), nearest("crnk", KNOWN)), (None, Some("crank")));
        assert_eq!((distance("kitten", "sitting"), distance("", "abc"), distance("abc", "")), (3, 3, 3));
    }
}
