//! Errors for people: the lines they speak of, underlined, with the notes beside the places they point at.

use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};
use linkwright_compiler::diagnostics::Severity;
use linkwright_compiler::source::{Located, Source};

/// How errors are drawn.
pub fn renderer(colours: bool) -> Renderer {
    if colours { Renderer::styled() } else { Renderer::plain() }
}

/// One error or warning with all of its places.
pub fn finding(renderer: &Renderer, source: &Source, found: &Located) -> String {
    let notes = found
        .notes
        .iter()
        .map(|(range, message)| AnnotationKind::Context.span(range.clone()).label(message.as_str()));
    let snippet = Snippet::source(source.text.as_str())
        .path(source.name.as_str())
        .annotation(AnnotationKind::Primary.span(found.range.clone()))
        .annotations(notes);
    let level = if found.severity == Severity::Error { Level::ERROR } else { Level::WARNING };
    let group = level.primary_title(found.message.as_str()).element(snippet);
    renderer.render(&[group]) + "\n"
}

/// An error without a place.
pub fn plain(renderer: &Renderer, message: &str) -> String {
    use annotate_snippets::Group;
    renderer.render(&[Group::with_title(Level::ERROR.primary_title(message))]) + "\n"
}
