//! Of joints that yield.

use crate::forms::{JointForm, Spans};

/// What says the same as the penalty of such a joint, or why it has none.
pub(crate) fn load_instead_of_penalty(joint: &str, form: &JointForm) -> Option<String> {
    let kind = form.call.word;
    if form.only_pulls {
        return Some(format!(
            "a {kind} that yields is a cable, which pulls as it is stretched: write `cable {joint}: cable(place, place, stiffness [N] = …, length [m] = …);` in place of the joint"
        ));
    }
    if form.spans == Spans::Rod {
        return Some(format!(
            "a {kind} that yields is a spring: write `spring {joint}: spring(place, place, stiffness [N/m] = …, damping [N*s/m] = …, length [m] = …);` in place of the joint"
        ));
    }
    if form.spans == Spans::Outline {
        return Some(format!(
            "a {kind} that yields is a contact: write `surface`s, a `profile` and a `circle`, and `contact {joint}: between(…, …) = kelvin_voigt(stiffness [N/m] = …, damping [N*s/m] = …);` in place of the joint"
        ));
    }
    if form.spans == Spans::Curve {
        return Some(format!(
            "a {kind} that yields is a force along how far its place is off the curve: write `force {joint}: along(off) = -stiffness*(off)`, off an \
             expression of positions such as `bead.center.y - 2 [1/m]*bead.center.x^2`, in place of the joint"
        ));
    }
    form.winds().then(|| {
        format!(
            "`{joint}` is a {kind}, whose travel follows an angle counted over its turns, and a penalty counts none: write `cylindrical(…) = penalty(…)` and \
             a `constraint` or a load between travel and angle"
        )
    })
}

pub(crate) fn penalty_without_use(argument: &str, joint: &str, kind: &str, what: &str) -> String {
    format!("`{argument}` has no use: `{joint}`, a {kind} joint, holds no {what}; leave it out")
}

pub(crate) fn penalty_missing(argument: &str, joint: &str, kind: &str, what: &str) -> String {
    let unit = if argument == "stiffness" { "N/m" } else { "N*m/rad" };
    format!(
        "`{joint}`, a {kind} joint, holds {what}, and nothing says how stiffly: write `{argument} [{unit}] = …` in its `penalty(…)`"
    )
}

pub(crate) fn penalty_has_no_line(joint: &str, kind: &str) -> String {
    format!(
        "damping along the line between two places needs a joint that keeps these together, and `{joint}`, a {kind} joint, lets them part: leave \
         `damping_along` out"
    )
}

pub(crate) fn penalty_on_beam(joint: &str, place: &str) -> String {
    format!(
        "`{joint}` yields by its `penalty`, and `{place}` is on a body that bends, which no penalty knows yet: put a small body there with `fixed`, and \
         the penalty between that and the rest"
    )
}

pub(crate) fn penalty_line_of_nothing(joint: &str) -> String {
    format!(
        "`damping_along` says how damping acts, and `{joint}` has none: write `damping [N*s/m] = …` too, or leave it out"
    )
}

pub(crate) fn penalty_without_smallest(joint: &str) -> String {
    format!(
        "damping along a line has no value where the places of `{joint}` coincide: write `smallest [m] = …`, the distance below which it fades, well below \
         force/stiffness"
    )
}

pub(crate) fn penalty_smallest_of_nothing(joint: &str) -> String {
    format!(
        "`smallest` is the distance below which damping along a line fades, and that of `{joint}` acts along all axes: write `damping_along = line` too, or leave it out"
    )
}

pub(crate) fn cut_of_what_yields(joint: &str) -> String {
    format!(
        "`{joint}` yields by its `penalty`, and carries no body that a cut could free: leave it out of `cut`"
    )
}

pub(crate) fn law_of_joint() -> String {
    "a joint holds, or yields by `= penalty(stiffness [N/m] = …, damping [N*s/m] = …);`, with `torsional_stiffness [N*m/rad]` where it holds a turn".to_string()
}
