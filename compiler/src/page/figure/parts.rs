//! Bodies: the shape that was declared, and bars and plates between the places where something acts on them.

use super::labels::Kind;
use super::{BODIES, Drawing, SHAPES, bent};
use crate::drawing::canvas::{Group, Pen};
use crate::drawing::shapes::{THIN, away, block, circle, heading, hull, plate, rectangle, shifted};
use crate::drawing::vector::{Point, along, difference, dot, length};
use crate::drawing::view::Spot;
use crate::forms::Outline;
use crate::model::Space;
use crate::page::sketch::Part;

pub fn part(drawing: &mut Drawing, part: &Part) {
    if !part.lines.is_empty() {
        return bent::bent(drawing, part);
    }
    let view = &drawing.view;
    let center = view.spot(part.center);
    let spots: Vec<Spot> = part.spots.iter().map(|spot| view.spot(*spot)).collect();
    let mut group = Group::new(BODIES, nearness(drawing, part), part.name.clone());
    let shape = shape(drawing, &mut group, part);
    let corners = skeleton(center, &spots, shape.as_ref().map(|shape| shape.reach), drawing.unit);
    if view.space == Space::Planar && shape.is_some() {
        // Wheels and plates behind arms.
        let arms = Group::new(BODIES, 0.0, part.name.clone());
        let mut back = std::mem::replace(&mut group, arms);
        back.layer = SHAPES;
        back.nearness =
            -extent(part).iter().map(|point| length(difference(*point, part.center))).fold(0.0, f64::max);
        drawing.add(back);
    }
    let half = 0.9 * drawing.unit;
    let is_bare = part.joints < 2 || spots.is_empty();
    if corners.len() >= 2 && (is_bare || spots.len() > 1) {
        plate(&mut group, &corners, half);
    } else if shape.is_none() && !part.is_block && is_bare {
        mass(&mut group, center, drawing.unit, part.form.turns);
    }
    if let (1, [_], [_, end]) = (part.joints, &spots[..], &corners[..]) {
        group.circle(*end, 1.3 * drawing.unit, Pen::Solid);
    }
    drawing.add(group);
    let (anchors, reach) = match (&corners[..], &shape) {
        ([a, b], _) => {
            ([0.5, 0.38, 0.62, 0.26, 0.74].map(|share| between(*a, *b, share)).to_vec(), half + 2.0)
        }
        (corners @ [_, _, _, ..], _) => {
            let mean = mean(corners);
            let towards = corners.iter().map(|corner| between(mean, *corner, 0.4));
            (std::iter::once(mean).chain(towards).collect(), 0.0)
        }
        // On its face, or around it.
        (_, Some(shape)) => {
            let towards =
                |turn: f64| [0.5 * shape.size * libm::cos(turn), 0.5 * shape.size * libm::sin(turn)];
            let inside = (0..8).map(|k| shifted(center, 1.0, towards(0.4 + f64::from(k) * 0.785)));
            (std::iter::once(center).chain(inside).collect(), 0.0)
        }
        _ => (vec![center], 2.0 * drawing.unit),
    };
    drawing.label(&part.name, anchors, reach, Kind::Body);
}

fn nearness(drawing: &Drawing, part: &Part) -> f64 {
    let count = part.spots.len();
    if count == 0 {
        return drawing.view.nearness(part.center);
    }
    part.spots.iter().map(|spot| drawing.view.nearness(*spot)).sum::<f64>() / count as f64
}

fn between(a: Spot, b: Spot, share: f64) -> Spot {
    [0, 1].map(|k| a[k] + share * (b[k] - a[k]))
}

fn mean(spots: &[Spot]) -> Spot {
    let count = spots.len().max(1) as f64;
    [0, 1].map(|k| spots.iter().map(|spot| spot[k]).sum::<f64>() / count)
}

/// What was drawn of a declared shape.
struct Drawn {
    /// From the centre to the farthest of its outline, px.
    size: f64,
    /// Spots within this distance from the centre, px, touch it.
    reach: f64,
}

/// The shape, where it is one that a bar does not show.
fn shape(drawing: &Drawing, group: &mut Group, part: &Part) -> Option<Drawn> {
    let view = &drawing.view;
    let [x, y, z] = part.axes;
    let outline = match (part.form.outline, view.space, &part.lengths[..]) {
        (Outline::Disk | Outline::Ball, _, [radius, ..]) => {
            let axis = if part.form.outline == Outline::Ball { view.toward } else { z };
            let outline = circle(view, part.center, axis, radius * view.scale);
            group.path(&outline, true, Pen::Outline(THIN));
            group.path(&outline, true, Pen::Tint(0.0));
            if part.form.outline == Outline::Disk {
                // A line that shows how it has turned.
                group.line(view.spot(part.center), view.spot(along(part.center, *radius, x)), Pen::Line(0.8));
            }
            outline
        }
        (Outline::Box, Space::Planar, [width, height, ..]) => {
            let e = heading([0.0; 2], view.way(x))?;
            let half = view.scale / 2.0;
            let outline = rectangle(view.spot(part.center), e, half * width, half * height);
            group.path(&outline, true, Pen::Outline(THIN));
            group.path(&outline, true, Pen::Tint(0.0));
            outline
        }
        (Outline::Box, Space::Spatial, [a, b, c]) => {
            let halves = [scaled(a / 2.0, x), scaled(b / 2.0, y), scaled(c / 2.0, z)];
            block(group, view, part.center, halves, Pen::Outline(THIN));
            let corners = corners(part.center, halves);
            hull(&corners.map(|corner| view.spot(corner)))
        }
        _ => return None,
    };
    let center = view.spot(part.center);
    let farthest = outline.iter().map(|spot| away(center, *spot)).fold(0.0, f64::max);
    let is_inside = |spot: &Point| touches(part, *spot);
    let reach = if part.spots.iter().all(is_inside) { f64::INFINITY } else { farthest };
    Some(Drawn { size: farthest, reach })
}

