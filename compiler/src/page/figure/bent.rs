//! What deforms: bars along its lines as they are bent, and behind them the axes of its frame and the straight lines.

use super::labels::Kind;
use super::{BODIES, Drawing, SHAPES, parts};
use crate::drawing::canvas::{Group, Pen};
use crate::drawing::shapes;
use crate::drawing::vector::along;
use crate::drawing::view::Spot;
use crate::page::sketch::Part;

/// Length of the axes of the frame, px, and how much of a body's at most.
const AXES: f64 = 24.0;
const SHARE: f64 = 0.2;

pub fn bent(drawing: &mut Drawing, part: &Part) {
    let view = &drawing.view;
    let half = 0.9 * drawing.unit;
    if let Some(straight) = &part.straight {
        let mut frame = Group::new(SHAPES, 0.0, format!("frame of {}", part.name));
        for ends in straight {
            let [from, to] = ends.map(|end| view.spot(end));
            frame.line(from, to, Pen::Broken(0.8));
        }
        let size = AXES.min(SHARE * parts::size(view.scale, part)) / view.scale;
        let origin = view.spot(part.center);
        for axis in &part.axes[..2] {
            frame.arrow(origin, view.spot(along(part.center, size, *axis)), Pen::Line(1.0), Pen::Solid);
        }
        drawing.add(frame);
    }
    let view = &drawing.view;
    let mut bar = Group::new(BODIES, 0.0, part.name.clone());
    let mut curve: Vec<Spot> = Vec::new();
    for line in &part.lines {
        let spots: Vec<Spot> = line.iter().map(|at| view.spot(*at)).collect();
        let ends: Vec<Spot> = [spots.first(), spots.last()].into_iter().flatten().copied().collect();
        shapes::bar(&mut bar, if part.straight.is_some() { &spots } else { &ends }, half);
        curve.extend(spots);
    }
    drawing.add(bar);
    let at = |share: f64| curve[(share * (curve.len() - 1) as f64).round() as usize];
    drawing.label(&part.name, [0.5, 0.38, 0.62, 0.26, 0.74].map(at).to_vec(), half + 2.0, Kind::Body);
}
