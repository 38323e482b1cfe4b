//! All texts of messages of the front end: what is wrong, why, and what to write instead.

use crate::model::Use;
use crate::self_check::Contradiction;
use crate::syntax::{JointWord, Space};
use crate::units::{self, Dimension, UnitError};

// ---- Tokens and expressions -------------------------------------------------------------------------------------

pub(crate) fn expected(what: &str, found: &str) -> String {
    format!("expected {what}, found {found}")
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
    format!("`{name}(…)` is not a place: write `body.point` or `ground(x, y) [m]`")
}

pub(crate) fn unit(error: &UnitError) -> String {
    match error {
        UnitError::Empty => "the unit is missing: write `[1]` for a plain number".to_string(),
        UnitError::Unknown(name) => match units::suggest(name) {
            Some(unit) => format!("no unit called \"{name}\"; did you mean `{unit}`?"),
            None => format!(
                "no unit called \"{name}\"; units are m g s N Pa J W Hz with prefixes, kg rad deg rev rpm min h t bar"
            ),
        },
        UnitError::Prefix(prefix, unit) => {
            format!("`{unit}` takes no prefix: write the factor that `{prefix}` stands for into the number")
        }
        UnitError::Malformed(piece) => {
            format!(
                "not a unit at `{piece}`: write products, quotients and integer powers, such as `kg*m^2/s`"
            )
        }
    }
}

// ---- Indices and repetition -------------------------------------------------------------------------------------

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
    format!("the constant `{name}` refers to itself, or to others too many levels deep")
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

pub(crate) fn constant_in_repeat() -> String {
    "constants stand outside of `repeat`".to_string()
}

pub(crate) fn repeat_in_block() -> String {
    "`repeat` goes around the block: write `repeat i in 0..N { start { … } }`".to_string()
}

// ---- Statements -------------------------------------------------------------------------------------------------

pub(crate) fn not_there_yet(word: &str) -> String {
    format!("`{word}` is not there yet in this version")
}

pub(crate) fn unknown_statement<'a>(word: &str, known: impl Iterator<Item = &'a str>) -> String {
    let hint = match closest(word, known) {
        Some(known) => format!("; did you mean `{known}`?"),
        None => {
            "; statements begin with const, param, input, body, joint, force, start and the like".to_string()
        }
    };
    format!("no statement begins with `{word}`{hint}")
}

pub(crate) fn input_with_value(name: &str) -> String {
    format!(
        "an input has no value here, it is given at every call; write `param {name} …` for a value that stays"
    )
}

pub(crate) fn gravity_twice() -> String {
    "gravity is given twice; write it once".to_string()
}

