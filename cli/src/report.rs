//! Errors for people: the lines they speak of, underlined, with the notes beside the places they point at.

use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};
use linkwright_compiler::source::{Located, Source};

/// How errors are drawn.
pub fn renderer(colours: bool) -> Renderer {
    if colours { Renderer::styled() } else { Renderer::plain() }
}

/// One error with all of its places.
pub fn error(renderer: &Renderer, source: &Source, error: &Located) -> String {
    let notes = error
        .notes
        .iter()
        .map(|(range, message)| AnnotationKind::Context.span(range.clone()).label(message.as_str()));
    let snippet = Snippet::source(source.text.as_str())
        .path(source.name.as_str())
        .annotation(AnnotationKind::Primary.span(error.range.clone()))
        .annotations(notes);
    let group = Level::ERROR.primary_title(error.message.as_str()).element(snippet);
    renderer.render(&[group]) + "\n"
}

/// An error without a place.
pub fn plain(renderer: &Renderer, message: &str) -> String {
    use annotate_snippets::Group;
    renderer.render(&[Group::with_title(Level::ERROR.primary_title(message))]) + "\n"
}
