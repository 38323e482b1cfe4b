//! The operations of every function of a mechanism, in both sets of coordinates, as tables.
//!
//! Counted are the instructions of the scheduled programs, from which the code is emitted one to one: the watch over
//! the pivots is part of the acceleration functions. A fused multiply-add is one operation, so is a division, a square
//! root, a choice (min, max, abs, sign, comparison, logic, select) and a call of sin or the like. Depth is the longest
//! chain of operations that wait for one another. Live is the largest number of results that are alive at once, in the
//! order of the code; true use of registers and stack is decided by the target's compiler.

use crate::compiled::Compiled;
use crate::diagnostics::Diagnostics;
use crate::driver::compile;
use crate::model::Coordinates;
use crate::schedule::{Counts, Function, count, live_values};
use proc_macro2::TokenStream;
use std::fmt::Write;

/// Both sets of coordinates, by name.
pub const COORDINATES: [(&str, Coordinates); 2] =
    [("absolute", Coordinates::Absolute), ("tree", Coordinates::Tree)];

/// One function of one model in one set of coordinates.
#[derive(Clone, Debug)]
pub struct Row {
    pub model: String,
    pub coordinates: &'static str,
    pub function: &'static str,
    pub counts: Counts,
    /// The largest number of results alive at once.
    pub live: usize,
}

impl Row {
    /// The counts by name, operations and depth first.
    pub fn named(&self) -> [(&'static str, usize); 10] {
        let c = &self.counts;
        [
            ("operations", c.total()),
            ("depth", c.depth),
            ("live_values", self.live),
            ("additions", c.additions),
            ("multiplications", c.multiplications),
            ("fused_multiply_adds", c.fused_multiply_adds),
            ("divisions", c.divisions),
            ("square_roots", c.square_roots),
            ("choices", c.choices),
            ("transcendentals", c.transcendentals),
        ]
    }
}

/// Compiles a definition in one set of coordinates and counts its functions.
pub fn rows(
    model: &str,
    tokens: TokenStream,
    (coordinates, asked): (&'static str, Coordinates),
) -> Result<Vec<Row>, Diagnostics> {
    Ok(rows_of(model, &compile(tokens, Some(asked))?, coordinates))
}

/// The functions of what has been compiled in these coordinates.
pub fn rows_of(model: &str, compiled: &Compiled, coordinates: &'static str) -> Vec<Row> {
    let row = |function: Function| Row {
        model: model.to_string(),
        coordinates,
        function: function.name(),
        counts: count(compiled.programs.get(function)),
        live: live_values(compiled.programs.get(function)),
    };
    Function::ALL.map(row).into()
}

/// An array of objects, one a line.
pub fn as_json(rows: &[Row]) -> String {
    let object = |row: &Row| {
        let counts = row.named().map(|(name, count)| format!("\"{name}\":{count}")).join(",");
        let Row { model, coordinates, function, .. } = row;
        format!(
            "{{\"model\":\"{model}\",\"coordinates\":\"{coordinates}\",\"function\":\"{function}\",{counts}}}"
        )
    };
    format!("[\n{}\n]\n", rows.iter().map(object).collect::<Vec<_>>().join(",\n"))
}

/// Heads of the columns and their widths, in the order of [`Row::named`].
const COLUMNS: [(&str, usize); 10] = [
    ("total", 7),
    ("depth", 7),
    ("live", 6),
    ("add", 6),
    ("mul", 6),
    ("fma", 6),
    ("div", 7),
    ("sqrt", 6),
    ("min..", 6),
    ("sin..", 7),
];

/// One table for each model and set of coordinates; functions that compute nothing are left out.
pub fn as_tables(rows: &[Row]) -> String {
    let mut text = String::new();
    for table in rows.chunk_by(|a, b| (&a.model, a.coordinates) == (&b.model, b.coordinates)) {
        let _ = writeln!(text, "{}, {} coordinates", table[0].model, table[0].coordinates);
        let heads = COLUMNS.map(|(head, width)| format!("{head:>width$}")).concat();
        let _ = writeln!(text, "  {:<24}{heads}", "function");
        for row in table.iter().filter(|row| row.counts.total() > 0) {
            let counts: String = row
                .named()
                .iter()
                .zip(COLUMNS)
                .map(|((_, count), (_, width))| format!("{count:>width$}"))
                .collect();
            let _ = writeln!(text, "  {:<24}{counts}", row.function);
        }
        text.push('\n');
    }
    text.push_str(
        "live: results alive at once; add: additions, subtractions, negations; min..: min, max, abs, sign, comparisons, logic, select; sin..: \
         calls of sin and the like\n",
    );
    text
}
