//! Columns and grids of numbers in a text: fields between commas, semicolons, tabs or spaces, `#` before comments, names of columns in the
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

/// Numbers of a grid: those of the first argument in the first line, behind its first field; then lines of one of the second and the
/// values there.
pub(super) struct Sheet {
    pub first: Vec<f64>,
    pub second: Vec<f64>,
    pub rows: Vec<Vec<f64>>,
    /// Of the first argument, then of the rows.
    pub lines: Vec<usize>,
}

/// Lines that are neither empty nor comments, with their numbers from 1.
fn lines(source: &Source, skip: usize) -> impl Iterator<Item = (usize, &str)> {
    source.text.lines().enumerate().skip(skip).filter_map(|(index, line)| {
        let line = line.trim_start_matches('\u{feff}');
        let line = line.split('#').next().unwrap_or_default();
        (!line.trim().is_empty()).then_some((index + 1, line))
    })
}

/// `file, line 3, column 7: ` before what is wrong with a field, or behind the last.
fn place(source: &Source, (line, text): (usize, &str), field: Option<&Field>) -> String {
    let bytes = field.map_or(text.trim_end().len(), |(start, _)| *start);
    messages::place_in_file(&source.name, line, text[..bytes].chars().count() + 1)
}

/// The fields of a line, as many as the first one has.
fn row<'t>(
    source: &Source,
    line: (usize, &'t str),
    separator: char,
    count: usize,
) -> Result<Vec<Field<'t>>, String> {
    let row = fields(line.1, separator);
    if row.len() == count {
        return Ok(row);
    }
    Err(place(source, line, row.get(count)) + &messages::csv_ragged(row.len(), count))
}

fn number_of(source: &Source, line: (usize, &str), field: &Field) -> Result<f64, String> {
    number(field.1).ok_or_else(|| place(source, line, Some(field)) + &messages::csv_no_number(field.1))
}

/// Reads a grid, behind `skip` lines.
pub(super) fn sheet(source: &Source, skip: usize) -> Result<Sheet, String> {
    let mut lines = lines(source, skip);
    let first = lines.next().ok_or_else(|| messages::csv_empty(&source.name))?;
    let separator = separator(first.1);
    let head = fields(first.1, separator);
    let numbers = |line: (usize, &str), fields: &[Field]| -> Result<Vec<f64>, String> {
        fields.iter().map(|field| number_of(source, line, field)).collect()
    };
    // What stands in the corner belongs to neither argument.
    let mut sheet = Sheet {
        first: numbers(first, &head[1..])?,
        second: Vec::new(),
        rows: Vec::new(),
        lines: vec![first.0],
    };
    for line in lines {
        let mut own = numbers(line, &row(source, line, separator, head.len())?)?;
        sheet.second.push(own.remove(0));
        sheet.rows.push(own);
        sheet.lines.push(line.0);
    }
    Ok(sheet)
}

/// Reads two columns, behind `skip` lines.
pub(super) fn columns(source: &Source, skip: usize, asked: &[ColumnTerm; 2]) -> Result<Columns, Wrong> {
    let mut lines = lines(source, skip);
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
    for line in (!named).then_some(first).into_iter().chain(lines) {
        let row = row(source, line, separator, head.len()).map_err(Wrong::InFile)?;
        let mut point = [0.0; 2];
        for (which, index) in at.into_iter().enumerate() {
            point[which] = number_of(source, line, &row[index]).map_err(Wrong::InFile)?;
        }
        columns.points.push(point);
        columns.lines.push(line.0);
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
