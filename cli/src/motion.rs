//! The range of motion, in words: what each joint goes through, where it turns back and where the input is then, where the constraints
//! lose rank, time ratios and transmission angles; how near forces come to their bounds.

use crate::text;
use linkwright_compiler::Compiled;
use linkwright_compiler::check::motion::{End, Least, Linkage, Moment, Motion, Range, Unswept};
use linkwright_compiler::model::{EffortBound, Side};
use std::f64::consts::TAU;

/// One line for each thing found; of mechanisms that cannot be followed, why.
pub fn motion(compiled: &Compiled) -> Vec<String> {
    let mut lines = of_linkage(compiled);
    let bounds = &compiled.mechanism.expect.motion.efforts;
    lines.extend(bounds.iter().zip(compiled.efforts()).map(|(bound, least)| effort(compiled, bound, &least)));
    lines
}

/// `follow.force is 60.2341 N where it is least, at shaft.angle = 90 deg; 1.70835 times as fast it is 0 N`
fn effort(compiled: &Compiled, bound: &EffortBound, least: &Least) -> String {
    let (condition, _) = &compiled.complete.equations.driven[0];
    let at = |moment: &Moment| {
        let position = if condition.angular { moment.position.rem_euclid(TAU) } else { moment.position };
        format!("at {} = {}", condition.of, number(position, condition.angular))
    };
    let what = if bound.side == Side::Above { "least" } else { "most" };
    let EffortBound { text, unit, .. } = bound;
    let line =
        format!("{text} is {} {unit} where it is {what}, {}", text::number(least.value), at(&least.at));
    match &least.fails {
        Some((faster, moment)) => format!(
            "{line}; {} times as fast as driven it is {} {unit} {}",
            text::number(*faster),
            text::number(bound.bound),
            at(moment)
        ),
        None => line,
    }
}

fn of_linkage(compiled: &Compiled) -> Vec<String> {
    match compiled.linkage() {
        Ok((motion, linkage)) => found(&motion, &linkage),
        Err(Unswept::InSpace) => vec!["found for planar mechanisms only".to_string()],
        Err(Unswept::Freedoms(count)) => {
            vec![format!("found for one degree of freedom only, and there are {count}")]
        }
        Err(Unswept::NoDirection) => vec!["no direction of motion was found at the start".to_string()],
    }
}

fn found(motion: &Motion, linkage: &Linkage) -> Vec<String> {
    let reference = &motion.ranges[motion.reference];
    let at = |value: f64| format!("at {} = {}", reference.of, number(value, reference.angular));
    let told = |index: usize, value: f64| {
        let range = &motion.ranges[index];
        format!("at {} = {}", range.of, number(value, range.angular))
    };
    let input = linkage.input.unwrap_or(motion.reference);
    let mut lines: Vec<String> = motion.ranges.iter().map(range).collect();
    for limit in &motion.limits {
        let of = &motion.ranges[limit.of];
        let line = in_line(&limit.in_line);
        // Where the input itself turns back another coordinate tells the position.
        let by = if limit.of == input { beside(motion, input) } else { input };
        let place = if by == limit.of { String::new() } else { format!(", {}", told(by, limit.values[by])) };
        lines.push(format!("{} turns back at {}{line}{place}", of.of, number(limit.value, of.angular)));
    }
    for ratio in &linkage.ratios {
        let of = &motion.ranges[ratio.of];
        lines.push(format!("{} has the time ratio {}", of.of, text::number(rounded(ratio.ratio))));
    }
    for transmission in &linkage.transmissions {
        let [least, most] = [transmission.least, transmission.most].map(transmitted);
        let [at_least, at_most] = transmission.at.map(|value| {
            // Beside an extremum the sine is flat.
            let range = &motion.ranges[input];
            let value = if range.angular { transmitted(value) } else { number(value, false) };
            format!("at {} = {value}", range.of)
        });
        lines.push(format!(
            "transmission angle from {} to {}: {least} {at_least}, to {most} {at_most}",
            transmission.link, transmission.driven
        ));
    }
    for singular in &motion.singular {
        lines.push(format!("change point {}{}", at(singular.reference), in_line(&singular.in_line)));
    }
    lines.push(match motion.end {
        End::Closed => "it returns to the start".to_string(),
        End::Unlimited => "a travel has no limit".to_string(),
        End::Bounded => {
            format!("not at the start again after {} steps: ranges are those up to there", motion.steps)
        }
        End::Stuck => {
            "it cannot be followed through its last position: ranges are those up to there".to_string()
        }
    });
    lines
}

/// Another coordinate than the input: one that does not turn back there for the same reason, the last of them.
fn beside(motion: &Motion, input: usize) -> usize {
    (0..motion.ranges.len()).rev().find(|index| *index != input).unwrap_or(input)
}

fn rounded(value: f64) -> f64 {
    (value * 1e9).round() / 1e9
}

/// To four places: at an extremum of its sine an angle is known by the root of what the sine is.
fn transmitted(angle: f64) -> String {
    format!("{} deg", text::number((angle.to_degrees() * 1e4).round() / 1e4 + 0.0))
}

fn range(range: &Range) -> String {
    if range.turns {
        return format!("{} turns fully", range.of);
    }
    let unit = if range.angular { "deg" } else { "m" };
    let [from, to] = [range.from, range.to].map(|value| plain(value, range.angular));
    format!("{} from {from} to {to} {unit}", range.of)
}

fn in_line(links: &[String]) -> String {
    if links.is_empty() { String::new() } else { format!(", {} in line", links.join(" and ")) }
}

fn number(value: f64, angular: bool) -> String {
    format!("{} {}", plain(value, angular), if angular { "deg" } else { "m" })
}

/// Degrees and metres to six digits, and to no more places than following the motion is good for.
fn plain(value: f64, angular: bool) -> String {
    let value = if angular { value.to_degrees() } else { value };
    text::number(rounded(value))
}
