//! Texts about bodies, joints and loads, and the rules that they obey.

use super::{closest, number, other_argument};
use crate::forms::{Form, Space};

// ---- Joints, constraints, loads --------------------------------------------------------------------------------------

/// `in_space`: the joints that space has.
/// `there`: the joints of the other space.
pub(crate) fn unknown_joint(word: &str, known: &[&Form], there: &[&Form], space: Space) -> String {
    if there.iter().any(|form| form.word == word) {
        return match space {
            Space::Planar => {
                format!("a {word} joint needs space: write `spatial` before the name of the mechanism")
            }
            Space::Spatial => format!(
                "a {word} joint is one of planar mechanisms so far: write `planar` before the name of the mechanism, if it moves in a plane"
            ),
        };
    }
    if let (Space::Planar, None, Some(ours)) = (space, likely(word, known), elsewhere(word, there)) {
        return format!(
            "a {word} joint is `{ours}`, which needs space: write `spatial` before the name of the mechanism"
        );
    }
    no_such("joint", word, known)
}

pub(crate) fn unknown_kind(what: &str, word: &str, known: &[&Form]) -> String {
    if what == "load" && word == "friction" {
        return super::friction_without_joint();
    }
    no_such(what, word, known)
}

fn no_such(what: &str, word: &str, known: &[&Form]) -> String {
    let hint = match likely(word, known) {
        Some(known) => format!("did you mean `{known}`?"),
        None => format!("there are {}", words(known).join(", ")),
    };
    format!("no {what} called \"{word}\"; {hint}")
}

fn words(forms: &[&Form]) -> Vec<&'static str> {
    forms.iter().map(|form| form.word).collect()
}

fn likely(word: &str, known: &[&Form]) -> Option<&'static str> {
    closest(word, words(known).into_iter()).or_else(|| elsewhere(word, known))
}

/// What other programs call so.
fn elsewhere(word: &str, known: &[&Form]) -> Option<&'static str> {
    known.iter().find(|form| form.elsewhere.contains(&word)).map(|form| form.word)
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
    "one number is expected here, and these parentheses hold several: components are given one by one, such as \
     `rod.rate.x [rad/s] = 1;`, and a vector stands only where places, axes and forces are"
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
    let likely = other_argument(name, known).or_else(|| closest(name, known.iter().copied()));
    let hint = match (likely, known.is_empty()) {
        (Some(known), _) => format!("did you mean `{known}`?"),
        (None, true) => "it takes none".to_string(),
        (None, false) => format!("it takes {}", known.join(", ")),
    };
    format!("`{kind}` has no argument called \"{name}\"; {hint}")
}

/// `places`: whether the arguments are places, not names; `instead`: what else could be meant.
pub(crate) fn missing_place(
    kind: &str,
    count: usize,
    given: usize,
    places: bool,
    instead: Option<&str>,
) -> String {
    let hint = match (instead, places) {
        (Some(instead), _) => format!("; {instead}"),
        (None, true) => "; a place of the ground is written `ground(x, y) [m]`".to_string(),
        (None, false) => String::new(),
    };
    format!(
        "`{kind}` needs {count} unnamed argument{} first, found {given}{hint}",
        if count == 1 { "" } else { "s" }
    )
}

pub(crate) fn along_what_stands() -> String {
    "this depends on no position, so no force can act along it".to_string()
}

pub(crate) fn named_arguments(names: &[&str]) -> String {
    match names {
        [] => "there are no further arguments".to_string(),
        [first, ..] => format!("what follows the unnamed arguments has a name: `{first} = …`"),
    }
}

pub(crate) fn direction_and_components() -> String {
    "a force with a direction has one value: leave the direction out, or write one number".to_string()
}

pub(crate) fn names_without_point() -> &'static str {
    "joints and bodies are named here without a point"
}

pub(crate) fn names_without_point_or_ratio() -> &'static str {
    "joints and bodies are named here without a point, and two toothings bring their ratio: for these leave `ratio` out"
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

// ---- Bodies and joints -----------------------------------------------------------------------------------------------

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

pub(crate) fn density_needs(shape: &str, body: &str, property: &str) -> String {
    format!(
        "the mass of the {shape} `{body}` follows from its density only with a {property}: write `{property} [m] = …;`, or its \
         `mass`"
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
    format!(
        "`{first}` and `{second}` never move apart, so nothing between them does anything: name a place of another body, or leave it out"
    )
}

pub(crate) fn rate_not_known(varying: &str, rate: &str, needed_by: &str) -> String {
    format!(
        "`{needed_by}` needs the rate of `{varying}`, which follows from no input and no state: write it as `{rate} = …`"
    )
}

// ---- Rules of the model ----------------------------------------------------------------------------------------------

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

pub(crate) fn too_many(what: &str, count: usize, most: usize, first: &str) -> String {
    format!(
        "{count} {what} are too many: from `{first}` on they are beyond {most}, and the equations of all are written out in \
         full; take a smaller mechanism"
    )
}

pub(crate) fn negative(what: &str, owner: &str, value: f64, unit: &str) -> String {
    let unit = if unit == "1" { String::new() } else { format!(" {unit}") };
    format!("the {what} of `{owner}` is negative: {value}{unit}; it must be zero or more")
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
        "the two axes of a universal joint are perpendicular, and these are {} degrees apart; write a \
         second_axis at right angles to the axis",
        number(degrees)
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
    format!("`{driver}` drives what `{first}` drives already: remove one of them")
}

pub(crate) fn start_twice(quantity: &str) -> String {
    format!("the start of `{quantity}` is given twice")
}

pub(crate) fn cut_twice(joint: &str) -> String {
    format!("`{joint}` is cut twice")
}

pub(crate) fn force_on_ground(load: &str, place: &str) -> String {
    format!(
        "`{load}` acts at `{place}`, a place of the ground, which nothing moves: write a place of a body, `body.point`"
    )
}
