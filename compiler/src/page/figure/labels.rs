//! Names beside what they name: each takes the free place nearest to it, where it covers no other name and nothing that is
//! drawn. Farther away a line leads to it, and one that finds no place is left out.

use super::room::Area;
use crate::drawing::canvas::{ACCENT, PAPER, Trace, escaped, number};
use crate::drawing::shapes::{away, heading, shifted};
use crate::drawing::view::Spot;
use std::fmt::Write;

/// Of what the name is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    Body,
    Joint,
    Coupling,
    Load,
}

/// A name to be placed.
#[derive(Clone, Debug)]
pub struct Label {
    pub text: String,
    /// Where it may stand, the best first.
    pub anchors: Vec<Spot>,
    /// What it names reaches so far around the anchor, px; 0 where the name may stand on it.
    pub reach: f64,
    pub kind: Kind,
}

/// Free room around what a name stands beside, px.
const DISTANCES: [f64; 14] =
    [2.0, 6.0, 11.0, 17.0, 25.0, 35.0, 48.0, 65.0, 85.0, 110.0, 140.0, 180.0, 230.0, 290.0];
const DIRECTIONS: u32 = 24;
/// From here on a line leads from the name to what it names.
const LED: f64 = 12.0;

/// Letters, px: smaller where there are many names.
pub fn size(names: usize) -> f64 {
    match names {
        0..=40 => 12.0,
        41..=80 => 11.0,
        _ => 10.0,
    }
}

/// Width of a text in letters of size one: what common fonts without serifs do not exceed.
pub fn width(text: &str, is_bold: bool) -> f64 {
    let letter = |c: char| match c {
        'i' | 'j' | 'l' | 'I' | '.' | ',' | ':' | ';' | '|' | '\'' => 0.35,
        'f' | 'r' | 't' | '(' | ')' | '[' | ']' | '-' | '/' | ' ' => 0.44,
        '_' => 0.51,
        'm' | 'w' | 'M' | 'W' => 1.0,
        'A'..='Z' => 0.8,
        'a'..='z' | '0'..='9' => 0.65,
        _ => 1.0,
    };
    text.chars().map(letter).sum::<f64>() * if is_bold { 1.13 } else { 1.0 }
}

/// The names that found a place.
struct Sheet<'a> {
    edge: [f64; 2],
    size: f64,
    drawn: &'a [Trace],
    taken: Vec<Area>,
    /// Lines to names.
    leads: Vec<Trace>,
    /// Whether names and lines to names cross nowhere.
    is_strict: bool,
}

/// A place for a name: where, and the line that leads there.
struct Found {
    area: Area,
    lead: Option<[Spot; 2]>,
}

/// Writes the names that find a place, into none of the areas; gives the number of those that do not.
pub fn write(svg: &mut String, labels: &[Label], areas: Vec<Area>, drawn: &[Trace], edge: [f64; 2]) -> usize {
    let mut sheet =
        Sheet { edge, size: size(labels.len()), drawn, taken: areas, leads: Vec::new(), is_strict: true };
    let all: Vec<&Label> = labels.iter().collect();
    let (mut lines, mut texts) = (String::new(), String::new());
    let left = sheet.write(&mut lines, &mut texts, &all);
    // Names that find no other place may interrupt lines to names, or be before one.
    sheet.is_strict = false;
    let left = sheet.write(&mut lines, &mut texts, &left);
    *svg += &(lines + &texts);
    left.len()
}

