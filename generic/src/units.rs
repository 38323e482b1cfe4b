//! Units as a user writes them, `kg*m^2/s^2`, to factors of SI. Dimensions are the compiler's affair.

use std::f64::consts::PI;

const PREFIXED: [&str; 14] = ["m", "g", "s", "N", "Pa", "J", "W", "Hz", "A", "V", "ohm", "H", "F", "Wb"];

/// The number by which a value in `unit` is multiplied to be in SI; `None` where it is no unit.
pub(crate) fn factor(unit: &str) -> Option<f64> {
    let tokens = tokens(unit)?;
    let mut rest = &tokens[..];
    let value = product(&mut rest, 0)?;
    rest.is_empty().then_some(value)
}

/// Words, numbers and operators.
fn tokens(unit: &str) -> Option<Vec<String>> {
    let mut tokens: Vec<String> = Vec::new();
    let mut goes_on = false;
    for letter in unit.chars() {
        let word = letter.is_alphanumeric() || letter == '.';
        match (word, goes_on, tokens.last_mut()) {
            (true, true, Some(last)) => last.push(letter),
            _ if letter.is_whitespace() => {}
            _ if word || "*/^()+-".contains(letter) => tokens.push(letter.to_string()),
            _ => return None,
        }
        goes_on = word;
    }
    Some(tokens)
}

/// Deeper groups are no unit of anybody's.
const DEEPEST: usize = 16;

fn product(rest: &mut &[String], depth: usize) -> Option<f64> {
    let mut value = power(rest, depth)?;
    while let Some((operator @ ("*" | "/"), behind)) = next(rest) {
        *rest = behind;
        let other = power(rest, depth)?;
        value = if operator == "*" { value * other } else { value / other };
    }
    Some(value)
}

fn next<'t>(rest: &&'t [String]) -> Option<(&'t str, &'t [String])> {
    let (first, behind) = rest.split_first()?;
    Some((first, behind))
}

fn taken(rest: &mut &[String], what: &str) -> bool {
    match next(rest) {
        Some((first, behind)) if first == what => {
            *rest = behind;
            true
        }
        _ => false,
    }
}

fn power(rest: &mut &[String], depth: usize) -> Option<f64> {
    let value = if taken(rest, "(") {
        if depth == DEEPEST {
            return None;
        }
        let value = product(rest, depth + 1)?;
        taken(rest, ")").then_some(value)?
    } else {
        let (first, behind) = next(rest)?;
        *rest = behind;
        single(first)?
    };
    if !taken(rest, "^") {
        return Some(value);
    }
    let grouped = taken(rest, "(");
    let sign = if taken(rest, "-") { -1.0 } else { 1.0 };
    let (first, behind) = next(rest)?;
    *rest = behind;
    let mut exponent = sign * first.parse::<f64>().ok()?;
    if grouped && taken(rest, "/") {
        let (first, behind) = next(rest)?;
        *rest = behind;
        exponent /= first.parse::<f64>().ok()?;
    }
    if grouped && !taken(rest, ")") {
        return None;
    }
    Some(value.powf(exponent))
}

fn single(name: &str) -> Option<f64> {
    let plain = match name {
        "1" | "kg" | "rad" => 1.0,
        "deg" => PI / 180.0,
        "rev" => 2.0 * PI,
        "rpm" => 2.0 * PI / 60.0,
        "bar" => 1e5,
        "t" => 1e3,
        "min" => 60.0,
        "h" => 3600.0,
        _ => return prefixed(name),
    };
    Some(plain)
}

fn prefixed(name: &str) -> Option<f64> {
    let own = |name: &str| PREFIXED.contains(&name).then_some(if name == "g" { 1e-3 } else { 1.0 });
    if let Some(factor) = own(name) {
        return Some(factor);
    }
    let mut letters = name.chars();
    let prefix = match letters.next()? {
        'f' => 1e-15,
        'p' => 1e-12,
        'n' => 1e-9,
        'u' | 'µ' | 'μ' => 1e-6,
        'm' => 1e-3,
        'c' => 1e-2,
        'd' => 1e-1,
        'h' => 1e2,
        'k' => 1e3,
        'M' => 1e6,
        'G' => 1e9,
        'T' => 1e12,
        _ => return None,
    };
    Some(prefix * own(letters.as_str())?)
}

#[cfg(test)]
mod tests {
    use super::factor;

    #[test]
    fn units_are_read_as_written() {
        let near = |unit: &str, value: f64| {
            let found = factor(unit).unwrap_or(f64::NAN);
            assert!((found - value).abs() <= 1e-15 * value, "{unit}: {found}");
        };
        near("kg*m^2", 1.0);
        near("mm", 1e-3);
        near("min", 60.0);
        near("kN/(mm*s)", 1e6);
        near("dm^3/min", 1e-3 / 60.0);
        near("m^(1/2)", 1.0);
        near("cm^-2", 1e4);
        near("rpm", std::f64::consts::TAU / 60.0);
    }

    #[test]
    fn what_is_no_unit_is_refused() {
        for text in ["", "inch", "m*", "(m", "m^", "m)", "m m", "3", "m^x", &"(".repeat(1000)] {
            assert_eq!(factor(text), None, "{text}");
        }
    }
}