fn scaled(k: f64, a: Point) -> Point {
    a.map(|x| k * x)
}

fn corners(center: Point, [a, b, c]: [Point; 3]) -> [Point; 8] {
    let sign = |bit: usize| if bit == 0 { -1.0 } else { 1.0 };
    std::array::from_fn(|k| {
        let at = along(along(center, sign(k & 1), a), sign(k & 2), b);
        along(at, sign(k & 4), c)
    })
}

/// Whether a spot lies in the shape or on it.
fn touches(part: &Part, spot: Point) -> bool {
    let local = part.axes.map(|axis| dot(axis, difference(spot, part.center)));
    let within = |halves: &[f64]| {
        let largest = halves.iter().copied().fold(0.0, f64::max);
        local.iter().zip(halves).all(|(x, half)| x.abs() <= half * 0.5 + 1e-6 * largest)
    };
    match (part.form.outline, &part.lengths[..]) {
        (Outline::Disk | Outline::Ball, [radius, ..]) => dot(local, local).sqrt() <= radius * (1.0 + 1e-6),
        (Outline::Box, lengths) => within(lengths),
        _ => false,
    }
}

/// The points that are all that a picture has to show of a body besides its joints.
pub fn extent(part: &Part) -> Vec<Point> {
    let mut points = part.spots.clone();
    points.push(part.center);
    let [x, y, z] = part.axes;
    match (part.form.outline, &part.lengths[..]) {
        (Outline::Disk | Outline::Ball, [radius, ..]) => {
            points.extend(
                [x, y, z].iter().flat_map(|axis| [-1.0, 1.0].map(|k| along(part.center, k * radius, *axis))),
            );
        }
        (Outline::Box, [a, b]) => {
            points.extend(corners(part.center, [scaled(a / 2.0, x), scaled(b / 2.0, y), [0.0; 3]]))
        }
        (Outline::Box, [a, b, c]) => {
            points.extend(corners(part.center, [scaled(a / 2.0, x), scaled(b / 2.0, y), scaled(c / 2.0, z)]));
        }
        _ => {}
    }
    points
}

/// The ends of a bar or the corners of a plate; fewer than two where there is nothing between the spots.
fn skeleton(center: Spot, spots: &[Spot], shape: Option<f64>, unit: f64) -> Vec<Spot> {
    if let Some(reach) = shape {
        // Arms to what lies outside of the shape.
        let outside = spots.iter().filter(|spot| away(center, **spot) > reach);
        return outside.take(1).flat_map(|spot| [*spot, center]).collect();
    }
    if let [only] = spots {
        return if away(*only, center) > 2.0 * unit { vec![*only, center] } else { Vec::new() };
    }
    let corners = hull(spots);
    let Some((a, b)) = farthest(&corners) else { return Vec::new() };
    if away(a, b) < unit {
        return Vec::new();
    }
    let Some(e) = heading(a, b) else { return Vec::new() };
    let aside = |spot: &Spot| ((spot[0] - a[0]) * e[1] - (spot[1] - a[1]) * e[0]).abs();
    if corners.iter().all(|corner| aside(corner) < 1.5 * unit) { vec![a, b] } else { corners }
}

fn farthest(spots: &[Spot]) -> Option<(Spot, Spot)> {
    let mut best: Option<(f64, (Spot, Spot))> = None;
    for (index, a) in spots.iter().enumerate() {
        for b in &spots[index + 1..] {
            if best.is_none_or(|(size, _)| away(*a, *b) > size + 1e-9) {
                best = Some((away(*a, *b), (*a, *b)));
            }
        }
    }
    best.map(|(_, pair)| pair)
}

/// A body without extent.
fn mass(group: &mut Group, center: Spot, unit: f64, turns: bool) {
    if !turns {
        group.circle(center, 1.5 * unit, Pen::Solid);
    } else {
        let outline = rectangle(center, [1.0, 0.0], 2.2 * unit, 2.2 * unit);
        group.path(&outline, true, Pen::Outline(THIN));
        group.path(&outline, true, Pen::Tint(0.0));
    }
}

/// Length of a body in the picture, px.
pub fn size(drawing_scale: f64, part: &Part) -> f64 {
    let spots = &part.spots;
    let longest = spots.iter().flat_map(|a| spots.iter().map(|b| difference(*a, *b)));
    drawing_scale * longest.map(|way| dot(way, way).sqrt()).fold(0.0, f64::max)
}
