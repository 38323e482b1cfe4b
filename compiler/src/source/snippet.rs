//! Errors of a file as text, for messages that have no place of their own in it: file, line, column, and the line with its
//! underline.
//!
//! ```text
//! no body called "crnk"; did you mean "crank"?
//!   --> arm.mech:12:26
//!    |
//! 12 | joint knee: revolute(crnk.end, coupler.start);
//!    |                      ^^^^
//! ```

use super::{Located, Source};
use crate::diagnostics::{Diagnostic, Diagnostics, Region, compile_error};
use proc_macro2::{Span, TokenStream};
use std::fmt::Write;
use std::ops::Range;

/// Longest part of a line that is shown, and how much of it stands before the place.
const MOST: usize = 140;
const BEFORE: usize = 60;

/// One compile error for each error of the file, its notes included, at a span outside of it.
pub fn compile_errors(source: &Source, errors: &[Located], span: Span) -> TokenStream {
    let mut stream = TokenStream::new();
    for error in errors {
        compile_error(&mut stream, span.into(), &text(source, error));
    }
    stream
}

/// The warnings of the file, their notes included, all at a region outside of it.
pub fn warnings(source: &Source, warnings: &[Located], at: Region) -> Diagnostics {
    let mut all = Diagnostics::new();
    for warning in warnings {
        let message = text(source, warning);
        all.push(Diagnostic { severity: warning.severity, region: at, message, notes: Vec::new() });
    }
    all
}

/// An error and its notes.
pub(super) fn text(source: &Source, error: &Located) -> String {
    let notes = error.notes.iter().map(|(range, _)| range);
    let last =
        std::iter::once(&error.range).chain(notes).map(|range| source.position(range.start).line).max();
    let width = last.unwrap_or(1).to_string().len();
    let mut text = error.message.clone();
    snippet(&mut text, source, &error.range, '^', width);
    for (range, message) in &error.notes {
        let _ = write!(text, "\nnote: {message}");
        snippet(&mut text, source, range, '~', width);
    }
    text
}

/// The place and its line, underlined as far as the region goes on it.
fn snippet(text: &mut String, source: &Source, range: &Range<usize>, mark: char, width: usize) {
    let position = source.position(range.start);
    let (line, start) = source.line(position.line);
    let from = (range.start - start).min(line.len());
    let to = (range.end - start).clamp(from, line.len());
    let [mut before, marked, after] = [&line[..from], &line[from..to], &line[to..]].map(spaced);
    if line.chars().count() > MOST
        && let Some((cut, _)) = before.char_indices().rev().nth(BEFORE)
    {
        before = format!("…{}", &before[cut..]);
    }
    let shown = MOST.saturating_sub(before.chars().count()).max(1);
    let marks = mark.to_string().repeat(marked.chars().count().clamp(1, shown));
    let mut rest: String = marked.chars().chain(after.chars()).collect();
    if let Some((cut, _)) = rest.char_indices().nth(shown) {
        rest.truncate(cut);
        rest.push('…');
    }
    let (column, indent) = (position.column, " ".repeat(before.chars().count()));
    let gutter = " ".repeat(width);
    let _ = write!(text, "\n{gutter}--> {}:{}:{column}", source.name, position.line);
    let _ =
        write!(text, "\n{gutter} |\n{:>width$} | {before}{rest}\n{gutter} | {indent}{marks}", position.line);
}

/// Tabs as spaces, and nothing invisible.
fn spaced(text: &str) -> String {
    text.replace('\t', "    ").replace('\u{feff}', "")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The error at the only `here` of a text.
    fn shown(text: &str) -> String {
        let source = Source::new("a.mech", text);
        let at = text.find("here").expect("a place");
        super::text(&source, &Located::new(at..at + 4, "wrong"))
    }

    #[test]
    fn tabs_and_other_characters_keep_the_underline_in_place() {
        assert_eq!(
            shown("one\n\tgröße = here;\r\n"),
            "wrong\n --> a.mech:2:10\n  |\n2 |     größe = here;\n  |             ^^^^"
        );
    }

    #[test]
    fn long_lines_are_cut_around_the_place() {
        let text = shown(&format!("{}here{}", "é".repeat(5000), "+".repeat(5000)));
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines[1], " --> a.mech:1:5001");
        assert!(lines[3].starts_with("1 | …é") && lines[3].ends_with("+…"), "{text}");
        assert!(lines[3].chars().count() < 160, "{text}");
        let column = |line: &str, mark: char| line.chars().position(|c| c == mark);
        assert_eq!(column(lines[3], 'h'), column(lines[4], '^'), "{text}");
    }

    #[test]
    fn regions_of_several_lines_are_underlined_on_the_first() {
        let source = Source::new("a.mech", "a b\nc");
        assert!(super::text(&source, &Located::new(2..5, "wrong")).ends_with("1 | a b\n  |   ^"));
    }
}
