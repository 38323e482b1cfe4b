//! Texts about names: of values, places, lines and quantities, and what may depend on them.

use super::{closest, is_ground, other_value};
use crate::forms::Space;

// ---- Names -----------------------------------------------------------------------------------------------------------

pub(crate) fn duplicate(name: &str, first: &str) -> String {
    if name == first {
        return format!("`{name}` is declared twice; rename one of them");
    }
    format!("`{name}` and `{first}` become the same name in Rust; rename one of them")
}

pub(crate) fn keyword(word: &str) -> String {
    format!("`{word}` is a word of Rust and cannot be a name; choose another")
}

pub(crate) fn reserved(word: &str) -> String {
    format!("`{word}` has a meaning of its own here; choose another name")
}

/// `kind` is what was looked for: a body, a joint, a value.
pub(crate) fn unknown(kind: &str, name: &str, similar: Option<&str>) -> String {
    let foreign = match kind {
        "value" => other_value(name).map(str::to_string),
        "body" if is_ground(name) => Some("the ground is written with a place, `ground(0, 0)`".to_string()),
        _ => None,
    };
    match (foreign, similar) {
        (Some(advice), _) => format!("no {kind} called \"{name}\"; {advice}"),
        (None, Some(similar)) => format!("no {kind} called \"{name}\"; did you mean \"{similar}\"?"),
        (None, None) => format!("no {kind} called \"{name}\""),
    }
}

pub(crate) fn other_kind(name: &str, kind: &str, expected: &str) -> String {
    format!("`{name}` is {kind}, expected the name of a {expected}")
}

pub(crate) fn such_as(message: &str, name: &str) -> String {
    format!("{message}, such as `{name}`")
}

/// `first` and `last` are names with indices, as `name` is.
pub(crate) fn unknown_index(name: &str, first: &str, last: &str) -> String {
    format!("no \"{name}\": indices go from \"{first}\" to \"{last}\"")
}

pub(crate) fn declared_by_rounds(name: &str) -> String {
    format!("every round of `repeat` declares `{name}`: give it the index of the round, such as `{name}[i]`")
}

/// `cycle`: each is defined by the next, the last by the first.
pub(crate) fn cyclic_constants(cycle: &[&str]) -> String {
    const MOST: usize = 8;
    let named = |name: &&str| format!("`{name}`");
    match cycle {
        [] => String::new(),
        [only] => format!("the constant `{only}` is defined by itself: give it a value"),
        [first, rest @ ..] => {
            let mut way: Vec<String> = rest.iter().take(MOST).map(named).collect();
            if rest.len() > MOST {
                way.push(format!("{} more", rest.len() - MOST));
            }
            way.push(named(first));
            format!(
                "the constants stand in a circle: `{first}` is defined by {}. Give one of them a value",
                way.join(", that by ")
            )
        }
    }
}

// ---- Places ----------------------------------------------------------------------------------------------------------

pub(crate) fn unknown_point(body: &str, point: &str, known: &[&str]) -> String {
    match closest(point, known.iter().copied()) {
        Some(similar) => format!("`{body}` has no point called \"{point}\"; did you mean \"{similar}\"?"),
        None => format!("`{body}` has no point called \"{point}\"; it has {}", known.join(", ")),
    }
}

pub(crate) fn body_as_place(body: &str) -> String {
    format!("a place is a point of a body: write `{body}.center` or another point of it")
}

pub(crate) fn not_a_place_name(name: &str) -> String {
    format!("`{name}` is not a place: a place is written `body.point`")
}

pub(crate) fn no_places(name: &str, kind: &str) -> String {
    format!("`{name}` is {kind} and has no points; places belong to bodies or to the ground")
}

pub(crate) fn point_without_body(body: &str, point: &str) -> String {
    format!("a place is written with its body: `{body}.{point}`")
}

pub(crate) fn line_leaves_body(place: &str, body: &str) -> String {
    format!("a line of `{body}` goes through two places of `{body}`, but `{place}` is none of them")
}

