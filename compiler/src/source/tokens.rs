//! Lexemes → the tokens that rustc would hand to the macro, and the place of each by its serial number.

use super::lexer::{Kind, Lexeme, lex};
use super::{Located, Source, delimiters};
use crate::diagnostics::{Diagnostics, Region};
use crate::messages;
use crate::syntax::DEEPEST;
use proc_macro2::{Delimiter, Group, Ident, Literal, Punct, Spacing, Span, TokenStream, TokenTree};
use std::ops::Range;

/// The tokens of a definition and where they stand.
#[derive(Clone, Debug)]
pub struct Tokens {
    pub stream: TokenStream,
    /// By serial number, as [`crate::syntax`] counts them: one for a token, a second one for the end of a group. Number 0
    /// is what stands behind the definition.
    pub(super) places: Vec<Range<usize>>,
    /// The call of the macro that has put them together: tokens side by side may then stand far apart.
    pub(super) call: Option<Range<usize>>,
}

impl Default for Tokens {
    /// None, at the beginning of the text.
    fn default() -> Self {
        Self { stream: TokenStream::new(), places: std::iter::once(0..0).collect(), call: None }
    }
}

impl Tokens {
    /// Where a region of these tokens stands.
    pub fn place(&self, region: Region) -> Range<usize> {
        let (first, last) = region.tokens();
        let (first, last) =
            (&self.places[first], &self.places[if self.call.is_some() { first } else { last }]);
        first.start..last.end.max(first.end)
    }

    /// The errors at their places.
    pub fn locate(&self, errors: Diagnostics) -> Vec<Located> {
        let call = self.call.iter().map(|call| (call.clone(), messages::written_by_macro()));
        let located = errors.into_found().into_iter().map(|error| {
            let notes = error.notes.into_iter().map(|note| (self.place(note.region), note.message));
            Located {
                severity: error.severity,
                range: self.place(error.region),
                message: error.message,
                notes: notes.chain(call.clone()).collect(),
            }
        });
        located.collect()
    }
}

/// The tokens of a text that is one definition. After errors they are those that could be read, for the item that takes the
/// mechanism's place.
pub fn definition(source: &Source) -> (Tokens, Vec<Located>) {
    definition_at(source, Span::call_site())
}

/// The same with a span for all tokens: where rustc is to show what it has to say of them.
pub(crate) fn definition_at(source: &Source, span: Span) -> (Tokens, Vec<Located>) {
    let mut errors = Vec::new();
    let lexemes = lex(&source.text, &mut errors);
    if errors.is_empty() {
        // A string that never ends takes delimiters along.
        errors.extend(delimiters::unbalanced(source, &lexemes));
    }
    let pieces = pieces(source, &lexemes, span, &mut errors);
    let end = source.text.trim_end().len();
    (tokens(pieces, end..end, span, &mut errors), errors)
}

/// A token, or one end of a group, with its place.
#[derive(Clone, Debug)]
pub(super) struct Piece {
    pub what: What,
    pub place: Range<usize>,
}

#[derive(Clone, Debug)]
pub(super) enum What {
    Leaf(TokenTree),
    Open(Delimiter),
    Close(Delimiter),
}

/// Lexemes as tokens with this span.
pub(super) fn pieces(
    source: &Source,
    lexemes: &[Lexeme],
    span: Span,
    errors: &mut Vec<Located>,
) -> Vec<Piece> {
    let mut writer = Writer { span, pieces: Vec::with_capacity(lexemes.len()) };
    for (index, lexeme) in lexemes.iter().enumerate() {
        let joint = matches!(lexemes.get(index + 1), Some(Lexeme { kind: Kind::Punct(_), range })
            if range.start == lexeme.range.end);
        if let Err(message) = writer.lexeme(lexeme, &source.text[lexeme.range.clone()], joint) {
            errors.push(Located::new(lexeme.range.clone(), message));
        }
    }
    writer.pieces
}

/// Nests them. Behind them stands `end`; what closes nothing is left out, and what is open at the end is closed there.
pub(super) fn tokens(pieces: Vec<Piece>, end: Range<usize>, span: Span, errors: &mut Vec<Located>) -> Tokens {
    let mut nest = Nest { span, groups: Vec::new(), trees: Vec::new(), places: vec![end.clone()] };
    for Piece { what, place } in pieces {
        match what {
            What::Leaf(tree) => {
                nest.trees.push(tree);
                nest.places.push(place);
            }
            What::Open(_) if nest.groups.len() >= DEEPEST => {
                errors.push(Located::new(place, messages::too_deep(DEEPEST)));
                break;
            }
            What::Open(delimiter) => nest.open(delimiter, place),
            What::Close(_) => nest.close(place),
        }
    }
    while !nest.groups.is_empty() {
        nest.close(end.clone());
    }
    Tokens { stream: nest.trees.into_iter().collect(), places: nest.places, call: None }
}

