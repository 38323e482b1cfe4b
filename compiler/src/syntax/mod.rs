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
//!             ("body" | "rod" | "disk" | "box" | "particle" | "beam") name "{" property* "}"
//!             "flexible" name "(" "file" "=" text ")" "{" property* "}"
//!             "line" name "=" "(" place "," place ")" ";"                      a line of the ground
//!             "joint" name ":" kind "(" places, named arguments ")" ";"
//!             "constraint" name ":" (gear(a, b, ratio = …) | rack(a, b, radius = …) | expr "=" expr) ";"
//!             "drive" name ":" quantity "=" expr ";"
//!             ("force" | LOAD) name ":" LOAD "(" … ")" ("=" law)? ";"
//!             "output" name unit? "=" expr ";"
//!             "table" name "(" name unit? ("," name unit?)? ")" unit? "=" data ("," word)* ";"
//!             "part" Name "(" ports ")" "{" statement* "}"                     a declaration
//!             "part" Name "=" "file" "(" text ")" ";"                          that of a file
//!             "part" name ":" Name "(" (port "=" value),* ")" ";"              a use
//!             "repeat" i "in" expr ".." expr "{" statement* "}"
//!             "start" "{" (quantity unit? ("=" | "~") expr ";")* "}"
//!             "options" "{" … "}"      "expect" "{" … "}"
//! port        name ":" ("place" | "body" | "joint" | "table")   name unit? ("=" expr)?
//! toothing    "toothing" name ":" kind "(" (name "=" expr),* ")" ";"
//! property    ("mass" | "density" | "inertia" | "length" | "radius" | "width" | "height" | "thickness") unit? "=" expr ";"
//!             "center" unit? "=" pair ";"     "point" name unit? "=" pair ";"     "line" …
//! LOAD        force(place, direction = pair) "=" expr     force(place) "=" pair      torque(a) "=" expr
//!             and what else the forms of loads say, without a law
//! FRICTION    "friction" name ":" "on" "(" name ")" "=" law "(" (name unit? "=" expr),* ")" ";"
//! place       body "." point | "ground" pair unit?        pair   "(" expr "," expr ")" unit?
//! ```
//! A load is declared by the word `force` or by its own: `force s: spring(…)` and `spring s: spring(…)` are the same.
//! Named arguments take their unit beside the name or beside the number: `length [mm] = 3`, `length = 3 [mm]`.
//! Before statements and properties doc comments and `#[allow(unused)]` may stand.
//! Names may carry indices, `upright[i+1]`; a declared name with an index and a unit has the unit last.
//!
//! Looking names up, units of values and all meaning are left to `model`.

mod attributes;
mod beam;
mod body;
mod calls;
mod contacts;
mod definition;
mod definition_json;
mod expression;
mod friction;
mod habits;
mod header;
mod index;
mod memories;
mod modal;
mod pairs;
mod parser;
mod parts;
mod play;
mod scope;
mod settings;
mod shelf;
mod statements;
mod tables;
mod token;
mod toothings;
mod touches;
mod unread;

pub use definition::*;
pub use definition_json::definition_json;
pub use header::{Fields, Header, header};
pub(crate) use scope::BUILT_IN;
pub use shelf::{PartText, Shelf};
pub(crate) use token::{DEEPEST, KEYWORDS};

use crate::diagnostics::{Allowed, Diagnostics, Region};
use crate::forms::Vocabulary;
use crate::messages;
use attributes::Bearer;
use parser::{Failed, Parsed, Parser};
use proc_macro2::{Delimiter, Span, TokenStream};
use scope::Scope;
use shelf::Texts;
use std::collections::{BTreeMap, BTreeSet, HashMap};
use token::{Cursor, Token};
use unread::Unread;

/// `repeat` may unroll to this many rounds and statements.
const MOST_STATEMENTS: usize = 10_000;

/// Reads a definition. All syntax errors are reported, one for each statement.
///
/// With errors the definition holds what could be read, and what their places are to be understood with.
pub fn parse(
    tokens: TokenStream,
    vocabulary: &'static Vocabulary,
    shelf: &dyn Shelf,
) -> Result<Definition, (Box<Definition>, Diagnostics)> {
    let mut diagnostics = Diagnostics::new();
    let whole = tokens.clone().into_iter().next().map_or(Span::call_site(), |token| token.span());
    let tokens = token::convert(tokens, &mut diagnostics);
    if !diagnostics.is_empty() {
        // Groups are missing, and what is missing must not be reported a second time.
        return Err((Box::new(empty()), diagnostics));
    }
    let (definition, found, _) = read(&tokens, whole.into(), vocabulary, shelf, false);
    match found.finish(()) {
        Ok(()) => Ok(definition),
        Err(found) => Err((Box::new(definition), found)),
    }
}

