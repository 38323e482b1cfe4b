//! Expressions on the command line: inputs as functions of time, measures of runs. Numbers, names, `+ - * / ^`, functions.

use linkwright_compiler::spelling::closest;

/// What was written.
#[derive(Clone, Debug, PartialEq)]
pub enum Expression {
    Number(f64),
    Name(String),
    Negated(Box<Expression>),
    /// One of `+ - * / ^`.
    Pair(char, Box<[Expression; 2]>),
    Call(String, Vec<Expression>),
}

/// A function of so many numbers.
struct Known {
    name: &'static str,
    arguments: usize,
    value: fn(&[f64]) -> f64,
}

const fn known(name: &'static str, arguments: usize, value: fn(&[f64]) -> f64) -> Known {
    Known { name, arguments, value }
}

const FUNCTIONS: [Known; 20] = [
    known("sin", 1, |x| x[0].sin()),
    known("cos", 1, |x| x[0].cos()),
    known("tan", 1, |x| x[0].tan()),
    known("asin", 1, |x| x[0].asin()),
    known("acos", 1, |x| x[0].acos()),
    known("atan", 1, |x| x[0].atan()),
    known("atan2", 2, |x| x[0].atan2(x[1])),
    known("exp", 1, |x| x[0].exp()),
    known("ln", 1, |x| x[0].ln()),
    known("log10", 1, |x| x[0].log10()),
    known("sqrt", 1, |x| x[0].sqrt()),
    known("abs", 1, |x| x[0].abs()),
    known("sign", 1, |x| if x[0] == 0.0 { 0.0 } else { x[0].signum() }),
    known("sinh", 1, |x| x[0].sinh()),
    known("cosh", 1, |x| x[0].cosh()),
    known("tanh", 1, |x| x[0].tanh()),
    known("floor", 1, |x| x[0].floor()),
    known("min", 2, |x| x[0].min(x[1])),
    known("max", 2, |x| x[0].max(x[1])),
    // 0 before, 1 from then on.
    known("step", 1, |x| if x[0] < 0.0 { 0.0 } else { 1.0 }),
];

impl Expression {
    /// Reads one; the error is a sentence that names the place.
    pub fn parse(text: &str) -> Result<Expression, String> {
        let mut reader = Reader { text, at: 0 };
        let expression = reader.sum()?;
        match reader.peek() {
            None => Ok(expression),
            Some(c) => Err(reader.unexpected(c)),
        }
    }

    /// Its value, names looked up by `value_of`. Names and functions have been looked at by [`check`](Expression::check).
    pub fn value(&self, value_of: &dyn Fn(&str) -> Option<f64>) -> f64 {
        match self {
            Expression::Number(number) => *number,
            Expression::Name(name) => value_of(name).or_else(|| constant(name)).unwrap_or(f64::NAN),
            Expression::Negated(inner) => -inner.value(value_of),
            Expression::Pair(sign, operands) => {
                let [a, b] = &**operands;
                let (a, b) = (a.value(value_of), b.value(value_of));
                pair(*sign, a, b)
            }
            Expression::Call(name, arguments) => {
                let values: Vec<f64> = arguments.iter().map(|argument| argument.value(value_of)).collect();
                call(name, &values)
            }
        }
    }