impl Sheet<'_> {
    /// Gives the names that find no place.
    fn write<'l>(&mut self, lines: &mut String, texts: &mut String, labels: &[&'l Label]) -> Vec<&'l Label> {
        let mut left = Vec::new();
        for label in labels {
            match self.place(label) {
                Some(found) => {
                    found.lead.iter().for_each(|ends| line(lines, *ends));
                    text(texts, label, &found.area, self.size);
                    self.taken.push(found.area);
                    self.leads.extend(found.lead.map(|line| Trace::Line(line, 0.3)));
                }
                None => left.push(*label),
            }
        }
        left
    }

    fn place(&self, label: &Label) -> Option<Found> {
        let width = width(&label.text, label.kind == Kind::Body) * self.size;
        let half = [width / 2.0 + 1.0, self.size / 2.0 + 0.5];
        let far = label.reach + 2.0 * half[0] + DISTANCES[DISTANCES.len() - 1];
        let near: Vec<&Trace> =
            self.drawn.iter().filter(|trace| is_near(trace, &label.anchors, far)).collect();
        if label.reach == 0.0 {
            let mut centers = label.anchors.iter().map(|center| Area { center: *center, half });
            if let Some(area) = centers.find(|area| self.is_free(area, &near)) {
                return Some(Found { area, lead: None });
            }
        }
        DISTANCES.iter().find_map(|distance| self.around(label, half, *distance, &near))
    }

    /// The best place so far away from an anchor.
    fn around(&self, label: &Label, half: [f64; 2], distance: f64, near: &[&Trace]) -> Option<Found> {
        let mut best: Option<(f64, Found)> = None;
        for (rank, anchor) in label.anchors.iter().enumerate() {
            for k in 0..DIRECTIONS {
                let angle = std::f64::consts::TAU * f64::from(k) / f64::from(DIRECTIONS);
                let (x, y) = (libm::cos(angle), libm::sin(angle));
                // To the right and above rather than below, all else being equal.
                let cost = 1.5 * rank as f64 + 2.0 - x - y;
                if best.as_ref().is_some_and(|(least, _)| *least <= cost) {
                    continue;
                }
                let free = label.reach + distance;
                let center = [anchor[0] + x * (free + half[0]), anchor[1] - y * (free + half[1])];
                let area = Area { center, half };
                let lead = (distance > LED).then(|| lead(&area, *anchor, label.reach)).flatten();
                if self.is_free(&area, near) && lead.is_none_or(|line| self.is_clear(line)) {
                    best = Some((cost, Found { area, lead }));
                }
            }
        }
        best.map(|(_, found)| found)
    }

    fn is_free(&self, area: &Area, near: &[&Trace]) -> bool {
        let is_inside =
            (0..2).all(|k| area.center[k] > area.half[k] && area.center[k] < self.edge[k] - area.half[k]);
        let covers = self.taken.iter().any(|other| area.overlaps(other))
            || self.is_strict && self.leads.iter().any(|line| area.is_crossed(line))
            || near.iter().any(|trace| area.is_crossed(trace));
        is_inside && !covers
    }

    /// Whether a line to a name crosses no other.
    fn is_clear(&self, line: [Spot; 2]) -> bool {
        !(self.is_strict && self.taken.iter().any(|area| area.is_crossed(&Trace::Line(line, 0.3))))
    }
}

fn is_near(trace: &Trace, anchors: &[Spot], far: f64) -> bool {
    anchors.iter().any(|anchor| match trace {
        Trace::Line([a, b], _) => away(*a, *anchor).min(away(*b, *anchor)) < far + away(*a, *b),
        Trace::Circle { center, radius, .. } => away(*center, *anchor) < far + radius,
    })
}

/// From a name to what it names.
fn lead(area: &Area, anchor: Spot, reach: f64) -> Option<[Spot; 2]> {
    let from = area.nearest(anchor);
    let e = heading(anchor, from)?;
    Some([from, shifted(anchor, reach.min(0.6 * away(anchor, from)), e)])
}

fn line(svg: &mut String, ends: [Spot; 2]) {
    let [from, to] = ends.map(|[x, y]| format!("{} {}", number(x), number(y)));
    let _ = writeln!(
        svg,
        "<path class=\"lead\" d=\"M{from}L{to}\" stroke=\"currentColor\" stroke-width=\"0.6\" opacity=\"0.6\"/>"
    );
}

fn text(svg: &mut String, label: &Label, area: &Area, size: f64) {
    let style = match label.kind {
        Kind::Body => "fill=\"currentColor\" font-weight=\"600\"".to_string(),
        Kind::Joint => "fill=\"currentColor\" font-style=\"italic\"".to_string(),
        Kind::Coupling => "fill=\"currentColor\"".to_string(),
        Kind::Load => format!("fill=\"{ACCENT}\""),
    };
    let size_of = if size == 12.0 { String::new() } else { format!(" font-size=\"{}\"", number(size)) };
    let [x, y] = area.center;
    let _ = writeln!(
        svg,
        "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\"{size_of} {style} stroke=\"{PAPER}\" stroke-width=\"3\" \
         paint-order=\"stroke\">{}</text>",
        number(x),
        number(y + 0.28 * size),
        escaped(&label.text)
    );
}