pub(crate) fn line_between_bodies(from: &str, to: &str) -> String {
    format!("a line goes through two places of one body, but `{from}` and `{to}` belong to different ones")
}

pub(crate) fn line_outside_body() -> String {
    "a line of a body stands inside the braces of the body; out here lines go through places of the ground"
        .to_string()
}

pub(crate) fn unknown_line(body: &str, name: &str, is_point: bool, known: &[&str]) -> String {
    if is_point {
        return format!(
            "`{body}.{name}` is a point; the first argument is a line, such as `line({body}.{name}, …)`"
        );
    }
    match (closest(name, known.iter().copied()), known.is_empty()) {
        (Some(similar), _) => format!("`{body}` has no line called \"{name}\"; did you mean \"{similar}\"?"),
        (None, true) => format!("`{body}` has no line: declare `line {name} = (…, …);` in its braces"),
        (None, false) => format!("`{body}` has no line called \"{name}\"; it has {}", known.join(", ")),
    }
}

pub(crate) fn line_comes_first(line: &str, place: &str) -> String {
    format!("the line comes first and then the point on it: write `point_on_line({line}, {place})`")
}

pub(crate) fn not_a_line(name: &str, kind: &str) -> String {
    format!("`{name}` is {kind}, expected a line such as `{name}.slot` or `line(place, place)`")
}

pub(crate) fn shape_has_point(shape: &str, end: &str) -> String {
    format!("a {shape} has a point `{end}` of its own; choose another name")
}

// ---- Quantities ------------------------------------------------------------------------------------------------------

pub(crate) fn joint_has_none(joint: &str, kind: &str, asked: &str, instead: &str) -> String {
    format!(
        "the {kind} joint `{joint}` has no {asked}: it has no coordinate at all; use {instead} or a place"
    )
}

pub(crate) fn joint_has(joint: &str, kind: &str, asked: &str, quantities: &[&str]) -> String {
    let reaction = match asked {
        "force" | "load" | "reactions" => {
            format!(", and what it carries is `{joint}.reaction.x`, `.y` or `.size`, in outputs")
        }
        _ => String::new(),
    };
    format!("the {kind} joint `{joint}` has no {asked}; it has {}{reaction}", quantities.join(", "))
}

pub(crate) fn joint_of_particle(joint: &str, asked: &str) -> String {
    format!("`{joint}` has no {asked}: one of its two bodies is a particle, which has no orientation")
}

/// `resists`: whether it says with what.
pub(crate) fn quantity_of_load(load: &str, effort: Option<&str>) -> String {
    if let Some(effort) = effort {
        return format!("`{load}` has the quantity `{load}.{effort}`, and its power is `power({load})`");
    }
    format!("a load has no quantities but its power: write `power({load})`")
}

pub(crate) fn no_quantities(name: &str, kind: &str) -> String {
    format!("`{name}` is {kind} and has no quantities")
}

/// Where an angle, a travel, a position or a rate is asked for: at the start, or of a driver.
pub(crate) fn value_as_quantity(name: &str, kind: &str) -> String {
    let stands = match kind {
        "a memory" => {
            format!("starts with the number that it is declared with, `memory {name} [unit] = value;`")
        }
        "a state" => {
            format!("starts with the number that it is declared with, `state {name} [unit] = value;`")
        }
        "a parameter" => format!("has the default that it is declared with, `param {name} [unit] = value;`"),
        "an input" => "is given from outside, at each instant".to_string(),
        _ => "has the value that it is declared with".to_string(),
    };
    format!("`{name}` is {kind} and {stands}: only angles, travels, positions and their rates can stand here")
}

pub(crate) fn part_as_value(name: &str, kind: &str) -> String {
    let example = match kind {
        "a body" => format!("`{name}.angle` or `{name}.center.x`"),
        "a load" => format!("`power({name})`"),
        "a driver" => format!("`{name}.effort`"),
        _ => return format!("`{name}` is {kind}, expected a value"),
    };
    format!("`{name}` is {kind}, expected a value such as {example}")
}

