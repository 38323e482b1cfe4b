//! Texts of the messages about the range of motion: what is wrong, why, with numbers, and what to write instead.

use super::{End, Motion, Range, Singular, Unswept};
use crate::check::messages::list;
use crate::model::Within;
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
