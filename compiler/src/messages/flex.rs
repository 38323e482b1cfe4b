//! Texts about bodies that deform by the modes of a file, and about such files.

use super::{closest, number};
use crate::numbers::significant;

// ---- The file --------------------------------------------------------------------------------------------------------

pub(crate) fn flex_not_begun() -> String {
    "a file of modes begins with `flex 1`, its version: see \"The format `.flex`\" in the documentation"
        .to_string()
}

pub(crate) fn flex_version(version: &str) -> String {
    format!(
        "this is version {version} of the format, and version 1 is read here: write the file anew, with `flex 1`"
    )
}

pub(crate) fn flex_unknown(word: &str, known: &[&str]) -> String {
    let hint = match closest(word, known.iter().copied()) {
        Some(similar) => format!("did you mean `{similar}`?"),
        None => format!("there are {}", known.join(", ")),
    };
    format!("`{word}` is no word of a file of modes; {hint}")
}

pub(crate) fn flex_twice(word: &str) -> String {
    format!("`{word}` is there already: leave one of them out")
}

pub(crate) fn flex_modes_first(word: &str) -> String {
    format!("how many numbers `{word}` has follows from the number of modes: write `modes 8` before it")
}

pub(crate) fn flex_modes_out_of_range(count: u64, most: usize) -> String {
    format!("a file has 1 to {most} modes, found {count}: leave the fastest out")
}

pub(crate) fn flex_no_count(word: &str, found: &str) -> String {
    format!("`{word}` is followed by a whole number, found `{found}`")
}

pub(crate) fn flex_too_few(word: &str, found: usize, count: usize) -> String {
    format!("`{word}` has {}, and the file ends behind {found}", flex_numbers(count))
}

pub(crate) fn flex_ends_early(word: &str, found: usize, count: usize, next: &str) -> String {
    format!("`{word}` has {}, and behind {found} of them stands `{next}`", flex_numbers(count))
}

fn flex_numbers(count: usize) -> String {
    if count == 1 { "one number".to_string() } else { format!("{count} numbers") }
}

pub(crate) fn flex_too_many(found: &str) -> String {
    format!("`{found}` is one number too many: all that belong to the word before it are there")
}

pub(crate) fn flex_missing(word: &str) -> String {
    format!("the file ends without `{word}`")
}

pub(crate) fn flex_without_nodes() -> String {
    "the file ends without a node, and nothing could be attached to the body: write `node 17  x y z` and its six rows, one number for each \
     mode: moved along x, y, z and turned about x, y, z"
        .to_string()
}

pub(crate) fn flex_node(node: u64) -> String {
    format!("node {node}")
}

pub(crate) fn flex_nodes_at_one_place(node: u64, other: u64) -> String {
    format!(
        "node {node} is where node {other} is, and places are told apart by where they are: leave one of them out"
    )
}

// ---- Its numbers -----------------------------------------------------------------------------------------------------

pub(crate) fn flex_not_positive(what: &str, found: f64) -> String {
    format!("the {what} must be positive, found {}", number(found))
}

pub(crate) fn flex_not_symmetric(word: &str, [row, column]: [usize; 2], below: f64, above: f64) -> String {
    format!(
        "`{word}` is symmetric, but has {} in row {row}, column {column}, and {} in row {column}, column {row}",
        significant(below, 9),
        significant(above, 9)
    )
}

pub(crate) fn flex_mass_of_mode(mode: usize, found: f64) -> String {
    format!(
        "the generalised mass of mode {mode} must be positive, found {} kg: a mode that moves nothing is none",
        number(found)
    )
}

pub(crate) fn flex_mass_not_definite(mode: usize) -> String {
    format!(
        "the generalised mass is not positive definite: mode {mode} moves everything as a sum of those before it does, and is none of its own; \
         leave it out"
    )
}

pub(crate) fn flex_sum_rule(function: &str, square: f64, mean: f64) -> String {
    format!(
        "the integrals do not belong together: that of the square of {function} over the mass is {}, less than the {} which its mean alone has. \
         Compare `mass`, `center` and `momentum` with `moments`, all of them about the origin of the frame",
        significant(square, 9),
        significant(mean, 9)
    )
}

pub(crate) fn flex_no_square(value: f64, [one, other]: &[String; 2]) -> String {
    format!(
        "the integrals do not belong together: a sum of the functions 1, x, y, z and phi, mostly of {one} and {other}, has a square with the \
         integral {} over the mass, of its size. Compare `mass`, `center` and `momentum` with `moments`",
        significant(value, 3)
    )
}

pub(crate) fn flex_less_inertia(entry: &str, found: f64, least: f64) -> String {
    format!(
        "the moment of inertia {entry} is {} kg m², less than the {} kg m² which the moments of x, y and z have: both are about the origin of the \
         frame, not about the centre of mass",
        significant(found, 9),
        significant(least, 9)
    )
}

pub(crate) fn flex_less_mass(mode: usize, found: f64, least: f64) -> String {
    format!(
        "the generalised mass of mode {mode} is {} kg, less than the {} kg which its moments have: one of them is scaled otherwise",
        significant(found, 9),
        significant(least, 9)
    )
}

pub(crate) fn flex_turns_with_less(value: f64) -> String {
    format!(
        "`inertia`, `angular_momentum` and `generalised_mass` do not belong together: what they have beyond `moments`, from nodes that turn, is no \
         sum of squares ({} of its size). Where no node has inertia of its own they are sums of `moments`",
        significant(value, 3)
    )
}

