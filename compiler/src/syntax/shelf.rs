//! Declarations of parts, found before anything is read: beside the mechanism, in files that it names, in the library.
//!
//! ```text
//! part Leg(hip: place, side [1] = 1) { … }        a declaration, in files perhaps behind `planar` or `spatial`
//! part Leg = file("leg.mech");                    that of a file
//! part left: Leg(hip = hull.left, side = -1);     a use
//! ```

use super::definition::{FileTerm, Label, OnDisk, PartFile, Space};
use super::token::{self, Cursor, Kind, Token};
use crate::diagnostics::Diagnostics;
use crate::messages;
use proc_macro2::{Delimiter, TokenStream};
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

/// Where the texts of parts are that stand outside of the definition.
pub trait Shelf {
    /// A file that a definition names, or why it cannot be read.
    fn file(&self, file: &FileTerm) -> Result<PartText, String>;
    /// The text of the library that declares a part of this name.
    fn library(&self, part: &str) -> Option<PartText>;
    /// The parts of the library.
    fn names(&self) -> &[&'static str];
}

/// A text that declares parts.
pub struct PartText {
    pub tokens: TokenStream,
    /// As messages show it.
    pub shown: String,
    /// Nothing of the library.
    pub on_disk: Option<OnDisk>,
    pub text: String,
    /// By serial number of the tokens.
    pub places: Vec<Range<usize>>,
}

/// A part that is declared.
#[derive(Clone)]
pub(super) struct Declared<'t> {
    pub name: Label,
    /// Where it may be used, if not everywhere.
    pub space: Option<Space>,
    /// What stands in its parentheses, if there are any.
    pub ports: Option<Cursor<'t>>,
    pub body: Cursor<'t>,
    pub file: Option<usize>,
    pub inner: Inner,
}

/// What a name can be the beginning of: the uses of parts and the tables of a mechanism or of a part.
#[derive(Clone, Debug, Default)]
pub(super) struct Inner {
    /// The part of each use, indices of its name left out.
    pub uses: BTreeMap<String, String>,
    pub tables: BTreeSet<String>,
}

/// All declarations that a definition may use.
#[derive(Clone, Default)]
pub(super) struct Declarations<'t> {
    /// By the file that they stand in, and by name.
    found: BTreeMap<(Option<usize>, String), Declared<'t>>,
    /// The file of each part of the library that is used.
    library: BTreeMap<String, usize>,
    /// Every part that could be used.
    names: Vec<String>,
    /// Of the mechanism itself.
    pub inner: Inner,
    /// Parts of files that do not have them.
    pub missing: BTreeSet<String>,
}

impl<'t> Declarations<'t> {
    /// The part of this name as seen in a file: its own, or that of the library.
    pub fn get(&self, file: Option<usize>, name: &str) -> Option<&Declared<'t>> {
        let own = self.found.get(&(file, name.to_string()));
        own.or_else(|| self.found.get(&(Some(*self.library.get(name)?), name.to_string())))
    }

    /// The nearest name.
    pub fn similar(&self, name: &str) -> Option<&str> {
        messages::closest(name, self.names.iter().map(String::as_str))
    }
}

/// The texts outside of the definition, as tokens, and what was wrong with them.
#[derive(Default)]
pub(super) struct Texts {
    pub tokens: Vec<Vec<Token>>,
    pub files: Vec<PartFile>,
    /// The part that the definition takes from which file.
    imports: Vec<(Label, usize)>,
    library: BTreeMap<String, usize>,
    /// Parts of files that cannot be read.
    missing: BTreeSet<String>,
}

impl Texts {
    /// Reads what the definition names, and of the library what is used.
    pub fn read(main: &[Token], shelf: &dyn Shelf, diagnostics: &mut Diagnostics) -> Self {
        let mut texts = Texts::default();
        let mut last = last_serial(main);
        let found = found_in(definition_of(main));
        let mut named: BTreeSet<String> = found.imports.iter().map(|(name, _)| name.text.clone()).collect();
        for (name, file) in &found.imports {
            match shelf.file(file) {
                Ok(text) => {
                    texts.imports.push((name.clone(), texts.files.len()));
                    texts.add(text, &mut last, diagnostics);
                }
                Err(message) => {
                    diagnostics.error(file.region, message);
                    texts.missing.insert(name.text.clone());
                }
            }
        }
        named.extend(found.declared.iter().map(|declared| declared.name.text.clone()));
        let mut pending: Vec<String> =
            found.inner.uses.into_values().filter(|it| !named.contains(it)).collect();
        pending.extend(found.declared.iter().flat_map(|it| it.inner.uses.values().cloned()));
        pending.extend(texts.tokens.iter().flat_map(|tokens| uses_in(tokens)));
        while let Some(name) = pending.pop() {
            if texts.library.contains_key(&name) {
                continue;
            }
            let Some(text) = shelf.library(&name) else { continue };
            texts.library.insert(name, texts.files.len());
            texts.add(text, &mut last, diagnostics);
            pending.extend(texts.tokens.last().into_iter().flat_map(|tokens| uses_in(tokens)));
        }
        texts
    }

    fn add(&mut self, text: PartText, last: &mut u32, diagnostics: &mut Diagnostics) {
        let before = *last as usize;
        self.tokens.push(token::convert_behind(text.tokens, last, diagnostics));
        let PartText { shown, on_disk, text, places, .. } = text;
        self.files.push(PartFile { shown, on_disk, text, places, before });
    }

