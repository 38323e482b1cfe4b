//! The front end: tokens → definition → model → static rules, and the exported definition.

mod beams;
mod builder;
mod cams;
mod contacts;
mod coverage;
mod curves;
mod definitions;
mod dry;
mod files;
mod flexible;
mod gears;
mod habits;
mod hysteresis;
mod json;
mod limits;
mod look_up;
mod loose;
mod memories;
mod mistakes;
mod parts;
mod penalties;
mod shear;
mod space;
mod spans;
mod statics;
mod strain;
mod tables;
mod values;
mod warnings;

use linkwright_compiler::diagnostics::{Diagnostics, Region};
use linkwright_compiler::model::{self, Mechanism};
use linkwright_compiler::{check, parse};
use proc_macro2::TokenStream;
use std::str::FromStr;

/// All stages of the front end, each stopping at its own errors.
fn front_end(source: &str) -> Result<Mechanism, Diagnostics> {
    let tokens = TokenStream::from_str(source).expect("the source consists of tokens");
    let mechanism = model::lower(&parse(tokens)?)?;
    let mut diagnostics = Diagnostics::new();
    check::rules::check(&mechanism, &mut diagnostics);
    diagnostics.finish(mechanism)
}

fn good(source: &str) -> Mechanism {
    front_end(source).unwrap_or_else(|diagnostics| panic!("{diagnostics}"))
}

fn bad(source: &str) -> Diagnostics {
    front_end(source).map(|_| ()).expect_err("the source has a mistake")
}

/// The warnings of a definition without errors.
fn warnings(source: &str) -> Diagnostics {
    check::warnings(&good(source), &[])
}

/// The source line of a region, and below it a line of `~` under the region.
fn underlined(source: &str, region: Region) -> String {
    let (start, end) = (region.start.start(), region.end.end());
    let line = source.lines().nth(start.line - 1).unwrap_or_default();
    let end = if end.line == start.line { end.column } else { line.chars().count() };
    let marks = "~".repeat(end.saturating_sub(start.column).max(1));
    format!("{line}\n{}{marks}", " ".repeat(start.column))
}

/// A slider-crank with everything that the small tests refer to; `more` is added at its end.
fn slider_crank(more: &str) -> String {
    format!(
        "planar SliderCrank {{
    const R [m] = 0.1;
    param heavy [kg] = 2.0 in 0.5..10.0;
    input drive [N*m];
    body crank {{ mass [kg] = 1; inertia [kg*m^2] = 0.01; point pin [m] = (R, 0); #[allow(unused)] line arm = (crank.origin, crank.pin); }}
    rod link {{ mass [kg] = 0.5; length [m] = 0.4; }}
    particle block {{ mass [kg] = heavy; }}
    line way = (ground(0, 0), ground(1, 0) [m]);
    joint base: revolute(ground(0, 0), crank.origin);
    joint knee: revolute(crank.pin, link.start);
    joint wrist: revolute(link.end, block.center);
    joint rail: point_on_line(way, block.center);
    force motor: torque(base) = drive;
{more}
}}"
    )
}

/// Statements of the slider-crank, each with the one message that it gives.
fn each_has_one_message(cases: &[(&str, &str)]) {
    let mut others = Vec::new();
    for (more, expected) in cases {
        let diagnostics = bad(&slider_crank(more));
        let found: Vec<String> = diagnostics.iter().map(|error| error.message.clone()).collect();
        if found != [*expected] {
            others.push(format!("{more}\n  expected {expected:?}\n     found {found:?}"));
        }
    }
    assert!(others.is_empty(), "{}", others.join("\n"));
}