struct Nest {
    span: Span,
    /// The groups that are open: delimiter, serial number, and the tokens before it.
    groups: Vec<(Delimiter, usize, Vec<TokenTree>)>,
    /// The tokens of the innermost.
    trees: Vec<TokenTree>,
    places: Vec<Range<usize>>,
}

impl Nest {
    fn open(&mut self, delimiter: Delimiter, place: Range<usize>) {
        self.groups.push((delimiter, self.places.len(), std::mem::take(&mut self.trees)));
        self.places.push(place);
    }

    fn close(&mut self, place: Range<usize>) {
        let Some((delimiter, serial, before)) = self.groups.pop() else { return };
        let inside = std::mem::replace(&mut self.trees, before);
        let mut group = Group::new(delimiter, inside.into_iter().collect());
        group.set_span(self.span);
        self.trees.push(group.into());
        self.places[serial].end = place.end.max(self.places[serial].end);
        self.places.push(place);
    }
}

struct Writer {
    span: Span,
    pieces: Vec<Piece>,
}

impl Writer {
    fn leaf(&mut self, tree: impl Into<TokenTree>, place: &Range<usize>) {
        let mut tree = tree.into();
        tree.set_span(self.span);
        self.pieces.push(Piece { what: What::Leaf(tree), place: place.clone() });
    }

    fn lexeme(&mut self, lexeme: &Lexeme, text: &str, joint: bool) -> Result<(), String> {
        let range = &lexeme.range;
        match lexeme.kind {
            Kind::Word => self.leaf(Ident::new(text, self.span), range),
            Kind::RawWord => {
                let word = &text["r#".len()..];
                if ["self", "Self", "super", "crate", "_"].contains(&word) {
                    return Err(messages::keyword(word));
                }
                self.leaf(Ident::new_raw(word, self.span), range);
            }
            Kind::Number if !is_number(text) => return Err(messages::not_decimal(text)),
            Kind::Number | Kind::Text => {
                let literal: Literal = text.parse().map_err(|_| messages::not_a_literal(text))?;
                self.leaf(literal, range);
            }
            Kind::Lifetime => {
                let name = range.start + 1;
                self.leaf(Punct::new('\'', Spacing::Joint), &(range.start..name));
                self.leaf(Ident::new(&text[1..], self.span), &(name..range.end));
            }
            Kind::Punct(character) => {
                let spacing = if joint { Spacing::Joint } else { Spacing::Alone };
                self.leaf(Punct::new(character, spacing), range);
            }
            Kind::Doc { inner, ahead, behind } => self.doc(range, inner, &text[ahead..text.len() - behind]),
            Kind::Open(delimiter) => {
                self.pieces.push(Piece { what: What::Open(delimiter), place: range.clone() })
            }
            Kind::Close(delimiter) => {
                self.pieces.push(Piece { what: What::Close(delimiter), place: range.clone() })
            }
        }
        Ok(())
    }

    /// `/// text` is `#[doc = " text"]`.
    fn doc(&mut self, place: &Range<usize>, inner: bool, text: &str) {
        self.leaf(Punct::new('#', Spacing::Alone), place);
        if inner {
            self.leaf(Punct::new('!', Spacing::Alone), place);
        }
        self.pieces.push(Piece { what: What::Open(Delimiter::Bracket), place: place.clone() });
        self.leaf(Ident::new("doc", self.span), place);
        self.leaf(Punct::new('=', Spacing::Alone), place);
        self.leaf(Literal::string(text), place);
        self.pieces.push(Piece { what: What::Close(Delimiter::Bracket), place: place.clone() });
    }
}

impl Piece {
    /// Whether it is this word or character.
    pub fn is(&self, text: &str) -> bool {
        match &self.what {
            What::Leaf(TokenTree::Ident(word)) => *word == text,
            What::Leaf(TokenTree::Punct(punct)) => text.len() == 1 && text.starts_with(punct.as_char()),
            _ => false,
        }
    }

    /// The word that it is.
    pub fn word(&self) -> Option<String> {
        match &self.what {
            What::Leaf(TokenTree::Ident(word)) => Some(word.to_string()),
            _ => None,
        }
    }

    pub fn is_literal(&self) -> bool {
        matches!(&self.what, What::Leaf(TokenTree::Literal(_))) || self.is("true") || self.is("false")
    }
}

/// How many pieces the token tree that comes first has: 0 where none comes, and where its group is not closed.
pub(super) fn tree(pieces: &[Piece]) -> usize {
    let mut depth = 0;
    for (index, piece) in pieces.iter().enumerate() {
        match piece.what {
            What::Open(_) => depth += 1,
            What::Close(_) if depth == 0 => return 0,
            What::Close(_) => depth -= 1,
            What::Leaf(_) => {}
        }
        if depth == 0 {
            return index + 1;
        }
    }
    0
}

