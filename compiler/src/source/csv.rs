//! Columns of numbers in a text: fields between commas, semicolons, tabs or spaces, `#` before comments, names of columns in the
//! first line if it has any.

use super::Source;
use crate::messages;
use crate::syntax::ColumnTerm;

/// Numbers of two columns, with their lines.
pub(super) struct Columns {
    pub points: Vec<[f64; 2]>,
    pub lines: Vec<usize>,
}

/// What is wrong: in the file at a place, or with a column that was asked for.
pub(super) enum Wrong {
    InFile(String),
    Column(usize, String),
}

/// A field and where in its line it begins.
type Field<'t> = (usize, &'t str);

/// Reads two columns, behind `skip` lines.
pub(super) fn columns(source: &Source, skip: usize, asked: &[ColumnTerm; 2]) -> Result<Columns, Wrong> {
    let mut lines = source.text.lines().enumerate().skip(skip).filter_map(|(index, line)| {
        let line = line.trim_start_matches('\u{feff}');
        let line = line.split('#').next().unwrap_or_default();
        (!line.trim().is_empty()).then_some((index + 1, line))
    });
    let Some(first) = lines.next() else {
        return Err(Wrong::InFile(messages::csv_empty(&source.name)));
    };
    let separator = separator(first.1);
    let head = fields(first.1, separator);
    let named = head.iter().any(|(_, field)| number(field).is_none());
    let mut at = [0; 2];
    for (which, column) in asked.iter().enumerate() {
        at[which] = index(column, &head, named).map_err(|message| Wrong::Column(which, message))?;
    }
    let mut columns = Columns { points: Vec::new(), lines: Vec::new() };
    for (line, text) in (!named).then_some(first).into_iter().chain(lines) {
        let row = fields(text, separator);
        let place = |field: Option<&Field>| {
            let bytes = field.map_or(text.trim_end().len(), |(start, _)| *start);
            messages::place_in_file(&source.name, line, text[..bytes].chars().count() + 1)
        };
        if row.len() != head.len() {
            let message = messages::csv_ragged(row.len(), head.len());
            return Err(Wrong::InFile(place(row.get(head.len())) + &message));
        }
        let mut point = [0.0; 2];
        for (which, index) in at.into_iter().enumerate() {
            let (_, field) = row[index];
            point[which] = number(field)
                .ok_or_else(|| Wrong::InFile(place(row.get(index)) + &messages::csv_no_number(field)))?;
        }
        columns.points.push(point);
        columns.lines.push(line);
    }
    Ok(columns)
}

fn separator(line: &str) -> char {
    [';', '\t', ','].into_iter().find(|separator| line.contains(*separator)).unwrap_or(' ')
}

fn fields(line: &str, separator: char) -> Vec<Field<'_>> {
    let start_of = |field: &str| field.as_ptr() as usize - line.as_ptr() as usize;
    let trimmed = |field: &'_ str| -> (usize, usize) {
        let inner = field.trim().trim_matches('"').trim();
        (start_of(inner), inner.len())
    };
    let found: Vec<(usize, usize)> = if separator == ' ' {
        line.split_whitespace().map(trimmed).collect()
    } else {
        line.split(separator).map(trimmed).collect()
    };
    found.into_iter().map(|(start, length)| (start, &line[start..start + length])).collect()
}

fn number(field: &str) -> Option<f64> {
    field.parse().ok().filter(|number: &f64| number.is_finite())
}

/// Which column is meant, by its number from 1 or by its name, behind which a unit may stand.
fn index(column: &ColumnTerm, head: &[Field], named: bool) -> Result<usize, String> {
    if let Ok(number) = column.text.parse::<usize>() {
        let fits = (1..=head.len()).contains(&number);
        return if fits { Ok(number - 1) } else { Err(messages::csv_no_such_column(number, head.len())) };
    }
    let without_unit = |field: &str| field.split(['[', '(']).next().unwrap_or_default().trim().to_string();
    let names: Vec<&str> = head.iter().map(|(_, field)| *field).collect();
    let found = names.iter().position(|name| *name == column.text || without_unit(name) == column.text);
    let names: &[&str] = if named { &names } else { &[] };
    found.ok_or_else(|| messages::csv_no_column(&column.text, names))
}
