//! Tokens → [`Definition`]: what was written, with its places in the source.
//!
//! # Grammar
//!
//! ```text
//! item        attributes visibility "planar" Name "{" statement* "}"
//! statement   "const" NAME unit? "=" expr ";"
//!             "param" name unit? "=" expr ("in" expr ".." expr)? ";"
//!             "input" name unit? ";"
//!             "gravity" unit? "=" pair ";"
//!             ("body" | "rod" | "disk" | "box" | "particle") name "{" property* "}"
//!             "line" name "=" "(" place "," place ")" ";"                      a line of the ground
//!             "joint" name ":" kind "(" places, named arguments ")" ";"
//!             "constraint" name ":" (gear(a, b, ratio = …) | rack(a, b, radius = …) | expr "=" expr) ";"
//!             "drive" name ":" quantity "=" expr ";"
//!             ("force" | LOAD) name ":" LOAD "(" … ")" ("=" law)? ";"
//!             "output" name unit? "=" expr ";"
//!             "repeat" i "in" expr ".." expr "{" statement* "}"
//!             "start" "{" (quantity unit? ("=" | "~") expr ";")* "}"
//!             "options" "{" … "}"      "expect" "{" … "}"
//! property    ("mass" | "inertia" | "length" | "radius" | "width" | "height") unit? "=" expr ";"
//!             "center" unit? "=" pair ";"     "point" name unit? "=" pair ";"     "line" …
//! LOAD        force(place, direction = pair) "=" expr     force(place) "=" pair      torque(a) "=" expr
//!             spring(p, q, stiffness = …, length = …, damping = …)      damper(p, q, damping = …)
//!             torsion_spring(a, stiffness = …, angle = …, damping = …)
//! place       body "." point | "ground" pair unit?        pair   "(" expr "," expr ")" unit?
//! ```
//! A load is declared by the word `force` or by its own: `force s: spring(…)` and `spring s: spring(…)` are the same.
//! Named arguments take their unit beside the name or beside the number: `length [mm] = 3`, `length = 3 [mm]`.
//! Names may carry indices, `upright[i+1]`; a declared name with an index and a unit has the unit last.
//!
//! Looking names up, units of values and all meaning are left to `model`.

mod body;
mod calls;
mod definition;
mod definition_json;
mod expression;
mod index;
mod parser;
mod settings;
mod statements;
mod token;

pub use definition::*;
pub use definition_json::definition_json;
pub(crate) use token::KEYWORDS;

use crate::diagnostics::Diagnostics;
use crate::messages;
use parser::{Failed, Parsed, Parser};
use proc_macro2::{Delimiter, Span, TokenStream, TokenTree};
use std::collections::HashMap;
use token::Cursor;

/// `repeat` may unroll to this many rounds and statements.
const MOST_STATEMENTS: usize = 10_000;

/// What stands before the braces: enough for an item that takes the mechanism's place after an error.
#[derive(Clone, Debug)]
pub struct Header {
    /// `pub`, `pub(crate)` or nothing.
    pub visibility: TokenStream,
    /// Whether it moves in space.
    pub spatial: bool,
    /// The mechanism's name.
    pub name: proc_macro2::Ident,
    /// What is written between its braces.
    body: TokenStream,
}

impl Header {
    /// Names declared by a statement `word NAME …` at the top of the braces, however broken the rest may be.
    pub fn declared(&self, word: &str) -> Vec<String> {
        let mut names: Vec<String> = Vec::new();
        let mut statement = true;
        let mut tokens = self.body.clone().into_iter().peekable();
        while let Some(token) = tokens.next() {
            if let (true, TokenTree::Ident(ident), Some(TokenTree::Ident(name))) =
                (statement, &token, tokens.peek())
                && *ident == word
            {
                let name = name.to_string();
                if !names.contains(&name) {
                    names.push(name);
                }
            }
            statement = match &token {
                TokenTree::Punct(punct) => punct.as_char() == ';',
                TokenTree::Group(group) => group.delimiter() == Delimiter::Brace,
                _ => false,
            };
        }
        names
    }
}

/// Reads a definition. All syntax errors are reported, one for each statement.
pub fn parse(tokens: TokenStream) -> Result<Definition, Diagnostics> {
    let mut diagnostics = Diagnostics::new();
    let whole = tokens.clone().into_iter().next().map_or(Span::call_site(), |token| token.span());
    let tokens = token::convert(tokens, &mut diagnostics);
    if !diagnostics.is_empty() {
        // Groups are missing, and what is missing must not be reported a second time.
        return Err(diagnostics);
    }
    let mut parser = Parser {
        diagnostics,
        definition: empty(),
        constants: HashMap::new(),
        indices: Vec::new(),
        budget: MOST_STATEMENTS,
        depth: 0,
    };
    // What is missing at the end is missing behind the last token.
    let end = tokens.last().map_or(whole.into(), |last| last.region);
    let mut cursor = Cursor::new(&tokens, end);
    let _: Parsed<()> = parser.item(&mut cursor);
    let Parser { diagnostics, definition, .. } = parser;
    diagnostics.finish(definition)
}