pub(crate) fn flex_stiffness_negative(least: f64) -> String {
    format!(
        "the stiffness is not that of a body at rest: the square of its lowest rate is {} (rad/s)²; leave out modes that make nothing bend, and take \
         K without loads",
        significant(least, 4)
    )
}

pub(crate) fn flex_rigid_modes(count: usize) -> String {
    let have = if count == 1 { "has" } else { "have" };
    format!(
        "{count} of the modes {have} no stiffness; a body that is held has none of these, and one that nothing holds has six: leave mechanisms and \
         loose parts out of the model"
    )
}

pub(crate) fn flex_rigid_modes_first(mode: usize, rate: f64) -> String {
    format!(
        "six motions have no stiffness, and mode {mode}, at {} rad/s, is none of them: write the six rigid modes first",
        significant(rate, 4)
    )
}

pub(crate) fn flex_not_orthogonal(word: &str, [one, other]: [usize; 2], share: f64) -> String {
    format!(
        "modes are said to be orthogonal here, but the `{word}` of modes {one} and {other} is {} of their own: leave `orthogonal` out, or take the \
         modes from one solution",
        significant(share, 3)
    )
}

pub(crate) fn flex_rigid_energy(mode: usize, own: f64, carried: f64) -> String {
    format!(
        "mode {mode} has no stiffness, and is no rigid motion: its generalised mass is {} kg, that of the rigid motion with its momenta {} kg",
        significant(own, 9),
        significant(carried, 9)
    )
}

pub(crate) fn flex_rigid_node(mode: usize, node: u64, axis: &str, [found, expected]: [f64; 2]) -> String {
    format!(
        "mode {mode} is a rigid motion that moves node {node} by {} along {axis}, and the rows of the node have {}",
        significant(expected, 9),
        significant(found, 9)
    )
}

// ---- The definition --------------------------------------------------------------------------------------------------

pub(crate) fn flexible_without_file(body: &str) -> String {
    format!(
        "the modes of a flexible body stand in a file: write `flexible {body}(file = \"{body}.flex\") {{ … }}`"
    )
}

pub(crate) fn no_such_node(node: u64, file: &str, known: &[u64]) -> String {
    let mut named: Vec<String> = known.iter().take(8).map(u64::to_string).collect();
    if known.len() > named.len() {
        named.push(format!("and {} more", known.len() - named.len()));
    }
    format!("`{file}` has no node {node}; it has {}", named.join(", "))
}

pub(crate) fn point_of_flexible(body: &str) -> String {
    format!(
        "how a place of the flexible body `{body}` moves is known at nodes of its file alone: write `point bearing = node(17);` with the number of one"
    )
}

pub(crate) fn modes_of_file() -> &'static str {
    "modes by their numbers in the file, such as `modes = 1..8;`"
}

pub(crate) fn modes_upside_down(from: i64, to: i64) -> String {
    format!("modes are numbered from 1 on, the lower number first, found {from}..{to}: both ends are taken")
}

pub(crate) fn modes_beyond(file: &str, to: usize, count: usize) -> String {
    format!("`{file}` has {count} modes, and there is no mode {to}: write `1..{count}` at most")
}

pub(crate) fn rigid_modes_taken(body: &str, rigid: usize, count: usize) -> String {
    if count == rigid {
        return format!(
            "all modes of the file are rigid motions, which the frame of `{body}` has anyway: take `body` for what does not deform"
        );
    }
    format!(
        "modes 1 to {rigid} of the file are rigid motions, which the frame of `{body}` has anyway: write `modes = {}..{count};`",
        rigid + 1
    )
}

pub(crate) fn not_on_flexible(what: &str, body: &str) -> String {
    format!(
        "a {what} on the flexible body `{body}` would have to deform with it: fix a body to one of its nodes and give that the {what}"
    )
}

pub(crate) fn of_the_file(property: &str, body: &str) -> String {
    format!("the {} of `{body}` is that of its file: leave it out", property.replace('_', " "))
}

pub(crate) fn mass_disagrees(body: &str, file: &str, written: f64, found: f64) -> String {
    format!(
        "the mass of `{body}` is written as {} kg, and `{file}` has {} kg: correct it or leave it out",
        significant(written, 7),
        significant(found, 7)
    )
}

pub(crate) fn modes_of_flexible(body: &str, asked: &str, numbers: &[usize]) -> String {
    let (first, last) = (numbers.first().copied().unwrap_or(1), numbers.last().copied().unwrap_or(1));
    let known = match numbers.len() {
        1 => format!("`{body}.mode[{first}]`"),
        _ => format!("`{body}.mode[{first}]` to `{body}.mode[{last}]`"),
    };
    format!("`{body}` has no mode `{asked}`; it has {known}, each with `.rate`")
}

pub(crate) fn torque_on_flexible(body: &str) -> String {
    format!(
        "a torque on the flexible body `{body}` deforms it where it acts: let it act on a joint at one of its nodes, whose angle is that of the node"
    )
}

pub(crate) fn origin_of_flexible(place: &str) -> String {
    format!(
        "`{place}` is the frame of a flexible body and no node of it, so that nothing can be attached to it: write a `point` at a node"
    )
}
