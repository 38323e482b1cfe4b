//! Names beside what they name: each takes the free place nearest to it, and one that finds none is left out.

use crate::drawing::canvas::{ACCENT, PAPER, escaped, number};
use crate::drawing::shapes::away;
use crate::drawing::view::Spot;
use std::fmt::Write;

/// Of what the name is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    Body,
    Joint,
    Load,
}

impl Kind {
    /// Mean width of a letter, px.
    fn letter(self) -> f64 {
        if self == Kind::Body { 7.4 } else { 6.3 }
    }
}

/// A name to be placed.
#[derive(Clone, Debug)]
pub struct Label {
    pub text: String,
    pub anchor: Spot,
    /// What it names reaches so far around the anchor, px; 0 where the name may stand on it.
    pub reach: f64,
    pub kind: Kind,
}

/// A rectangle along the axes of the picture: centre and half sizes.
#[derive(Clone, Copy, Debug)]
pub struct Area {
    pub center: Spot,
    pub half: [f64; 2],
}

/// Height of letters, px; their widths are those of [`Kind::letter`].
const HEIGHT: f64 = 12.0;
/// Free room around what a name stands beside, px.
const DISTANCES: [f64; 5] = [2.0, 7.0, 13.0, 20.0, 29.0];
const DIRECTIONS: u32 = 16;
/// Of more names only those are written that need no line.
const MANY: usize = 40;
/// From here on a line leads from the name to what it names.
const LED: f64 = 12.0;

impl Area {
    fn overlap(&self, other: &Area) -> f64 {
        let along = |k: usize| {
            let apart = (self.center[k] - other.center[k]).abs();
            (self.half[k] + other.half[k] - apart).clamp(0.0, 2.0 * self.half[k].min(other.half[k]))
        };
        along(0) * along(1)
    }

    fn size(&self) -> f64 {
        4.0 * self.half[0] * self.half[1]
    }
}

/// Writes the names that find a place; gives the number of those that do not.
pub fn write(svg: &mut String, labels: &[Label], blocked: &[Area], width: f64, height: f64) -> usize {
    let mut taken: Vec<Area> = Vec::new();
    let mut left_out = 0;
    for label in labels {
        match place(label, &taken, blocked, width, height) {
            Some((area, distance)) if distance <= LED || labels.len() <= MANY => {
                text(svg, label, &area, distance);
                taken.push(area);
            }
            _ => left_out += 1,
        }
    }
    left_out
}

fn place(label: &Label, taken: &[Area], blocked: &[Area], width: f64, height: f64) -> Option<(Area, f64)> {
    let letters = label.text.chars().count() as f64;
    let half = [letters * label.kind.letter() / 2.0 + 1.0, HEIGHT / 2.0];
    let near: Vec<&Area> = blocked
        .iter()
        .filter(|area| away(area.center, label.anchor) < label.reach + 2.0 * half[0] + 60.0)
        .collect();
    let mut best: Option<(f64, (Area, f64))> = None;
    let mut consider = |center: Spot, distance: f64, preference: f64| {
        let area = Area { center, half };
        let inside = (0..2).all(|k| center[k] > half[k] && center[k] < [width, height][k] - half[k]);
        let names: f64 = taken.iter().map(|other| area.overlap(other)).sum();
        let lines: f64 = near.iter().map(|other| area.overlap(other)).sum();
        if !inside || names > 0.0 || lines > 0.3 * area.size() {
            return;
        }
        let cost = 6.0 * lines + 4.0 * distance + preference;
        if best.is_none_or(|(least, _)| cost < least) {
            best = Some((cost, (area, distance)));
        }
    };
    if label.reach == 0.0 {
        consider(label.anchor, 0.0, 0.0);
    }
    for distance in DISTANCES {
        for k in 0..DIRECTIONS {
            let angle = std::f64::consts::TAU * f64::from(k) / f64::from(DIRECTIONS);
            let (x, y) = (libm::cos(angle), libm::sin(angle));
            let free = label.reach + distance;
            let center = [label.anchor[0] + x * (free + half[0]), label.anchor[1] - y * (free + half[1])];
            // To the right and above rather than below, all else being equal.
            consider(center, distance, 2.0 - x - y);
        }
    }
    best.map(|(_, found)| found)
}

fn text(svg: &mut String, label: &Label, area: &Area, distance: f64) {
    let [x, y] = area.center;
    if distance > LED {
        let reach = [0, 1].map(|k| (label.anchor[k] - area.center[k]).clamp(-area.half[k], area.half[k]));
        let from = [x + reach[0], y + reach[1]];
        let _ = writeln!(
            svg,
            "<path d=\"M{} {}L{} {}\" stroke=\"currentColor\" stroke-width=\"0.6\" opacity=\"0.6\"/>",
            number(from[0]),
            number(from[1]),
            number(label.anchor[0]),
            number(label.anchor[1])
        );
    }
    let style = match label.kind {
        Kind::Body => "fill=\"currentColor\" font-weight=\"600\"".to_string(),
        Kind::Joint => "fill=\"currentColor\" font-style=\"italic\"".to_string(),
        Kind::Load => format!("fill=\"{ACCENT}\""),
    };
    let _ = writeln!(
        svg,
        "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\" {style} stroke=\"{PAPER}\" stroke-width=\"3\" \
         paint-order=\"stroke\">{}</text>",
        number(x),
        number(y + 0.35 * HEIGHT),
        escaped(&label.text)
    );
}
