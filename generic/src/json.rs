//! Fields of the tree by name, with errors that say whose they are.

use crate::error::DefinitionError;
use serde_json::Value;

type Read<T> = Result<T, DefinitionError>;

/// A field that is there and not null.
pub(crate) fn optional<'t>(node: &'t Value, field: &str) -> Option<&'t Value> {
    node.get(field).filter(|value| !value.is_null())
}

pub(crate) fn field<'t>(node: &'t Value, name: &str, part: &str) -> Read<&'t Value> {
    optional(node, name).ok_or_else(|| DefinitionError::malformed(part, name))
}

pub(crate) fn text<'t>(node: &'t Value, name: &str, part: &str) -> Read<&'t str> {
    field(node, name, part)?.as_str().ok_or_else(|| DefinitionError::malformed(part, name))
}

/// An array; an empty one where the field is not there.
pub(crate) fn list<'t>(node: &'t Value, name: &str, part: &str) -> Read<&'t [Value]> {
    match optional(node, name) {
        None => Ok(&[]),
        Some(value) => {
            value.as_array().map(Vec::as_slice).ok_or_else(|| DefinitionError::malformed(part, name))
        }
    }
}

/// The name that a part declares.
pub(crate) fn name<'t>(node: &'t Value, of: &str) -> Read<&'t str> {
    text(node, "name", of)
}
