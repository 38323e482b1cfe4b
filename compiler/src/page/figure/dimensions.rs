//! Dimensions as in engineering drawings: a line with heads beside what it measures, thin lines that lead to its ends, and the name
//! and value on the line or beside it. They cover no parts, and names make way for them; what finds no place is told.

use super::JOINTS;
use super::labels::width;
use super::room::Area;
use crate::drawing::canvas::{Group, PAPER, Pen, Trace, escaped, number};
use crate::drawing::shapes::{away, heading, middle, shifted};
use crate::drawing::view::{Spot, View};
use crate::page::dimensions::Dimension;
use std::fmt::Write;

/// From what is measured to the line, px.
const DISTANCES: [f64; 12] = [16.0, 22.0, 29.0, 37.0, 46.0, 57.0, 70.0, 86.0, 105.0, 130.0, 160.0, 200.0];
/// Where the text may stand along the line, the best first.
const SHARES: [f64; 5] = [0.5, 0.4, 0.6, 0.3, 0.7];
/// Length and half width of a head; room for two of them and what is between; the line outside where there is less.
const HEAD: [f64; 2] = [7.0, 2.2];
const LEAST: f64 = 24.0;
const OUTSIDE: f64 = 16.0;
/// Below this what is measured is not seen.
const SEEN: f64 = 4.0;
/// Widths of lines.
const LINE: f64 = 0.8;
const THIN: f64 = 0.5;
/// From the text to its line; from the edge of the picture.
const GAP: f64 = 3.0;
const EDGE: f64 = 3.0;
/// What a thin line over a part is worth, in px of distance; and a place among the parts instead of beside them all.
const CROSSING: f64 = 30.0;
const INSIDE: f64 = 12.0;

/// Around what is drawn, for the texts beside it, px.
pub fn room(dimensions: &[Dimension]) -> f64 {
    let widths = dimensions.iter().map(|dimension| 12.0 * width(&dimension.text, false));
    let widest = widths.fold(0.0, f64::max);
    if dimensions.is_empty() { 0.0 } else { (widest - 28.0).clamp(40.0, 90.0) }
}

/// What is on the sheet already.
pub struct Sheet<'a> {
    view: &'a View,
    unit: f64,
    /// Letters, px.
    size: f64,
    pub texts: Vec<Area>,
    drawn: &'a [Trace],
    /// Of dimensions, with their heads.
    pub lines: Vec<Trace>,
    /// Of dimensions, those that lead to their ends.
    pub thin: Vec<Trace>,
}

/// A place for a dimension.
struct Found {
    /// From tail to head.
    lines: Vec<[Spot; 2]>,
    thin: [[Spot; 2]; 2],
    text: Area,
}

impl<'a> Sheet<'a> {
    pub fn new(view: &'a View, unit: f64, size: f64, texts: Vec<Area>, drawn: &'a [Trace]) -> Self {
        Sheet { view, unit, size, texts, drawn, lines: Vec::new(), thin: Vec::new() }
    }

