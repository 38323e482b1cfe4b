//! The equations as text: Φ, D, M, Q and γ in the user's names, as far as they are short enough to be read.

use super::expression::Writer;
use super::text::count;
use crate::compiled::Compiled;
use crate::symbolic::Node;
use std::fmt::Write;

/// Longest listing of one matrix or vector, lines.
const MOST: usize = 48;
/// Of an entry that needs more definitions than this nothing can be read.
const DEFINITIONS: usize = 8;
/// Width of a line.
const WIDTH: usize = 108;

/// One matrix or vector: its entries with what stands left of their signs of equality.
struct Section {
    heading: &'static str,
    entries: Vec<(String, Node)>,
    /// What an entry equals besides its expression: `= 0`.
    ending: &'static str,
}

pub fn equations(page: &mut String, compiled: &Compiled) {
    page.push_str("\n# Equations\n\n");
    page.push_str(match compiled.complete.equations.rows.is_empty() {
        true => "M v̇ = Q, where\n",
        false => "M v̇ + Dᵀ λ = Q, D v̇ = γ, on Φ = 0 and D v = ν, where\n",
    });
    let graph = compiled.complete.equations.graph.read();
    let mut writer = Writer::new(&compiled.mechanism, &compiled.complete.equations, &graph);
    let begin = page.len();
    for section in sections(compiled).iter().filter(|section| !section.entries.is_empty()) {
        listing(page, &mut writer, section);
    }
    if page[begin..].contains("  h1 =") {
        page.push_str("\nWhat occurs again stands before its first use: h1, h2 and so on.\n");
    }
}

fn sections(compiled: &Compiled) -> Vec<Section> {
    let equations = &compiled.complete.equations;
    let v = equations.layout.velocity_names(&compiled.mechanism);
    let rows = || equations.rows.iter();
    let row = |index: usize| format!("{}.{}", equations.rows[index].of, equations.rows[index].form.name);
    let is_zero = |node: &Node| equations.graph.read().is_zero(*node);
    let phi = rows().enumerate().map(|(index, own)| (row(index), own.jet.value));
    let jacobian = rows().enumerate().flat_map(|(index, own)| {
        let columns = own.jet.columns.iter();
        columns.map(|(column, node)| (format!("{}, {}", row(index), v[*column]), *node)).collect::<Vec<_>>()
    });
    let mass = equations.mass.iter().map(|((i, j), node)| (format!("{}, {}", v[*i], v[*j]), *node));
    let of_rows = |nodes: &[Node]| -> Vec<(String, Node)> {
        nodes.iter().enumerate().map(|(index, node)| (row(index), *node)).collect()
    };
    let forces = v.iter().cloned().zip(equations.forces.iter().copied());
    let nu = if equations.nu.iter().all(is_zero) { Vec::new() } else { of_rows(&equations.nu) };
    let outputs = compiled.mechanism.outputs.iter().map(|output| output.name.text.clone());
    let states = compiled.mechanism.states.iter().map(|state| state.name.text.clone());
    let energies = [("T", equations.kinetic_energy), ("V", equations.potential_energy)];
    let energies = energies.into_iter().filter(|(_, node)| !is_zero(node));
    vec![
        Section { heading: "Φ, m or rad", entries: phi.collect(), ending: " = 0" },
        Section { heading: "D", entries: jacobian.collect(), ending: "" },
        Section { heading: "M, lower triangle", entries: mass.collect(), ending: "" },
        Section { heading: "Q", entries: forces.collect(), ending: "" },
        Section { heading: "ν", entries: nu, ending: "" },
        Section { heading: "γ", entries: of_rows(&equations.gamma), ending: "" },
        Section {
            heading: "Kinetic and potential energy, J",
            entries: energies.map(|(name, node)| (name.to_string(), node)).collect(),
            ending: "",
        },
        Section {
            heading: "Rates of the states",
            entries: states.zip(equations.internal_rates.iter().copied()).collect(),
            ending: "",
        },
        Section {
            heading: "Outputs",
            entries: outputs.zip(equations.outputs.iter().copied()).collect(),
            ending: "",
        },
    ]
}

fn listing(page: &mut String, writer: &mut Writer, section: &Section) {
    let roots: Vec<Node> = section.entries.iter().map(|(_, node)| *node).collect();
    writer.share(&roots);
    let (mut lines, mut left_out) = (Vec::new(), 0);
    let broad = section.entries.iter().map(|(label, _)| label.chars().count()).max().unwrap_or(0);
    for (index, (label, node)) in section.entries.iter().enumerate() {
        let wanting = writer.wanting(*node);
        if wanting > DEFINITIONS || lines.len() + wanting >= MOST {
            left_out += 1;
            if lines.len() >= MOST {
                left_out += section.entries.len() - index - 1;
                break;
            }
            continue;
        }
        let (definitions, text) = writer.lines(*node);
        for (name, text) in definitions {
            wrap(&mut lines, &format!("  {name} = {text}"), name.len() + 5);
        }
        let (sign, ending) = if section.ending.is_empty() { (" =", "") } else { (":", section.ending) };
        let left = format!("{label}{sign}");
        wrap(&mut lines, &format!("{left:<width$} {text}{ending}", width = broad + sign.len()), broad + 3);
    }
    let _ = writeln!(page, "\n{}:\n\n```text", section.heading);
    for line in &lines {
        let _ = writeln!(page, "{line}");
    }
    if left_out > 0 {
        let entries = count(left_out, "entry", "entries");
        let _ = writeln!(page, "… {}{entries} left out", if lines.is_empty() { "" } else { "and " });
    }
    page.push_str("```\n");
}

/// Breaks a long line before a sign, outside of parentheses where there is one.
fn wrap(lines: &mut Vec<String>, text: &str, indent: usize) {
    let indent = indent.min(40);
    let pieces: Vec<&str> = text.split_inclusive(' ').collect();
    let is_sign = |piece: &str| matches!(piece.trim_end(), "+" | "−");
    let (mut line, mut open) = (String::new(), 0);
    for (index, piece) in pieces.iter().enumerate() {
        let length = line.chars().count();
        // To the next sign.
        let next: usize =
            pieces[index + 1..].iter().take_while(|it| !is_sign(it)).map(|it| it.chars().count()).sum();
        let is_full = length + 2 + next > WIDTH;
        if is_sign(piece) && length > indent && is_full && (open == 0 || 4 * length > 3 * WIDTH) {
            lines.push(line.trim_end().to_string());
            line = " ".repeat(indent);
        }
        open += piece.matches('(').count();
        open -= piece.matches(')').count().min(open);
        line.push_str(piece);
    }
    lines.push(line.trim_end().to_string());
}
