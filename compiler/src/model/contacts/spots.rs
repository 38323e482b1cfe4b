//! Where surfaces touch, and their normal there: asked for by friction, and where something names the point or the sliding.
//!
//! The point is halfway between both surfaces, the normal of unit length from the second of a pair to the first, along the axes of the world.

use super::pairs::{
    Beside, Edge, Meeting, Nearest, Tilt, about, coordinate, direction, edges, profile, root, square,
    squares, unit,
};
use super::surfaces::Shape;
use super::{difference, least, most, product, quotient, sum};
use crate::model::{Comparison, Condition, Coordinate, Expr, Function1, Place, Space, Spot, Vector, fold};

/// Two surfaces in the order in which their gap has a closed form.
pub struct Pair {
    pub shapes: [Shape; 2],
    /// Whether they are written the other way round.
    pub reversed: bool,
}

impl Pair {
    /// Where each gap of the pair closes.
    pub fn spots(&self, meetings: &[Meeting], space: Space) -> Option<Vec<Spot>> {
        let [first, second] = &self.shapes;
        let spot = |(which, meeting): (usize, &Meeting)| {
            let Touch { point, normal } = touch(first, second, which, &meeting.gap, space.dimensions())?;
            let mut places = [first.place().clone(), second.place().clone()];
            // The sliding in the plane is that along the normal turned by a right angle, which is the same for both orders.
            if self.reversed && space == Space::Spatial {
                places.swap(0, 1);
            }
            Some(Spot { places, point, normal })
        };
        meetings.iter().enumerate().map(spot).collect()
    }
}

struct Touch {
    point: Vec<Expr>,
    normal: Vec<Expr>,
}

fn touch(first: &Shape, second: &Shape, which: usize, gap: &Expr, axes: usize) -> Option<Touch> {
    Some(match (first, second) {
        (Shape::Round { place, radius }, Shape::Flat { place: foot, normal }) => {
            below(place, radius, gap, flat(foot, normal, axes))
        }
        (Shape::Bar { ends, radius }, Shape::Flat { place: foot, normal }) => {
            below(&ends[which], radius, gap, flat(foot, normal, axes))
        }
        (Shape::Polygon(corners), Shape::Flat { place: foot, normal }) => {
            below(&corners[which], &Expr::Number(0.0), gap, flat(foot, normal, axes))
        }
        (Shape::Round { place, .. }, Shape::Round { place: other, radius: r }) => {
            along(other, place, halfway(r, gap), axes, false)
        }
        (Shape::Round { place, .. }, Shape::Hollow { place: middle, radius: hole }) => {
            let far = difference(hole.clone(), product(Expr::Number(0.5), gap.clone()));
            along(middle, place, far, axes, true)
        }
        (Shape::Round { place, .. }, Shape::Bar { ends, radius: own }) => bar(place, ends, own, gap, axes),
        (Shape::Bar { ends, .. }, Shape::Bar { ends: others, radius: own }) => bars(ends, others, own, gap),
        (Shape::Round { place, radius }, Shape::Polygon(corners)) => {
            below(place, radius, gap, world(&corners[0], &polygon(place, corners)))
        }
        (Shape::Round { place, radius }, Shape::Profile { place: middle, curve, base }) => {
            let normal = [[1, 0], [0, 1]].map(|orders| profile(place, middle, curve, base, orders));
            below(place, radius, gap, world(middle, &normal))
        }
        (Shape::Round { place, radius }, Shape::Cylinder { place: middle, axis, radius: own, length }) => {
            let normal = cylinder(place, middle, axis, own, length.as_ref());
            below(place, radius, gap, world(middle, &normal))
        }
        (Shape::Round { place, radius }, Shape::Bore { place: middle, axis, .. }) => {
            let inwards = out_of(middle, axis, place).map(|part| fold::unary(Function1::Neg, part));
            below(place, radius, gap, world(middle, &inwards))
        }
        (Shape::Rim { place, axis, radius }, Shape::Flat { place: foot, normal }) => {
            rim(place, radius, gap, Tilt::of(place, axis, foot, normal))
        }
        _ => return None,
    })
}