    /// An error unless every name is one of `names` and every function is known and has as many arguments as it needs. `other` are
    /// functions of one argument beside those of numbers.
    pub fn check(&self, names: &[&str], other: &[&str]) -> Result<(), String> {
        match self {
            Expression::Number(_) => Ok(()),
            Expression::Name(name) => {
                if names.contains(&name.as_str()) || constant(name).is_some() {
                    return Ok(());
                }
                Err(unknown("nothing is called", name, names.iter().copied().chain(["pi"])))
            }
            Expression::Negated(inner) => inner.check(names, other),
            Expression::Pair(_, operands) => {
                operands.iter().try_for_each(|operand| operand.check(names, other))
            }
            Expression::Call(name, arguments) => {
                arguments.iter().try_for_each(|argument| argument.check(names, other))?;
                if other.contains(&name.as_str()) && arguments.len() == 1 {
                    return Ok(());
                }
                let Some(known) = FUNCTIONS.iter().find(|known| known.name == name) else {
                    let all = FUNCTIONS.iter().map(|known| known.name).chain(other.iter().copied());
                    return Err(unknown("no function is called", name, all));
                };
                if known.arguments == arguments.len() {
                    return Ok(());
                }
                let plural = if known.arguments == 1 { "argument" } else { "arguments" };
                Err(format!("`{name}` takes {} {plural}, {} are given", known.arguments, arguments.len()))
            }
        }
    }
}

/// The value of a function of numbers.
pub fn call(name: &str, values: &[f64]) -> f64 {
    let known = FUNCTIONS.iter().find(|known| known.name == name && known.arguments == values.len());
    known.map_or(f64::NAN, |known| (known.value)(values))
}

/// The value of `+ - * / ^`.
pub fn pair(sign: char, a: f64, b: f64) -> f64 {
    match sign {
        '+' => a + b,
        '-' => a - b,
        '*' => a * b,
        '/' => a / b,
        _ => a.powf(b),
    }
}

fn constant(name: &str) -> Option<f64> {
    (name == "pi").then_some(std::f64::consts::PI)
}

/// `nothing is called "spede"; did you mean `speed`? There are speed, force and pi`; the list only where it is short.
pub fn unknown<'a>(what: &str, name: &str, all: impl Iterator<Item = &'a str> + Clone) -> String {
    let mut list: Vec<&str> = all.clone().collect();
    list.dedup();
    let listed = match list.as_slice() {
        [] => "there are none".to_string(),
        [one] => format!("there is {one}"),
        [.., _] if list.len() > 24 => String::new(),
        [first @ .., last] => format!("there are {} and {last}", first.join(", ")),
    };
    match closest(name, all) {
        Some(near) => {
            let listed = listed.replacen("there", " There", 1);
            format!("{what} \"{name}\"; did you mean `{near}`?{listed}")
        }
        None if listed.is_empty() => format!("{what} \"{name}\""),
        None => format!("{what} \"{name}\": {listed}"),
    }
}

/// A text that is being read.
struct Reader<'t> {
    text: &'t str,
    at: usize,
}

