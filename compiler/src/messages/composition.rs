//! Texts about parts that mechanisms are put together from.

use super::closest;
use crate::forms::Space;

pub(crate) fn part_twice(name: &str) -> String {
    format!("a part called `{name}` is declared already; give one of them another name")
}

pub(crate) fn part_not_in_file(name: &str, file: &str, there: &[&str]) -> String {
    let hint = match (closest(name, there.iter().copied()), there) {
        (Some(known), _) => format!("did you mean `{known}`?"),
        (None, []) => format!("write `part {name}(…) {{ … }}` in it"),
        (None, there) => format!("it has {}", there.join(", ")),
    };
    format!("{file} declares no part called `{name}`; {hint}")
}

pub(crate) fn part_without_mechanism() -> &'static str {
    "a part is declared within a mechanism, or in a file of its own that a mechanism names: `part Leg = file(\"leg.mech\");`"
}

pub(crate) fn part_within(name: &str) -> String {
    format!("`{name}` is declared within a part or a `repeat`; declare it beside the bodies of the mechanism")
}

pub(crate) fn part_of_itself(circle: &[&str]) -> String {
    match circle {
        [name, ..] if circle.len() == 2 => format!("the part `{name}` uses itself; it would never end"),
        _ => format!("parts use one another in a circle, which would never end: {}", circle.join(" uses ")),
    }
}

pub(crate) fn part_of_other_space(name: &str, space: Space) -> String {
    let (has, needs) = match space {
        Space::Planar => ("the plane", "planar"),
        Space::Spatial => ("space", "spatial"),
    };
    format!("the part `{name}` is made for {has}; use it in a `{needs}` mechanism")
}

pub(crate) fn too_many_parts(most: usize) -> String {
    format!("with the statements of this part there are more than {most}; use fewer parts")
}

pub(crate) fn port_not_given(part: &str, port: &str, kind: Option<&str>) -> String {
    let what = kind.unwrap_or("value");
    format!("`{part}` needs to be given `{port}`, a {what}: write `{port} = …`")
}

pub(crate) fn no_such_port(part: &str, name: &str, ports: &[&str]) -> String {
    let hint = match (closest(name, ports.iter().copied()), ports) {
        (Some(known), _) => format!("did you mean `{known}`?"),
        (None, []) => "it is given nothing".to_string(),
        (None, ports) => format!("it is given {}", ports.join(", ")),
    };
    format!("`{part}` has no port called `{name}`; {hint}")
}

pub(crate) fn unknown_kind_of_port(port: &str, word: &str) -> String {
    format!(
        "`{word}` is no kind of port: write `{port}: place`, `body`, `joint` or `table`, or the unit of a value, `{port} [m]`"
    )
}

pub(crate) fn wrong_kind_given(port: &str, wanted: &str, given: &str, is: &str) -> String {
    format!("`{port}` is to be given a {wanted}, and `{given}` is {is}")
}

pub(crate) fn outside_of_part(what: &str, name: &str, used: &str) -> String {
    format!(
        "no {what} called `{name}` in `{used}`: a part sees what it is given and what stands in it; give the mechanism's `{name}` \
         to it by a port"
    )
}

pub(crate) fn ground_of_port(port: &str) -> String {
    format!(
        "`{port}` was given a place of the ground here, which has no quantities; ask for `distance({port}, …)` or for a \
         quantity of what is joined to it"
    )
}

pub(crate) fn not_in_a_part(word: &str) -> String {
    format!("`{word}` is of the whole mechanism; write it beside the uses of parts, not within one")
}

/// Where an error within a part came from.
pub(crate) fn used_here(name: &str, part: &str) -> String {
    format!("this is said of the part `{name}`, which is used here: a `{part}`")
}

/// The same behind an error of a text of its own.
pub(crate) fn of_use(name: &str, part: &str) -> String {
    format!("within `{name}`, a `{part}`")
}
