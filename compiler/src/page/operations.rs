//! Operations of each function.

use crate::schedule::{Function, Programs, count};
use std::fmt::Write;

/// A Markdown table of the operations of each function.
pub fn operation_table(programs: &Programs) -> String {
    let mut table =
        String::from("| function | operations | + | × | fma | ÷ | √ | choices | sin, exp … | depth |\n");
    table.push_str("|---|---|---|---|---|---|---|---|---|---|\n");
    for (function, program) in &programs.functions {
        let counts = count(program);
        if counts.total() == 0 || *function == Function::StartTargets {
            continue;
        }
        let _ = writeln!(
            table,
            "| `{}` | {} | {} | {} | {} | {} | {} | {} | {} | {} |",
            function.name(),
            counts.total(),
            counts.additions,
            counts.multiplications,
            counts.fused_multiply_adds,
            counts.divisions,
            counts.square_roots,
            counts.choices,
            counts.transcendentals,
            counts.depth
        );
    }
    table
}
