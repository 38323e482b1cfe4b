//! Texts about how a definition is written: tokens, expressions, indices, statements, settings.

use super::{closest, foreign_statement, other_option};
use crate::units::{self, Dimension, UnitError};

// ---- Tokens and expressions ------------------------------------------------------------------------------------------

pub(crate) fn expected(what: &str, found: &str) -> String {
    format!("expected {what}, found {found}")
}

pub(crate) fn expected_and_advice(what: &str, found: &str, advice: &str) -> String {
    format!("expected {what}, found {found}; {advice}")
}

pub(crate) fn too_deep(limit: usize) -> String {
    format!("nested more than {limit} deep; name a part of it by a `const` or `param`")
}

pub(crate) fn too_long(limit: usize) -> String {
    format!("this expression has more than {limit} operations in a row; put parentheses around parts of it")
}

pub(crate) fn empty_macro() -> String {
    "the definition is empty: write `planar Name { … }` or `spatial Name { … }`".to_string()
}

pub(crate) fn visibility() -> String {
    "a visibility is `pub`, `pub(crate)`, `pub(self)`, `pub(super)` or `pub(in path)`".to_string()
}

pub(crate) fn attribute() -> String {
    "this is no attribute: write a path, and behind it nothing, `(…)` or `= literal`".to_string()
}

pub(crate) fn crate_path(found: &str) -> String {
    format!("expected the path of this crate, such as `::my_crate::linkwright`, found `{found}`")
}

pub(crate) fn chained_comparison() -> String {
    "comparisons do not chain: write `a < b and b < c`".to_string()
}

pub(crate) fn foreign_operator(operator: &str) -> String {
    match operator {
        "**" => "`**` is no operator: a power is written `a^2`".to_string(),
        "&&" => "`&` is no operator: write `and`".to_string(),
        "||" => "`|` is no operator: write `or`".to_string(),
        "!" => "`!` is no operator: write `not`".to_string(),
        _ => format!("`{operator}` is no operator of the language"),
    }
}

pub(crate) fn unary_plus() -> String {
    "a sign `+` before a value says nothing: leave it out".to_string()
}

pub(crate) fn not_decimal(digits: &str) -> String {
    format!("`{digits}` is not a plain decimal number: write digits without suffix, such as `1.5` or `2e-3`")
}

pub(crate) fn two_units() -> String {
    "the unit is written twice: beside the name or behind the parentheses, not both".to_string()
}

pub(crate) fn ground_without_place() -> String {
    "`ground` needs a place: write `ground(0, 0)`, or `ground(0.1, 0.2) [m]`".to_string()
}

pub(crate) fn not_a_place(name: &str) -> String {
    if name == "line" {
        return "a line is not a place; a joint that has one takes it first: `point_on_line(line, place)`"
            .to_string();
    }
    format!("`{name}(…)` is not a place: write `body.point` or `ground(x, y) [m]`")
}

/// Units that are converted by hand.
fn foreign_unit(name: &str) -> Option<String> {
    let (one, is) = match name {
        "inch" | "inches" | "in" => ("inch", "25.4 [mm]"),
        "ft" | "foot" | "feet" => ("foot", "0.3048 [m]"),
        "lb" | "lbs" | "lbm" | "pound" => ("pound", "0.45359237 [kg]"),
        "lbf" => ("pound-force", "4.4482216152605 [N]"),
        "kgf" | "kp" => ("kilogram-force", "9.80665 [N]"),
        "psi" => ("psi", "6894.757293168 [Pa]"),
        "hp" | "PS" => ("horsepower", "745.7 [W], metric 735.49875 [W]"),
        _ => return None,
    };
    Some(format!("one {one} is {is}"))
}

pub(crate) fn unit(error: &UnitError) -> String {
    match error {
        UnitError::Empty => "the unit is missing: write `[1]` for a plain number".to_string(),
        UnitError::Unknown(name) => match (foreign_unit(name), units::suggest(name)) {
            (Some(advice), _) => format!("no unit called \"{name}\"; {advice}"),
            (None, Some(unit)) => format!("no unit called \"{name}\"; did you mean `{unit}`?"),
            (None, None) => format!(
                "no unit called \"{name}\"; units are m g s N Pa J W Hz A V ohm H F Wb with prefixes, kg rad deg rev rpm min h t bar"
            ),
        },
        UnitError::Prefix(prefix, unit) => {
            format!("`{unit}` takes no prefix: write the factor that `{prefix}` stands for into the number")
        }
        UnitError::Malformed(piece) if piece.starts_with(['.', '·', '⋅']) => {
            format!("not a unit at `{piece}`: products of units are written with `*`, such as `N*m`")
        }
        UnitError::Malformed(piece) => {
            format!(
                "not a unit at `{piece}`: write products, quotients and integer powers, such as `kg*m^2/s`"
            )
        }
    }
}

