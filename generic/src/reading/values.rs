//! Values that are known when the definition is read: entries, tuples, units.

use super::laws::May;
use super::{Read, Reader};
use crate::error::DefinitionError;
use crate::json::{field, optional};
use crate::units;
use crate::vector::{V3, ZERO};
use serde_json::Value;

impl<'t> Reader<'t> {
    /// The value of `{"unit": …, "value": EXPR}` in SI, finite.
    pub fn entry(&self, node: &Value, part: &str) -> Read<f64> {
        self.in_unit(field(node, "value", part)?, node.get("unit").and_then(Value::as_str), part)
    }

    /// The same of a field, where it is written.
    pub fn entry_of(&self, node: &Value, name: &str, part: &str) -> Read<Option<f64>> {
        optional(node, name).map(|entry| self.entry(entry, part)).transpose()
    }

    pub fn needed(&self, node: &Value, name: &str, part: &str) -> Read<f64> {
        self.entry(field(node, name, part)?, part)
    }

    /// A value of constants and parameters under the unit of its entry.
    pub fn in_unit(&self, value: &Value, unit: Option<&str>, part: &str) -> Read<f64> {
        let law = self.law_in_unit(value, unit, part, May::Constant)?;
        let value = law.expression.constant();
        value
            .filter(|value| value.is_finite())
            .ok_or_else(|| DefinitionError::value(part, "a value that should be known and finite is not"))
    }

    /// Two components in the plane, three in space.
    pub fn tuple(&self, node: &Value, name: &str, part: &str) -> Read<V3> {
        let values = field(node, name, part)?.as_array();
        let values = values.filter(|values| values.len() == self.dimension());
        let values = values.ok_or_else(|| DefinitionError::malformed(part, "a tuple of this dimension"))?;
        let unit = node.get("unit").and_then(Value::as_str);
        let mut tuple = ZERO;
        for (component, value) in tuple.iter_mut().zip(values) {
            *component = self.in_unit(value, unit, part)?;
        }
        Ok(tuple)
    }

    pub fn dimension(&self) -> usize {
        if self.spatial { 3 } else { 2 }
    }
}

pub(super) fn factor(unit: Option<&str>, part: &str) -> Read<f64> {
    let Some(unit) = unit else { return Ok(1.0) };
    units::factor(unit)
        .ok_or_else(|| DefinitionError::Unit { part: part.to_string(), unit: unit.to_string() })
}

/// Whether a value names no quantity and carries no unit anywhere inside: then the unit of its entry is its own.
pub(super) fn is_bare(node: &Value) -> bool {
    let arguments_are =
        || node.get("args").and_then(Value::as_array).is_some_and(|arguments| arguments.iter().all(is_bare));
    if node.get("number").is_some() {
        return node.get("unit").is_none_or(Value::is_null);
    }
    if let Some(name) = node.get("name") {
        return name.as_str() == Some("pi");
    }
    if node.get("op").is_some() {
        return arguments_are();
    }
    node.get("call").and_then(Value::as_str).is_some_and(super::laws::is_function) && arguments_are()
}
