//! The tokens as the parser reads them: converted once, numbered, so that the rounds of a `repeat` can read
//! them again at no cost. What they mean is left to the parser.

use crate::diagnostics::{Diagnostics, Region};
use crate::messages;
use proc_macro2::{Delimiter, Spacing, TokenStream, TokenTree};

/// Groups nested deeper than this are refused, and so are expressions.
pub(crate) const DEEPEST: usize = 96;

/// The keywords of Rust, which cannot be names in the generated code.
pub(crate) const KEYWORDS: [&str; 53] = [
    "Self", "abstract", "as", "async", "await", "become", "box", "break", "const", "continue", "crate", "do",
    "dyn", "else", "enum", "extern", "false", "final", "fn", "for", "gen", "if", "impl", "in", "let", "loop",
    "macro", "match", "mod", "move", "mut", "override", "priv", "pub", "ref", "return", "self", "static",
    "struct", "super", "trait", "true", "try", "type", "typeof", "union", "unsafe", "unsized", "use",
    "virtual", "where", "while", "yield",
];

/// One token with its place.
#[derive(Debug)]
pub(super) struct Token {
    pub kind: Kind,
    pub region: Region,
    /// As received, for the parts that are handed through (attributes, visibility, paths).
    pub original: TokenTree,
}

/// What a token is.
#[derive(Debug)]
pub(super) enum Kind {
    /// An identifier or keyword.
    Word(String),
    /// A numeric literal, digits as written without underscores.
    Number(String),
    /// Any other literal.
    Text(String),
    /// One character.
    Punct(char),
    /// A group, the region of its closing delimiter beside it.
    Group(Delimiter, Vec<Token>, Region),
}

/// Numbers and nests the tokens of a stream.
pub(super) fn convert(stream: TokenStream, diagnostics: &mut Diagnostics) -> Vec<Token> {
    convert_behind(stream, &mut 0, diagnostics)
}

/// The same with numbers behind those of other texts; leaves the last one in `serial`.
pub(super) fn convert_behind(
    stream: TokenStream,
    serial: &mut u32,
    diagnostics: &mut Diagnostics,
) -> Vec<Token> {
    convert_nested(stream, 0, serial, diagnostics)
}

fn convert_nested(
    stream: TokenStream,
    depth: usize,
    serial: &mut u32,
    diagnostics: &mut Diagnostics,
) -> Vec<Token> {
    let mut tokens = Vec::new();
    for tree in stream {
        *serial += 1;
        let region = Region::of_token(tree.span(), *serial);
        let kind = match &tree {
            TokenTree::Ident(ident) => Kind::Word(ident.to_string()),
            TokenTree::Punct(punct) => Kind::Punct(punct.as_char()),
            TokenTree::Literal(literal) => literal_kind(literal.to_string()),
            TokenTree::Group(group) => {
                if depth >= DEEPEST {
                    diagnostics.error(region, messages::too_deep(DEEPEST));
                    continue;
                }
                let inner = convert_nested(group.stream(), depth + 1, serial, diagnostics);
                *serial += 1;
                let close = Region::of_token(group.span_close(), *serial);
                // A macro's fragment of one token is that token; a longer one keeps its grouping.
                if group.delimiter() == Delimiter::None && inner.len() <= 1 {
                    tokens.extend(inner);
                    continue;
                }
                Kind::Group(group.delimiter(), inner, close)
            }
        };
        tokens.push(Token { kind, region, original: tree });
    }
    tokens
}

fn literal_kind(text: String) -> Kind {
    let digits = text.strip_prefix('-').unwrap_or(&text);
    if digits.starts_with(|c: char| c.is_ascii_digit()) {
        Kind::Number(text.replace('_', ""))
    } else {
        Kind::Text(text)
    }
}

/// A position in the tokens of one group.
#[derive(Clone, Debug)]
pub(super) struct Cursor<'t> {
    tokens: &'t [Token],
    at: usize,
    /// The closing delimiter: where something is missing when the tokens run out.
    close: Region,
    /// The use of a part that they are read for.
    brought: u32,
}

impl<'t> Cursor<'t> {
    pub fn new(tokens: &'t [Token], close: Region) -> Self {
        Self { tokens, at: 0, close, brought: 0 }
    }

    /// The same tokens, read for this use of a part.
    pub fn brought_by(&self, brought: u32) -> Self {
        Self { brought, close: self.close.brought_by(brought), ..self.clone() }
    }

    /// The place of one of these tokens.
    fn place(&self, region: Region) -> Region {
        region.brought_by(self.brought)
    }