    /// Every declaration, by where it stands.
    pub fn declarations<'t>(
        &'t self,
        main: &'t [Token],
        shelf: &dyn Shelf,
        files: &[PartFile],
        diagnostics: &mut Diagnostics,
    ) -> Declarations<'t> {
        let mut all = Declarations {
            library: self.library.clone(),
            missing: self.missing.clone(),
            ..Declarations::default()
        };
        let own = found_in(definition_of(main));
        all.inner = own.inner;
        let mut enter = |declared: Declared<'t>, file: Option<usize>, diagnostics: &mut Diagnostics| {
            let key = (file, declared.name.text.clone());
            if let Some(first) = all.found.get(&key) {
                let message = messages::part_twice(&declared.name.text);
                let note = messages::first_here(&declared.name.text);
                diagnostics.conflict(declared.name.region, message, first.name.region, note);
                return;
            }
            all.found.insert(key, declared);
        };
        for declared in own.declared {
            enter(declared, None, diagnostics);
        }
        for (index, tokens) in self.tokens.iter().enumerate() {
            let end = tokens.last().map_or_else(|| proc_macro2::Span::call_site().into(), |it| it.region);
            for declared in found_in(Cursor::new(tokens, end)).declared {
                enter(Declared { file: Some(index), ..declared }, Some(index), diagnostics);
            }
        }
        for (name, index) in &self.imports {
            match all.found.get(&(Some(*index), name.text.clone())).cloned() {
                Some(declared) if !all.found.contains_key(&(None, name.text.clone())) => {
                    all.found.insert((None, name.text.clone()), declared);
                }
                Some(_) => diagnostics.error(name.region, messages::part_twice(&name.text)),
                None => {
                    let of_file = all.found.keys().filter(|(file, _)| *file == Some(*index));
                    let mut there: Vec<&str> = of_file.map(|(_, name)| name.as_str()).collect();
                    there.sort_unstable();
                    let shown = &files[*index].shown;
                    diagnostics.error(name.region, messages::part_not_in_file(&name.text, shown, &there));
                    all.missing.insert(name.text.clone());
                }
            }
        }
        let own = all.found.keys().filter(|(file, _)| file.is_none()).map(|(_, name)| name.clone());
        all.names = own.chain(shelf.names().iter().map(|name| name.to_string())).collect();
        all.names.sort_unstable();
        all
    }
}

/// The serial number of the last token.
fn last_serial(tokens: &[Token]) -> u32 {
    let last = match tokens.last() {
        Some(Token { kind: Kind::Group(.., close), .. }) => *close,
        Some(token) => token.region,
        None => return 0,
    };
    last.serials().1
}

/// The braces of the mechanism.
fn definition_of(main: &[Token]) -> Cursor<'_> {
    let mut c = Cursor::new(main, proc_macro2::Span::call_site().into());
    while !c.is_done() {
        if let Some(inside) = c.enter(Delimiter::Brace) {
            return inside;
        }
        c.advance();
    }
    c
}

/// The parts that a text uses.
fn uses_in(tokens: &[Token]) -> Vec<String> {
    let found = found_in(Cursor::new(tokens, proc_macro2::Span::call_site().into()));
    found.declared.iter().flat_map(|declared| declared.inner.uses.values().cloned()).collect()
}

#[derive(Default)]
struct Found<'t> {
    declared: Vec<Declared<'t>>,
    imports: Vec<(Label, FileTerm)>,
    inner: Inner,
}

/// What stands at this level; uses and tables in the braces of `repeat` too.
fn found_in(mut c: Cursor) -> Found {
    let mut found = Found::default();
    let mut space = None;
    while !c.is_done() {
        match c.word() {
            Some("planar") => space = Some(Space::Planar),
            Some("spatial") => space = Some(Space::Spatial),
            Some("part") => {
                c.advance();
                part(&mut c, space.take(), &mut found);
                continue;
            }
            Some("table") => {
                c.advance();
                found.inner.tables.extend(c.word().map(str::to_string));
                continue;
            }
            _ => space = None,
        }
        if let Some(inside) = c.inside(Delimiter::Brace) {
            let Found { inner, .. } = found_in(inside);
            found.inner.uses.extend(inner.uses);
            found.inner.tables.extend(inner.tables);
        }
        c.advance();
    }
    found
}

/// What stands behind the word `part`, as far as it is that of a statement.
fn part<'t>(c: &mut Cursor<'t>, space: Option<Space>, found: &mut Found<'t>) {
    let (Some(word), region) = (c.word(), c.region()) else { return };
    let name = Label { text: word.to_string(), region };
    c.advance();
    let mut ahead = c.clone();
    let ports = ahead.enter(Delimiter::Parenthesis);
    if let Some(body) = ahead.enter(Delimiter::Brace) {
        let inner = found_in(body.clone()).inner;
        found.declared.push(Declared { name, space, ports, body, file: None, inner });
        *c = ahead;
        return;
    }
    while ahead.enter(Delimiter::Bracket).is_some() {}
    if ahead.eat_punct(':') {
        found.inner.uses.extend(ahead.word().map(|part| (name.text, part.to_string())));
    } else if ahead.eat_punct('=') && ahead.eat_word("file") {
        found.imports.extend(ahead.inside(Delimiter::Parenthesis).and_then(file).map(|file| (name, file)));
    }
}

/// `"leg.mech"`
fn file(mut inside: Cursor) -> Option<FileTerm> {
    let region = inside.region();
    let Kind::Text(text) = &inside.advance()?.kind else { return None };
    let name = syn::parse_str::<syn::LitStr>(text).ok()?.value();
    Some(FileTerm { name, region, skip: 0 })
}
