//! The modes of bodies that deform: what they are, how fast they are by themselves, the step that they allow, and what they look like.

use super::figure::{escaped, number};
use super::net::Net;
use super::table::{Table, code};
use crate::beams::{Mode, RK4, Way};
use crate::compiled::Compiled;
use crate::drawing::vector::{Point, along, difference, dot, length, unit};
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
/// Of the largest displacement: less is not seen.
const SLIGHT: f64 = 1e-3;
/// Places along a curve, and marks along an axis that is stretched.
const PLACES: usize = 60;
const MARKS: usize = 20;

pub fn beams(page: &mut String, compiled: &Compiled) {
    let mechanism = &compiled.mechanism;
    let defaults = mechanism.defaults();
    let mut table = Table::new(&["mode", "shapes", "by itself, Hz", "steps of RK4 up to, µs"]);
    let mut pictures = String::new();
    for body in &mechanism.bodies {
        if let Some(deforms @ Deforms::Modal(modal)) = &body.deforms {
            let net = Net::new(&modal.reduced, &[]);
            for (mode, rate) in deforms.rates(&body.mass, &defaults).into_iter().enumerate() {
                let name = &format!("{}.{}", body.name.text, deforms.mode_name(mode));
                if let Some(net) = &net {
                    pictures.push_str(&of_net(net, mode, &titled(name, rate)));
                }
                table.row(row(name, "of its file", rate));
            }
        }
        let Some(beam) = body.beam() else { continue };
        for (index, (mode, rate)) in
            beam.slender.modes.iter().zip(beam.rates(&body.mass, &defaults)).enumerate()
        {
            let name = &format!("{}.{}", body.name.text, beam.mode_name(index));
            pictures.push_str(&picture(mode, &titled(name, rate)));
            table.row(row(name, beam.slender.shapes.word(), rate));
        }
    }
    table.write(page, "Modes");
    if !pictures.is_empty() {
        let _ = write!(
            page,
            "\n<div>\n{pictures}</div>\n\nThe axis of each mode, start at the left, beside the axis of the frame; of what is axial, marks \
             that are evenly spaced while nothing moves, of torsion a line on the surface of a round shaft; of a body from a file the lines \
             between its nodes, from where it moves most. How large they are says nothing.\n"
        );
    }
}

fn titled(name: &str, rate: f64) -> String {
    format!("{name}, {} Hz", significant(rate / TAU, 6))
}

fn row(name: &str, shapes: &str, rate: f64) -> Vec<String> {
    vec![code(name), shapes.to_string(), significant(rate / TAU, 6), significant(1e6 * RK4 / rate, 3)]
}

/// The axis as a mode bends or stretches it.
fn picture(mode: &Mode, title: &str) -> String {
    let [width, height] = [LENGTH + 2.0 * MARGIN, 2.0 * (DEFLECTION + MARGIN) + TEXT];
    let largest = (0..=PLACES).map(|k| at(mode, k, PLACES).abs()).fold(0.0, f64::max);
    let shape = |k: usize, count: usize| at(mode, k, count) / largest;
    let share = |k: usize, count: usize| LENGTH * k as f64 / count as f64;
    let drawn = match mode.way {
        Way::Bending | Way::BendingZ => {
            let place =
                |k: usize| format!("{} {}", number(share(k, PLACES)), number(-DEFLECTION * shape(k, PLACES)));
            format!("M{}", (0..=PLACES).map(place).collect::<Vec<_>>().join("L"))
        }
        Way::Axial => {
            let mark = |k: usize| format!("M{} -9v18", number(share(k, MARKS) + STRETCH * shape(k, MARKS)));
            (0..=MARKS).map(mark).collect()
        }
        // On the surface of a shaft, by sines up to one at a right angle.
        Way::Torsion => {
            let place = |k: usize| {
                let height = -DEFLECTION * libm::sin(FRAC_PI_2 * shape(k, PLACES));
                format!("{} {}", number(share(k, PLACES)), number(height))
            };
            let line = (0..=PLACES).map(place).collect::<Vec<_>>().join("L");
            format!("M0 -{DEFLECTION}h{LENGTH}M0 {DEFLECTION}h{LENGTH}M{line}")
        }
    };
    framed(&format!("M0 0h{}", number(LENGTH)), &drawn, [width, height], title)
}

