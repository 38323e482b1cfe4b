//! Drivers, and what couplings and equations hold to one another.

use super::labels::Kind;
use super::{Drawing, JOINTS, LOADS};
use crate::drawing::canvas::{Group, Pen};
use crate::drawing::load::angle_of_top;
use crate::drawing::shapes::{away, circle, heading, middle, ring, shifted};
use crate::drawing::vector::difference;
use crate::drawing::view::Spot;
use crate::page::sketch::{Drive, Driven, Link, Wheel};

/// Radius of an arc about a driven axis, and of a ring about axes that are one in the picture, units.
const ARC: f64 = 5.4;
const RING: f64 = 3.2;
/// Length of an arrow along a driven way, units.
const ARROW: f64 = 9.0;
const LINE: f64 = 1.4;

/// A gear by the point where its pitch circles touch; other links as a broken line from axis to axis, or a ring about one.
pub fn link(drawing: &mut Drawing, link: &Link, wheels: &[Wheel]) {
    let spots = distinct(link.ends.iter().map(|end| drawing.view.spot(*end)));
    let own = wheels.iter().find(|wheel| wheel.of == link.name);
    let (anchor, reach) = match (&spots[..], own) {
        ([], _) => return,
        (spots, Some(wheel)) => {
            let to = spots.iter().find(|spot| away(**spot, drawing.view.spot(wheel.center)) > 1.0);
            (touching(drawing, wheel, to), 2.0)
        }
        ([a, b, ..], None) if link.is_of_teeth => (middle(*a, *b), 2.0),
        ([spot], None) => {
            let radius = RING * drawing.unit;
            let mut group = Group::new(JOINTS, 0.0, link.name.clone());
            group.circle(*spot, radius, Pen::Broken(1.0));
            drawing.add(group);
            (*spot, radius + 2.0)
        }
        ([a, b, ..], None) => {
            let mut group = Group::new(JOINTS, -1.0, link.name.clone());
            group.path(&spots, false, Pen::Broken(1.0));
            drawing.add(group);
            (middle(*a, *b), 3.0)
        }
    };
    drawing.label(&link.name, vec![anchor], reach, Kind::Coupling);
}

/// Where a pitch circle is nearest to the other axis, or highest.
fn touching(drawing: &Drawing, wheel: &Wheel, other: Option<&Spot>) -> Spot {
    let rim = circle(&drawing.view, wheel.center, wheel.about, wheel.radius * drawing.view.scale);
    let measure = |spot: &Spot| other.map_or(spot[1], |other| away(*spot, *other));
    let best = rim.iter().copied().min_by(|a, b| measure(a).total_cmp(&measure(b)));
    best.unwrap_or_else(|| drawing.view.spot(wheel.center))
}

fn distinct(spots: impl Iterator<Item = Spot>) -> Vec<Spot> {
    spots.fold(Vec::new(), |mut found, spot| {
        if found.iter().all(|other| away(*other, spot) > 1.0) {
            found.push(spot);
        }
        found
    })
}

/// An arc with a head at each end about an axis, an arrow with two heads along a way, a broken line between places.
pub fn drive(drawing: &mut Drawing, drive: &Drive) {
    let (view, unit) = (drawing.view.clone(), drawing.unit.max(2.5));
    let mut group = Group::new(LOADS, 0.0, drive.name.clone());
    let (anchor, reach) = match drive.what {
        Driven::Turn(at, about) => {
            let top = angle_of_top(&view, about);
            let arc = ring(&view, at, about, ARC * unit, top - 1.2, top + 1.2);
            let [first, second, .., before, end] = arc[..] else { return };
            group.path(&arc[1..arc.len() - 1], false, Pen::Line(LINE));
            group.arrow(before, end, Pen::Line(LINE), Pen::Solid);
            group.arrow(second, first, Pen::Line(LINE), Pen::Solid);
            (view.spot(at), (ARC + 0.4) * unit)
        }
        Driven::Way(at, along) => {
            let at = view.spot(at);
            let Some(e) = heading([0.0; 2], view.way(along)) else { return };
            let [a, b] = [-0.5, 0.5].map(|k| shifted(at, k * ARROW * unit, e));
            // Beside what it moves.
            let aside = [-2.4 * unit * e[1], 2.4 * unit * e[0]].map(|x| if e[0] > 0.0 { -x } else { x });
            let [a, b] = [a, b].map(|end| shifted(end, 1.0, aside));
            group.arrow(middle(a, b), b, Pen::Line(LINE), Pen::Solid);
            group.arrow(middle(a, b), a, Pen::Line(LINE), Pen::Solid);
            (middle(a, b), 3.0)
        }
        Driven::Between(first, second) => {
            let [a, b] = [first, second].map(|end| view.spot(end));
            if difference(first, second).iter().all(|x| *x == 0.0) {
                return;
            }
            group.line(a, b, Pen::Broken(1.0));
            (middle(a, b), 3.0)
        }
    };
    drawing.add(group);
    drawing.label(&drive.name, vec![anchor], reach, Kind::Coupling);
}