fn flat(foot: &Place, normal: &Vector, axes: usize) -> Vec<Expr> {
    (0..axes).map(|axis| direction(foot, normal, axis)).collect()
}

/// Of a round surface, from its place against the normal.
fn below(place: &Place, radius: &Expr, gap: &Expr, normal: Vec<Expr>) -> Touch {
    let inward = halfway(radius, gap);
    let point = normal
        .iter()
        .enumerate()
        .map(|(axis, n)| difference(position(place, axis), product(n.clone(), inward.clone())));
    Touch { point: point.collect(), normal }
}

/// From one place so far towards another; the normal goes there, or comes from there.
fn along(from: &Place, to: &Place, far: Expr, axes: usize, back: bool) -> Touch {
    let distance = root(square(from, to));
    let share = quotient(far, distance.clone());
    let (mut point, mut normal) = (Vec::new(), Vec::new());
    for axis in 0..axes {
        let (a, b) = (position(from, axis), position(to, axis));
        let way = difference(b.clone(), a.clone());
        point.push(sum(a.clone(), product(share.clone(), way.clone())));
        normal.push(quotient(if back { difference(a, b) } else { way }, distance.clone()));
    }
    Touch { point, normal }
}

/// From the nearest point of a bar.
fn bar(place: &Place, ends: &[Place; 2], own: &Expr, gap: &Expr, axes: usize) -> Touch {
    let Beside { along, length, distance } = Beside::of(place, ends, axes);
    let out = quotient(halfway(own, gap), distance.clone());
    let share = quotient(along, length);
    let (mut point, mut normal) = (Vec::new(), Vec::new());
    for axis in 0..axes {
        let [a, b] = [&ends[0], &ends[1]].map(|end| position(end, axis));
        let foot = sum(a.clone(), product(share.clone(), difference(b, a)));
        let way = difference(position(place, axis), foot.clone());
        point.push(sum(foot, product(out.clone(), way.clone())));
        normal.push(quotient(way, distance.clone()));
    }
    Touch { point, normal }
}

/// From the nearest point of the second of two bars.
fn bars(first: &[Place; 2], second: &[Place; 2], own: &Expr, gap: &Expr) -> Touch {
    let Nearest { foot, way, distance } = Nearest::of(first, second);
    let out = quotient(halfway(own, gap), distance.clone());
    let point =
        foot.into_iter().zip(&way).map(|(foot, way)| sum(foot, product(out.clone(), way.clone()))).collect();
    Touch { point, normal: way.into_iter().map(|way| quotient(way, distance.clone())).collect() }
}

/// Along the axes of the first corner: of the edge that is least far inside, or away from what is nearest outside.
fn polygon(place: &Place, corners: &[Place]) -> [Expr; 2] {
    // What is nearest so far, and the way out of it.
    let mut inside: Option<(Expr, [Expr; 2])> = None;
    let mut outside: Option<(Expr, [Expr; 2])> = None;
    for Edge { tangent, normal, across, beyond, square } in edges(place, corners) {
        let from_nearest = [0, 1].map(|axis| {
            sum(product(across.clone(), normal[axis].clone()), product(beyond.clone(), tangent[axis].clone()))
        });
        inside = Some(match inside {
            Some((known, way)) => {
                let way = either(less(&known, &across), normal, way);
                (most(known, across), way)
            }
            None => (across, normal),
        });
        outside = Some(match outside {
            Some((known, way)) => {
                let way = either(less(&square, &known), from_nearest, way);
                (least(known, square), way)
            }
            None => (square, from_nearest),
        });
    }
    let nothing = || (Expr::Number(0.0), [Expr::Number(0.0), Expr::Number(0.0)]);
    let (inside, normal) = inside.unwrap_or_else(nothing);
    let (outside, way) = outside.unwrap_or_else(nothing);
    let distance = root(outside);
    either(less(&Expr::Number(0.0), &inside), way.map(|part| quotient(part, distance.clone())), normal)
}

