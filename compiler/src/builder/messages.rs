//! The texts of what cannot be written down.

/// A number that is none.
pub fn not_finite(value: f64) -> String {
    format!("{value} is no number that a definition can have; give a finite one")
}

/// Text that is no name.
pub fn no_name(text: &str) -> String {
    format!(
        "`{}` is no name: names have letters, digits and `_`, and whole numbers in brackets behind",
        text.escape_debug()
    )
}

/// Text that is no unit.
pub fn no_unit(text: &str) -> String {
    format!("`{}` is no unit: units are such as `kg*m^2` and `rad/s`", text.escape_debug())
}