/// What can be read of tokens, however wrong; `whole`: where they stand if there are none; `patient`: every round of a `repeat` too, where the first has an error.
fn read(
    tokens: &[Token],
    whole: Region,
    vocabulary: &'static Vocabulary,
    shelf: &dyn Shelf,
    patient: bool,
) -> (Definition, Diagnostics, Unread) {
    let mut diagnostics = Diagnostics::new();
    let mut texts = Texts::read(tokens, shelf, &mut diagnostics);
    let files = std::mem::take(&mut texts.files);
    let declarations = texts.declarations(tokens, shelf, &files, &mut diagnostics);
    let scope = Scope { inner: declarations.inner.clone(), ..Scope::default() };
    let mut parser = Parser {
        vocabulary,
        diagnostics,
        declarations,
        scope,
        definition: Definition { files, ..empty() },
        constants: HashMap::new(),
        integers: HashMap::new(),
        indices: Vec::new(),
        backwards: BTreeMap::new(),
        budget: MOST_STATEMENTS,
        depth: 0,
        patient,
        unread: Unread::default(),
    };
    // What is missing at the end is missing behind the last token.
    let end = tokens.last().map_or(whole, |last| last.region);
    let mut cursor = Cursor::new(tokens, end);
    if parser.item(&mut cursor).is_err() {
        parser.unread.others = true;
    }
    for (region, message) in std::mem::take(&mut parser.backwards).into_values().flatten() {
        parser.diagnostics.error(region, message);
    }
    (parser.definition, parser.diagnostics, parser.unread)
}

/// Whether a macro is called here.
fn is_macro(c: &Cursor) -> bool {
    let mut ahead = c.clone();
    ahead.advance();
    ahead.at_punct('!')
}

fn empty() -> Definition {
    Definition {
        space: Space::Planar,
        name: Label { text: String::new(), region: Span::call_site().into() },
        visibility: TokenStream::new(),
        attributes: TokenStream::new(),
        allowed: Allowed::default(),
        counted: BTreeSet::new(),
        parts: Vec::new(),
        uses: Vec::new(),
        files: Vec::new(),
        constants: Vec::new(),
        parameters: Vec::new(),
        inputs: Vec::new(),
        signals: Vec::new(),
        states: Vec::new(),
        rates: Vec::new(),
        memories: Vec::new(),
        events: Vec::new(),
        tables: Vec::new(),
        gravity: None,
        bodies: Vec::new(),
        lines: Vec::new(),
        markers: Vec::new(),
        joints: Vec::new(),
        constraints: Vec::new(),
        drivers: Vec::new(),
        loads: Vec::new(),
        surfaces: Vec::new(),
        materials: Vec::new(),
        contacts: Vec::new(),
        start: Vec::new(),
        steady: Vec::new(),
        deflected: Vec::new(),
        orientations: Vec::new(),
        options: Vec::new(),
        expect: Vec::new(),
        outputs: Vec::new(),
    }
}

impl Parser<'_> {
    /// `attributes visibility planar Name { … }` and nothing behind it.
    fn item(&mut self, c: &mut Cursor) -> Parsed<()> {
        if c.is_done() {
            return self.fail(c.region(), messages::empty_macro());
        }
        let start = c.region();
        let attributes = self.attributes(c, Bearer::Item)?;
        self.definition.attributes = attributes.handed_through;
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
            Some("part") => return self.fail(c.region(), messages::part_without_mechanism().to_string()),
            Some("file") => return self.fail(c.region(), messages::file_in_file()),
            Some("mechanism") if is_macro(c) => return self.fail(c.region(), messages::macro_in_file()),
            word => {
                let what = "`planar` or `spatial`, the kind of the mechanism";
                let advice = word.and_then(|word| messages::kind_of_mechanism(word, &self.statement_words()));
                return match advice {
                    Some(advice) => self.advised(c, what, &advice),
                    None => self.expected(c, what),
                };
            }
        }
        c.advance();
        self.definition.name = self.word(c, "the name of the mechanism")?;
        let inside = self.group(c, Delimiter::Brace)?;
        self.allow(&attributes.allowed, start.to(inside.end()));
        self.constants_first(inside.clone());
        self.statements(inside);
        self.end(c, "the end: one mechanism for each macro")
    }

    /// Reads the constants, so that indices and bounds may name those that stand further down.
    fn constants_first(&mut self, mut c: Cursor) {
        while !c.is_done() {
            let before = c.clone();
            let readable = c.skip_attributes();
            let Err(Failed) = self.constant_ahead(&mut c, readable) else { continue };
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
