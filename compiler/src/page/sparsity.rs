//! The patterns of M, D and of the factor, as small pictures: a square for an entry, a lighter one for what elimination adds.

use super::figure::{escaped, number};
use crate::compiled::Compiled;
use crate::order::Strategy;
use crate::solve;
use std::collections::BTreeSet;
use std::fmt::Write;

/// Side of a square, px, for small and for large matrices; of the largest picture.
const CELL: f64 = 9.0;
const LARGEST: f64 = 240.0;

/// A matrix by its entries.
struct Pattern {
    title: String,
    rows: usize,
    columns: usize,
    entries: BTreeSet<(usize, usize)>,
    fill: BTreeSet<(usize, usize)>,
}

pub fn sparsity(page: &mut String, compiled: &Compiled) {
    let patterns = patterns(compiled);
    page.push_str("\n# Sparsity\n\n<div>\n");
    for pattern in &patterns {
        page.push_str(&picture(pattern));
    }
    page.push_str("</div>\n\n");
    let captions: Vec<String> = patterns.iter().map(caption).collect();
    let _ = writeln!(page, "{}.", captions.join("; "));
    if compiled.complete.solved.order.strategy == Strategy::ArticulatedBodies {
        page.push_str("\nNothing is factored: the tree is solved by articulated bodies, without M.\n");
    }
}

fn patterns(compiled: &Compiled) -> Vec<Pattern> {
    let equations = &compiled.complete.equations;
    let (n, rows) = (equations.layout.velocities(), equations.rows.len());
    let lower = equations.mass.keys().copied();
    let symmetric = lower.flat_map(|(i, j)| [(i, j), (j, i)]).collect();
    let mut patterns = vec![Pattern {
        title: "M".to_string(),
        rows: n,
        columns: n,
        entries: symmetric,
        fill: BTreeSet::new(),
    }];
    if rows > 0 {
        let entries = equations.rows.iter().enumerate();
        let entries = entries.flat_map(|(row, own)| own.jet.columns.keys().map(move |column| (row, *column)));
        patterns.push(Pattern {
            title: "D".to_string(),
            rows,
            columns: n,
            entries: entries.collect(),
            fill: BTreeSet::new(),
        });
    }
    if compiled.complete.solved.order.strategy != Strategy::ArticulatedBodies {
        let (entries, fill) = solve::factor_pattern(equations, &compiled.complete.solved);
        let size = compiled.complete.solved.order.sequence.len();
        patterns.push(Pattern { title: "L".to_string(), rows: size, columns: size, entries, fill });
    }
    patterns
}

fn caption(pattern: &Pattern) -> String {
    let Pattern { title, rows, columns, entries, fill } = pattern;
    match title.as_str() {
        "L" if *rows == 0 => "nothing is left to be factored".to_string(),
        "L" => format!(
            "L of K = L Δ Lᵀ, {rows} unknowns in the order of elimination: {} below the diagonal, {} of them new",
            entries.len() + fill.len(),
            fill.len()
        ),
        _ => format!("{title}, {rows} × {columns}: {} entries", entries.len()),
    }
}

fn picture(pattern: &Pattern) -> String {
    let Pattern { title, rows, columns, entries, fill } = pattern;
    let largest = (*rows).max(*columns).max(1) as f64;
    let cell = CELL.min(LARGEST / largest);
    let (width, height) = (cell * *columns as f64, cell * *rows as f64);
    let frame = 14.0;
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" width=\"{0}\" height=\"{1}\" viewBox=\"-2 -{frame} {0} {1}\" \
         font-family=\"sans-serif\" font-size=\"11\" style=\"margin-right:16px;vertical-align:top\">\n<title>{2}</title>\n",
        number(width.max(20.0) + 4.0),
        number(height + frame + 4.0),
        escaped(&caption(pattern))
    );
    let _ = writeln!(svg, "<text x=\"0\" y=\"-4\" fill=\"currentColor\">{title}</text>");
    let _ = writeln!(
        svg,
        "<rect x=\"-1\" y=\"-1\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"currentColor\" stroke-width=\"0.8\"/>",
        number(width + 2.0),
        number(height + 2.0)
    );
    let is_factor = title == "L";
    let diagonal: BTreeSet<(usize, usize)> =
        if is_factor { (0..*rows).map(|k| (k, k)).collect() } else { BTreeSet::new() };
    for (cells, opacity) in [(entries, "1"), (&diagonal, "1"), (fill, "0.4")] {
        let mut path = String::new();
        for (row, first, count) in runs(cells) {
            let (x, y) = (cell * first as f64, cell * row as f64);
            let (w, h) = (cell * count as f64, cell);
            let gap = if cell > 4.0 { 0.5 } else { 0.0 };
            let _ = write!(
                path,
                "M{} {}h{}v{}h-{}z",
                number(x + gap),
                number(y + gap),
                number(w - 2.0 * gap),
                number(h - 2.0 * gap),
                number(w - 2.0 * gap)
            );
        }
        if !path.is_empty() {
            let _ = writeln!(svg, "<path d=\"{path}\" fill=\"currentColor\" fill-opacity=\"{opacity}\"/>");
        }
    }
    svg.push_str("</svg>\n");
    svg
}

/// Entries that stand side by side, as row, first column and count.
fn runs(cells: &BTreeSet<(usize, usize)>) -> Vec<(usize, usize, usize)> {
    let mut runs: Vec<(usize, usize, usize)> = Vec::new();
    for (row, column) in cells {
        match runs.last_mut() {
            Some((last, first, count)) if last == row && *first + *count == *column => *count += 1,
            _ => runs.push((*row, *column, 1)),
        }
    }
    runs
}
