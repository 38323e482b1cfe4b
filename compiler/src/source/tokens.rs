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
    places: Vec<Range<usize>>,
}

impl Default for Tokens {
    /// None, at the beginning of the text.
    fn default() -> Self {
        Self { stream: TokenStream::new(), places: vec![0..0] }
    }
}

impl Tokens {
    /// Where a region of these tokens stands.
    pub fn place(&self, region: Region) -> Range<usize> {
        let (first, last) = region.tokens();
        let (first, last) = (&self.places[first], &self.places[last]);
        first.start..last.end.max(first.end)
    }

    /// The errors at their places.
    pub fn locate(&self, errors: Diagnostics) -> Vec<Located> {
        let located = errors.into_errors().into_iter().map(|error| Located {
            range: self.place(error.region),
            message: error.message,
            notes: error.notes.into_iter().map(|note| (self.place(note.region), note.message)).collect(),
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
    let end = source.text.trim_end().len();
    let tokens = convert(source, &lexemes, end..end, span, &mut errors);
    (tokens, errors)
}

/// The tokens of some lexemes, behind which `end` stands.
pub(super) fn convert(
    source: &Source,
    lexemes: &[Lexeme],
    end: Range<usize>,
    span: Span,
    errors: &mut Vec<Located>,
) -> Tokens {
    let mut builder =
        Builder { source, span, groups: Vec::new(), trees: Vec::new(), places: vec![end.clone()] };
    for (index, lexeme) in lexemes.iter().enumerate() {
        match lexeme.kind {
            Kind::Open(_) if builder.groups.len() >= DEEPEST => {
                errors.push(Located::new(lexeme.range.clone(), messages::too_deep(DEEPEST)));
                break;
            }
            Kind::Open(delimiter) => builder.open(delimiter, &lexeme.range),
            Kind::Close(_) => builder.close(&lexeme.range),
            _ => {
                let joint = matches!(lexemes.get(index + 1), Some(Lexeme { kind: Kind::Punct(_), range })
                    if range.start == lexeme.range.end);
                if let Err(error) = builder.token(lexeme, joint) {
                    errors.push(error);
                }
            }
        }
    }
    while !builder.groups.is_empty() {
        builder.close(&end);
    }
    Tokens { stream: builder.trees.into_iter().collect(), places: builder.places }
}

struct Builder<'s> {
    source: &'s Source,
    span: Span,
    /// The groups that are open: delimiter, serial number, and the tokens before it.
    groups: Vec<(Delimiter, usize, Vec<TokenTree>)>,
    /// The tokens of the innermost.
    trees: Vec<TokenTree>,
    places: Vec<Range<usize>>,
}

impl Builder<'_> {
    fn push(&mut self, tree: impl Into<TokenTree>, place: &Range<usize>) {
        let mut tree = tree.into();
        tree.set_span(self.span);
        self.trees.push(tree);
        self.places.push(place.clone());
    }

    fn open(&mut self, delimiter: Delimiter, place: &Range<usize>) {
        self.groups.push((delimiter, self.places.len(), std::mem::take(&mut self.trees)));
        self.places.push(place.clone());
    }

    fn close(&mut self, place: &Range<usize>) {
        let Some((delimiter, serial, before)) = self.groups.pop() else { return };
        let inside = std::mem::replace(&mut self.trees, before);
        let mut group = Group::new(delimiter, inside.into_iter().collect());
        group.set_span(self.span);
        self.trees.push(group.into());
        self.places[serial].end = place.end;
        self.places.push(place.clone());
    }

    fn token(&mut self, lexeme: &Lexeme, joint: bool) -> Result<(), Located> {
        let range = &lexeme.range;
        let text = &self.source.text[range.clone()];
        let wrong = |message| Located::new(range.clone(), message);
        match lexeme.kind {
            Kind::Word => self.push(Ident::new(text, self.span), range),
            Kind::RawWord => {
                let word = &text["r#".len()..];
                if ["self", "Self", "super", "crate", "_"].contains(&word) {
                    return Err(wrong(messages::keyword(word)));
                }
                self.push(Ident::new_raw(word, self.span), range);
            }
            Kind::Number if !is_number(text) => return Err(wrong(messages::not_decimal(text))),
            Kind::Number | Kind::Text => {
                let literal: Literal = text.parse().map_err(|_| wrong(messages::not_a_literal(text)))?;
                self.push(literal, range);
            }
            Kind::Lifetime => {
                let name = range.start + 1;
                self.push(Punct::new('\'', Spacing::Joint), &(range.start..name));
                self.push(Ident::new(&text[1..], self.span), &(name..range.end));
            }
            Kind::Punct(character) => {
                let spacing = if joint { Spacing::Joint } else { Spacing::Alone };
                self.push(Punct::new(character, spacing), range);
            }
            Kind::Doc { inner, ahead, behind } => self.doc(range, inner, &text[ahead..text.len() - behind]),
            Kind::Open(_) | Kind::Close(_) => {}
        }
        Ok(())
    }

    /// `/// text` is `#[doc = " text"]`.
    fn doc(&mut self, place: &Range<usize>, inner: bool, text: &str) {
        self.push(Punct::new('#', Spacing::Alone), place);
        if inner {
            self.push(Punct::new('!', Spacing::Alone), place);
        }
        self.open(Delimiter::Bracket, place);
        self.push(Ident::new("doc", self.span), place);
        self.push(Punct::new('=', Spacing::Alone), place);
        self.push(Literal::string(text), place);
        self.close(place);
    }
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