    pub fn peek(&self) -> Option<&'t Token> {
        self.tokens.get(self.at)
    }

    pub fn peek_second(&self) -> Option<&'t Token> {
        self.tokens.get(self.at + 1)
    }

    pub fn is_done(&self) -> bool {
        self.at >= self.tokens.len()
    }

    pub fn advance(&mut self) -> Option<&'t Token> {
        let token = self.tokens.get(self.at)?;
        self.at += 1;
        Some(token)
    }

    /// The next token's place, or the end's.
    pub fn region(&self) -> Region {
        self.peek().map_or(self.close, |token| self.place(token.region))
    }

    /// The place of the token before this position.
    pub fn previous(&self) -> Region {
        match self.at.checked_sub(1).and_then(|before| self.tokens.get(before)) {
            Some(token) => self.place(token.region),
            None => self.close,
        }
    }

    /// The token this many before the position.
    pub fn back(&self, by: usize) -> Option<&'t Token> {
        self.tokens.get(self.at.checked_sub(by)?)
    }

    /// The end of what has been read, closing delimiter included.
    pub fn behind(&self) -> Region {
        match self.at.checked_sub(1).and_then(|before| self.tokens.get(before)) {
            Some(Token { kind: Kind::Group(.., close), .. }) => self.place(*close),
            Some(token) => self.place(token.region),
            None => self.close,
        }
    }

    /// The word that comes next.
    pub fn word(&self) -> Option<&'t str> {
        match &self.peek()?.kind {
            Kind::Word(word) => Some(word),
            _ => None,
        }
    }

    /// Whether this word comes next.
    pub fn at_word(&self, word: &str) -> bool {
        self.word() == Some(word)
    }

    /// Whether this character comes next.
    pub fn at_punct(&self, character: char) -> bool {
        is_punct(self.peek(), character)
    }

    /// Whether these two characters come next.
    pub fn at_puncts(&self, first: char, second: char) -> bool {
        is_punct(self.peek(), first) && is_punct(self.peek_second(), second)
    }

    /// Takes the character if it comes next.
    pub fn eat_punct(&mut self, character: char) -> bool {
        let eaten = self.at_punct(character);
        self.at += usize::from(eaten);
        eaten
    }

    /// Takes the word if it comes next.
    pub fn eat_word(&mut self, word: &str) -> bool {
        let eaten = self.at_word(word);
        self.at += usize::from(eaten);
        eaten
    }

    /// A cursor into the group that comes next, if it has this delimiter.
    pub fn inside(&self, delimiter: Delimiter) -> Option<Cursor<'t>> {
        match &self.peek()?.kind {
            Kind::Group(found, tokens, close) if *found == delimiter => {
                Some(Cursor::new(tokens, *close).brought_by(self.brought))
            }
            _ => None,
        }
    }

    /// Like [`Self::inside`], and steps over the group.
    pub fn enter(&mut self, delimiter: Delimiter) -> Option<Cursor<'t>> {
        let inside = self.inside(delimiter)?;
        self.at += 1;
        Some(inside)
    }

    /// How many groups of this delimiter follow one another from here.
    pub fn groups_ahead(&self, delimiter: Delimiter) -> usize {
        let is_one = |token: &&Token| matches!(&token.kind, Kind::Group(found, ..) if *found == delimiter);
        self.tokens[self.at.min(self.tokens.len())..].iter().take_while(is_one).count()
    }

    /// Whether a comma stands at this level further on.
    pub fn has_comma(&self) -> bool {
        self.tokens[self.at.min(self.tokens.len())..]
            .iter()
            .any(|token| matches!(token.kind, Kind::Punct(',')))
    }

    /// Whether what stands here up to the end may stand in `pub(…)`.
    pub fn is_restriction(&self) -> bool {
        let mut c = self.clone();
        if c.eat_word("in") {
            return c.is_path();
        }
        (c.eat_word("crate") || c.eat_word("self") || c.eat_word("super")) && c.is_done()
    }

    /// Whether a path stands here up to the end: words with `::` between them, and perhaps before the first.
    pub fn is_path(&self) -> bool {
        let mut c = self.clone();
        // `: :` is not `::` to Rust.
        let colons = |c: &mut Cursor| c.at_joint(':') && c.eat_punct(':') && c.eat_punct(':');
        if c.at_punct(':') && !colons(&mut c) {
            return false;
        }
        let mut inner = false;
        loop {
            let special = |word: &str| matches!(word, "crate" | "self" | "super");
            let is_name = |word: &str| word != "_" && !KEYWORDS.contains(&word);
            let fits = |word: &str| is_name(word) || (!inner && special(word)) || word == "super";
            if !c.word().is_some_and(fits) {
                return false;
            }
            inner = true;
            c.advance();
            if c.is_done() {
                return true;
            }
            if !colons(&mut c) {
                return false;
            }
        }
    }

    /// Whether what stands here up to the end may stand in `#[…]`: a path, then nothing, a group or `= value`.
    pub fn is_attribute(&self) -> bool {
        // `$meta` of a macro.
        if let [Token { kind: Kind::Group(Delimiter::None, inner, ..), .. }] = self.tokens {
            return Cursor::new(inner, self.close).is_attribute();
        }
        let is_value = |token: &Token| match &token.kind {
            Kind::Number(_) | Kind::Text(_) | Kind::Group(Delimiter::None, ..) => true,
            Kind::Word(word) => matches!(word.as_str(), "true" | "false"),
            _ => false,
        };
        let length =
            self.tokens.iter().take_while(|token| matches!(token.kind, Kind::Word(_) | Kind::Punct(':')));
        let (path, rest) = self.tokens.split_at(length.count());
        let rest_fits = match rest {
            [] => true,
            [group] => matches!(group.kind, Kind::Group(..)),
            [equals, value] => is_punct(Some(equals), '=') && is_value(value),
            // `doc = include_str!("…")`
            [equals, name, bang, arguments] => {
                is_punct(Some(equals), '=')
                    && matches!(name.kind, Kind::Word(_))
                    && is_punct(Some(bang), '!')
                    && matches!(arguments.kind, Kind::Group(..))
            }
            _ => false,
        };
        rest_fits && Cursor::new(path, self.close).is_path()
    }

    /// Whether this character comes next and the one behind it belongs to it.
    fn at_joint(&self, character: char) -> bool {
        let joint = |token: &Token| matches!(&token.original, TokenTree::Punct(punct) if punct.spacing() == Spacing::Joint);
        self.at_punct(character) && self.peek().is_some_and(joint)
    }

    /// After an error: to behind the next `;` or braces of this level.
    pub fn skip_statement(&mut self) {
        while let Some(token) = self.advance() {
            match token.kind {
                Kind::Punct(';') => return,
                // `if … { … } else { … };` of Rust is one statement.
                Kind::Group(Delimiter::Brace, ..) if !self.at_word("else") => {
                    self.eat_punct(';');
                    return;
                }
                _ => {}
            }
        }
    }

    /// Over attributes in front of a statement; whether they can be read.
    pub fn skip_attributes(&mut self) -> bool {
        while self.eat_punct('#') {
            if self.enter(Delimiter::Bracket).is_none() {
                return false;
            }
        }
        true
    }

    /// The closing delimiter.
    pub fn end(&self) -> Region {
        self.close
    }

    /// The tokens up to the next `;`.
    pub fn until_semicolon(&mut self) -> Cursor<'t> {
        let rest = &self.tokens[self.at.min(self.tokens.len())..];
        let length = rest.iter().take_while(|token| !matches!(token.kind, Kind::Punct(';'))).count();
        self.at += length;
        Cursor::new(&rest[..length], self.region()).brought_by(self.brought)
    }

    /// All tokens of this group, as received.
    pub fn originals(&self) -> TokenStream {
        self.tokens.iter().map(|token| token.original.clone()).collect()
    }

    /// The tokens from here to the end without spaces, and their region.
    pub fn joined(&self) -> String {
        let mut text = String::new();
        join(&self.tokens[self.at.min(self.tokens.len())..], &mut text);
        text
    }

    /// The token with this text, anywhere inside.
    pub fn find(&self, text: &str) -> Option<Region> {
        find(self.tokens, text).map(|region| self.place(region))
    }

    /// From the first token inside to the last; the closing delimiter if there is none.
    pub fn whole(&self) -> Region {
        match (self.tokens.first(), self.tokens.last()) {
            (Some(first), Some(last)) => self.place(first.region.to(last.region)),
            _ => self.close,
        }
    }
}

fn is_punct(token: Option<&Token>, character: char) -> bool {
    matches!(token, Some(Token { kind: Kind::Punct(found), .. }) if *found == character)
}

fn join(tokens: &[Token], text: &mut String) {
    for token in tokens {
        match &token.kind {
            Kind::Word(piece) | Kind::Number(piece) | Kind::Text(piece) => text.push_str(piece),
            Kind::Punct(character) => text.push(*character),
            Kind::Group(delimiter, inner, _) => {
                let (open, close) = match delimiter {
                    Delimiter::Brace => ("{", "}"),
                    Delimiter::Bracket => ("[", "]"),
                    Delimiter::Parenthesis | Delimiter::None => ("(", ")"),
                };
                text.push_str(open);
                join(inner, text);
                text.push_str(close);
            }
        }
    }
}

fn find(tokens: &[Token], text: &str) -> Option<Region> {
    tokens.iter().find_map(|token| match &token.kind {
        Kind::Word(piece) | Kind::Number(piece) if piece == text => Some(token.region),
        Kind::Group(_, inner, _) => find(inner, text),
        _ => None,
    })
}