// ---- Indices and repetition ------------------------------------------------------------------------------------------

pub(crate) fn empty_index() -> String {
    "the index is missing".to_string()
}

pub(crate) fn negative_index(value: i64) -> String {
    format!("{value} is negative; indices and counts start at 0")
}

pub(crate) fn not_an_index(name: &str, is_unit: bool) -> String {
    let hint = if is_unit {
        "; brackets after a name are an index, a unit follows a number or `)`"
    } else {
        "; only variables of `repeat` and constants can be used here"
    };
    format!("no index or constant called \"{name}\"{hint}")
}

pub(crate) fn index_too_deep(name: &str) -> String {
    format!("the constant `{name}` refers to others too many levels deep; write its value")
}

pub(crate) fn not_an_integer() -> String {
    "expected a whole number: digits, constants, variables of `repeat` and + - * / ^".to_string()
}

pub(crate) fn division_by_zero() -> String {
    "division by zero".to_string()
}

pub(crate) fn index_shadowed(name: &str) -> String {
    format!("`{name}` is the variable of an outer `repeat` already; choose another name")
}

pub(crate) fn too_many_rounds(rounds: usize, limit: usize) -> String {
    format!("{rounds} rounds are too many: `repeat` may unroll to {limit} rounds and statements in all")
}

pub(crate) fn repeat_backwards(first: i64, behind: i64, variable: &str) -> String {
    let why = format!(
        "`repeat` counts upwards and stops before the number behind `..`, so from {first} to {behind} there is no round"
    );
    if behind < 0 {
        return format!("{why}: write the smaller number first");
    }
    let (past, sum) = (first.saturating_add(1), first.saturating_add(behind));
    format!(
        "{why}: write `{behind}..{past}` for the numbers from {behind} to {first}, and `{sum} - {variable}` in place of `{variable}` to \
         count them downwards"
    )
}

pub(crate) fn constant_in_repeat() -> String {
    "constants stand outside of `repeat`".to_string()
}

pub(crate) fn repeat_in_block() -> String {
    "`repeat` goes around the block: write `repeat i in 0..N { start { … } }`".to_string()
}

// ---- Statements ------------------------------------------------------------------------------------------------------

pub(crate) fn unknown_statement<'a>(word: &str, known: impl Iterator<Item = &'a str>) -> String {
    let hint = match (foreign_statement(word), closest(word, known)) {
        (Some(advice), _) => format!("; {advice}"),
        (None, Some(known)) => format!("; did you mean `{known}`?"),
        (None, None) => {
            "; statements begin with const, param, input, body, joint, force, start and the like".to_string()
        }
    };
    format!("no statement begins with `{word}`{hint}")
}

pub(crate) fn joint_by_its_kind(kind: &str) -> String {
    format!("no statement begins with `{kind}`; a {kind} is a joint: write `joint name: {kind}(…);`")
}

pub(crate) fn driven_distance(name: &str) -> String {
    format!(
        "a driver moves one coordinate, such as `crank_pin.angle`; a distance of two places that follows a law is a joint: \
         `joint {name}: distance(one, other, length [m] = …);`"
    )
}

pub(crate) fn input_with_value(name: &str) -> String {
    format!(
        "an input has no value here, it is given at every call; write `param {name} …` for a value that stays"
    )
}

pub(crate) fn parameter_without_default(name: &str) -> String {
    format!(
        "the parameter `{name}` has no default: write `param {name} [unit] = value;`, or `input {name} [unit];` for what changes \
         at every call"
    )
}

pub(crate) fn bounds_as_range() -> &'static str {
    "bounds are written `least..most`"
}

pub(crate) fn bounds_are_inclusive() -> &'static str {
    "bounds are inclusive already: write `least..most`"
}

pub(crate) fn rounds_stop_before() -> &'static str {
    "`repeat` stops before the number behind `..`: write one more"
}

pub(crate) fn output_without_name() -> &'static str {
    "an output has a name of its own: `output name [unit] = value;`"
}

pub(crate) fn planar_inertia() -> String {
    "the inertia of a planar body is one number, about its centre of mass and across the plane: write `inertia [kg*m^2] = …;`"
        .to_string()
}

pub(crate) fn gravity_twice() -> String {
    "gravity is given twice; write it once".to_string()
}

pub(crate) fn unknown_property(
    shape: &str,
    word: &str,
    allowed: &[&str],
    known_statements: &[&str],
) -> String {
    let (shape, places) = match shape {
        "particle" => (shape, ""),
        "flexible" => ("flexible body", ", and points at nodes"),
        _ => (shape, ", and points and lines"),
    };
    if known_statements.contains(&word) && !["point", "line", "marker"].contains(&word) {
        return format!(
            "`{word}` begins a statement of the mechanism, not of a {shape}: close the braces of the {shape} first"
        );
    }
    if word == "density" {
        return format!("the volume of a {shape} is not known, so it has no `density`: write its `mass`");
    }
    let hint = match closest(word, allowed.iter().copied().chain(["point", "line", "center"])) {
        Some(known) => format!("; did you mean `{known}`?"),
        None => format!("; it has {}{places}", allowed.join(", ")),
    };
    format!("a {shape} has no `{word}`{hint}")
}