/// The name and visibility of a definition that may be full of errors.
pub fn header(tokens: TokenStream) -> Option<Header> {
    let mut tokens = tokens.into_iter().peekable();
    while matches!(tokens.peek(), Some(TokenTree::Punct(punct)) if punct.as_char() == '#') {
        tokens.next();
        tokens.next();
    }
    let mut visibility = TokenStream::new();
    if matches!(tokens.peek(), Some(TokenTree::Ident(ident)) if *ident == "pub") {
        visibility.extend(tokens.next());
        if matches!(tokens.peek(), Some(TokenTree::Group(group)) if group.delimiter() != Delimiter::Brace) {
            let restriction = token::convert(tokens.next().into_iter().collect(), &mut Diagnostics::new());
            let inside = Cursor::new(&restriction, Span::call_site().into()).inside(Delimiter::Parenthesis);
            if inside.is_some_and(|inside| inside.is_restriction()) {
                visibility.extend(restriction.into_iter().map(|token| token.original));
            }
        }
    }
    let TokenTree::Ident(kind) = tokens.next()? else { return None };
    match tokens.next()? {
        TokenTree::Ident(name) => {
            let body = tokens.find_map(|token| match token {
                TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => Some(group.stream()),
                _ => None,
            });
            Some(Header { visibility, spatial: kind == "spatial", name, body: body.unwrap_or_default() })
        }
        // The kind was forgotten: `pub FourBar { … }`.
        TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => {
            Some(Header { visibility, spatial: false, name: kind, body: group.stream() })
        }
        _ => None,
    }
}

fn empty() -> Definition {
    Definition {
        space: Space::Planar,
        name: Label { text: String::new(), region: Span::call_site().into() },
        visibility: TokenStream::new(),
        attributes: TokenStream::new(),
        constants: Vec::new(),
        parameters: Vec::new(),
        inputs: Vec::new(),
        gravity: None,
        bodies: Vec::new(),
        lines: Vec::new(),
        markers: Vec::new(),
        joints: Vec::new(),
        constraints: Vec::new(),
        drivers: Vec::new(),
        loads: Vec::new(),
        start: Vec::new(),
        orientations: Vec::new(),
        options: Vec::new(),
        expect: Vec::new(),
        outputs: Vec::new(),
    }
}

impl Parser {
    /// `attributes visibility planar Name { … }` and nothing behind it.
    fn item(&mut self, c: &mut Cursor) -> Parsed<()> {
        if c.is_done() {
            return self.fail(c.region(), messages::empty_macro());
        }
        self.definition.attributes = self.attributes(c)?;
        if c.at_word("pub") {
            self.definition.visibility.extend(c.advance().map(|token| token.original.clone()));
            if let Some(inside) = c.inside(Delimiter::Parenthesis) {
                if !inside.is_restriction() {
                    return self.fail(c.region(), messages::visibility());
                }
                self.definition.visibility.extend(c.advance().map(|token| token.original.clone()));
            }
        }
        match c.word() {
            Some("planar") => {}
            Some("spatial") => self.definition.space = Space::Spatial,
            Some(word @ ("part" | "file")) => return self.fail(c.region(), messages::not_there_yet(word)),
            _ => return self.expected(c, "`planar` or `spatial`, the kind of the mechanism"),
        }
        c.advance();
        self.definition.name = self.word(c, "the name of the mechanism")?;
        let inside = self.group(c, Delimiter::Brace)?;
        self.constants_first(inside.clone());
        self.statements(inside);
        self.end(c, "the end: one mechanism for each macro")
    }

    /// Reads the constants, so that indices and bounds may name those that stand further down.
    fn constants_first(&mut self, mut c: Cursor) {
        while !c.is_done() {
            let before = c.clone();
            let attributes = self.attributes(&mut c);
            let Err(Failed) = self.constant_ahead(&mut c, attributes.is_ok()) else { continue };
            // Not a constant, or a constant with an error: on to the next statement.
            c = before;
            c.skip_statement();
        }
    }

    fn constant_ahead(&mut self, c: &mut Cursor, readable: bool) -> Parsed<()> {
        if !readable || !c.eat_word("const") {
            return Err(Failed);
        }
        let constant = self.constant(c)?;
        self.constants.entry(constant.name.text.clone()).or_insert_with(|| constant.entry.value.clone());
        self.definition.constants.push(constant);
        Ok(())
    }
}
