//! A definition as it stands in its Rust file, with its comments and its lines: what a macro is given are tokens.

use proc_macro2::{Span, TokenStream};
use std::fs;
use std::path::PathBuf;

/// Where a token stands: its file; line and column of its beginning and of its end, both from 1.
#[derive(Clone, Debug)]
pub struct Place {
    pub file: PathBuf,
    pub start: [usize; 2],
    pub end: [usize; 2],
}

impl Place {
    /// In this file, and nobody knows where.
    pub fn somewhere(file: impl Into<PathBuf>) -> Self {
        Place { file: file.into(), start: [0, 0], end: [0, 0] }
    }
}

/// The text of these tokens in their file; nothing where other tokens stand there, as in a definition that comes out of a macro or in a
/// file that an editor has not saved.
pub fn as_written(tokens: &TokenStream, place_of: &dyn Fn(Span) -> Option<Place>) -> Option<String> {
    let mut all = tokens.clone().into_iter();
    let first = all.next()?;
    let last = all.last().unwrap_or_else(|| first.clone());
    let (from, to) = (place_of(first.span())?, place_of(last.span())?);
    let text = (from.file == to.file).then(|| fs::read_to_string(&from.file).ok())??;
    let written = text.get(byte(&text, from.start)?..byte(&text, to.end)?)?;
    let same = written.parse::<TokenStream>().is_ok_and(|read| read.to_string() == tokens.to_string());
    same.then(|| shifted(written, from.start[1] - 1))
}

/// The byte at a line and a column, counted in characters.
fn byte(text: &str, [line, column]: [usize; 2]) -> Option<usize> {
    let begin = match line {
        0 => return None,
        1 => 0,
        _ => text.match_indices('\n').nth(line - 2)?.0 + 1,
    };
    let own = text[begin..].split('\n').next()?;
    let mut ends = own.char_indices().map(|(at, _)| at).chain([own.len()]);
    Some(begin + ends.nth(column.checked_sub(1)?)?)
}

/// Without the indentation of the first line.
fn shifted(text: &str, indentation: usize) -> String {
    let mut lines = text.split('\n');
    let first = lines.next().unwrap_or_default().to_string();
    lines.fold(first, |whole, line| {
        let spaces = line.len() - line.trim_start_matches(' ').len();
        whole + "\n" + &line[spaces.min(indentation)..]
    })
}

#[cfg(test)]
mod tests {
    use super::{byte, shifted};

    #[test]
    fn places_are_bytes() {
        let text = "a\nbä c\n";
        let at = [[1, 1], [1, 2], [2, 1], [2, 3], [2, 5]].map(|place| byte(text, place));
        assert_eq!(at, [Some(0), Some(1), Some(2), Some(5), Some(7)]);
        assert_eq!([[0, 1], [1, 0], [1, 3], [9, 1]].map(|place| byte(text, place)), [None; 4]);
    }

    #[test]
    fn the_first_line_leads() {
        assert_eq!(shifted("a {\n        b\n  c\n    }", 4), "a {\n    b\nc\n}");
    }
}
