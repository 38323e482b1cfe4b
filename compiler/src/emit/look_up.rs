//! Tables of the user's as statics: rows of bases and coefficients that `table` of the runtime looks up in.
//!
//! ```text
//! mod tables {
//! use ::core::primitive::f64;
//! pub(super) static lift: [[f64; 5]; 8] = [[0.0, 0.0, 1.5, 0.0, 0.0], …];
//! }
//! ```

use super::rust::literal;
use super::{Emitter, array};
use crate::symbolic::Table;
use std::fmt::Write;
use std::sync::Arc;

/// The statics, in a module of their own, whose names are no names of anything else; nothing where there are none.
pub fn tables(text: &mut String, emitter: &Emitter) {
    let graph = emitter.compiled.complete.equations.graph.read();
    let tables = graph.tables();
    if tables.is_empty() {
        return;
    }
    text.push_str(
        "#[allow(non_upper_case_globals, clippy::all)] mod tables {\nuse ::core::primitive::f64;\n",
    );
    for (number, table) in tables.iter().enumerate() {
        let (width, count) = (table.width(), table.rows().len().next_power_of_two());
        let nan = "f64::NAN".to_string();
        let fill = array((0..width).map(|_| nan.clone()));
        let own = table.rows().map(|row| array(row.iter().map(|entry| literal(*entry))));
        let rows = own.chain(std::iter::repeat(fill)).take(count);
        let name = name(tables, number);
        let _ = writeln!(text, "pub(super) static {name}: [[f64; {width}]; {count}] = {};", array(rows));
    }
    text.push_str("}\n");
}

/// What the static of a table is called: as the user calls it, never two alike.
pub fn name(tables: &[Arc<Table>], number: usize) -> String {
    let readable = |table: &Table| table.name.replace(['[', '.'], "_").replace(']', "");
    let own = readable(&tables[number]);
    let before = tables[..number].iter().filter(|other| readable(other) == own).count();
    let taken = |name: &str| tables.iter().any(|other| readable(other) == name);
    let mut name = own;
    for _ in 0..before {
        name.push('_');
        while taken(&name) {
            name.push('_');
        }
    }
    name
}
