//! The page of a mechanism: a drawing of it, what it consists of, its equations, what they cost and why they are as they
//! are. Markdown with SVG between its lines, for rustdoc and for whoever else shows Markdown.
//!
//! Nothing of it may become a test or a link: blocks of text are fenced as `text`, names with brackets stand in code, and
//! no blank line interrupts a drawing.

mod beams;
mod bent;
mod curves;
mod dimensions;
mod equations;
mod expression;
mod figure;
mod links;
mod net;
mod operations;
mod plot;
pub mod scene;
mod sketch;
mod sparsity;
mod stand;
mod surfaces;
mod table;
mod tables;
mod teeth;
mod terms;
mod text;

use crate::compiled::Compiled;
pub use figure::{Figure, alone, magnified};
use sketch::Sketch;
pub use stand::Pose;
use std::fmt::Write;
use text::count;

/// The page, without a title.
pub fn page(compiled: &Compiled) -> String {
    let mut page = String::new();
    drawing(&mut page, compiled);
    summary(&mut page, compiled);
    tables::parts(&mut page, compiled);
    tables::bodies(&mut page, compiled);
    beams::beams(&mut page, compiled);
    tables::joints(&mut page, compiled);
    tables::couplings(&mut page, compiled);
    teeth::tables(&mut page, compiled);
    teeth::pictures(&mut page, compiled);
    tables::loads(&mut page, compiled);
    tables::settings(&mut page, compiled);
    curves::curves(&mut page, compiled);
    tables::coordinates(&mut page, compiled);
    tables::rows(&mut page, compiled);
    equations::equations(&mut page, compiled);
    sparsity::sparsity(&mut page, compiled);
    page.push_str("\n# Operations\n\n");
    page.push_str(&operations::operation_table(&compiled.programs));
    page
}

/// The drawing of a mechanism in a pose.
pub fn drawing_at(compiled: &Compiled, pose: &Pose) -> Figure {
    figure::figure(&compiled.mechanism.name.text, &Sketch::of(compiled, pose), &[])
}

/// The same with the lengths between joints.
pub fn dimensioned_at(compiled: &Compiled, pose: &Pose) -> Figure {
    let dimensions = dimensions::dimensions(compiled, pose);
    figure::figure(&compiled.mechanism.name.text, &Sketch::of(compiled, pose), &dimensions)
}

fn drawing(page: &mut String, compiled: &Compiled) {
    let figure = drawing_at(compiled, &Pose::start(compiled));
    let _ = writeln!(page, "<div>\n{}\n</div>\n", figure.svg);
    if figure.left_out > 0 {
        let names = count(figure.left_out, "name found", "names found");
        let _ = writeln!(page, "{names} no place in the drawing; the tables have all of them.\n");
    }
}

fn summary(page: &mut String, compiled: &Compiled) {
    let equations = &compiled.complete.equations;
    let _ = writeln!(
        page,
        "{}; {}; {}.\n",
        count(compiled.assembly.mobility.generic, "degree of freedom", "degrees of freedom"),
        count(equations.layout.velocities(), "velocity", "velocities"),
        count(equations.rows.len(), "constraint row", "constraint rows"),
    );
    let _ = writeln!(page, "{}", compiled.explanation());
}
