//! All texts of messages of the front end: what is wrong, why, and what to write instead. One file a subject; those of
//! the assembled mechanism stand in `check/messages.rs`.

mod beams;
mod composition;
mod contacts;
mod curves;
mod files;
mod flex;
mod friction;
mod gears;
mod habits;
mod hysteresis;
mod memories;
mod names;
mod parts;
mod penalty;
mod states;
mod tables;
mod values;
mod warnings;
mod writing;

pub(crate) use beams::*;
pub(crate) use composition::*;
pub(crate) use contacts::*;
pub(crate) use curves::*;
pub(crate) use files::*;
pub(crate) use flex::*;
pub(crate) use friction::*;
pub(crate) use gears::*;
pub(crate) use habits::*;
pub(crate) use hysteresis::*;
pub(crate) use memories::*;
pub(crate) use names::*;
pub(crate) use parts::*;
pub(crate) use penalty::*;
pub(crate) use states::*;
pub(crate) use tables::*;
pub(crate) use values::*;
pub(crate) use warnings::*;
pub(crate) use writing::*;

pub(crate) use crate::spelling::closest;

// ---- Advice -----------------------------------------------------------------------------------------------------

pub(crate) fn angle_without_unit(function: &str, text: &str) -> String {
    format!(
        "{function} of a bare number: write its unit, `{function}({text} [deg])` or `{function}({text} [rad])`"
    )
}

/// As messages show it.
pub(crate) fn number(value: f64) -> String {
    crate::numbers::significant(value, 5)
}

// ---- The compiler itself ----------------------------------------------------------------------------------------

pub(crate) fn unreadable_expansion(error: &str) -> String {
    format!(
        "the generated code could not be read back ({error}); this is a mistake of Linkwright: please report it with this definition"
    )
}

/// The compiler has found a mistake of its own.
pub(crate) fn contradiction(
    check: &str,
    at: &str,
    [found, expected, margin]: [f64; 3],
    state: &str,
) -> String {
    format!(
        "Linkwright contradicts itself, so there is no model: this is a mistake of Linkwright, not of the definition. It \
         compared {check} and found at {at} {found:e} in place of {expected:e} (to within {margin:.1e}), with {state}. Please report \
         this message with the definition; `options {{ self_check = off; }}` takes the model unchecked"
    )
}
