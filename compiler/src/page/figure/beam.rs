//! A beam: a bar along its axis as it is bent, and behind it the axes of its frame and the straight axis.

use super::labels::Kind;
use super::{BODIES, Drawing, SHAPES};
use crate::drawing::canvas::{Group, Pen};
use crate::drawing::shapes;
use crate::drawing::vector::{along, difference, length};
use crate::drawing::view::Spot;
use crate::page::sketch::Part;

/// Length of the axes of the frame, px, and how much of a beam's at most.
const AXES: f64 = 24.0;
const SHARE: f64 = 0.2;

pub fn beam(drawing: &mut Drawing, part: &Part) {
    let view = &drawing.view;
    let curve: Vec<Spot> = part.axis.iter().map(|at| view.spot(*at)).collect();
    let [Some(first), Some(last)] = [curve.first(), curve.last()].map(|it| it.copied()) else { return };
    let half = 0.9 * drawing.unit;
    if let Some(straight) = part.straight {
        let [from, to] = straight.map(|end| view.spot(end));
        let mut frame = Group::new(SHAPES, 0.0, format!("frame of {}", part.name));
        frame.line(from, to, Pen::Broken(0.8));
        let size = (AXES / view.scale).min(SHARE * length(difference(straight[1], straight[0])));
        let origin = view.spot(part.center);
        for axis in &part.axes[..2] {
            frame.arrow(origin, view.spot(along(part.center, size, *axis)), Pen::Line(1.0), Pen::Solid);
        }
        drawing.add(frame);
    }
    let mut bar = Group::new(BODIES, 0.0, part.name.clone());
    let path = if part.straight.is_some() { curve.clone() } else { vec![first, last] };
    shapes::bar(&mut bar, &path, half);
    drawing.add(bar);
    let at = |share: f64| curve[(share * (curve.len() - 1) as f64).round() as usize];
    drawing.label(&part.name, [0.5, 0.38, 0.62, 0.26, 0.74].map(at).to_vec(), half + 2.0, Kind::Body);
}