pub(crate) fn unknown_property(shape: &str, word: &str, allowed: &[&str]) -> String {
    let places = if shape == "particle" { "" } else { ", and points and lines" };
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

pub(crate) fn property_twice(property: &str, owner: &str) -> String {
    format!("`{property}` of `{owner}` is given twice")
}

pub(crate) fn first_here(name: &str) -> String {
    format!("the first `{name}` is here")
}

// ---- Joints, constraints, loads ---------------------------------------------------------------------------------

pub(crate) fn unknown_kind(what: &str, word: &str, known: &[&'static str], space: Space) -> String {
    if what == "joint" && JointWord::ALL.iter().any(|kind| kind.text() == word) {
        debug_assert!(space == Space::Planar);
        return format!("a {word} joint needs space: write `spatial` before the name of the mechanism");
    }
    if what == "load" && ["bushing", "friction", "contact", "mesh"].contains(&word) {
        return not_there_yet(word);
    }
    let likely = closest(word, known.iter().copied()).or_else(|| other_name(word, known));
    let hint = match likely {
        Some(known) => format!("did you mean `{known}`?"),
        None => format!("there are {}", known.join(", ")),
    };
    format!("no {what} called \"{word}\"; {hint}")
}

/// The joint that other programs call so.
fn other_name(word: &str, known: &[&'static str]) -> Option<&'static str> {
    const OTHERS: [(&str, &str); 13] = [
        ("hinge", "revolute"),
        ("pin", "revolute"),
        ("continuous", "revolute"),
        ("slider", "prismatic"),
        ("translational", "prismatic"),
        ("ball", "spherical"),
        ("ball_and_socket", "spherical"),
        ("cardan", "universal"),
        ("hooke", "universal"),
        ("helical", "screw"),
        ("weld", "fixed"),
        ("rigid", "fixed"),
        ("homokinetic", "constant_velocity"),
    ];
    let (_, ours) = OTHERS.into_iter().find(|(other, _)| *other == word)?;
    known.iter().copied().find(|known| *known == ours)
}

pub(crate) fn other_load(word: &str, kind: &str) -> String {
    format!("a `{word}` cannot be a {kind}: write `force` or `{kind}` before the name")
}

pub(crate) fn load_without_law(kind: &str) -> String {
    format!("a {kind} has no law behind it, its arguments say all; write `;`")
}

pub(crate) fn force_without_direction(space: Space) -> String {
    match space {
        Space::Planar => {
            "a force needs two components, `force(place) = (fx, fy)`, or a direction, `force(place, direction = (1, 0)) \
             = law`"
        }
        Space::Spatial => {
            "a force needs three components, `force(place) = (fx, fy, fz)`, or a direction, \
             `force(place, direction = (1, 0, 0)) = law`"
        }
    }
    .to_string()
}

pub(crate) fn one_number() -> String {
    "a value here is one number; write the components one by one, such as `rod.rate.x [rad/s] = 1;`"
        .to_owned()
}

pub(crate) fn third_coordinate() -> String {
    "a planar mechanism has two coordinates: leave the third out, or write `spatial` before the name of the mechanism"
        .to_string()
}

pub(crate) fn only_in_space(word: &str) -> String {
    format!("`{word}` needs space: write `spatial` before the name of the mechanism")
}

pub(crate) fn marker_axes_mixed() -> String {
    "the axes of a marker are given by directions (`axis`, `reference`) or by turns (`about_x`, `about_y`, `about_z`), not \
     by both"
        .to_string()
}

pub(crate) fn reference_without_axis() -> String {
    "a reference direction fixes the turn about the axis: write `axis = (…)` before it".to_string()
}

pub(crate) fn missing_axis(kind: &str) -> String {
    format!(
        "`{kind}` needs its axis: write `axis = (0, 0, 1)`, in the axes of both places, or let one of its places be a \
         marker, whose axis it then takes"
    )
}

pub(crate) fn missing_argument(kind: &str, name: &str, space: Space) -> String {
    let vector = matches!(name, "axis" | "second_axis" | "direction");
    let example = match (vector, space) {
        (true, Space::Planar) => "(1, 0)",
        (true, Space::Spatial) => "(0, 0, 1)",
        (false, _) => "…",
    };
    format!("`{kind}` needs its {name}: write `{name} = {example}`")
}

pub(crate) fn unknown_argument(kind: &str, name: &str, known: &[&str]) -> String {
    let hint = match (closest(name, known.iter().copied()), known.is_empty()) {
        (Some(known), _) => format!("did you mean `{known}`?"),
        (None, true) => "it takes none".to_string(),
        (None, false) => format!("it takes {}", known.join(", ")),
    };
    format!("`{kind}` has no argument called \"{name}\"; {hint}")
}

pub(crate) fn missing_place(kind: &str, count: usize, given: usize) -> String {
    format!(
        "`{kind}` needs {count} unnamed argument{} first, found {given}",
        if count == 1 { "" } else { "s" }
    )
}

pub(crate) fn too_many_places(kind: &str, count: usize) -> String {
    format!(
        "`{kind}` takes {count} unnamed argument{}, this is one too many",
        if count == 1 { "" } else { "s" }
    )
}

pub(crate) fn place_for_line() -> String {
    "the first argument is the line: write `line(ground(0, 0), ground(1, 0) [m])`, then the point".to_string()
}

// ---- Settings ---------------------------------------------------------------------------------------------------

pub(crate) fn one_of(words: &[&str]) -> String {
    words.iter().map(|word| format!("`{word}`")).collect::<Vec<_>>().join(" or ")
}

pub(crate) fn unknown_option(word: &str, known: &[&str]) -> String {
    let hint = match closest(word, known.iter().copied()) {
        Some(known) => format!("did you mean `{known}`?"),
        None => format!("there are {}", known.join(", ")),
    };
    format!("nothing here is called \"{word}\"; {hint}")
}

// ---- Names ------------------------------------------------------------------------------------------------------

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
    match similar {
        Some(similar) => format!("no {kind} called \"{name}\"; did you mean \"{similar}\"?"),
        None => format!("no {kind} called \"{name}\""),
    }
}

pub(crate) fn cyclic_constant(name: &str, other: &str) -> String {
    if name == other {
        return format!("the constant `{name}` is defined by itself");
    }
    format!("the constants `{name}` and `{other}` are defined by each other")
}

// ---- Places -----------------------------------------------------------------------------------------------------

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

pub(crate) fn not_a_line(name: &str, kind: &str) -> String {
    format!("`{name}` is {kind}, expected a line such as `{name}.slot` or `line(place, place)`")
}

pub(crate) fn rod_has_end(end: &str) -> String {
    format!("a rod has a point `{end}` of its own; choose another name")
}

// ---- Bodies and joints ------------------------------------------------------------------------------------------

pub(crate) fn missing_property(shape: &str, body: &str, property: &str, space: Space) -> String {
    let unit = match property {
        "mass" => "kg",
        "inertia" => "kg*m^2",
        _ => "m",
    };
    let vector = property == "size" || (property == "inertia" && space == Space::Spatial);
    let value = if vector { "(…, …, …)" } else { "…" };
    format!("the {shape} `{body}` has no {property}: write `{property} [{unit}] = {value};`")
}

pub(crate) fn not_positive(property: &str, body: &str, metres: f64) -> String {
    format!("the {property} of `{body}` must be positive, found {metres} m")
}

pub(crate) fn joint_with_itself(joint: &str, body: &str) -> String {
    format!(
        "the joint `{joint}` connects `{body}` with itself; its two places must belong to different bodies"
    )
}

pub(crate) fn joint_of_ground(joint: &str) -> String {
    format!("the joint `{joint}` connects the ground with itself; one of its places must belong to a body")
}

pub(crate) fn orientation_of_particle(kind: &str, place: &str) -> String {
    let instead = if kind == "fixed" { "revolute" } else { "point_on_line" };
    format!("a {kind} joint holds an orientation, and the particle at `{place}` has none; write `{instead}`")
}

pub(crate) fn particle_turns(particle: &str) -> String {
    format!(
        "`{particle}` is a particle and has no orientation; write `body`, `rod`, `disk` or `box` for one that turns"
    )
}

pub(crate) fn zero_direction(what: &str, space: Space) -> String {
    let example = if space == Space::Planar { "(1, 0)" } else { "(0, 0, 1)" };
    format!("the {what} is zero: it points nowhere; write for instance {example}")
}

pub(crate) fn zero_quaternion() -> String {
    "this quaternion is zero: no orientation has it; (1, 0, 0, 0) is the one in which body axes are world axes"
        .to_string()
}

pub(crate) fn mass_and_density(body: &str) -> String {
    format!("`{body}` is given both a mass and a density; leave one of them out")
}

pub(crate) fn density_needs_radius(body: &str) -> String {
    format!(
        "the mass of the rod `{body}` follows from its density only with a radius: write `radius [m] = …;`, or its `mass`"
    )
}

pub(crate) fn products_without_inertia(body: &str) -> String {
    format!(
        "products of inertia of `{body}` need the moments beside them: write `inertia [kg*m^2] = (…, …, …);`"
    )
}

pub(crate) fn unknown_marker(body: &str, name: &str, known: &[&str]) -> String {
    match (closest(name, known.iter().copied()), known.is_empty()) {
        (Some(similar), _) => {
            format!("`{body}` has no marker called \"{name}\"; did you mean \"{similar}\"?")
        }
        (None, true) => {
            format!("`{body}` has no marker: declare `marker {name} [m] = (0, 0, 0), …;` in its braces")
        }
        (None, false) => format!("`{body}` has no marker called \"{name}\"; it has {}", known.join(", ")),
    }
}

pub(crate) fn joint_of_particle_kind(kind: &str, place: &str) -> String {
    format!(
        "a {kind} joint needs the orientation of both its bodies, and the particle at `{place}` has none; write \
         `spherical`, `point_on_line`, `point_on_plane` or `distance`"
    )
}

pub(crate) fn body_has_no_angle(body: &str) -> String {
    format!(
        "the orientation of `{body}` in space is no single angle: name the angle of a joint, or `{body}.rate.x`"
    )
}

pub(crate) fn quantities_of_rate(body: &str) -> String {
    format!("`{body}.rate` has the components x, y and z, in the axes of `{body}`")
}

pub(crate) fn which_angle(joint: &str, angles: &[&str]) -> String {
    let exact = if angles.is_empty() { "none" } else { "more than one" };
    format!(
        "a single angle is needed here, and `{joint}` has {exact}; use a joint with exactly one, such as a revolute"
    )
}

pub(crate) fn torque_of_components(name: &str) -> String {
    format!(
        "a torque on a body in space has three components, `torque({name}) = (tx, ty, tz)` in world axes; on a joint it \
         has one"
    )
}

pub(crate) fn spring_in_one_body(first: &str, second: &str) -> String {
    format!("`{first}` and `{second}` never move apart, so nothing between them does anything")
}

// ---- Quantities -------------------------------------------------------------------------------------------------

pub(crate) fn joint_has_none(joint: &str, kind: &str, asked: &str, instead: &str) -> String {
    format!(
        "the {kind} joint `{joint}` has no {asked}: it has no coordinate at all; use {instead} or a place"
    )
}

pub(crate) fn joint_has(joint: &str, kind: &str, asked: &str, quantities: &[&str]) -> String {
    format!("the {kind} joint `{joint}` has no {asked}; it has {}", quantities.join(", "))
}

pub(crate) fn joint_of_particle(joint: &str, asked: &str) -> String {
    format!("`{joint}` has no {asked}: one of its two bodies is a particle, which has no orientation")
}

pub(crate) fn quantity_of_load(load: &str) -> String {
    format!("a load has no quantities but its power: write `power({load})`")
}

pub(crate) fn no_quantities(name: &str, kind: &str) -> String {
    format!("`{name}` is {kind} and has no quantities")
}

pub(crate) fn part_as_value(name: &str, kind: &str) -> String {
    let example = match kind {
        "a body" => format!("`{name}.angle` or `{name}.center.x`"),
        "a joint" => format!("`{name}.angle` or `{name}.travel`"),
        "a load" => format!("`power({name})`"),
        "a driver" => format!("`{name}.effort`"),
        _ => return format!("`{name}` is {kind}, expected a value"),
    };
    format!("`{name}` is {kind}, expected a value such as {example}")
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

pub(crate) fn power_of_what() -> String {
    "`power` takes the name of a load".to_string()
}

pub(crate) fn power_of_driver(driver: &str) -> String {
    format!("the power of a driver is written `{driver}.power`")
}

pub(crate) fn not_a_position(name: &str, verb: &str) -> String {
    format!("`{name}` cannot {verb}: only an angle, a travel or a position can")
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

pub(crate) fn not_permitted(name: &str, kind: &str, usage: &Use) -> String {
    let mut allowed = vec!["constants"];
    let kinds = [
        (usage.parameters, "parameters"),
        (usage.time, "time"),
        (usage.inputs, "inputs"),
        (usage.positions, "positions"),
        (usage.velocities, "velocities"),
    ];
    allowed.extend(kinds.iter().filter(|(permitted, _)| *permitted).map(|(_, name)| *name));
    let last = allowed.pop().unwrap_or_default();
    let list =
        if allowed.is_empty() { last.to_string() } else { format!("{} and {last}", allowed.join(", ")) };
    format!("`{name}` is {kind}, but {} may depend on {list} only", usage.what)
}

// ---- Dimensions -------------------------------------------------------------------------------------------------

/// What the unit of a frequency is meant to say where an angular rate is expected.
fn rate_hint(expected: Dimension, found: Dimension) -> &'static str {
    if expected.fits(Dimension::ANGULAR_RATE) && found.is_frequency() { "; write rad/s or rpm" } else { "" }
}

pub(crate) fn wrong_unit(what: &str, expected: Dimension, found: Dimension) -> String {
    let hint = rate_hint(expected, found);
    format!("{what} is given {}: expected {expected}, found {found}{hint}", found.kind())
}

pub(crate) fn wrong_dimension(what: &str, expected: Dimension, found: Dimension) -> String {
    if found == Dimension::ONE {
        return format!(
            "{what} is given a plain number: expected {expected}; write the unit, as in `3 [{expected}]`"
        );
    }
    wrong_unit(what, expected, found)
}

pub(crate) fn different_dimensions(what: &str, left: Dimension, right: Dimension) -> String {
    let (left_one, right_one) = (left == Dimension::ONE, right == Dimension::ONE);
    if left_one != right_one {
        let other = if left_one { right } else { left };
        return format!(
            "{what} do not fit: a plain number meets {}; write its unit, as in `3 [{other}]`",
            other.kind()
        );
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

// ---- Values -----------------------------------------------------------------------------------------------------

pub(crate) fn not_constant(what: &str) -> String {
    format!("the value of {what} must be known at expansion")
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
    match closest(name, known) {
        Some(similar) => format!("no function called \"{name}\"; did you mean \"{similar}\"?"),
        None => format!("no function called \"{name}\""),
    }
}

pub(crate) fn arguments(name: &str, expected: usize, found: usize) -> String {
    format!("`{name}` takes {expected} argument{}, found {found}", if expected == 1 { "" } else { "s" })
}

// ---- Rules of the model -----------------------------------------------------------------------------------------

pub(crate) fn no_bodies(name: &str, space: Space) -> String {
    let inertia = if space == Space::Planar { "…" } else { "(…, …, …)" };
    format!("`{name}` has no body: write `body crank {{ mass [kg] = …; inertia [kg*m^2] = {inertia}; }}`")
}

pub(crate) fn empty_bounds(name: &str) -> String {
    format!("the bounds of `{name}` hold no value: write the smaller one first")
}

/// All in SI units.
pub(crate) fn default_out_of_bounds(name: &str, default: f64, minimum: f64, maximum: f64) -> String {
    format!(
        "the default of `{name}` lies outside of its bounds: {default} is not in {minimum}..{maximum} (SI units); \
         widen the bounds or change the default"
    )
}

pub(crate) fn negative(what: &str, owner: &str, value: f64, unit: &str) -> String {
    format!("the {what} of `{owner}` is negative: {value} {unit}")
}

/// Principal moments, ascending.
pub(crate) fn inertia_of_no_body(body: &str, [a, b, c]: [f64; 3]) -> String {
    format!(
        "the inertia of `{body}` belongs to no real body: its principal moments are {}, {} and {} kg*m^2, and \
         the sum of any two must be at least the third; check its numbers and the signs of its products, which are entries \
         of the tensor, Ixy = -sum(x*y*m). If they are published so, write \
         `options {{ inertia = accept; }}`",
        number(a),
        number(b),
        number(c)
    )
}

pub(crate) fn inertia_not_positive(body: &str, least: f64) -> String {
    format!(
        "the inertia of `{body}` is not positive: about one of its principal axes the moment is {} kg*m^2; its products \
         are too large for its moments",
        number(least)
    )
}

pub(crate) fn not_perpendicular(degrees: f64) -> String {
    format!(
        "the two axes of a universal joint are perpendicular, and these are {degrees:.4} degrees apart; write a \
         second_axis at right angles to the axis"
    )
}

pub(crate) fn reference_along_axis() -> String {
    "the reference points along the axis, so it fixes no turn about it; write a direction across the axis"
        .to_string()
}

pub(crate) fn zero_pitch() -> String {
    "a screw of no pitch does not advance; write `revolute` for one that only turns, or `cylindrical` for one that slides \
     freely"
        .to_string()
}

pub(crate) fn particle_carries(kind: &str, place: &str) -> String {
    let what = if kind == "point_on_plane" { "plane" } else { "line" };
    format!(
        "a {what} turns with its body, and the particle at `{place}` has no orientation; name the particle second"
    )
}

pub(crate) fn line_without_length(line: &str) -> String {
    format!("the two ends of `{line}` are the same point, so it has no direction")
}

pub(crate) fn distance_not_positive(joint: &str) -> String {
    format!("the length of `{joint}` must be positive; write `revolute` for two places that coincide")
}

pub(crate) fn coupled_with_itself(constraint: &str) -> String {
    format!("`{constraint}` couples something with itself")
}

pub(crate) fn zero_factor(constraint: &str, what: &str) -> String {
    format!("the {what} of `{constraint}` is zero: nothing would be passed on")
}

pub(crate) fn nothing_moves(constraint: &str) -> String {
    format!("the constraint `{constraint}` names nothing that can move, such as `knee.angle`")
}

pub(crate) fn driven_twice(driver: &str, first: &str) -> String {
    format!("`{driver}` drives what `{first}` drives already")
}

pub(crate) fn start_twice(quantity: &str) -> String {
    format!("the start of `{quantity}` is given twice")
}

pub(crate) fn cut_twice(joint: &str) -> String {
    format!("`{joint}` is cut twice")
}

pub(crate) fn not_connected(body: &str) -> String {
    format!(
        "`{body}` is connected to nothing: no joint, constraint or load names it; add a joint or leave it out"
    )
}

/// Four digits behind the point, or powers of ten where those would say little.
fn number(value: f64) -> String {
    if value == 0.0 || (0.01..1e5).contains(&value.abs()) {
        let text = format!("{value:.4}");
        text.trim_end_matches('0').trim_end_matches('.').to_string()
    } else {
        format!("{value:.4e}")
    }
}

// ---- Advice -----------------------------------------------------------------------------------------------------

/// The known word nearest to a misspelt one, if near enough to be meant.
pub(crate) fn closest<'a>(word: &str, known: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    let most = (word.chars().count() / 3).max(1);
    known
        .map(|candidate| (distance(word, candidate), candidate))
        .filter(|(edits, _)| *edits <= most)
        .min_by_key(|(edits, _)| *edits)
        .map(|(_, candidate)| candidate)
}

/// Edits (insert, delete, replace, swap neighbours) from one word to another; letter case does not count.
fn distance(a: &str, b: &str) -> usize {
    let (a, b): (Vec<char>, Vec<char>) =
        (a.to_lowercase().chars().collect(), b.to_lowercase().chars().collect());
    let mut rows = vec![vec![0; b.len() + 1]; a.len() + 1];
    for (i, row) in rows.iter_mut().enumerate() {
        row[0] = i;
    }
    for (j, first) in rows[0].iter_mut().enumerate() {
        *first = j;
    }
    for i in 1..=a.len() {
        for j in 1..=b.len() {
            let replaced = rows[i - 1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
            let mut best = replaced.min(rows[i - 1][j] + 1).min(rows[i][j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                best = best.min(rows[i - 2][j - 2] + 1);
            }
            rows[i][j] = best;
        }
    }
    rows[a.len()][b.len()]
}

pub(crate) fn angle_without_unit(function: &str, text: &str) -> String {
    format!(
        "{function} of a bare number: write its unit, `{function}({text} [deg])` or `{function}({text} [rad])`"
    )
}

// ---- The compiler itself ----------------------------------------------------------------------------------------

pub(crate) fn unreadable_expansion(error: &str) -> String {
    format!(
        "the generated code could not be read back ({error}); this is a mistake of Linkwright: please report it with this definition"
    )
}

/// The compiler has found a mistake of its own.
pub(crate) fn contradiction(contradiction: &Contradiction) -> String {
    let Contradiction { check, at, found, expected, margin, state } = contradiction;
    format!(
        "Linkwright contradicts itself, so there is no model: this is a mistake of Linkwright, not of the definition. It \
         compared {} and found at {at} {found:e} in place of {expected:e} (to within {margin:.1e}), with {state}. Please report \
         this message with the definition; `options {{ self_check = off; }}` takes the model unchecked",
        check.text()
    )
}
