//! Messages about mechanisms for which no position was found that meets all conditions: what stays open, by how much, and
//! what to blame.

use super::{freedoms, list};
use crate::check::assemble::{Blame, Gap};
use crate::messages::number;
use crate::numbers::coordinate;

/// `start` gives more coordinates than there are freedoms: those to keep, and those that could be guesses.
pub struct Overgiven {
    pub freedoms: usize,
    pub keep: Vec<String>,
    pub guess: Vec<String>,
}

fn overgiven(overgiven: &Overgiven) -> String {
    let Overgiven { freedoms: count, keep, guess } = overgiven;
    let quoted = |names: &[String]| list(&names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>());
    let kept = if keep.is_empty() { String::new() } else { format!("keep {} and ", quoted(keep)) };
    format!(
        "`start` gives {} coordinates of a mechanism with {}: {kept}make {} a guess (`~` instead of `=`)",
        keep.len() + guess.len(),
        freedoms(*count),
        quoted(guess)
    )
}

/// The gap that stays open.
pub struct StaysOpen<'a> {
    /// The joint or coupling.
    pub of: &'a str,
    /// The bodies of the loop that it closes.
    pub path: &'a [String],
    pub gap: Gap,
    /// Other loops are kept closed.
    pub with_others: bool,
    /// Positions from which was searched.
    pub searched: usize,
}

impl StaysOpen<'_> {
    /// `"right" is still 0.3 m apart`.
    fn gap(&self) -> String {
        let of = self.of;
        match self.gap {
            Gap::Apart(length) => format!("\"{of}\" is still {} m apart", number(length)),
            Gap::Turned(angle) => {
                format!("\"{of}\" is still {} degrees off its direction", number(angle.to_degrees()))
            }
            Gap::Off(amount) => {
                format!("the two sides of \"{of}\" still differ by {} in SI units", number(amount))
            }
        }
    }

    fn what(&self) -> String {
        match self.path {
            [] => format!("\"{}\"", self.of),
            path => format!("the loop {}", path.join(" - ")),
        }
    }
}

/// The joints alone do not close.
pub fn cannot_close(open: &StaysOpen, blames: &[Blame]) -> String {
    let (what, gap) = (open.what(), open.gap());
    let others = if open.with_others { ", the loops before it kept closed" } else { "" };
    if let Some(Blame::TooLong { link, length, others: rest }) = blames.first() {
        return format!(
            "{what} cannot close: {} is {} m long between its joints, and all others together are {} m; at the nearest \
             position{others} {gap}. Correct a length, or the place of a joint",
            quoted(link),
            number(*length),
            number(*rest)
        );
    }
    let searched = open.searched;
    let mut text = format!(
        "no position was found at which {what} closes, searched from {searched} positions spread over all it can take: at the \
         nearest{others} {gap}."
    );
    for blame in blames {
        text += &match blame {
            Blame::TooLong { .. } => continue,
            Blame::Twisted { link, joints: [a, b], angle } => format!(
                " On {} the axes of \"{a}\" and \"{b}\" are {} degrees off parallel, while others of the loop are parallel: \
                 correct them, or let a joint give way (`spherical`, `universal` or `cylindrical`)",
                quoted(link),
                number(angle.to_degrees())
            ),
            Blame::AxisOfMarker { joint, marker } => format!(
                " The `axis` of \"{joint}\" is read in the axes of its places, those of the marker `{marker}`, and not in \
                 those of the world: leave it out, and it is the marker's z"
            ),
        };
        text += ".";
    }
    if blames.is_empty() {
        text += " Check the lengths and the places of its joints.";
    }
    text.pop();
    text
}

fn quoted(link: &str) -> String {
    if link == "ground" { "the ground".to_string() } else { format!("\"{link}\"") }
}

/// A condition of `start` at the nearest position that closes.
pub struct Missed {
    pub of: String,
    pub stated: f64,
    pub nearest: f64,
    /// `rad`, `m`.
    pub unit: &'static str,
}

/// The joints close, but not with what `start` states: what stays open then, and where it would close.
pub fn cannot_meet_start(
    missed: &[Missed],
    open: Option<&StaysOpen>,
    drivers: Vec<(String, String, f64)>,
    start: Option<&Overgiven>,
) -> String {
    let mut text = match open {
        Some(open) => format!(
            "no position was found that meets all conditions of `start`, searched from {} positions: with them {} does not \
             close, at the nearest {}",
            open.searched,
            open.what(),
            open.gap()
        ),
        None => "no position was found that meets all conditions of `start`".to_string(),
    };
    for (driver, quantity, value) in drivers {
        text +=
            &format!("; the driver \"{driver}\" holds {quantity} at {} at time zero", coordinate(value, 5));
    }
    let nearest = missed.iter().map(|missed| {
        let Missed { of, stated, nearest, unit } = missed;
        format!("{of} at {} {unit} in place of {}", coordinate(*nearest, 5), coordinate(*stated, 5))
    });
    let nearest: Vec<String> = nearest.collect();
    if !nearest.is_empty() {
        text += &format!(". The nearest position without them has {}", list(&nearest));
    }
    match start {
        Some(start) => format!("{text}. {}", overgiven(start)),
        None => text + ". Turn a condition into a guess (`~` instead of `=`), or correct its value",
    }
}

/// The bounded search found neither a position nor a reason.
pub fn cannot_start(searched: usize) -> String {
    format!(
        "no position was found that meets the constraints, searched from {searched} positions, and the bounded search does not \
         suffice to say why: guess more angles in `start`, or check the lengths and places of the joints"
    )
}

/// Of each joint with play: how far its centres are apart, and its clearance.
pub fn loop_beyond_play(joints: &[(&str, (f64, f64))]) -> String {
    let names: Vec<String> = joints.iter().map(|(name, _)| format!("`{name}`")).collect();
    let mm = |of: fn(&(f64, f64)) -> f64| number(1e3 * joints.iter().map(|(_, it)| of(it)).sum::<f64>());
    format!(
        "the loop does not close: where the centres of {} come nearest they stay {} mm apart, of which the play takes up {} mm; change a length, or the play",
        list(&names),
        mm(|it| it.0),
        mm(|it| it.1)
    )
}

/// `reach`: the nearest distance, that without play, and the farthest.
pub fn teeth_out_of_reach([first, second]: [&str; 2], found: f64, reach: [f64; 3]) -> String {
    let mm = |length: f64| number(1e3 * length);
    format!(
        "the teeth of `{first}` and `{second}` do not reach each other at the start, where the centres are {} mm apart: they can touch between {} and {} mm, and \
         without play at {} mm; state in `start` where the wheels are, or move what holds them",
        mm(found),
        mm(reach[0]),
        mm(reach[2]),
        mm(reach[1])
    )
}

pub fn teeth_do_not_meet(gear: &str, apart: f64) -> String {
    format!(
        "the teeth of `{gear}` do not meet at the start: where `start` puts the wheels they are {} of a pitch apart. Leave one of the wheels out of \
         `start`, or write `~` in place of `=`, and it turns to where they meet",
        number(apart.abs())
    )
}
