//! Numbers of tables that stand in files: read beside the file that names them, before anything is known of their meaning.

use super::csv::{self, Sheet, Wrong};
use super::{FileOf, disk, flex};
use crate::diagnostics::{Diagnostics, Region};
use crate::messages;
use crate::syntax::{
    ColumnTerm, Definition, FileTerm, Operator, ReadFile, TableData, TableTerm, Term, TermKind,
};

/// What is wrong, and where it is to be said.
type Misread = (Region, String);

/// Puts the numbers of files into the tables and bodies that name them.
pub fn read_files(definition: &mut Definition, file_of: FileOf) -> Result<(), Diagnostics> {
    let mut errors = Diagnostics::new();
    flex::read_bodies(definition, file_of, &mut errors);
    for table in &mut definition.tables {
        let TableData::File(file) = &table.data else { continue };
        match data(table, file, file_of) {
            Ok((data, read)) => {
                table.data = data;
                table.read = Some(read);
            }
            Err((region, message)) => errors.error(region, message),
        }
    }
    errors.finish(())
}

fn data(table: &TableTerm, file: &FileTerm, file_of: FileOf) -> Result<(TableData, ReadFile), Misread> {
    let region = file.region;
    let at_file = |message| (region, message);
    let caller = file_of(region.start);
    let source = disk::read(&file.name, caller.as_deref()).map_err(at_file)?;
    let on_disk = disk::on_disk(&source, caller).map_err(at_file)?;
    let terms = |values: Vec<f64>| -> Vec<Term> { values.into_iter().map(|it| term(it, region)).collect() };
    let (data, lines) = if table.arguments.len() == 2 {
        if let Some([column, _]) = &table.columns {
            return Err((column.region, messages::columns_of_grid(&table.name.text)));
        }
        let Sheet { first, second, rows, lines } = csv::sheet(&source, file.skip).map_err(at_file)?;
        let rows = rows.into_iter().map(|row| (terms(row), region)).collect();
        (TableData::Grid { axes: [terms(first), terms(second)], rows }, lines)
    } else {
        let first = || [1, 2].map(|number| ColumnTerm { text: number.to_string(), region });
        let asked = table.columns.clone().unwrap_or_else(first);
        let columns = csv::columns(&source, file.skip, &asked).map_err(|wrong| match wrong {
            Wrong::InFile(message) => (region, message),
            Wrong::Column(which, message) => (asked[which].region, message),
        })?;
        let points = columns.points.iter().map(|point| point.map(|value| term(value, region))).collect();
        (TableData::Points(points), columns.lines)
    };
    Ok((data, ReadFile { shown: source.name, on_disk, lines }))
}

/// A number as if it were written where the file is named.
pub(super) fn term(value: f64, region: Region) -> Term {
    let number = |value: f64| TermKind::Number { text: format!("{value:?}"), unit: None };
    let positive = Term { kind: number(value.abs()), region, height: 0 };
    if value.is_sign_negative() && value != 0.0 {
        Term { kind: TermKind::Operation(Operator::Negate, vec![positive]), region, height: 1 }
    } else {
        positive
    }
}
