//! Markdown tables; long ones are folded away.

use std::fmt::Write;

/// Longer tables are shown on request.
const SHOWN: usize = 24;

pub struct Table {
    columns: Vec<&'static str>,
    rows: Vec<Vec<String>>,
}

impl Table {
    pub fn new(columns: &[&'static str]) -> Self {
        Table { columns: columns.to_vec(), rows: Vec::new() }
    }

    pub fn row(&mut self, cells: Vec<String>) {
        debug_assert_eq!(cells.len(), self.columns.len());
        self.rows.push(cells);
    }

    /// Under a heading; nothing where there are no rows. Columns without any content are left out.
    pub fn write(self, page: &mut String, heading: &str) {
        if self.rows.is_empty() {
            return;
        }
        let _ = writeln!(page, "\n# {heading}\n");
        let is_folded = self.rows.len() > SHOWN;
        if is_folded {
            let _ = writeln!(page, "<details><summary>{} rows</summary>\n", self.rows.len());
        }
        let kept: Vec<usize> =
            (0..self.columns.len()).filter(|k| self.rows.iter().any(|row| !row[*k].is_empty())).collect();
        let mut line = |cells: &mut dyn Iterator<Item = &str>| {
            let cells: Vec<&str> = cells.collect();
            let _ = writeln!(page, "| {} |", cells.join(" | "));
        };
        line(&mut kept.iter().map(|k| self.columns[*k]));
        line(&mut kept.iter().map(|_| "---"));
        for row in &self.rows {
            line(&mut kept.iter().map(|k| row[*k].as_str()));
        }
        if is_folded {
            page.push_str("\n</details>\n");
        }
    }
}

/// A name of the definition.
pub fn code(name: &str) -> String {
    format!("`{name}`")
}
