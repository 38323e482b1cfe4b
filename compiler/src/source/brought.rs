//! What is said of the inside of a part, in the words of who uses it: the place inside the part, and the use that brought it.
//!
//! Beside the mechanism the place stands where it is, with a note at the use. Of a text of its own rustc knows nothing: there the
//! message is shown at the use and tells its place itself.

use super::{Located, Source, snippet};
use crate::diagnostics::{Diagnostic, Diagnostics, Lint, Note, Region, Severity};
use crate::messages;
use crate::syntax::{Definition, PartFile, PartUse};
use std::collections::BTreeSet;

/// The findings with their places as they are to be shown.
pub(crate) fn brought(definition: &Definition, found: Diagnostics) -> Diagnostics {
    let Definition { uses, files, .. } = definition;
    if uses.is_empty() && files.is_empty() {
        return found;
    }
    let mut known = BTreeSet::new();
    let mut all = Diagnostics::new();
    for diagnostic in found.into_found() {
        let used = use_of(uses, diagnostic.region);
        let of_text = file_of(files, diagnostic.region);
        if of_text.is_some() && diagnostic.severity == Severity::Warning(Lint::Unused) {
            // A part serves others, who may need what is not needed here.
            continue;
        }
        let plain = used.map_or_else(
            || diagnostic.message.clone(),
            |used| diagnostic.message.replace(&format!("{}.", used.name.text), ""),
        );
        if known.insert((diagnostic.region.tokens(), plain)) {
            all.push(shown(uses, files, diagnostic));
        }
    }
    all
}

fn shown(uses: &[PartUse], files: &[PartFile], diagnostic: Diagnostic) -> Diagnostic {
    let Diagnostic { severity, region, mut message, notes } = diagnostic;
    let (mut notes, others): (Vec<Note>, Vec<Note>) =
        notes.into_iter().partition(|note| file_of(files, note.region).is_none());
    let used = use_of(uses, region);
    let mut at = region;
    match (file_of(files, region), used) {
        (Some(file), used) => {
            snippet_of(&mut message, file, region);
            at = outermost(uses, region);
            if let Some(used) = used {
                message.push_str(&format!("\nnote: {}", messages::of_use(&used.name.text, &used.part)));
            }
        }
        (None, Some(used)) => notes.push(Note {
            region: outermost(uses, region),
            message: messages::used_here(&used.name.text, &used.part),
        }),
        (None, None) => {}
    }
    for Note { region, message: note } in others {
        let Some(file) = file_of(files, region) else { continue };
        message.push_str(&format!("\nnote: {note}"));
        snippet_of(&mut message, file, region);
    }
    Diagnostic { severity, region: at, message, notes }
}

/// The use that brought a region.
fn use_of(uses: &[PartUse], region: Region) -> Option<&PartUse> {
    uses.get(region.brought().checked_sub(1)?)
}

/// The use in the mechanism itself that a region came by; the region if none.
fn outermost(uses: &[PartUse], region: Region) -> Region {
    let mut at = region;
    while let Some(used) = use_of(uses, at) {
        at = used.region;
    }
    // Of a text that nothing uses the place is not one of the definition.
    if region.brought() == 0 { region.span().into() } else { at }
}

/// The text outside of the definition that a region stands in.
fn file_of(files: &[PartFile], region: Region) -> Option<&PartFile> {
    let (first, _) = region.tokens();
    files.iter().rev().find(|file| first > file.before)
}

/// The place and its line.
fn snippet_of(message: &mut String, file: &PartFile, region: Region) {
    let source = Source::new(file.shown.clone(), file.text.clone());
    let (first, last) = region.tokens();
    let place = |serial: usize| file.places.get(serial - file.before);
    if let Some((first, last)) = place(first).zip(place(last)) {
        let located = Located::new(first.start..last.end.max(first.end), std::mem::take(message));
        *message = snippet::text(&source, &located);
    }
}
