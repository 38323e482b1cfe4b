//! Numbers and names as a reader wants them.

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
        return minus(rounded.trim_end_matches('0').trim_end_matches('.'));
    }
    if let Some(fraction) = fraction(value) {
        return minus(&fraction);
    }
    if !scale.is_finite() {
        return shortest;
    }
    let exponent = libm::floor(libm::log10(scale)) as i32;
    if (-4..7).contains(&exponent) {
        let digits = (5 - exponent).clamp(0, 9) as usize;
        let text = format!("{value:.digits$}");
        return minus(if text.contains('.') {
            text.trim_end_matches('0').trim_end_matches('.')
        } else {
            &text
        });
    }
    let text = format!("{value:.5e}");
    let (mantissa, power) = text.split_once('e').unwrap_or((&text, "0"));
    let mantissa =
        if mantissa.contains('.') { mantissa.trim_end_matches('0').trim_end_matches('.') } else { mantissa };
    minus(&format!("{mantissa}e{power}"))
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