/// Along the axes of the cylinder: of its side or an end, whichever is less far inside, or away from what is nearest outside.
fn cylinder(place: &Place, middle: &Place, axis: &Vector, own: &Expr, length: Option<&Expr>) -> [Expr; 3] {
    let out = out_of(middle, axis, place);
    let Some(length) = length else { return out };
    let (across, z) = about(middle, axis, place);
    let side = difference(across, own.clone());
    let end = difference(fold::unary(Function1::Abs, z.clone()), product(Expr::Number(0.5), length.clone()));
    let zero = || Expr::Number(0.0);
    let nearer = most(side.clone(), end.clone());
    let beyond = [most(side.clone(), zero()), most(end.clone(), zero())];
    let outside = root(squares(&beyond));
    let ahead = axis.clone().map(|part| product(fold::unary(Function1::Sign, z.clone()), part));
    let [beside, beyond] = beyond.map(|part| quotient(part, outside.clone()));
    let from_edge = [0, 1, 2]
        .map(|k| sum(product(beside.clone(), out[k].clone()), product(beyond.clone(), ahead[k].clone())));
    let within = either(less(&side, &end), ahead, out);
    either(less(&zero(), &nearer), from_edge, within)
}

/// Straight away from the axis of a cylinder, along its axes, of unit length.
fn out_of(middle: &Place, axis: &Vector, place: &Place) -> [Expr; 3] {
    let (across, z) = about(middle, axis, place);
    let ways = super::pairs::components(middle, place, 3);
    [0, 1, 2].map(|k| {
        let radial = difference(ways[k].clone(), product(z.clone(), axis[k].clone()));
        quotient(radial, across.clone())
    })
}

/// p − R (a − c k)/√(1 − c²), less half of the gap.
fn rim(place: &Place, radius: &Expr, gap: &Expr, tilt: Tilt) -> Touch {
    let Tilt { normal: a, axis: k, cosine, sine } = tilt;
    let lowest = (0..3).map(|axis| {
        let across = difference(a[axis].clone(), product(cosine.clone(), k[axis].clone()));
        let down = product(radius.clone(), quotient(across, sine.clone()));
        let half = product(a[axis].clone(), product(Expr::Number(0.5), gap.clone()));
        difference(difference(position(place, axis), down), half)
    });
    Touch { point: lowest.collect(), normal: a.to_vec() }
}

fn less(a: &Expr, b: &Expr) -> Condition {
    Condition::Compare(Comparison::Less, a.clone(), b.clone())
}

fn either<const N: usize>(condition: Condition, then: [Expr; N], otherwise: [Expr; N]) -> [Expr; N] {
    let mut otherwise = otherwise.into_iter();
    then.map(|then| {
        let other = otherwise.next().unwrap_or(Expr::Number(0.0));
        Expr::If(Box::new(condition.clone()), Box::new(then), Box::new(other))
    })
}

/// What stands along the axes of a place along those of the world.
fn world(place: &Place, local: &[Expr]) -> Vec<Expr> {
    let of = |axis: usize| {
        let parts =
            local.iter().enumerate().map(|(k, part)| product(part.clone(), direction(place, &unit(k), axis)));
        parts.reduce(sum).unwrap_or(Expr::Number(0.0))
    };
    (0..local.len()).map(of).collect()
}

/// From a surface of radius r outwards by half of the gap.
fn halfway(radius: &Expr, gap: &Expr) -> Expr {
    sum(radius.clone(), product(Expr::Number(0.5), gap.clone()))
}

fn position(place: &Place, axis: usize) -> Expr {
    coordinate(Coordinate::Position(Box::new(place.clone()), axis))
}
