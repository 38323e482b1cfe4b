//! Tables that functions look up in, as arrays; a second array has the bases that a search compares with.

use super::Writer;
use crate::scalar::Scalar;
use crate::symbolic::Table;
use std::fmt::Write;

impl Writer<'_> {
    /// The tables that `text` names.
    pub fn tables(&self, text: &str) -> String {
        let graph = self.compiled.complete.equations.graph.read();
        let mut arrays = String::new();
        for (number, table) in graph.tables().iter().enumerate() {
            let name = format!("{}_table_{number}", self.prefix.lower);
            let (width, real, rows) = (table.width(), self.scalar.c(), table.rows().len());
            if text.contains(&format!("{name},")) {
                let entries: Vec<String> = table.rows().map(|row| self.numbers(row)).collect();
                let _ = writeln!(
                    arrays,
                    "/* The table `{}`: rows of bases and coefficients. */\n\
                     static const {real} {name}[{rows}][{width}] = {{\n    {},\n}};\n",
                    table.name,
                    entries.join(",\n    ")
                );
            }
            if text.contains(&format!("{name}_bases,")) {
                let _ = writeln!(
                    arrays,
                    "/* The bases of `{}`. */\nstatic const {real} {name}_bases[{}] = {};\n",
                    table.name,
                    rows.next_power_of_two(),
                    self.numbers(&bases(table, self.scalar))
                );
            }
        }
        arrays
    }

    /// `{1.0, 2.0}`.
    pub fn numbers(&self, values: &[f64]) -> String {
        let values: Vec<String> = values.iter().map(|value| self.scalar.literal(*value)).collect();
        format!("{{{}}}", values.join(", "))
    }
}

/// The bases as numbers of the scalar that the same arguments are not below, filled up to a power of two with NaN, which nothing is above.
fn bases(table: &Table, scalar: Scalar) -> Vec<f64> {
    let own = table.rows().filter_map(|row| row.first()).map(|base| scalar.ceiling(*base));
    own.chain(std::iter::repeat(f64::NAN)).take(table.rows().len().next_power_of_two()).collect()
}
