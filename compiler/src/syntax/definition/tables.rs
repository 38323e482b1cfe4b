//! Tables as written, and the files that they were read from.

use super::{Label, OnDisk, Term, WrittenUnit};
use crate::diagnostics::Region;
use crate::forms::{Interpolation, Outside};

/// `table lift(angle [deg]) [mm] = [(0, 0), (90, 8)], periodic;`
#[derive(Clone, Debug)]
pub struct TableTerm {
    pub name: Label,
    /// One, or two of a grid.
    pub arguments: Vec<(Label, Option<WrittenUnit>)>,
    pub unit: Option<WrittenUnit>,
    pub data: TableData,
    pub kind: Option<(Interpolation, Region)>,
    pub outside: Option<(Outside, Region)>,
    pub columns: Option<[ColumnTerm; 2]>,
    /// Where the points come from, once they have been read from a file.
    pub read: Option<ReadFile>,
}

/// What a table holds, in the units of its head.
#[derive(Clone, Debug)]
pub enum TableData {
    Points(Vec<[Term; 2]>),
    /// Values of both arguments, and a row for each value of the second one.
    Grid {
        axes: [Vec<Term>; 2],
        rows: Vec<(Vec<Term>, Region)>,
    },
    File(FileTerm),
}

/// `file("cam.csv", skip = 2)`
#[derive(Clone, Debug)]
pub struct FileTerm {
    pub name: String,
    /// Where the name stands.
    pub region: Region,
    /// Lines before the first one that is read.
    pub skip: usize,
}

/// A column by its name, or by its number from 1.
#[derive(Clone, Debug)]
pub struct ColumnTerm {
    pub text: String,
    pub region: Region,
}

/// A file that points were read from.
#[derive(Clone, Debug)]
pub struct ReadFile {
    /// As messages show it.
    pub shown: String,
    pub on_disk: OnDisk,
    /// Lines of the points; of a grid that of the first argument, then those of the rows.
    pub lines: Vec<usize>,
}