/// The same if it is a group, else 0.
pub(super) fn group(pieces: &[Piece]) -> usize {
    if matches!(pieces.first(), Some(Piece { what: What::Open(_), .. })) { tree(pieces) } else { 0 }
}

/// Whether Rust reads it as a number, whatever its suffix.
fn is_number(text: &str) -> bool {
    let digits = |text: &str, base: u32| {
        let mut run = text.chars().take_while(|c| c.is_ascii_digit() || *c == '_' || c.is_digit(base));
        let digits: Vec<char> = run.by_ref().filter(|c| *c != '_').collect();
        !digits.is_empty() && digits.iter().all(|c| c.is_digit(base))
    };
    match text.get(..2) {
        Some("0x") => digits(&text[2..], 16),
        Some("0o") => digits(&text[2..], 8),
        Some("0b") => digits(&text[2..], 2),
        // An exponent without digits would be the beginning of the suffix.
        _ => {
            let mantissa = text.trim_start_matches(|c: char| c.is_ascii_digit() || "._".contains(c));
            let exponent = mantissa.strip_prefix(['e', 'E']);
            exponent.is_none_or(|rest| {
                rest.trim_start_matches(['+', '-', '_']).starts_with(|c: char| c.is_ascii_digit())
            })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;
    use std::str::FromStr;

    /// Kind, text and bytes of every token, in the order of the serial numbers.
    fn flat(stream: TokenStream, found: &mut Vec<(String, Option<Range<usize>>)>, with_places: bool) {
        for tree in stream {
            let place = with_places.then(|| tree.span().byte_range());
            match tree {
                TokenTree::Group(group) => {
                    found.push((format!("{:?}", group.delimiter()), place));
                    flat(group.stream(), found, with_places);
                    found.push(("end".to_string(), with_places.then(|| group.span_close().byte_range())));
                }
                tree => found.push((tree.to_string(), place)),
            }
        }
    }

    fn sources(folder: &Path, found: &mut Vec<std::path::PathBuf>) {
        for entry in std::fs::read_dir(folder).expect("a folder of the workspace") {
            let path = entry.expect("it can be listed").path();
            if path.is_dir() && !path.ends_with("target") {
                sources(&path, found);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                found.push(path);
            }
        }
    }

    /// Tokens and places of a text are those that `proc_macro2` finds in it.
    #[track_caller]
    fn same_tokens(name: &str, text: &str) {
        let source = Source::new(name, text);
        let (tokens, errors) = definition(&source);
        assert_eq!(errors, [], "{name}");
        let (mut ours, mut theirs) = (Vec::new(), Vec::new());
        flat(tokens.stream, &mut ours, false);
        flat(TokenStream::from_str(text).expect(name), &mut theirs, true);
        assert_eq!(ours.len(), theirs.len(), "{name}");
        assert_eq!(tokens.places.len(), theirs.len() + 1, "{name}");
        for (index, ((our, _), (their, place))) in ours.iter().zip(theirs.clone()).enumerate() {
            assert_eq!(*our, their, "{name}, {place:?}");
            let (ours, theirs) = (&tokens.places[index + 1], place.expect("it has been asked for"));
            // A doc comment is written without the brackets that it stands for.
            let comment = our == "end" && text[ours.clone()].starts_with("/") && ours.end == theirs.end;
            assert!(*ours == theirs || comment, "{name}: {our} at {ours:?}, {theirs:?}");
        }
    }

    #[test]
    fn sources_of_the_workspace_have_the_tokens_that_rust_reads() {
        let mut paths = Vec::new();
        for folder in ["models", "macros", "examples", "compiler/src/syntax", "compiler/src/emit"] {
            sources(&Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(folder), &mut paths);
        }
        assert!(paths.len() > 50, "{}", paths.len());
        for path in paths {
            let text = std::fs::read_to_string(&path).expect("sources are text");
            same_tokens(&path.display().to_string(), &text);
        }
    }

    #[test]
    fn tokens_that_are_seldom_written() {
        for text in [
            "r#type r\"a\" r#\"a\"b\"# br##\"\"#\"## b\"\\\"\" b'\\'' c\"x\" 'a' '\\'' '\\u{41}' 'é' 'static '_",
            "1.5e-3 1e5 1E+5f64 1_000.5 1. 1.. 1..2 1.x 0x_fFu8 0b1_0 0o17 7usize 1.0.to 2e_3",
            "a=-1 b>>=c d..=e f::g -> => && || !x ?x @ $ ~ \\u{e9}".trim_end_matches("\\u{e9}"),
            "/* a /* b */ c */ /**/ /*** d */ /** e */ x /*! f */ //// g\n/// h\n//! i\n// j",
            "\u{feff}größe µ αβ x'y",
        ] {
            same_tokens(text, text);
        }
    }
}
