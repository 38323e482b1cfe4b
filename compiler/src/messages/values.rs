//! Texts about values: dimensions, functions.

use super::{closest, number, other_function};
use crate::units::Dimension;
use std::f64::consts::TAU;

// ---- Dimensions ------------------------------------------------------------------------------------------------------

/// What the unit of a frequency is meant to say where an angular rate is expected.
fn rate_hint(expected: Dimension, found: Dimension) -> &'static str {
    if expected.fits(Dimension::ANGULAR_RATE) && found.is_frequency() { "; write rad/s or rpm" } else { "" }
}

pub(crate) fn wrong_unit(what: &str, expected: Dimension, found: Dimension) -> String {
    let hint = rate_hint(expected, found);
    format!("{what} is given {}: expected {expected}, found {found}{hint}", found.kind())
}

/// `value`: where it is known.
pub(crate) fn wrong_dimension(
    what: &str,
    expected: Dimension,
    found: Dimension,
    value: Option<f64>,
) -> String {
    if found == Dimension::ONE {
        let advice = unit_advice(expected, value);
        return format!("{what} is given a plain number: expected {expected}; write {advice}");
    }
    wrong_unit(what, expected, found)
}

/// How a value gets its unit: digits by brackets, all else by a factor. Angles beyond a turn are hardly meant in radians.
fn unit_advice(unit: Dimension, value: Option<f64>) -> String {
    match value {
        Some(value) if unit == Dimension::ANGLE && value.abs() > TAU => {
            format!("the unit, as in `{} [deg]`", number(value))
        }
        Some(value) => format!("the unit, as in `{} [{unit}]`", number(value)),
        None => format!("its unit as a factor, `… * 1 [{unit}]`"),
    }
}

/// A declaration without a unit, whose value has one.
pub(crate) fn unit_left_out(kind: &str, name: &str, found: Dimension) -> String {
    format!(
        "`{name}` is declared without a unit, as a plain number, and is given {}: write `{kind} {name} [{found}] = …`",
        found.kind()
    )
}

/// `value`: the number that lacks a unit, where it is written.
pub(crate) fn different_dimensions(
    what: &str,
    left: Dimension,
    right: Dimension,
    value: Option<f64>,
) -> String {
    let (left_one, right_one) = (left == Dimension::ONE, right == Dimension::ONE);
    if left_one != right_one {
        let other = if left_one { right } else { left };
        let advice = unit_advice(other, value);
        return format!("{what} do not fit: a plain number meets {}; write {advice}", other.kind());
    }
    let hint =
        if rate_hint(left, right).is_empty() { rate_hint(right, left) } else { rate_hint(left, right) };
    format!("{what} do not fit: {} ({left}) meets {} ({right}){hint}", left.kind(), right.kind())
}

pub(crate) fn not_bare(found: Dimension, unit: &str) -> String {
    format!(
        "the value is {} in {found} already and would be converted a second time by [{unit}]; write [{found}]",
        found.kind()
    )
}

pub(crate) fn no_vector(function: &str) -> String {
    format!(
        "`{function}` takes vectors: places and their velocities, sums of these, and products with numbers, such as `a.end - b.start`"
    )
}

pub(crate) fn product_of_vectors() -> String {
    "two vectors meet in a product: write `dot(a, b)` or `cross(a, b)`".to_string()
}

pub(crate) fn cross_is_a_vector() -> String {
    "the cross product of vectors in space is a vector: write `dot(cross(a, b), c)`, or `norm(cross(a, b))`"
        .to_string()
}

pub(crate) fn exponent() -> String {
    "an exponent must be a number known here; for others write `exp(b*ln(a))`".to_string()
}

pub(crate) fn power_of_dimension(dimension: Dimension, exponent: f64) -> String {
    format!("{} to the power {exponent} has no unit", dimension.kind())
}

/// A name of the user's at the beginning of a message.
pub(crate) fn quoted(name: &str) -> String {
    format!("`{name}`")
}

// ---- Values ----------------------------------------------------------------------------------------------------------

pub(crate) fn not_constant(what: &str) -> String {
    format!("the value of {what} must be known at expansion")
}

pub(crate) fn out_of_range(value: f64, least: f64, most: f64) -> String {
    format!(
        "{value:e} (SI units) is out of range: a value is 0 or its magnitude lies between {least:e} and {most:e}; check its \
         exponent and its unit"
    )
}

pub(crate) fn place_not_known_yet(place: &str) -> String {
    format!("`{place}` is not known here: bodies are placed after their own points and lines are read")
}

pub(crate) fn not_finite(value: f64) -> String {
    let why = if value.is_nan() { "it is not defined" } else { "it is infinite" };
    format!("this has no value: {why}")
}

pub(crate) fn place_as_value() -> String {
    "a place is no value; `distance(a.p, ground(0, 0))` is one".to_string()
}

pub(crate) fn value_as_place() -> String {
    "expected a place: `body.point` or `ground(x, y) [m]`".to_string()
}

pub(crate) fn condition_as_value() -> String {
    "a condition is no value: write `if(condition, value, other)`".to_string()
}

pub(crate) fn value_as_condition() -> String {
    "expected a condition, such as `a < b`".to_string()
}

pub(crate) fn unknown_function<'a>(name: &str, known: impl Iterator<Item = &'a str>) -> String {
    match (other_function(name), closest(name, known)) {
        (Some(advice), _) => format!("no function called \"{name}\"; {advice}"),
        (None, Some(similar)) => format!("no function called \"{name}\"; did you mean \"{similar}\"?"),
        (None, None) => format!("no function called \"{name}\""),
    }
}

pub(crate) fn arguments(name: &str, expected: &[usize], found: usize) -> String {
    let counts = expected.iter().map(ToString::to_string).collect::<Vec<_>>().join(" or ");
    format!("`{name}` takes {counts} argument{}, found {found}", if expected == [1] { "" } else { "s" })
}

/// What is wrong with arguments, as far as they are numbers.
pub(crate) fn impossible_arguments(name: &str, numbers: &[Option<f64>]) -> Option<String> {
    match (name, numbers) {
        ("clamp", [_, Some(least), Some(most)]) if least > most => {
            Some("the least value is above the largest: `clamp(x, least, most)`".to_string())
        }
        ("smoothstep", [_, Some(from), Some(to)]) if from == to => Some(
            "the step has no width: `smoothstep(x, from, to)` goes from 0 to 1 between the two".to_string(),
        ),
        ("deadband", [_, Some(half)]) if *half < 0.0 => {
            Some("the band is negative: `deadband(x, half)` is zero from −half to half".to_string())
        }
        ("wrap", [_, Some(period)]) if *period <= 0.0 => {
            Some("a period is positive: `wrap(x, period)` is x less whole periods".to_string())
        }
        _ => None,
    }
}
