//! Texts of the messages about the range of motion: what is wrong, why, with numbers, and what to write instead.

use super::efforts::{Least, Moment};
use super::{End, Motion, Range, Singular, Unswept};
use crate::check::messages::list;
use crate::equations::conditions;
use crate::model::{Coordinate, EffortBound, Mechanism, Side, Within};
use crate::numbers::{coordinate, significant};

pub fn unswept(why: Unswept) -> String {
    match why {
        Unswept::InSpace => {
            "the range of motion is not there yet for spatial mechanisms: leave this out of `expect`"
                .to_string()
        }
        Unswept::Freedoms(0) => {
            "nothing can be expected of the motion: the mechanism has no degree of freedom".to_string()
        }
        Unswept::Freedoms(freedoms) => format!(
            "the range of motion is there for mechanisms with one degree of freedom, and this one has {freedoms}: more are \
             not there yet. Leave this out of `expect`, or join what else moves"
        ),
        Unswept::NoDirection => {
            "the motion cannot be followed: no direction was found in which it leaves the start".to_string()
        }
    }
}

/// `links`: of the four-bar that the joint belongs to.
pub fn turns_back(
    name: &str,
    range: &Range,
    in_line: &[&[String]],
    links: Option<[(String, f64); 4]>,
) -> String {
    let (from, to) = (degrees(range.from), degrees(range.to));
    let mut text = format!("expected {name} to turn fully, but it moves between {from} and {to} deg");
    let lines: Vec<String> = in_line.iter().map(|links| format!("{} in line", list(links))).collect();
    if lines.is_empty() {
        text += ": dead centres there";
    } else {
        text += &format!(": dead centres there ({})", lines.join("; "));
    }
    if let Some(links) = links {
        text += &format!(". {}", grashof(&links));
    }
    text
}

/// How a coordinate leaves a range.
pub struct Outside<'r> {
    /// At the lower end.
    pub low: bool,
    /// The range that it goes through, SI.
    pub from: f64,
    pub to: f64,
    pub turns: bool,
    pub unlimited: bool,
    /// The coordinate by which positions are told, and its value where the range is left furthest.
    pub at: Option<(&'r Range, f64)>,
}

pub fn leaves_range(expected: &Within, outside: &Outside) -> String {
    let (unit, scale) = (&expected.unit.0, expected.unit.1);
    let (least, most) = (significant(expected.from / scale, 9), significant(expected.to / scale, 9));
    let mut text = format!("expected {} in {least}..{most} {unit}, ", expected.text);
    if outside.turns {
        return text + "but it turns fully; write `rotates` for its joint if that is meant";
    }
    if outside.unlimited {
        return text + "but nothing limits it; leave this out of `expect`, or add what stops it";
    }
    let (from, to) = (outside.from / scale, outside.to / scale);
    if to - from <= 1e-9 * from.abs() {
        return text + &format!("but it stays at {} {unit}", number(from));
    }
    text += &format!("but it moves between {} and {} {unit}", number(from), number(to));
    if let Some((reference, value)) = outside.at {
        let what = if outside.low { "least" } else { "most" };
        text += &format!(", {what} at {}", position(reference, value));
    }
    let step = 10f64.powf((to - from).log10().floor() - 1.0);
    let (low, high) = ((from / step).floor() * step, (to / step).ceil() * step);
    let range = format!("{} in {}..{} [{unit}]", expected.text, significant(low, 9), significant(high, 9));
    text + &format!("; write `{range}` if that is meant, or change the lengths")
}

pub fn singular_on_the_way(
    singular: &Singular,
    reference: &Range,
    links: Option<[(String, f64); 4]>,
) -> String {
    let why = if singular.in_line.is_empty() {
        let lost: Vec<String> = singular.lost.iter().map(|of| format!("\"{of}\"")).collect();
        format!("singular position: equations of {} repeat the others", list(&lost))
    } else {
        format!("change point: {} in line", list(&singular.in_line))
    };
    let mut text = format!(
        "expected no singular position, but at {} the constraints lose rank ({why}): another motion branches off there, and \
         reactions are undetermined",
        position(reference, singular.reference)
    );
    if let Some(links) = links {
        text += &format!(". {}", grashof(&links));
    }
    text
}

pub fn undecided(expectation: &str, motion: &Motion) -> String {
    let why = match motion.end {
        End::Closed => "the motion was followed to its end".to_string(),
        End::Unlimited => "a travel has no limit".to_string(),
        End::Bounded => format!("after {} steps the motion is not back at its start", motion.steps),
        End::Stuck => "the motion could not be followed through a singular position".to_string(),
    };
    format!("`{expectation}` could not be decided: {why}; leave it out of `expect`")
}

