//! Of states and their rates.

use super::closest;

pub(crate) fn state_without_start(name: &str) -> String {
    format!("the state \"{name}\" has no start value: write `state {name} [unit] = value;`")
}

pub(crate) fn state_without_rate(name: &str) -> String {
    format!("the state `{name}` has no rate: write `rate {name} = …;`, in its unit per second")
}

pub(crate) fn two_rates(name: &str) -> String {
    format!("`{name}` has a rate already: a state has one")
}

pub(crate) fn rate_with_unit(name: &str) -> String {
    format!("a rate has the unit of its state per second: write `rate {name} = …;`")
}

pub(crate) fn rate_of_no_state(name: &str) -> String {
    format!(
        "`{name}` is no state: only what is declared by `state {name} [unit] = value;` has a rate of its own"
    )
}

pub(crate) fn unknown_state<'a>(name: &str, states: impl Iterator<Item = &'a str>) -> String {
    match closest(name, states) {
        Some(similar) => format!("no state called \"{name}\"; did you mean \"{similar}\"?"),
        None => format!("no state called \"{name}\": declare it by `state {name} [unit] = value;`"),
    }
}

pub(crate) fn steady_twice(name: &str) -> String {
    format!("`{name}` is among the steady states twice")
}

/// What a rate is called where its dimension is wrong.
pub(crate) fn rate_of(name: &str) -> String {
    format!("the rate of `{name}`")
}

pub(crate) fn state_that_rests(name: &str) -> String {
    format!("the rate of `{name}` is zero, so it keeps its start value: write `param {name} [unit] = value;`")
}

pub(crate) fn scale_not_positive(found: f64) -> String {
    format!("the scale of a state must be positive, found {}", super::number(found))
}
