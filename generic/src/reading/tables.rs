//! Tables of the tree, in SI.

use super::{Read, Reader};
use crate::error::DefinitionError;
use crate::json::{field, list, name, optional, text};
use crate::slopes::pieces;
use crate::table::{Curve, Table};
use serde_json::Value;
use std::sync::Arc;

impl<'t> Reader<'t> {
    /// Their numbers are constants.
    pub(super) fn read_tables(&mut self) -> Read<()> {
        for node in list(self.tree, "tables", "tables")? {
            let own = name(node, "tables")?;
            let table = self.table(node, own)?;
            self.tables.insert(own, Arc::new(table));
        }
        Ok(())
    }

    fn table(&self, node: &Value, own: &str) -> Read<Table> {
        let unit = node.get("unit").and_then(Value::as_str);
        let arguments = list(node, "arguments", own)?;
        let units: Vec<_> =
            arguments.iter().map(|argument| argument.get("unit").and_then(Value::as_str)).collect();
        let (kind, hold) = (text(node, "kind", own)?, text(node, "outside", own)? == "hold");
        let curve = |x: &[f64], y: &[f64], kind: &str| {
            if kind != "linear" && !is_curve(kind) {
                return Err(DefinitionError::kind(own, kind));
            }
            let curve =
                pieces(x, y, kind).and_then(|pieces| Curve::new(x, y, pieces, hold, kind == "periodic"));
            curve.ok_or_else(|| DefinitionError::value(own, "the points are too few"))
        };
        if optional(node, "points").is_some() {
            let [argument] = units[..] else { return Err(DefinitionError::malformed(own, "one argument")) };
            let (mut x, mut y) = (Vec::new(), Vec::new());
            for point in list(node, "points", own)? {
                let [at, value] = point.as_array().map_or(&[][..], Vec::as_slice) else {
                    return Err(DefinitionError::malformed(own, "a point of two numbers"));
                };
                x.push(self.in_unit(at, argument, own)?);
                y.push(self.in_unit(value, unit, own)?);
            }
            ascends(&x, own)?;
            return curve(&x, &y, kind).map(Table::Curve);
        }
        let [first, second] = units[..] else { return Err(DefinitionError::malformed(own, "points")) };
        let axes = list(node, "axes", own)?;
        let [x, y] = axes else { return Err(DefinitionError::malformed(own, "axes")) };
        let (x, y) = (self.numbers(x, first, own)?, self.numbers(y, second, own)?);
        ascends(&x, own)?;
        ascends(&y, own)?;
        let rows = field(node, "rows", own)?.as_array().map_or(&[][..], Vec::as_slice);
        let values = rows.iter().map(|row| self.numbers(row, unit, own)).collect::<Read<Vec<_>>>()?;
        if values.len() != y.len() || values.iter().any(|row| row.len() != x.len()) {
            return Err(DefinitionError::malformed(own, "a value for each pair of arguments"));
        }
        if kind != "bicubic" {
            return Ok(Table::Grid { x, y, values, hold });
        }
        let rows = values.iter().map(|row| curve(&x, row, "cubic")).collect::<Read<_>>()?;
        let share = |at: usize| {
            let one: Vec<f64> = (0..y.len()).map(|k| if k == at { 1.0 } else { 0.0 }).collect();
            curve(&y, &one, "cubic")
        };
        Ok(Table::Sheet { rows, shares: (0..y.len()).map(share).collect::<Read<_>>()? })
    }

    fn numbers(&self, node: &Value, unit: Option<&str>, own: &str) -> Read<Vec<f64>> {
        let values = node.as_array().map_or(&[][..], Vec::as_slice);
        values.iter().map(|value| self.in_unit(value, unit, own)).collect()
    }
}

fn is_curve(kind: &str) -> bool {
    matches!(kind, "monotone" | "pchip" | "akima" | "modified_akima" | "cubic" | "natural" | "periodic")
}

fn ascends(knots: &[f64], own: &str) -> Read<()> {
    if knots.len() >= 2 && knots.windows(2).all(|pair| pair[0] < pair[1]) {
        return Ok(());
    }
    Err(DefinitionError::value(own, "its arguments are too few or do not ascend"))
}
