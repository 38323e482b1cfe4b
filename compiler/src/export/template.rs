//! Texts in C with places to fill in.
//!
//! ```text
//! @m, @M         the prefix of the mechanism: four_bar, FOUR_BAR
//! @real          double or float; @sqrt, @fabs, @floor for that type
//! @0.5           a number of that type
//! @size          any other name: what it is set to
//! @?rows text    a line only where `rows` is set; @!rows only where it is not
//! ```

use super::names::Prefix;
use crate::scalar::Scalar;
use std::collections::BTreeMap;

/// What is filled in.
#[derive(Clone, Debug)]
pub struct Template {
    scalar: Scalar,
    flags: BTreeMap<&'static str, bool>,
    words: BTreeMap<&'static str, String>,
}

impl Template {
    pub fn new(prefix: &Prefix, scalar: Scalar) -> Template {
        let suffix = |name: &str| match scalar {
            Scalar::F64 => name.to_string(),
            Scalar::F32 => format!("{name}f"),
        };
        let words = BTreeMap::from([
            ("m", prefix.lower.clone()),
            ("M", prefix.upper.clone()),
            ("real", scalar.c().to_string()),
            ("sqrt", suffix("sqrt")),
            ("fabs", suffix("fabs")),
            ("floor", suffix("floor")),
        ]);
        Template { scalar, flags: BTreeMap::new(), words }
    }

    /// Whether lines that ask for `name` stand.
    pub fn flag(&mut self, name: &'static str, value: bool) {
        self.flags.insert(name, value);
    }

    /// What `@name` stands for.
    pub fn word(&mut self, name: &'static str, value: String) {
        self.words.insert(name, value);
    }

    /// The text, filled in.
    pub fn fill(&self, text: &str) -> String {
        let mut filled = String::new();
        for line in text.lines() {
            if let Some(line) = self.line(line) {
                self.words(&mut filled, &line);
                filled.push('\n');
            }
        }
        filled
    }

    /// The line without its conditions, if they hold.
    fn line(&self, line: &str) -> Option<String> {
        let indent = line.len() - line.trim_start().len();
        let (space, mut rest) = line.split_at(indent);
        loop {
            let wanted = match rest.get(..2) {
                Some("@?") => true,
                Some("@!") => false,
                _ => return Some(format!("{space}{rest}")),
            };
            let end = rest.find(' ').unwrap_or(rest.len());
            let name = &rest[2..end];
            assert!(self.flags.contains_key(name), "a template asks for `{name}`");
            if self.flags[name] != wanted {
                return None;
            }
            rest = rest[end..].strip_prefix(' ').unwrap_or("");
        }
    }

    fn words(&self, filled: &mut String, line: &str) {
        let mut parts = line.split('@');
        filled.push_str(parts.next().unwrap_or(""));
        for part in parts {
            let number = part.starts_with(|letter: char| letter.is_ascii_digit());
            let belongs = |letter: char| {
                if number {
                    letter.is_ascii_digit() || matches!(letter, '.' | 'e')
                } else {
                    letter.is_ascii_alphanumeric()
                }
            };
            let end = part.find(|letter| !belongs(letter)).unwrap_or(part.len());
            let (name, rest) = part.split_at(end);
            match name.parse::<f64>() {
                Ok(value) if number => filled.push_str(&self.scalar.literal(value)),
                _ => match self.words.get(name) {
                    Some(word) => filled.push_str(word),
                    None => unreachable!("a template asks for `@{name}`"),
                },
            }
            filled.push_str(rest);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_filled_in() {
        let mut template = Template::new(&Prefix::of("FourBar"), Scalar::F32);
        template.flag("rows", true);
        template.flag("angles", false);
        template.word("n", "3".to_string());
        let text =
            "@real @m_x[@n]; /* @M_X */\n  @?rows y = @sqrt(x) * @0.5;\n@?rows @!angles z;\n@?angles no;";
        let filled = "float four_bar_x[3]; /* FOUR_BAR_X */\n  y = sqrtf(x) * 0.5F;\nz;\n";
        assert_eq!(template.fill(text), filled);
    }
}
