//! Numbers as people read them.

/// At most so many significant digits, without zeros at the end; powers of ten where there would be many zeros.
pub fn significant(value: f64, digits: usize) -> String {
    if value == 0.0 || !value.is_finite() {
        // No −0.
        return format!("{}", value + 0.0);
    }
    let text = format!("{value:.*e}", digits.max(1) - 1);
    let (mantissa, power) = text.split_once('e').unwrap_or((&text, "0"));
    // The exponent of the rounded number, which may have a digit more: 9.9996 becomes 10.
    let exponent: i32 = power.parse().unwrap_or(0);
    if (-4..6).contains(&exponent) {
        let behind = usize::try_from(digits as i32 - 1 - exponent).unwrap_or(0);
        trimmed(&format!("{value:.behind$}")).to_string()
    } else {
        format!("{}e{exponent}", trimmed(mantissa))
    }
}

/// The same of a length, an angle or a rate in SI units: what is only rounding of a zero among these is zero.
pub fn coordinate(value: f64, digits: usize) -> String {
    significant(if value.abs() < 1e-12 { 0.0 } else { value }, digits)
}

/// Without zeros at the end of a fraction.
pub fn trimmed(text: &str) -> &str {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text }
}

#[cfg(test)]
mod tests {
    use super::{coordinate, significant};

    #[test]
    fn rounding_of_a_zero_is_zero() {
        for (value, text) in [(-3e-17, "0"), (1e-9, "1e-9"), (-0.25, "-0.25"), (f64::NAN, "NaN")] {
            assert_eq!(coordinate(value, 4), text, "{value:?}");
        }
    }

    #[test]
    fn digits_are_those_that_say_something() {
        let cases = [
            (0.0, 4, "0"),
            (-0.0, 4, "0"),
            (90.0, 6, "90"),
            (0.1 + 0.2, 6, "0.3"),
            (9.99996, 4, "10"),
            (-1.0 / 3.0, 4, "-0.3333"),
            (0.000123456, 3, "0.000123"),
            (0.0000123456, 3, "1.23e-5"),
            (123456.7, 4, "123457"),
            (999_999.6, 6, "1e6"),
            (12_345_678.0, 6, "1.23457e7"),
            (f64::INFINITY, 6, "inf"),
            (f64::NAN, 6, "NaN"),
        ];
        for (value, digits, text) in cases {
            assert_eq!(significant(value, digits), text, "{value:?} with {digits} digits");
        }
    }
}
