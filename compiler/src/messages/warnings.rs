//! Texts of warnings: what is possible and probably not meant. Each says how it is taken back.

use super::number;
use crate::forms::BodyForm;

/// `kind`: a constant, parameter, input, point, marker or line.
pub(crate) fn unused(kind: &str, name: &str, body: Option<&str>) -> String {
    let of = body.map(|body| format!(" of `{body}`")).unwrap_or_default();
    let dropped = match kind {
        "parameter" | "input" | "state" => "so no equation depends on it",
        "part" => "so nothing inside it was read",
        "surface" => "so it touches nothing",
        "constant" | "signal" | "table" | "material" => "so it stands for nothing",
        _ => "so no joint, load, start value or output is there",
    };
    format!(
        "nothing names the {kind} `{name}`{of}, {dropped}: use it or leave it out, or write `#[allow(unused)]` before it"
    )
}

pub(crate) fn not_connected(body: &str) -> String {
    format!(
        "`{body}` is connected to nothing, and moves by itself: no joint, constraint or load names it. Add a joint or leave \
         it out, or write `#[allow(unused)]` before it"
    )
}

pub(crate) fn zero_gravity() -> String {
    "this gravity is zero: leave it out, there is none where none is written".to_string()
}

pub(crate) fn zero_load(load: &str) -> String {
    format!(
        "`{load}` is zero at all times: give it a law of inputs, parameters or time, or leave it out, or write \
         `#[allow(no_effect)]` before it"
    )
}

pub(crate) fn spring_of_nothing(load: &str) -> String {
    format!(
        "`{load}` has neither stiffness nor damping, so it pulls at nothing: give it one of them, or a parameter, or leave it \
         out, or write `#[allow(no_effect)]` before it"
    )
}

pub(crate) fn spring_that_damps(load: &str) -> String {
    format!(
        "the stiffness of `{load}` is zero, so its length says nothing: write `damper(place, place, damping = …)` if it only \
         damps, or `#[allow(no_effect)]` before it"
    )
}

pub(crate) fn load_on_held(load: &str, body: &str) -> String {
    format!(
        "`{load}` acts on `{body}`, which fixed joints hold to the ground: it changes their reactions and no motion. Name \
         another body, or write `#[allow(no_effect)]` before it"
    )
}

pub(crate) fn torque_on_held(load: &str, body: &str) -> String {
    format!(
        "`{load}` would turn `{body}`, which cannot turn: there are only fixed and prismatic joints between it and the \
         ground. Name a body or joint that turns, or write `#[allow(no_effect)]` before it"
    )
}

pub(crate) fn load_on_locked(load: &str, joint: &str) -> String {
    format!(
        "`{load}` acts along `{joint}`, which cannot move: other joints hold its two bodies together. Name a joint that \
         moves, or write `#[allow(no_effect)]` before it"
    )
}

pub(crate) fn spring_between_held(load: &str, first: &str, second: &str) -> String {
    format!(
        "`{load}` pulls `{first}` and `{second}` together, which fixed joints hold apart: it moves nothing. Name a place that \
         moves, or write `#[allow(no_effect)]` before it"
    )
}

/// SI units, at the defaults of parameters.
pub(crate) fn negative_coefficient(what: &str, load: &str, value: f64) -> String {
    let does =
        if what == "damping" { "drives the motion it should damp" } else { "pushes where it should pull" };
    format!(
        "the {what} of `{load}` is negative, {} in SI units, so it {does}: change its sign, or write `#[allow(negative)]` \
         before it",
        number(value)
    )
}

/// Metres; `along`: in which direction, and how far out.
pub(crate) fn outside(place: &str, form: &BodyForm, body: &str, along: (&str, f64), limit: f64) -> String {
    let (direction, out) = along;
    let shape = form.word;
    format!(
        "`{place}` lies outside of the {shape} `{body}`: {} m {direction}, and the {shape} ends at {} m. Correct the place or \
         the dimensions, or write `#[allow(outside)]` before it",
        number(out),
        number(limit)
    )
}

/// `name`: the output or state.
pub(crate) fn shared_reaction(name: &str, joint: &str) -> String {
    format!(
        "`{name}` names the reaction of `{joint}`, which is one of many: joints repeat what others fix and share what holds them. Let \
         a joint of the loop leave more freedom, or write `#[allow(shared)]` before `{name}`"
    )
}

/// `identifier`: of the cord.
pub(crate) fn unwatched(cord: &str, identifier: &str) -> String {
    format!(
        "nothing tells when the cord `{cord}` would have to push, where the equations no longer hold: write \
         `output {identifier}_tension [N] = {cord}.tension;`, of which `Event::of(\"{identifier}_tension\").falling()` tells the time, or \
         `#[allow(unwatched)]` before it"
    )
}

/// A moment of inertia that is too large for its body. SI units.
pub(crate) struct Disproportion {
    pub moment: f64,
    pub mass: f64,
    /// √(I/m), and how far the places of the body are from its centre of mass.
    pub gyration: f64,
    pub reach: f64,
    /// The unit in which the same number would fit best.
    pub unit: &'static str,
}

/// SI units, at the defaults of parameters.
pub(crate) fn out_of_proportion(body: &str, found: &Disproportion) -> String {
    let Disproportion { moment, mass, gyration, reach, unit } = found;
    let most = mass * reach * reach;
    format!(
        "`{body}` has a moment of inertia of {} kg*m^2 and a mass of {} kg, a radius of gyration of {} m, but nothing of it is farther \
         than {} m from its centre of mass: a body of that size and mass has up to {} kg*m^2. Correct the number or the unit, which \
         `[{unit}]` would fit, or write `#[allow(proportion)]` before it",
        number(*moment),
        number(*mass),
        number(*gyration),
        number(*reach),
        number(most)
    )
}
