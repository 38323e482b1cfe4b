//! A small diagram: lines in a frame with the ranges of both axes beside it.

use super::figure::{escaped, number};
use crate::numbers::significant;
use std::fmt::Write;

/// The frame, px, and the space for the text around it.
const WIDTH: f64 = 180.0;
const HEIGHT: f64 = 110.0;
const MARGIN: [f64; 2] = [8.0, 32.0];

/// A line, and whether it is broken.
pub struct Line {
    pub points: Vec<[f64; 2]>,
    pub broken: bool,
}

pub struct Plot {
    pub title: String,
    /// With their units.
    pub across: String,
    pub up: String,
    /// From zero on, or from the least value.
    pub from_zero: bool,
    pub lines: Vec<Line>,
}

impl Plot {
    pub fn svg(&self) -> String {
        let all = || self.lines.iter().flat_map(|line| &line.points);
        let range = |k: usize, from_zero: bool| {
            let values = || all().map(|point| point[k]);
            let least = if from_zero { 0.0 } else { values().fold(f64::INFINITY, f64::min) };
            let most = values().fold(f64::NEG_INFINITY, f64::max);
            if most > least { [least, most] } else { [least - 1.0, most + 1.0] }
        };
        let (across, up) = (range(0, false), range(1, self.from_zero));
        let share = |value: f64, [least, most]: [f64; 2]| (value - least) / (most - least);
        let [side, text] = MARGIN;
        let mut svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" width=\"{0}\" height=\"{1}\" viewBox=\"-{side} -{text} {0} {1}\" \
             font-family=\"sans-serif\" font-size=\"11\" style=\"margin-right:16px;vertical-align:top\">\n<title>{2}</title>\n",
            number(WIDTH + 2.0 * side),
            number(HEIGHT + 2.0 * text),
            escaped(&self.title)
        );
        let mut write = |x: f64, y: f64, anchor: &str, content: &str| {
            let _ = writeln!(
                svg,
                "<text x=\"{}\" y=\"{}\" text-anchor=\"{anchor}\" fill=\"currentColor\">{}</text>",
                number(x),
                number(y),
                escaped(content)
            );
        };
        let digits =
            |value: f64| super::text::decimal(significant(value, 3).parse().unwrap_or(value)).to_string();
        write(0.0, -18.0, "start", &self.up);
        write(0.0, -5.0, "start", &format!("{} to {}", digits(up[0]), digits(up[1])));
        write(0.0, HEIGHT + 13.0, "start", &digits(across[0]));
        write(WIDTH, HEIGHT + 13.0, "end", &digits(across[1]));
        write(0.5 * WIDTH, HEIGHT + 26.0, "middle", &self.across);
        let _ = writeln!(
            svg,
            "<path d=\"M0 0h{0}v{1}h-{0}z\" fill=\"none\" stroke=\"currentColor\" stroke-width=\"0.8\"/>",
            number(WIDTH),
            number(HEIGHT)
        );
        for line in &self.lines {
            let place = |[x, y]: &[f64; 2]| {
                format!("{} {}", number(WIDTH * share(*x, across)), number(HEIGHT * (1.0 - share(*y, up))))
            };
            let points: Vec<String> = line.points.iter().map(place).collect();
            let dashes = if line.broken { " stroke-dasharray=\"4 3\"" } else { "" };
            let _ = writeln!(
                svg,
                "<path d=\"M{}\" fill=\"none\" stroke=\"currentColor\" stroke-width=\"1.4\"{dashes}/>",
                points.join("L")
            );
        }
        svg.push_str("</svg>\n");
        svg
    }
}
