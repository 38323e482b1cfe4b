//! Numbers and names as a reader wants them.

use crate::numbers::{significant, trimmed};

/// What rounding does to a number, relative to it.
const NEAR: f64 = 4.0 * f64::EPSILON;

/// Six digits at most, simple fractions as such.
pub fn decimal(value: f64) -> String {
    let shortest = format!("{value}");
    let scale = value.abs();
    if shortest.len() <= 8 && (scale == 0.0 || (1e-4..1e7).contains(&scale)) {
        return minus(&shortest);
    }
    let rounded = format!("{value:.6}");
    let is_same = |text: &str| text.parse().is_ok_and(|other: f64| (other - value).abs() <= NEAR * scale);
    if scale < 1e4 && is_same(&rounded) {
        return minus(trimmed(&rounded));
    }
    if let Some(fraction) = fraction(value) {
        return minus(&fraction);
    }
    minus(&significant(value, 6))
}

/// A number whose digits do not end, as a fraction with a small denominator.
fn fraction(value: f64) -> Option<String> {
    (3..=24).find_map(|denominator| {
        let numerator = value * f64::from(denominator);
        let whole = numerator.round();
        let is_one = (numerator - whole).abs() <= NEAR * whole.abs();
        (is_one && whole != 0.0 && whole.abs() < 1000.0).then(|| format!("{whole}/{denominator}"))
    })
}

fn minus(text: &str) -> String {
    text.replace('-', "−")
}

/// A count with its noun.
pub fn count(number: usize, one: &str, many: &str) -> String {
    format!("{number} {}", if number == 1 { one } else { many })
}