    /// Writes those that find a place; gives the others.
    pub fn write<'d>(&mut self, svg: &mut String, dimensions: &'d [Dimension]) -> Vec<&'d Dimension> {
        let mut left = Vec::new();
        for dimension in dimensions {
            let Some(found) = self.place(dimension) else {
                left.push(dimension);
                continue;
            };
            let Dimension { of, text, .. } = dimension;
            let mut leading = Group::new(JOINTS, 0.0, format!("to the dimension {text} of {of}"));
            found.thin.iter().for_each(|[a, b]| leading.line(*a, *b, Pen::Line(THIN)));
            leading.write(svg);
            let mut group = Group::new(JOINTS, 0.0, format!("dimension {text} of {of}"));
            found.lines.iter().for_each(|[tail, head]| arrow(&mut group, *tail, *head));
            group.write(svg);
            let [x, y] = found.text.center;
            let size_of = if self.size == 12.0 {
                String::new()
            } else {
                format!(" font-size=\"{}\"", number(self.size))
            };
            let _ = writeln!(
                svg,
                "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\"{size_of} fill=\"currentColor\" stroke=\"{PAPER}\" \
                 stroke-width=\"3\" paint-order=\"stroke\">{}</text>",
                number(x),
                number(y + 0.28 * self.size),
                escaped(text)
            );
            self.texts.push(found.text);
            self.lines.extend(group.traces());
            self.thin.extend(leading.traces());
        }
        left
    }

    fn place(&self, dimension: &Dimension) -> Option<Found> {
        let [a, b] = dimension.ends.map(|end| self.view.spot(end));
        let along = heading(a, b).filter(|_| away(a, b) >= SEEN)?;
        let half = [width(&dimension.text, false) * self.size / 2.0 + 1.0, self.size / 2.0 + 0.5];
        let mut best: Option<(f64, Found)> = None;
        for distance in DISTANCES {
            if best.as_ref().is_some_and(|(cost, _)| *cost <= distance) {
                break;
            }
            for sign in [1.0, -1.0] {
                let aside = [sign * along[1], -sign * along[0]];
                let Some((cost, found)) = self.beside([a, b], along, aside, distance, half) else { continue };
                if best.as_ref().is_none_or(|(least, _)| cost < *least) {
                    best = Some((cost, found));
                }
            }
        }
        best.map(|(_, found)| found)
    }

    /// The best place of the text for a line so far away, with its cost.
    fn beside(
        &self,
        [a, b]: [Spot; 2],
        along: Spot,
        aside: Spot,
        distance: f64,
        half: [f64; 2],
    ) -> Option<(f64, Found)> {
        let [p, q] = [a, b].map(|end| shifted(end, distance, aside));
        let from = (2.5 * self.unit + 1.0).min(distance - 6.0);
        let thin = [(a, p), (b, q)].map(|(end, line)| [shifted(end, from, aside), shifted(line, 3.0, aside)]);
        let covers = |line: &[Spot; 2]| {
            let trace = Trace::Line(*line, THIN / 2.0);
            !self.is_inside(*line)
                || self.texts.iter().any(|text| text.is_crossed(&trace))
                || self.lines.iter().any(|other| meets(&trace, other))
        };
        if thin.iter().any(covers) {
            return None;
        }
        let crossed = |line: &[Spot; 2]| {
            let trace = Trace::Line(*line, THIN / 2.0);
            self.drawn.iter().any(|part| meets(&trace, part))
        };
        let center = [self.view.width / 2.0, self.view.height / 2.0];
        let is_inside = (0..2).map(|k| (center[k] - middle(a, b)[k]) * aside[k]).sum::<f64>() > 0.0;
        let inside = if is_inside { INSIDE } else { 0.0 };
        let cost = distance + inside + CROSSING * thin.iter().filter(|line| crossed(line)).count() as f64;
        let found =
            texts(p, q, along, aside, half).find_map(|(text, lines)| {
                (self.is_free(&text, &thin) && lines.iter().all(|line| self.is_clear(line)))
                    .then_some(Found { lines, thin, text })
            })?;
        Some((cost, found))
    }

    fn is_inside(&self, ends: [Spot; 2]) -> bool {
        let edge = [self.view.width, self.view.height];
        ends.iter().all(|at| (0..2).all(|k| at[k] > EDGE && at[k] < edge[k] - EDGE))
    }

    /// Whether nothing that is drawn is under the text.
    fn is_free(&self, text: &Area, own: &[[Spot; 2]; 2]) -> bool {
        let corners = [-1.0, 1.0].map(|sign| [0, 1].map(|k| text.center[k] + sign * text.half[k]));
        let lines = self.drawn.iter().chain(&self.lines).chain(&self.thin);
        self.is_inside(corners)
            && !self.texts.iter().any(|other| text.overlaps(other))
            && !lines.into_iter().any(|line| text.is_crossed(line))
            && !own.iter().any(|line| text.is_crossed(&Trace::Line(*line, THIN / 2.0)))
    }

    /// Whether a line with its head crosses neither texts nor parts nor other lines.
    fn is_clear(&self, line: &[Spot; 2]) -> bool {
        let trace = Trace::Line(*line, HEAD[1]);
        let lines = self.drawn.iter().chain(&self.lines).chain(&self.thin);
        self.is_inside(*line)
            && !self.texts.iter().any(|text| text.is_crossed(&trace))
            && !lines.into_iter().any(|other| meets(&trace, other))
    }
}

