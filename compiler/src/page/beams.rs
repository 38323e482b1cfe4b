//! The modes of bodies that deform: what they are, how fast they are by themselves, the step that they allow, and what they look like.

use super::figure::{escaped, number};
use super::table::{Table, code};
use crate::beams::{Mode, RK4, Way};
use crate::compiled::Compiled;
use crate::model::Deforms;
use crate::numbers::significant;
use std::f64::consts::{FRAC_PI_2, TAU};
use std::fmt::Write;

/// A picture of a mode, px: the length of the beam, the largest deflection of bending, half the height of a shaft, and stretch, what is around.
const LENGTH: f64 = 150.0;
const DEFLECTION: f64 = 18.0;
const STRETCH: f64 = 8.0;
const MARGIN: f64 = 10.0;
const TEXT: f64 = 18.0;
/// Places along a curve, and marks along an axis that is stretched.
const PLACES: usize = 60;
const MARKS: usize = 20;

pub fn beams(page: &mut String, compiled: &Compiled) {
    let mechanism = &compiled.mechanism;
    let defaults = mechanism.defaults();
    let mut table = Table::new(&["mode", "shapes", "by itself, Hz", "steps of RK4 up to, µs"]);
    let mut pictures = String::new();
    for body in &mechanism.bodies {
        if let Some(deforms @ Deforms::Modal(_)) = &body.deforms {
            for (mode, rate) in deforms.rates(&body.mass, &defaults).into_iter().enumerate() {
                table.row(row(
                    &format!("{}.{}", body.name.text, deforms.mode_name(mode)),
                    "of its file",
                    rate,
                ));
            }
        }
        let Some(beam) = body.beam() else { continue };
        for (index, (mode, rate)) in
            beam.slender.modes.iter().zip(beam.rates(&body.mass, &defaults)).enumerate()
        {
            let name = &format!("{}.{}", body.name.text, beam.mode_name(index));
            let hertz = significant(rate / TAU, 6);
            pictures.push_str(&picture(mode, &format!("{name}, {hertz} Hz")));
            table.row(row(name, beam.slender.shapes.word(), rate));
        }
    }
    table.write(page, "Modes");
    if !pictures.is_empty() {
        let _ = write!(
            page,
            "\n<div>\n{pictures}</div>\n\nThe axis of each mode, start at the left, beside the axis of the frame; of what is axial, marks \
             that are evenly spaced while nothing moves, of torsion a line on the surface of a round shaft. How large they are says nothing.\n"
        );
    }
}

fn row(name: &str, shapes: &str, rate: f64) -> Vec<String> {
    vec![code(name), shapes.to_string(), significant(rate / TAU, 6), significant(1e6 * RK4 / rate, 3)]
}

/// The axis as a mode bends or stretches it.
fn picture(mode: &Mode, title: &str) -> String {
    let [width, height] = [LENGTH + 2.0 * MARGIN, 2.0 * (DEFLECTION + MARGIN) + TEXT];
    let largest = (0..=PLACES).map(|k| at(mode, k, PLACES).abs()).fold(0.0, f64::max);
    let shape = |k: usize, count: usize| at(mode, k, count) / largest;
    let along = |k: usize, count: usize| LENGTH * k as f64 / count as f64;
    let drawn = match mode.way {
        Way::Bending | Way::BendingZ => {
            let place =
                |k: usize| format!("{} {}", number(along(k, PLACES)), number(-DEFLECTION * shape(k, PLACES)));
            format!("M{}", (0..=PLACES).map(place).collect::<Vec<_>>().join("L"))
        }
        Way::Axial => {
            let mark = |k: usize| format!("M{} -9v18", number(along(k, MARKS) + STRETCH * shape(k, MARKS)));
            (0..=MARKS).map(mark).collect()
        }
        // On the surface of a shaft, by sines up to one at a right angle.
        Way::Torsion => {
            let place = |k: usize| {
                let height = -DEFLECTION * libm::sin(FRAC_PI_2 * shape(k, PLACES));
                format!("{} {}", number(along(k, PLACES)), number(height))
            };
            let line = (0..=PLACES).map(place).collect::<Vec<_>>().join("L");
            format!("M0 -{DEFLECTION}h{LENGTH}M0 {DEFLECTION}h{LENGTH}M{line}")
        }
    };
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" width=\"{0}\" height=\"{1}\" viewBox=\"-{MARGIN} -{2} {0} {1}\" \
         font-family=\"sans-serif\" font-size=\"11\" style=\"margin-right:16px;vertical-align:top\">\n<title>{3}</title>\n\
         <path d=\"M0 0h{4}\" fill=\"none\" stroke=\"currentColor\" stroke-width=\"0.8\" stroke-dasharray=\"9 3 2 3\"/>\n\
         <path d=\"{drawn}\" fill=\"none\" stroke=\"currentColor\" stroke-width=\"1.6\" stroke-linecap=\"round\" stroke-linejoin=\"round\"/>\n\
         <text x=\"0\" y=\"{5}\" fill=\"currentColor\">{3}</text>\n</svg>\n",
        number(width),
        number(height),
        number(DEFLECTION + MARGIN),
        escaped(title),
        number(LENGTH),
        number(DEFLECTION + MARGIN + 10.0),
    )
}

fn at(mode: &Mode, k: usize, count: usize) -> f64 {
    mode.shape.at(k as f64 / count as f64, 0)
}
