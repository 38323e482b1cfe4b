//! Constant tables: patterns, names of rows and coordinates, the elimination. The runtime asks the mechanism for each by a method,
//! which returns a constant.

use super::{Emitter, array, quoted};
use crate::forms::row::Whole;
use crate::functions::Sparse;
use std::fmt::Write;

/// The method that returns a table.
pub fn method(text: &mut String, name: &str, of: &str, table: &str) {
    let _ = writeln!(text, "#[inline] fn {name}(&self) -> {of} {{ {table} }}");
}

/// (row, column) of the structural non-zeros of a matrix, row by row.
pub fn pattern(text: &mut String, emitter: &Emitter, matrix: &Sparse) {
    let places = pairs(matrix.places(&emitter.compiled.complete));
    method(text, matrix.pattern, "&[(u16, u16)]", &places);
}

pub fn layout(emitter: &Emitter) -> String {
    let layout = &emitter.compiled.complete.equations.layout;
    let angles = layout.angles.iter().map(|angle| {
        let rate = angle.rate.iter().map(|(index, weight)| format!("({index}, {weight:?})"));
        format!("MultiTurn {{ rate: &{} }}", array(rate))
    });
    format!(
        "Layout {{ linear: {}, rotations: {}, quaternions: {}, angles: &{} }}",
        layout.linear.len(),
        layout.rotations.len(),
        layout.quaternions.len(),
        array(angles)
    )
}

pub fn rows(emitter: &Emitter) -> String {
    let rows = emitter.compiled.complete.equations.rows.iter();
    format!(
        "&{}",
        array(rows.map(|row| format!("Row {{ of: {}, what: {} }}", quoted(&row.of), quoted(row.form.name))))
    )
}

pub fn strings(names: Vec<String>) -> String {
    format!("&{}", array(names.iter().map(|name| quoted(name))))
}

/// The direction rows, joint by joint.
pub fn flips(emitter: &Emitter) -> String {
    let rows = &emitter.compiled.complete.equations.rows;
    let upright: Vec<usize> = (0..rows.len()).filter(|row| rows[*row].upright.is_some()).collect();
    let is_axis = |row: &usize| rows[*row].form.part_of == Some(Whole::Axis);
    let joints = upright.chunk_by(|a, b| rows[*a].origin == rows[*b].origin).map(|joint| {
        let (axes, turns) = match joint {
            [first, second, turns @ ..] if is_axis(first) && is_axis(second) => {
                (format!("Option::Some([{first}, {second}])"), turns)
            }
            turns => ("Option::None".to_string(), turns),
        };
        format!("Flips {{ axes: {axes}, turns: {} }}", indices(turns.iter().copied()))
    });
    format!("&{}", array(joints))
}

pub fn conditions(emitter: &Emitter) -> String {
    let conditions = emitter.compiled.complete.conditions.rows.iter().map(|condition| {
        let kind = match condition {
            condition if !condition.coordinate.has_value() => "Rate",
            condition if condition.angular && !condition.counted => "Angle",
            _ => "Linear",
        };
        format!("Condition {{ of: {}, kind: ConditionKind::{kind} }}", quoted(&condition.of))
    });
    format!("&{}", array(conditions))
}

pub fn indices(indices: impl IntoIterator<Item = usize>) -> String {
    format!("&{}", array(indices.into_iter().map(|index| index.to_string())))
}

pub fn pairs(pairs: impl Iterator<Item = (usize, usize)>) -> String {
    format!("&{}", array(pairs.map(|(row, column)| format!("({row}, {column})"))))
}

pub fn elimination(emitter: &Emitter) -> String {
    let table = &emitter.compiled.table;
    format!(
        "Elimination {{ order: {}, position: {}, row_start: {}, columns: {} }}",
        indices(table.order.iter().copied()),
        indices(table.position.iter().copied()),
        indices(table.row_start.iter().copied()),
        indices(table.columns.iter().copied())
    )
}
