//! Of memories and the events that set them.

use super::{closest, number};

pub(crate) fn memory_without_start(name: &str) -> String {
    format!("the memory \"{name}\" has no start value: write `memory {name} [unit] = value;`")
}

pub(crate) fn event_without_assignments(name: &str) -> String {
    format!(
        "the event `{name}` sets nothing: write `{{ memory = value; }}` or `{{ jump(speed) = value; }}` behind its condition, or leave it \
         out"
    )
}

pub(crate) fn second_jump(event: &str) -> String {
    format!(
        "`{event}` lets a second speed jump, and an event has one: write another event with the same condition, for all that occurs \
         at one time jumps together"
    )
}

pub(crate) fn jump_closed_late(speed: &str) -> String {
    format!("the value stands behind the parentheses: write `jump({speed}) = value;`")
}

pub(crate) fn jump_of_no_speed(name: &str) -> String {
    format!(
        "`{name}` cannot jump: only a speed can, such as `rail.speed`, `pin.rate` or `body.origin.velocity.x`; positions go on as they are"
    )
}

/// What a speed that jumps is called where what it jumps to has another dimension.
pub(crate) fn what_jumps(speed: &str) -> String {
    format!("what `{speed}` jumps to")
}

pub(crate) fn jump_of_what_is_driven(speed: &str, driver: &str) -> String {
    format!(
        "`{speed}` cannot jump, since `{driver}` drives it: let the law of the driver jump, or another speed"
    )
}

pub(crate) fn driven_here(driver: &str) -> String {
    format!("`{driver}` drives it")
}

pub(crate) fn too_many_jumps(found: usize, most: usize) -> String {
    format!(
        "{found} events let speeds jump, and at most {most} may: let loads that a memory switches push instead"
    )
}

pub(crate) fn sides_of_an_event(word: &str) -> String {
    format!("the two sides of `{word}`")
}

pub(crate) fn never_passes(event: &str, word: &str) -> String {
    format!(
        "`{event}` never occurs: nothing on either side of `{word}` changes while the mechanism moves; name a position, a velocity, \
         a state, a memory or the time"
    )
}

pub(crate) fn never_inside(contact: &str, what: &str) -> String {
    format!(
        "`{contact}` is rigid, and nothing is inside it, so that `{what}` does not pass this level: of a touch write `{contact}.closing falls 0`, \
         which an impulse does"
    )
}

/// What a period is called where its dimension is wrong.
pub(crate) fn period_of(event: &str) -> String {
    format!("the period of `{event}`")
}

pub(crate) fn period_too_short(event: &str, found: f64) -> String {
    format!(
        "the period of `{event}` must be a nanosecond or more, found {} s: write a time between two ticks, such as `every 1e-3 [s]`",
        number(found)
    )
}

pub(crate) fn sets_no_memory(name: &str) -> String {
    format!(
        "`{name}` is no memory, and events set memories and let speeds jump, nothing else: declare another name by \
         `memory NAME [unit] = value;`"
    )
}

pub(crate) fn assigned_quantity(name: &str) -> String {
    format!(
        "no quantity of `{name}` can be set like that: events set memories, which `memory NAME [unit] = value;` declares, and let speeds \
         jump, `jump({name}.…) = value;`"
    )
}

pub(crate) fn unknown_memory<'a>(name: &str, memories: impl Iterator<Item = &'a str>) -> String {
    match closest(name, memories) {
        Some(similar) => format!("no memory called \"{name}\"; did you mean \"{similar}\"?"),
        None => format!("no memory called \"{name}\": declare it by `memory {name} [unit] = value;`"),
    }
}

pub(crate) fn set_twice(memory: &str, event: &str) -> String {
    format!(
        "`{event}` sets `{memory}` twice, and all that it sets is of the values before it: leave one of both out"
    )
}

pub(crate) fn set_by_two(memory: &str, event: &str, earlier: &str) -> String {
    format!(
        "`{event}` occurs where `{earlier}` does, and both set `{memory}`: write one event, or set another memory"
    )
}

pub(crate) fn set_here_too(memory: &str) -> String {
    format!("`{memory}` is set here too")
}

pub(crate) fn memory_never_set(memory: &str) -> String {
    format!(
        "no event sets the memory `{memory}`, so it keeps its start value: write `param {memory} [unit] = value;`, or \
         `#[allow(unused)]` before it"
    )
}

pub(crate) fn memories_in_c(memory: &str) -> String {
    format!(
        "the functions in C take whole steps and find no event within them, so that `{memory}` would be late: leave \
         `export_c` out, or give what `{memory}` says as an input"
    )
}
