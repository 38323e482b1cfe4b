//! Points of tables that stand in files: read beside the file that names them, before anything is known of their meaning.

use super::csv::{self, Wrong};
use super::{FileOf, disk};
use crate::diagnostics::{Diagnostics, Region};
use crate::syntax::{ColumnTerm, Definition, FileTerm, Operator, ReadFile, TableData, Term, TermKind};

/// Pairs of numbers.
type Points = Vec<[Term; 2]>;
/// What is wrong, and where it is to be said.
type Misread = (Region, String);

/// Puts the points of files into the tables that name them.
pub fn read_tables(definition: &mut Definition, file_of: FileOf) -> Result<(), Diagnostics> {
    let mut errors = Diagnostics::new();
    for table in &mut definition.tables {
        let TableData::File(file) = &table.data else { continue };
        let first = || [1, 2].map(|number| ColumnTerm { text: number.to_string(), region: file.region });
        let columns = table.columns.clone().unwrap_or_else(first);
        match points(file, &columns, file_of) {
            Ok((points, read)) => {
                table.data = TableData::Points(points);
                table.read = Some(read);
            }
            Err((region, message)) => errors.error(region, message),
        }
    }
    errors.finish(())
}

fn points(file: &FileTerm, asked: &[ColumnTerm; 2], file_of: FileOf) -> Result<(Points, ReadFile), Misread> {
    let region = file.region;
    let caller = file_of(region.start);
    let source = disk::read(&file.name, caller.as_deref()).map_err(|message| (region, message))?;
    let on_disk = disk::on_disk(&source, caller).map_err(|message| (region, message))?;
    let columns = csv::columns(&source, file.skip, asked).map_err(|wrong| match wrong {
        Wrong::InFile(message) => (region, message),
        Wrong::Column(which, message) => (asked[which].region, message),
    })?;
    let points = columns.points.iter().map(|point| point.map(|value| term(value, region))).collect();
    Ok((points, ReadFile { shown: source.name, on_disk, lines: columns.lines }))
}

/// A number as if it were written where the file is named.
fn term(value: f64, region: Region) -> Term {
    let number = |value: f64| TermKind::Number { text: format!("{value:?}"), unit: None };
    let positive = Term { kind: number(value.abs()), region, height: 0 };
    if value.is_sign_negative() && value != 0.0 {
        Term { kind: TermKind::Operation(Operator::Negate, vec![positive]), region, height: 1 }
    } else {
        positive
    }
}
