//! What can be said of a definition that may be full of errors: enough for items that take the mechanism's place.

use super::definition::{Definition, Label, OptionEntry, WrittenUnit};
use super::token::Cursor;
use super::unread::Unread;
use super::{Shelf, read, token};
use crate::diagnostics::Diagnostics;
use crate::forms::Vocabulary;
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
    /// The mechanism's name.
    pub name: Ident,
    /// Path of the crate, as `options` say.
    pub crate_path: Option<TokenStream>,
    /// What the emitted structs have; nothing where a statement is given up that may have given more.
    pub fields: Option<Fields>,
}

/// Fields of the emitted structs, as identifiers.
#[derive(Clone, Debug)]
pub struct Fields {
    pub parameters: Vec<String>,
    pub inputs: Vec<String>,
    pub outputs: Vec<String>,
    /// End of the struct's name, field and unit of those that are not in SI units.
    pub declared: Vec<(&'static str, String, Unit)>,
}

/// The header of a definition; nothing if not even a name was written.
pub fn header(tokens: TokenStream, vocabulary: &'static Vocabulary, shelf: &dyn Shelf) -> Option<Header> {
    let mut diagnostics = Diagnostics::new();
    let converted = token::convert(tokens.clone(), &mut diagnostics);
    let (definition, _, unread) = read(&converted, Span::call_site().into(), vocabulary, shelf, true);
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
    let name = match tokens.next()? {
        TokenTree::Ident(name) => name,
        // The kind was forgotten: `pub FourBar { … }`.
        TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => kind,
        _ => return None,
    };
    Some(Header {
        visibility,
        attributes: definition.attributes.clone(),
        name,
        crate_path: crate_path(&definition),
        fields: (diagnostics.is_empty() && !unread.others).then(|| fields(&definition, &unread)),
    })
}

fn fields(definition: &Definition, unread: &Unread) -> Fields {
    let parameters = definition.parameters.iter().map(|it| (&it.name, it.entry.unit.as_ref()));
    let inputs = definition.inputs.iter().map(|it| (&it.name, it.unit.as_ref()));
    let outputs = definition.outputs.iter().map(|it| (&it.name, it.entry.unit.as_ref()));
    let mut declared = Vec::new();
    Fields {
        parameters: of_struct(
            "Parameters",
            parameters.chain(without_unit(&unread.parameters)),
            &mut declared,
        ),
        inputs: of_struct("Inputs", inputs.chain(without_unit(&unread.inputs)), &mut declared),
        outputs: of_struct("Outputs", outputs.chain(without_unit(&unread.outputs)), &mut declared),
        declared,
    }
}

fn without_unit(labels: &[Label]) -> impl Iterator<Item = (&Label, Option<&WrittenUnit>)> {
    labels.iter().map(|label| (label, None))
}

/// The fields of one struct, each name once; those whose unit is not that of SI are added to `declared`.
fn of_struct<'d>(
    suffix: &'static str,
    all: impl Iterator<Item = (&'d Label, Option<&'d WrittenUnit>)>,
    declared: &mut Vec<(&'static str, String, Unit)>,
) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    let mut known: HashSet<String> = HashSet::new();
    for (label, unit) in all {
        let name = label.identifier();
        if !known.insert(name.clone()) {
            continue;
        }
        if let Some(written) = unit.filter(|written| written.unit.scale != 1.0) {
            declared.push((suffix, name.clone(), written.unit.clone()));
        }
        names.push(name);
    }
    names
}

fn crate_path(definition: &Definition) -> Option<TokenStream> {
    definition.options.iter().find_map(|option| match option {
        OptionEntry::Crate(path) => Some(path.clone()),
        _ => None,
    })
}