/// The lines of a net as a mode bends them, seen along what it moves least.
fn of_net(net: &Net, mode: usize, title: &str) -> String {
    let stations = 0..net.count();
    let moved: Vec<Point> = stations.clone().map(|station| net.factors(station, 1.0)[mode]).collect();
    let places: Vec<Point> = stations.map(|station| net.place(station)).collect();
    let Some(from) = places.first() else { return String::new() };
    // Along the body, and across it the way it moves most.
    let farthest = |of: &mut dyn Iterator<Item = Point>| {
        of.fold([0.0; 3], |best, it| if dot(it, it) > dot(best, best) { it } else { best })
    };
    let long = unit(farthest(&mut places.iter().map(|at| difference(*at, *from))));
    let beside = |at: Point| along(at, -dot(at, long), long);
    let largest = moved.iter().map(|it| length(*it)).fold(0.0, f64::max);
    let mut wide = farthest(&mut moved.iter().map(|it| beside(*it)));
    if length(wide) <= SLIGHT * largest {
        wide = farthest(&mut places.iter().map(|at| beside(difference(*at, *from))));
    }
    let wide = unit(wide);
    let seen = |at: Point| [dot(difference(at, *from), long), dot(difference(at, *from), wide)];
    let spread = |k: usize| {
        let all = places.iter().map(|at| seen(*at)[k]);
        (all.clone().fold(f64::INFINITY, f64::min), all.fold(f64::NEG_INFINITY, f64::max))
    };
    let ((left, right), (low, high)) = (spread(0), spread(1));
    let scale = LENGTH / (right - left).max(high - low);
    let grown = if largest > 0.0 { DEFLECTION / scale / largest } else { 0.0 };
    let path = |grown: f64| {
        let mut text = String::new();
        let mut station = 0;
        for count in &net.lines {
            for k in 0..*count {
                let [x, y] = seen(along(places[station], grown, moved[station]));
                let letter = if k == 0 { 'M' } else { 'L' };
                let _ = write!(
                    text,
                    "{letter}{} {}",
                    number(scale * (x - left)),
                    number(-scale * (y - (low + high) / 2.0))
                );
                station += 1;
            }
        }
        text
    };
    let tall = scale * (high - low) + 2.0 * DEFLECTION;
    framed(&path(0.0), &path(grown), [LENGTH + 2.0 * MARGIN, tall + 2.0 * MARGIN + TEXT], title)
}

/// Lines while nothing moves, and as they move, about a middle height.
fn framed(still: &str, drawn: &str, [width, height]: [f64; 2], title: &str) -> String {
    let half = (height - TEXT) / 2.0;
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" width=\"{0}\" height=\"{1}\" viewBox=\"-{MARGIN} -{2} {0} {1}\" \
         font-family=\"sans-serif\" font-size=\"11\" style=\"margin-right:16px;vertical-align:top\">\n<title>{3}</title>\n\
         <path d=\"{still}\" fill=\"none\" stroke=\"currentColor\" stroke-width=\"0.8\" stroke-dasharray=\"9 3 2 3\"/>\n\
         <path d=\"{drawn}\" fill=\"none\" stroke=\"currentColor\" stroke-width=\"1.6\" stroke-linecap=\"round\" stroke-linejoin=\"round\"/>\n\
         <text x=\"0\" y=\"{4}\" fill=\"currentColor\">{3}</text>\n</svg>\n",
        number(width),
        number(height),
        number(half),
        escaped(title),
        number(half + 10.0),
    )
}

fn at(mode: &Mode, k: usize, count: usize) -> f64 {
    mode.shape.at(k as f64 / count as f64, 0)
}
