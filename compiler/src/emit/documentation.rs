//! The generated documentation of a model: degrees of freedom, coordinates and why, tables, counts.

use super::{Emitter, quoted};
use crate::model::Mechanism;
use crate::schedule::{Function, Programs, count};
use std::fmt::Write;

/// `#[cfg_attr(doc, doc = "…")]` lines for the model's struct.
pub fn model(text: &mut String, emitter: &Emitter) {
    let compiled = emitter.compiled;
    let mut page = String::new();
    let equations = &compiled.equations;
    let _ = writeln!(
        page,
        "\n{} of freedom: {}; velocities: {}; constraint rows: {}.\n",
        if compiled.assembly.mobility.generic == 1 { "Degree" } else { "Degrees" },
        compiled.assembly.mobility.generic,
        equations.layout.velocities(),
        equations.rows.len()
    );
    let _ = writeln!(page, "{}\n", compiled.choice.explanation());
    page.push_str("# Coordinates\n\n| | q | v |\n|---|---|---|\n");
    coordinates(&mut page, emitter.mechanism, emitter);
    if !equations.rows.is_empty() {
        page.push_str("\n# Constraint rows\n\n| # | joint | row |\n|---|---|---|\n");
        for (index, row) in equations.rows.iter().enumerate().take(MOST) {
            let _ = writeln!(page, "| {index} | `{}` | {} |", row.of, row.what);
        }
        more(&mut page, equations.rows.len());
    }
    if !compiled.assembly.dropped.is_empty() {
        page.push_str("\n# Redundant rows\n\nThe others fix what these fix:");
        for row in &compiled.assembly.dropped {
            let _ = write!(page, " `{}` ({});", emitter.mechanism.joints[row.joint.0].name.text, row.what);
        }
        page.push_str(" the reactions of these joints are not unique:");
        for joint in &compiled.assembly.shared {
            let _ = write!(page, " `{}`", emitter.mechanism.joints[joint.0].name.text);
        }
        page.push('\n');
    }
    page.push_str("\n# Operations\n\n");
    page.push_str(&operation_table(&compiled.programs));
    for line in page.lines() {
        let _ = writeln!(text, "#[cfg_attr(doc, doc = {})]", quoted(line));
    }
    // Without `cargo doc` one line is enough.
    let summary = format!(
        "Equations of motion of the {} mechanism `{}`.",
        emitter.mechanism.space.text(),
        emitter.name
    );
    let _ = writeln!(text, "#[cfg_attr(not(doc), doc = {})]", quoted(&summary));
}

/// Longest table of a page.
const MOST: usize = 40;

fn more(page: &mut String, length: usize) {
    if length > MOST {
        let _ = writeln!(page, "| … | {} more | |", length - MOST);
    }
}

fn coordinates(page: &mut String, mechanism: &Mechanism, emitter: &Emitter) {
    let layout = &emitter.compiled.equations.layout;
    let (q, v) = (layout.position_names(mechanism), layout.velocity_names(mechanism));
    let (linear, rotations) = (layout.linear.len(), layout.rotations.len());
    let lines = layout.velocities();
    for index in 0..lines.min(MOST) {
        let position = if index < linear {
            format!("`{}`", q[index])
        } else if index < linear + rotations {
            let pair = layout.pair(index - linear);
            format!("`{}`, `{}`", q[pair], q[pair + 1])
        } else {
            // Four entries beside three rates.
            let (ball, axis) = ((index - linear - rotations) / 3, (index - linear - rotations) % 3);
            let at = layout.quaternion(ball);
            let scalar = if axis == 0 { format!("`{}`, ", q[at]) } else { String::new() };
            format!("{scalar}`{}`", q[at + 1 + axis])
        };
        let _ = writeln!(page, "| {index} | {position} | `{}` |", v[index]);
    }
    more(page, lines);
    for a in 0..layout.angles.len().min(MOST) {
        let at = layout.turns(a);
        let _ = writeln!(page, "| | `{}`, `{}` | |", q[at], q[at + 1]);
    }
}

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
