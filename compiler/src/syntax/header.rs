//! What can be said of a definition that may be full of errors: enough for items that take the mechanism's place.

use super::definition::{Definition, Label, Load, OptionEntry, TableData, TermKind};
use super::token::Cursor;
use super::{Shelf, read, token};
use crate::diagnostics::Diagnostics;
use crate::forms::{Owned, Vocabulary};
use crate::units::Unit;
use proc_macro2::{Delimiter, Ident, Span, TokenStream, TokenTree};
use std::collections::HashSet;

/// What stands before the braces, and the names that become fields.
#[derive(Clone, Debug)]
pub struct Header {
    /// `pub`, `pub(crate)` or nothing.
    pub visibility: TokenStream,
    /// Doc comments and attributes of the item.
    pub attributes: TokenStream,
    /// Whether it moves in space.
    pub spatial: bool,
    /// The mechanism's name.
    pub name: Ident,
    /// Path of the crate, as `options` say.
    pub crate_path: Option<TokenStream>,
    /// Fields of the parameters, inputs and outputs.
    pub parameters: Vec<String>,
    pub inputs: Vec<String>,
    pub outputs: Vec<String>,
    /// Of the internal states.
    pub states: Vec<String>,
    /// End of the struct's name, field and unit of those that were read and are not in SI units.
    pub declared: Vec<(&'static str, String, Unit)>,
    /// Names of the bodies and joints, as identifiers.
    pub bodies: Vec<String>,
    pub joints: Vec<String>,
    /// How many bodies, joints, loads and drivers there are, where no statement was given up.
    pub counts: Option<[usize; 4]>,
}

/// The header of a definition; nothing if not even a name was written.
pub fn header(tokens: TokenStream, vocabulary: &'static Vocabulary, shelf: &dyn Shelf) -> Option<Header> {
    let mut diagnostics = Diagnostics::new();
    let converted = token::convert(tokens.clone(), &mut diagnostics);
    let (definition, found) = read(&converted, Span::call_site().into(), vocabulary, shelf, true);
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
    let (name, spatial, body) = match tokens.next()? {
        TokenTree::Ident(name) => {
            let body = tokens.find_map(|token| match token {
                TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => Some(group.stream()),
                _ => None,
            });
            (name, kind == "spatial", body.unwrap_or_default())
        }
        // The kind was forgotten: `pub FourBar { … }`.
        TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => (kind, false, group.stream()),
        _ => return None,
    };
    let known = |labels: Vec<&Label>, word| fields(labels, &body, word);
    let mut bodies: Vec<String> = definition.bodies.iter().map(|it| identifier(&it.name)).collect();
    for form in vocabulary.bodies {
        let others = known(Vec::new(), form.word).into_iter().filter(|name| !bodies.contains(name));
        bodies.extend(others.collect::<Vec<_>>());
    }
    Some(Header {
        visibility,
        attributes: definition.attributes.clone(),
        spatial,
        name,
        crate_path: crate_path(&definition),
        parameters: known(definition.parameters.iter().map(|it| &it.name).collect(), "param"),
        inputs: known(definition.inputs.iter().map(|it| &it.name).collect(), "input"),
        outputs: known(definition.outputs.iter().map(|it| &it.name).collect(), "output"),
        states: {
            let declared = known(definition.states.iter().map(|it| &it.name).collect(), "state");
            declared
                .into_iter()
                .chain(definition.loads.iter().flat_map(|it| owned(&definition, it)))
                .collect()
        },
        declared: declared(&definition),
        bodies,
        joints: known(definition.joints.iter().map(|it| &it.name).collect(), "joint"),
        counts: found.is_empty().then_some([
            definition.bodies.len(),
            definition.joints.len(),
            definition.loads.len() + definition.contacts.len(),
            definition.drivers.len(),
        ]),
    })
}

/// The internal states of a load, of a backbone as many as its table has points.
fn owned(definition: &Definition, load: &Load) -> Vec<String> {
    let owner = identifier(&load.name);
    match load.form.owns {
        None => Vec::new(),
        Some(Owned::One { name, .. }) => vec![format!("{owner}_{name}")],
        Some(Owned::Elements { name, backbone }) => {
            let named = load.named.entry(backbone).map(|entry| &entry.value.kind);
            let Some(TermKind::Name(path)) = named else { return Vec::new() };
            let table = definition.tables.iter().find(|table| table.name.text == path.text);
            let count = match table.map(|table| &table.data) {
                Some(TableData::Points(points)) => points.len(),
                Some(TableData::Grid { .. } | TableData::File(_)) | None => 0,
            };
            (0..count).map(|index| format!("{owner}_{name}_{index}")).collect()
        }
    }
}

/// What was read with a unit that is not that of SI.
fn declared(definition: &Definition) -> Vec<(&'static str, String, Unit)> {
    let parameters = definition.parameters.iter().map(|it| ("Parameters", &it.name, it.entry.unit.as_ref()));
    let inputs = definition.inputs.iter().map(|it| ("Inputs", &it.name, it.unit.as_ref()));
    let outputs = definition.outputs.iter().map(|it| ("Outputs", &it.name, it.entry.unit.as_ref()));
    let states = definition.states.iter().map(|it| ("Internal", &it.name, it.entry.unit.as_ref()));
    let all = parameters.chain(inputs).chain(outputs).chain(states);
    let units = all.filter_map(|(of, name, unit)| Some((of, identifier(name), unit?.unit.clone())));
    units.filter(|(_, _, unit)| unit.scale != 1.0).collect()
}

fn crate_path(definition: &Definition) -> Option<TokenStream> {
    definition.options.iter().find_map(|option| match option {
        OptionEntry::Crate(path) => Some(path.clone()),
        _ => None,
    })
}

fn identifier(label: &Label) -> String {
    label.identifier()
}

/// Names of what has been read, rounds of `repeat` included, and of statements `word NAME …` that could not be read.
fn fields(read: Vec<&Label>, body: &TokenStream, word: &str) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    let mut known: HashSet<String> = HashSet::new();
    let mut add = |name: String| {
        if known.insert(name.clone()) {
            names.push(name);
        }
    };
    let indexed: HashSet<&str> =
        read.iter().filter_map(|label| Some(label.text.split_once('[')?.0)).collect();
    read.iter().for_each(|label| add(identifier(label)));
    let (mut statement, mut attribute) = (true, false);
    let mut tokens = body.clone().into_iter().peekable();
    while let Some(token) = tokens.next() {
        if let (true, TokenTree::Ident(ident), Some(TokenTree::Ident(name))) =
            (statement, &token, tokens.peek())
            && *ident == word
            && !indexed.contains(name.to_string().as_str())
        {
            add(name.to_string());
        }
        (statement, attribute) = match &token {
            TokenTree::Punct(punct) => (punct.as_char() == ';', punct.as_char() == '#'),
            TokenTree::Group(group) => (attribute || group.delimiter() == Delimiter::Brace, false),
            _ => (false, false),
        };
    }
    names
}