/// Why efforts cannot be followed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unfollowed {
    /// That no driver fixes.
    Freedoms(usize),
    /// By reactions, on which it depends how the mechanism is pressed.
    Friction,
    NoStart,
}

pub fn unfollowed(name: &str, why: Unfollowed) -> String {
    let why = match why {
        Unfollowed::Freedoms(left) => format!(
            "drivers leave {left} of the degrees of freedom, whose motion depends on the forces. Drive these too, or leave this out of `expect`"
        ),
        Unfollowed::Friction => {
            "friction by reactions is not there yet along a driven motion. Leave this out of `expect`".to_string()
        }
        Unfollowed::NoStart => {
            "at the start the drivers do not fix the motion: it is a singular position. Let the law of a driver begin elsewhere".to_string()
        }
    };
    format!("`{name}` cannot be followed along the motion: {why}, and watch it as an output")
}

pub fn walk_without_end(name: &str, instants: usize) -> String {
    format!(
        "whether `{name}` stays beyond its bound could not be decided: it does so at {instants} positions, and the mechanism is not back where it \
         began, as fast as there; give its drivers periodic laws, or leave this out of `expect`"
    )
}

pub fn walk_that_stops(name: &str, time: f64) -> String {
    format!(
        "whether `{name}` stays beyond its bound could not be decided: after {} s there is no position that the drivers ask for; give them laws \
         that the mechanism can follow, or leave this out of `expect`",
        number(time)
    )
}

pub fn beyond_bound(mechanism: &Mechanism, bound: &EffortBound, least: &Least) -> String {
    let EffortBound { text, unit, .. } = bound;
    let sign = if bound.side == Side::Above { '>' } else { '<' };
    let driver = &mechanism.drivers[0];
    let driven = conditions::name(mechanism, &driver.coordinate);
    let (of_position, of_rate) = units_of(&driver.coordinate);
    let at = |moment: &Moment| {
        let place = if of_position == "deg" {
            // At 360 deg it is where it is at none.
            number(moment.position.to_degrees().rem_euclid(360.0))
        } else {
            number(moment.position)
        };
        format!("{driven} = {place} {of_position}")
    };
    let found = format!(
        "expected {text} {sign} {} {unit}, but it is {} {unit} at {}, where `{}` goes at {} {of_rate}",
        number(bound.bound),
        number(least.value),
        at(&least.at),
        driver.name.text,
        number(least.at.rate)
    );
    let advice = match bound.side {
        Side::Above => {
            "drive slower, move less mass, or let more press, such as a stiffer spring or more preload"
        }
        Side::Below => "drive slower, or move less mass",
    };
    match &least.fails {
        Some((sigma, moment)) if *sigma > 0.0 => {
            let share = if (moment.rate - least.at.rate).abs() <= 1e-9 * moment.rate.abs() {
                format!("{} {of_rate}", significant(sigma * moment.rate, 6))
            } else {
                format!("{} of that speed", significant(*sigma, 6))
            };
            format!(
                "{found}. Slower than {share} it is so all along, and then fails first at {}: {advice}",
                at(moment)
            )
        }
        _ => format!(
            "{found}. It is not so at rest either, so that no lower speed helps: let other forces act"
        ),
    }
}

fn units_of(coordinate: &Coordinate) -> (&'static str, &'static str) {
    match coordinate {
        Coordinate::Angle(_) => ("deg", "rad/s"),
        _ => ("m", "m/s"),
    }
}

/// The rule of Grashof on four links.
fn grashof(links: &[(String, f64); 4]) -> String {
    let mut sorted: Vec<&(String, f64)> = links.iter().collect();
    sorted.sort_by(|a, b| a.1.total_cmp(&b.1));
    let (ends, middle) = (sorted[0].1 + sorted[3].1, sorted[1].1 + sorted[2].1);
    let sums =
        format!("Shortest + longest link = {} m, the other two = {} m: ", number(ends), number(middle));
    let verdict = if (ends - middle).abs() <= 1e-9 * middle {
        "at this limit all links can lie in one line; change one of them".to_string()
    } else if ends > middle {
        format!(
            "by Grashof's rule no link turns fully against another; shorten \"{}\" or \"{}\"",
            sorted[0].0, sorted[3].0
        )
    } else {
        format!(
            "by Grashof's rule only the shortest link, \"{}\", turns fully against the others",
            sorted[0].0
        )
    };
    sums + &verdict
}

/// `crank_pin.angle = 31.2 deg`
fn position(reference: &Range, value: f64) -> String {
    let value =
        if reference.angular { format!("{} deg", degrees(value)) } else { format!("{} m", number(value)) };
    format!("{} = {value}", reference.of)
}

fn degrees(angle: f64) -> String {
    format!("{:.1}", angle.to_degrees())
}

/// As the results of a sweep are known.
fn number(value: f64) -> String {
    coordinate(value, 4)
}
