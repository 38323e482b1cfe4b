//! Plane and solid shapes as outlines in the picture: hulls, rings, cylinders, boxes, bars, hatching.

use super::canvas::{Group, Pen};
use super::vector::{Point, along, cross, dot, unit};
use super::view::{Spot, View};

/// Width of thin lines, px.
pub const THIN: f64 = 1.2;

pub fn away(from: Spot, to: Spot) -> f64 {
    let (x, y) = (to[0] - from[0], to[1] - from[1]);
    libm::sqrt(x * x + y * y)
}

/// a + k b.
pub fn shifted(a: Spot, k: f64, b: Spot) -> Spot {
    [a[0] + k * b[0], a[1] + k * b[1]]
}

pub fn middle(a: Spot, b: Spot) -> Spot {
    [(a[0] + b[0]) / 2.0, (a[1] + b[1]) / 2.0]
}

/// From one spot to another, of length one; `None` where they meet.
pub fn heading(from: Spot, to: Spot) -> Option<Spot> {
    let size = away(from, to);
    (size > 1e-6).then(|| [(to[0] - from[0]) / size, (to[1] - from[1]) / size])
}

/// The corners of the convex hull in order (Andrew's monotone chain).
pub fn hull(points: &[Spot]) -> Vec<Spot> {
    let mut sorted = points.to_vec();
    sorted.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    sorted.dedup_by(|a, b| away(*a, *b) < 1e-6);
    let turn = |a: Spot, b: Spot, c: Spot| (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    let half = |points: &mut dyn Iterator<Item = Spot>| {
        let mut chain: Vec<Spot> = Vec::new();
        for point in points {
            while chain.len() >= 2 && turn(chain[chain.len() - 2], chain[chain.len() - 1], point) <= 1e-9 {
                chain.pop();
            }
            chain.push(point);
        }
        chain.pop();
        chain
    };
    let mut lower = half(&mut sorted.iter().copied());
    let upper = half(&mut sorted.iter().rev().copied());
    lower.extend(upper);
    if lower.is_empty() { sorted } else { lower }
}

/// Two directions across an axis and each other.
pub fn across(axis: Point) -> [Point; 2] {
    let least = (1..3).fold(0, |best, k| if axis[k].abs() < axis[best].abs() { k } else { best });
    let mut helper = [0.0; 3];
    helper[least] = 1.0;
    let u = unit(cross(axis, helper));
    [u, unit(cross(axis, u))]
}

/// A circle about an axis, its radius in px, from one angle to another.
pub fn ring(view: &View, center: Point, axis: Point, radius: f64, from: f64, to: f64) -> Vec<Spot> {
    let [u, v] = across(axis);
    let size = radius / view.scale;
    let at = |angle: f64| {
        let (sin, cos) = (libm::sin(angle), libm::cos(angle));
        view.spot(along(along(center, size * cos, u), size * sin, v))
    };
    // Corners that the eye does not see.
    let steps = (2 * radius as u32).clamp(24, 96);
    (0..=steps).map(|k| at(from + (to - from) * f64::from(k) / f64::from(steps))).collect()
}

pub fn circle(view: &View, center: Point, axis: Point, radius: f64) -> Vec<Spot> {
    let mut points = ring(view, center, axis, radius, 0.0, std::f64::consts::TAU);
    points.pop();
    points
}

/// A solid cylinder: its silhouette, and the end that is seen.
pub fn cylinder(group: &mut Group, view: &View, center: Point, axis: Point, radius: f64, half: f64) {
    let towards = if dot(axis, view.toward) < 0.0 { axis.map(|x| -x) } else { axis };
    let end = |k: f64| circle(view, along(center, k * half / view.scale, towards), towards, radius);
    let (near, far) = (end(1.0), end(-1.0));
    group.path(&hull(&[near.clone(), far].concat()), true, Pen::Outline(THIN));
    group.path(&near, true, Pen::Outline(THIN));
}

/// A solid box with half edges along three directions, in the world: its silhouette, and the edges of its nearest corner.
pub fn block(group: &mut Group, view: &View, center: Point, halves: [Point; 3], pen: Pen) {
    let corner = |signs: [f64; 3]| (0..3).fold(center, |at, k| along(at, signs[k], halves[k]));
    let sign = |bit: usize| if bit == 0 { -1.0 } else { 1.0 };
    let corners: Vec<Spot> =
        (0..8).map(|k| view.spot(corner([sign(k & 1), sign(k & 2), sign(k & 4)]))).collect();
    let outline = hull(&corners);
    group.path(&outline, true, pen);
    group.path(&outline, true, Pen::Tint(0.0));
    let nearest = halves.map(|half| if dot(half, view.toward) < 0.0 { -1.0 } else { 1.0 });
    for k in 0..3 {
        // Where a face is seen edge on there is nothing to tell apart.
        if dot(unit(halves[k]), view.toward).abs() > 1e-3 {
            let mut other = nearest;
            other[k] = -other[k];
            group.line(view.spot(corner(nearest)), view.spot(corner(other)), Pen::Line(0.8));
        }
    }
}

/// A rectangle along a direction of the picture.
pub fn rectangle(center: Spot, e: Spot, half: f64, aside: f64) -> Vec<Spot> {
    let n = [-e[1], e[0]];
    let corner = |a: f64, b: f64| shifted(shifted(center, a * half, e), b * aside, n);
    vec![corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)]
}

/// A bar with round ends, or a plate with round corners.
pub fn plate(group: &mut Group, corners: &[Spot], half: f64) {
    if corners.len() < 3 {
        return bar(group, corners, half);
    }
    group.path(corners, true, Pen::Line(2.0 * half + THIN));
    group.path(corners, true, Pen::Blank(2.0 * half - THIN));
    group.path(corners, true, Pen::Tint(2.0 * half - THIN));
}

/// A bar with round ends, along any path.
pub fn bar(group: &mut Group, path: &[Spot], half: f64) {
    group.path(path, false, Pen::Line(2.0 * half + THIN));
    group.path(path, false, Pen::Erase(2.0 * half - THIN));
}

/// A line with short strokes on the side of the ground.
pub fn ground_line(group: &mut Group, a: Spot, b: Spot, into: Spot, unit: f64) {
    group.line(a, b, Pen::Line(1.4));
    let Some(e) = heading(a, b) else { return };
    let (size, step) = (away(a, b), (1.5 * unit).max(2.5));
    let count = (size / step).floor().max(1.0) as usize;
    let rest = (size - step * count as f64) / 2.0;
    for k in 0..=count {
        let foot = shifted(a, rest + step * k as f64, e);
        let end = shifted(shifted(foot, 0.9 * step, into), -0.7 * step, e);
        group.line(foot, end, Pen::Line(0.8));
    }
}