impl Reader<'_> {
    fn peek(&mut self) -> Option<char> {
        let rest = &self.text[self.at..];
        self.at += rest.len() - rest.trim_start().len();
        self.text[self.at..].chars().next()
    }

    fn take(&mut self, wanted: char) -> bool {
        let is_there = self.peek() == Some(wanted);
        self.at += if is_there { wanted.len_utf8() } else { 0 };
        is_there
    }

    fn unexpected(&self, c: char) -> String {
        format!(
            "`{c}` is not expected at character {} of \"{}\"",
            self.text[..self.at].chars().count() + 1,
            self.text
        )
    }

    fn sum(&mut self) -> Result<Expression, String> {
        let mut left = self.product()?;
        while let Some(sign @ ('+' | '-')) = self.peek() {
            self.at += 1;
            left = Expression::Pair(sign, Box::new([left, self.product()?]));
        }
        Ok(left)
    }

    fn product(&mut self) -> Result<Expression, String> {
        let mut left = self.signed()?;
        while let Some(sign @ ('*' | '/')) = self.peek() {
            self.at += 1;
            left = Expression::Pair(sign, Box::new([left, self.signed()?]));
        }
        Ok(left)
    }

    /// −x² is −(x²), and 2^−1 is a half.
    fn signed(&mut self) -> Result<Expression, String> {
        if self.take('-') {
            return Ok(Expression::Negated(Box::new(self.signed()?)));
        }
        if self.take('+') {
            return self.signed();
        }
        let base = self.primary()?;
        if self.take('^') {
            return Ok(Expression::Pair('^', Box::new([base, self.signed()?])));
        }
        Ok(base)
    }

    fn primary(&mut self) -> Result<Expression, String> {
        let Some(first) = self.peek() else {
            return Err(format!("\"{}\" ends where a number or a name is expected", self.text));
        };
        if self.take('(') {
            let inner = self.sum()?;
            return if self.take(')') {
                Ok(inner)
            } else {
                Err(format!("`)` is missing in \"{}\"", self.text))
            };
        }
        if first.is_ascii_digit() || first == '.' {
            return self.number();
        }
        if !is_of_name(first) {
            return Err(self.unexpected(first));
        }
        let rest = &self.text[self.at..];
        let length = rest.find(|c| !is_of_name(c)).unwrap_or(rest.len());
        let name = rest[..length].to_string();
        self.at += length;
        if !self.take('(') {
            return Ok(Expression::Name(name));
        }
        let mut arguments = vec![self.sum()?];
        while self.take(',') {
            arguments.push(self.sum()?);
        }
        if self.take(')') {
            Ok(Expression::Call(name, arguments))
        } else {
            Err(format!("`)` is missing in \"{}\"", self.text))
        }
    }

    fn number(&mut self) -> Result<Expression, String> {
        let rest = &self.text[self.at..];
        let bytes = rest.as_bytes();
        let is_of_number = |(index, c): (usize, char)| {
            let signed = matches!(c, '+' | '-') && index > 0 && matches!(bytes[index - 1], b'e' | b'E');
            c.is_ascii_digit() || matches!(c, '.' | 'e' | 'E') || signed
        };
        let length = rest.char_indices().find(|at| !is_of_number(*at)).map_or(rest.len(), |(index, _)| index);
        let number = rest[..length].parse();
        let number =
            number.map_err(|_| format!("`{}` in \"{}\" is no number", &rest[..length], self.text))?;
        self.at += length;
        Ok(Expression::Number(number))
    }
}

/// Names have dots and indices: `upright[3].angle`.
fn is_of_name(c: char) -> bool {
    c.is_alphanumeric() || matches!(c, '_' | '.' | '[' | ']')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values() {
        let value_of = |name: &str| (name == "t").then_some(0.5);
        for (text, value) in [
            ("1 + 2 * 3", 7.0),
            ("-2^2", -4.0),
            ("2^-1 ^ 1", 0.5),
            ("(1 - 2) - 3", -4.0),
            ("8 / 4 / 2", 1.0),
            ("1.5e-1*10", 1.5),
            ("step(t - 0.5) + step(t - 0.6)", 1.0),
            ("max(t, 2) * sin(pi * t)", 2.0),
        ] {
            let expression = Expression::parse(text).expect(text);
            assert_eq!(expression.check(&["t"], &[]), Ok(()), "{text}");
            assert!((expression.value(&value_of) - value).abs() < 1e-12, "{text}");
        }
    }

    #[test]
    fn mistakes_are_said() {
        for (text, message) in [
            ("", "ends where a number or a name is expected"),
            ("1 +", "ends where"),
            ("(1", "`)` is missing"),
            ("1 2", "`2` is not expected at character 3"),
            ("a # b", "`#` is not expected at character 3"),
            ("1.2.3", "`1.2.3`"),
        ] {
            let error = Expression::parse(text).expect_err(text);
            assert!(error.contains(message), "{text}: {error}");
        }
        let check = |text: &str| Expression::parse(text).expect(text).check(&["speed", "t"], &["mean"]);
        assert_eq!(
            check("2 * spede").unwrap_err(),
            "nothing is called \"spede\"; did you mean `speed`? There are speed, t and pi"
        );
        assert!(check("sine(t)").unwrap_err().contains("did you mean `sin`?"));
        assert_eq!(check("atan2(t)").unwrap_err(), "`atan2` takes 2 arguments, 1 are given");
        assert_eq!(check("mean(t)"), Ok(()));
    }
}
