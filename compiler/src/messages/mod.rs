//! All texts of messages of the front end: what is wrong, why, and what to write instead. One file a subject; those of
//! the assembled mechanism stand in `check/messages.rs`.

mod files;
mod habits;
mod names;
mod parts;
mod values;
mod warnings;
mod writing;

pub(crate) use files::*;
pub(crate) use habits::*;
pub(crate) use names::*;
pub(crate) use parts::*;
pub(crate) use values::*;
pub(crate) use warnings::*;
pub(crate) use writing::*;

use crate::self_check::Contradiction;

// ---- Advice -----------------------------------------------------------------------------------------------------

/// The known word nearest to a misspelt one, if near enough to be meant.
pub(crate) fn closest<'a>(word: &str, known: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    let most = (word.chars().count() / 3).max(1);
    known
        .map(|candidate| (distance(word, candidate), candidate))
        // Nothing would be left of a single letter.
        .filter(|(edits, _)| *edits <= most && *edits < word.chars().count())
        .min_by_key(|(edits, _)| *edits)
        .map(|(_, candidate)| candidate)
}

/// Edits (insert, delete, replace, swap neighbours) from one word to another; letter case does not count.
fn distance(a: &str, b: &str) -> usize {
    let (a, b): (Vec<char>, Vec<char>) =
        (a.to_lowercase().chars().collect(), b.to_lowercase().chars().collect());
    let mut rows = vec![vec![0; b.len() + 1]; a.len() + 1];
    for (i, row) in rows.iter_mut().enumerate() {
        row[0] = i;
    }
    for (j, first) in rows[0].iter_mut().enumerate() {
        *first = j;
    }
    for i in 1..=a.len() {
        for j in 1..=b.len() {
            let replaced = rows[i - 1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
            let mut best = replaced.min(rows[i - 1][j] + 1).min(rows[i][j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                best = best.min(rows[i - 2][j - 2] + 1);
            }
            rows[i][j] = best;
        }
    }
    rows[a.len()][b.len()]
}

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
pub(crate) fn contradiction(contradiction: &Contradiction) -> String {
    let Contradiction { check, at, found, expected, margin, state } = contradiction;
    format!(
        "Linkwright contradicts itself, so there is no model: this is a mistake of Linkwright, not of the definition. It \
         compared {} and found at {at} {found:e} in place of {expected:e} (to within {margin:.1e}), with {state}. Please report \
         this message with the definition; `options {{ self_check = off; }}` takes the model unchecked",
        check.text()
    )
}