pub(crate) fn particle_with_places(name: &str) -> String {
    format!(
        "a particle has no extent: everything attached to `{name}` sits at `{name}.center`. Write `body` for more"
    )
}

pub(crate) fn center_of_shape(shape: &str) -> String {
    format!(
        "the centre of a {shape} is its middle; write `body` with a mass, an inertia and a centre instead"
    )
}

pub(crate) fn attribute_without_effect(word: &str) -> String {
    if word.starts_with("cfg") {
        return "`#[cfg]` has no effect within a mechanism, whose equations have all of its parts: put it before the whole \
                `mechanism!`"
            .to_string();
    }
    format!(
        "`#[{word}]` has no effect here: doc comments and `#[allow(unused)]`, `no_effect` or `outside` may stand before any \
         statement, other attributes before the mechanism, parameters, inputs, states and outputs"
    )
}

pub(crate) fn unknown_lint(word: &str, known: &[&str]) -> String {
    match closest(word, known.iter().copied()) {
        Some(known) => format!("no warning called \"{word}\"; did you mean `{known}`?"),
        None => format!("no warning called \"{word}\"; there are {}", known.join(", ")),
    }
}

pub(crate) fn property_twice(property: &str, owner: &str) -> String {
    format!("`{property}` of `{owner}` is given twice")
}

pub(crate) fn property_here(name: &str) -> String {
    format!("its `{name}` is here")
}

pub(crate) fn first_here(name: &str) -> String {
    format!("the first `{name}` is here")
}

// ---- Settings --------------------------------------------------------------------------------------------------------

pub(crate) fn one_of(words: &[&str]) -> String {
    words.iter().map(|word| format!("`{word}`")).collect::<Vec<_>>().join(" or ")
}

pub(crate) fn list_in_parentheses() -> &'static str {
    "several stand in parentheses: `(one, other)`"
}

pub(crate) fn unknown_option(word: &str, known: &[&str]) -> String {
    let likely = other_option(word).filter(|ours| known.contains(ours));
    let hint = match likely.or_else(|| closest(word, known.iter().copied())) {
        Some(known) => format!("did you mean `{known}`?"),
        None => format!("there are {}", known.join(", ")),
    };
    format!("nothing here is called \"{word}\"; {hint}")
}

// ---- Expectations ----------------------------------------------------------------------------------------------------

pub(crate) fn unknown_expectation(word: &str, known: &[&str]) -> String {
    let likely = other_option(word).filter(|ours| known.contains(ours));
    let hint = match likely.or_else(|| closest(word, known.iter().copied())) {
        Some(known) => format!("did you mean `{known}`?"),
        None => format!("there are {} and ranges such as `knee.angle in 10..170 [deg]`", known.join(", ")),
    };
    format!("nothing that can be expected is called \"{word}\"; {hint}")
}

pub(crate) fn motion_in_space(what: &str) -> String {
    format!(
        "`{what}` in `expect` is not there yet for spatial mechanisms: the range of motion is found for planar ones with one \
         degree of freedom"
    )
}

pub(crate) fn bound_of_no_effort(name: &str, found: Dimension) -> String {
    format!(
        "`{name}` is {}, and a bound along the motion is that of a force or torque, such as `follow.force > 0`; of a coordinate write a range, \
         `rail.travel in 0..8 [mm]`",
        found.kind()
    )
}

pub(crate) fn effort_without_driver(name: &str) -> String {
    format!(
        "`{name}` depends on how fast the mechanism moves, and no driver says so: add one, such as `drive motor: shaft.angle = 100 [rad/s]*time;`"
    )
}

pub(crate) fn effort_by_states(name: &str) -> String {
    format!(
        "`{name}` is followed along the motion that drivers fix, and the states of this mechanism do not follow from that: leave this out of `expect`, \
         and watch `{name}` as an output"
    )
}

/// `turn`: of an angle, in its unit.
pub(crate) fn range_upside_down(from: f64, to: f64, unit: &str, turn: Option<f64>) -> String {
    let [from, to, beyond] = [from, to, to + turn.unwrap_or(0.0)].map(|x| (x * 1e9).round() / 1e9);
    let further = match turn {
        Some(_) => format!(", or `{from}..{beyond} [{unit}]` if it goes on past half a turn"),
        None => String::new(),
    };
    format!("the range is upside down: from {from} to {to} {unit}; write `{to}..{from} [{unit}]`{further}")
}