/// `coordinates`: angles and travels of the joint.
pub(crate) fn joint_as_value(name: &str, coordinates: &[&str]) -> String {
    let written: Vec<String> =
        coordinates.iter().map(|coordinate| format!("`{name}.{coordinate}`")).collect();
    match written.is_empty() {
        true => format!("`{name}` is a joint without coordinates, expected a value"),
        false => format!("`{name}` is a joint, expected a value: write {}", written.join(" or ")),
    }
}

pub(crate) fn place_without_axis(place: &str, space: Space) -> String {
    let third = if space == Space::Planar { String::new() } else { format!(", `{place}.z`") };
    format!(
        "`{place}` is a place, expected a value: write `{place}.x`, `{place}.y`{third} or `{place}.velocity.x`"
    )
}

pub(crate) fn quantities_of_place(place: &str, space: Space) -> String {
    match space {
        Space::Planar => format!("the place `{place}` has x, y, velocity.x and velocity.y"),
        Space::Spatial => {
            format!("the place `{place}` has x, y, z, velocity.x, velocity.y and velocity.z, in world axes")
        }
    }
}

pub(crate) fn quantities_of_driver(driver: &str) -> String {
    format!("the driver `{driver}` has effort and power")
}

pub(crate) fn quantities_of_equation(constraint: &str) -> String {
    format!("the constraint `{constraint}` has an effort")
}

pub(crate) fn parts_of_reaction(joint: &str, parts: &[&str]) -> String {
    let parts: Vec<String> = parts.iter().map(|part| format!("`{joint}.reaction.{part}`")).collect();
    format!("a reaction is named by its parts: {}", parts.join(", "))
}

pub(crate) fn power_of_what() -> String {
    "`power` takes the name of a load".to_string()
}

pub(crate) fn power_of_driver(driver: &str) -> String {
    format!("the power of a driver is written `{driver}.power`")
}

pub(crate) fn not_a_position(name: &str, verb: &str) -> String {
    let hint = match verb {
        "be driven" => "; a rate is driven through its angle or travel, such as `angle = 3 [rad/s]*time`",
        _ => "",
    };
    format!("`{name}` cannot {verb}: only an angle, a travel or a position can{hint}")
}

pub(crate) fn not_a_state(name: &str) -> String {
    format!("`{name}` cannot be given at the start: only angles, travels, positions and their rates can")
}

pub(crate) fn guessed_rate(name: &str) -> String {
    format!(
        "`{name}` cannot be guessed: write `=` for a rate that is to be met, or leave it out; rates that are not stated \
         are those of least kinetic energy"
    )
}

pub(crate) fn distance_in_one_body() -> String {
    "the distance of two places of one body never changes".to_string()
}

/// `what` may depend on constants and on the things that are `permitted`.
pub(crate) fn not_permitted(name: &str, kind: &str, what: &str, permitted: &[&str]) -> String {
    format!("`{name}` is {kind}, but {what} may depend on {} only", listed(permitted))
}

/// Constants, and what else is permitted.
fn listed(permitted: &[&str]) -> String {
    match permitted.split_last() {
        None => "constants".to_string(),
        Some((last, others)) => format!("{} and {last}", [&["constants"], others].concat().join(", ")),
    }
}

pub(crate) fn signal_not_permitted(name: &str, kind: &str, what: &str, permitted: &[&str]) -> String {
    format!("`{name}` depends on {kind}, but {what} may depend on {} only", listed(permitted))
}

/// `names`: from the signal to itself again.
pub(crate) fn signal_of_itself(names: &[&str]) -> String {
    match names {
        [name, _] => format!("the signal `{name}` names itself"),
        _ => format!("the signal `{}` names itself: {}", names[0], names.join(" → ")),
    }
}

pub(crate) fn signal_too_large(name: &str, size: usize) -> String {
    format!(
        "the signal `{name}` is {size} operations long where all signals in it are written out: make what it names shorter"
    )
}