/// Places of the text, with the lines that then lead to the ends: on the line, which it interrupts, or beside it.
fn texts(
    p: Spot,
    q: Spot,
    along: Spot,
    aside: Spot,
    half: [f64; 2],
) -> impl Iterator<Item = (Area, Vec<[Spot; 2]>)> {
    let length = away(p, q);
    // So much of the line is under a text on it.
    let under = (0..2).map(|k| half[k] / along[k].abs().max(1e-9)).fold(f64::INFINITY, f64::min) + GAP;
    let on = SHARES.into_iter().filter_map(move |share| {
        let rest = [share * length - under, (1.0 - share) * length - under];
        let center = shifted(p, share * length, along);
        let lines = vec![[shifted(center, -under, along), p], [shifted(center, under, along), q]];
        (rest.iter().all(|rest| *rest > LEAST / 2.0)).then_some((Area { center, half }, lines))
    });
    let lines = if length >= LEAST {
        let center = middle(p, q);
        vec![[center, p], [center, q]]
    } else {
        vec![[shifted(p, -OUTSIDE, along), p], [shifted(q, OUTSIDE, along), q]]
    };
    let reach = half[0] * aside[0].abs() + half[1] * aside[1].abs() + GAP + HEAD[1];
    let beside = SHARES.into_iter().map(move |share| {
        let center = shifted(shifted(p, share * length, along), reach, aside);
        (Area { center, half }, lines.clone())
    });
    on.chain(beside)
}

/// A line with a head at its end.
fn arrow(group: &mut Group, tail: Spot, head: Spot) {
    let Some(e) = heading(tail, head) else { return };
    let back = shifted(head, -HEAD[0], e);
    group.line(tail, back, Pen::Line(LINE));
    let across = [-e[1], e[0]];
    group.path(&[head, shifted(back, HEAD[1], across), shifted(back, -HEAD[1], across)], true, Pen::Solid);
}

/// Whether a line comes nearer to what is drawn than their widths.
fn meets(line: &Trace, other: &Trace) -> bool {
    let Trace::Line(ends, half) = line else { return false };
    match other {
        Trace::Line(others, width) => between(*ends, *others) < half + width + 0.5,
        Trace::Circle { center, radius, half: width, is_full } => {
            let nearest = from_line(*center, *ends);
            let farthest = ends.iter().map(|end| away(*center, *end)).fold(0.0, f64::max);
            let around = half + width + 0.5;
            nearest < radius + around && (*is_full || farthest > radius - around)
        }
    }
}

/// The distance of two lines, 0 where they cross.
fn between(a: [Spot; 2], b: [Spot; 2]) -> f64 {
    let side = |[p, q]: [Spot; 2], at: Spot| (q[0] - p[0]) * (at[1] - p[1]) - (q[1] - p[1]) * (at[0] - p[0]);
    let parts = |one: [Spot; 2], other: [Spot; 2]| side(one, other[0]) * side(one, other[1]) < 0.0;
    if parts(a, b) && parts(b, a) {
        return 0.0;
    }
    let ends = a.map(|end| from_line(end, b)).into_iter().chain(b.map(|end| from_line(end, a)));
    ends.fold(f64::INFINITY, f64::min)
}

fn from_line(at: Spot, [a, b]: [Spot; 2]) -> f64 {
    let way = [b[0] - a[0], b[1] - a[1]];
    let size = way[0] * way[0] + way[1] * way[1];
    let share = ((at[0] - a[0]) * way[0] + (at[1] - a[1]) * way[1]) / size.max(1e-12);
    away(at, shifted(a, share.clamp(0.0, 1.0), way))
}

/// The sentences below the picture of what found no place, in lines of this width, with the height that they take.
pub fn told(left: &[&Dimension], sheet: f64, height: f64) -> (String, f64) {
    const SIZE: f64 = 11.0;
    if left.is_empty() {
        return (String::new(), 0.0);
    }
    let mut lines: Vec<String> = Vec::new();
    let pieces = left.iter().map(|Dimension { of, text, .. }| format!("{text} ({of})"));
    for (index, piece) in pieces.enumerate() {
        let piece = if index + 1 < left.len() { format!("{piece},") } else { piece };
        match lines.last_mut() {
            Some(line) if width(&format!("{line} {piece}"), false) * SIZE < sheet - 2.0 * EDGE => {
                let _ = write!(line, " {piece}");
            }
            Some(_) => lines.push(piece),
            None => lines.push(format!("without a place: {piece}")),
        }
    }
    let mut svg = String::new();
    for (index, line) in lines.iter().enumerate() {
        let _ = writeln!(
            svg,
            "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\" fill=\"currentColor\" font-size=\"{SIZE}\">{}</text>",
            number(sheet / 2.0),
            number(height + 14.0 * (index as f64 + 1.0)),
            escaped(line)
        );
    }
    (svg, 14.0 * lines.len() as f64 + 8.0)
}
