//! Loads, and the pitch circles of gears: arrows, zigzags, dashpots, spirals.

use super::labels::Kind;
use super::{Drawing, JOINTS, LOADS};
use crate::drawing::canvas::{Group, Pen};
use crate::drawing::shapes::{away, circle, ground_line, heading, middle, ring, shifted};
use crate::drawing::vector::Point;
use crate::drawing::view::Spot;
use crate::page::sketch::{Effort, EffortKind, Wheel};

const LINE: f64 = 1.4;

pub fn effort(drawing: &mut Drawing, effort: &Effort) {
    let mut group = Group::new(LOADS, 0.0, effort.name.clone());
    let unit = drawing.unit.max(2.5);
    let view = drawing.view.clone();
    let (anchor, reach) = match &effort.kind {
        EffortKind::Force { at, along } => force(drawing, &mut group, view.spot(*at), view.way(*along), unit),
        EffortKind::Torque { at, about } => {
            // Counter-clockwise about its axis, away from what is below the joint.
            let start = angle_of_top(drawing, *about);
            let arc = ring(&view, *at, *about, 4.2 * unit, start - 1.9, start + 1.9);
            if let [.., before, end] = arc[..] {
                group.path(&arc[..arc.len() - 1], false, Pen::Load(LINE));
                group.arrow(before, end, Pen::Load(LINE), Pen::SolidLoad);
            }
            drawing.block(view.spot(*at), 3.6 * unit, 3.6 * unit);
            (view.spot(*at), 4.4 * unit)
        }
        EffortKind::Spring { ends, is_elastic, is_damped } => {
            let [a, b] = ends.map(|end| view.spot(end.at));
            for (end, from, to) in [(ends[0], b, a), (ends[1], a, b)] {
                if let (true, Some(e)) = (end.is_grounded, heading(from, to)) {
                    let across = [-2.6 * unit * e[1], 2.6 * unit * e[0]];
                    ground_line(&mut group, shifted(to, -1.0, across), shifted(to, 1.0, across), e, unit);
                }
            }
            spring(&mut group, a, b, (*is_elastic, *is_damped), unit);
            drawing.block_path(&[a, b], false);
            (middle(a, b), if *is_elastic && *is_damped { 3.4 * unit } else { 2.0 * unit })
        }
        EffortKind::TorsionSpring { at, about } => {
            let spiral: Vec<Spot> = (0..40)
                .map(|k| {
                    let turn = f64::from(k) / 39.0;
                    let radius = (1.8 + 2.0 * turn) * unit;
                    ring(&view, *at, *about, radius, 13.0 * turn, 13.0 * turn)[0]
                })
                .collect();
            group.path(&spiral, false, Pen::Load(1.1));
            drawing.block(view.spot(*at), 3.6 * unit, 3.6 * unit);
            (view.spot(*at), 4.0 * unit)
        }
    };
    drawing.add(group);
    drawing.label(&effort.name, anchor, reach, Kind::Load);
}

/// In the basis of a ring about an axis, the angle of its highest point in the picture.
fn angle_of_top(drawing: &Drawing, about: Point) -> f64 {
    let [u, v] = super::shapes::across(about).map(|e| drawing.view.way(e));
    libm::atan2(-v[1], -u[1])
}

/// An arrow that ends where it acts; one along the view is a point.
fn force(drawing: &mut Drawing, group: &mut Group, at: Spot, way: Spot, unit: f64) -> (Spot, f64) {
    let Some(e) = heading([0.0; 2], way) else {
        group.circle(at, 1.2 * unit, Pen::SolidLoad);
        return (at, 2.0 * unit);
    };
    let (tail, tip) = (shifted(at, -11.0 * unit, e), shifted(at, -2.0 * unit, e));
    group.arrow(tail, tip, Pen::Load(LINE), Pen::SolidLoad);
    drawing.block_path(&[tail, tip], false);
    (tail, 2.0)
}

/// A zigzag, a dashpot, or both side by side.
fn spring(group: &mut Group, a: Spot, b: Spot, (elastic, damped): (bool, bool), unit: f64) {
    let Some(e) = heading(a, b) else { return };
    let n = [-e[1], e[0]];
    let size = away(a, b);
    let aside = if elastic && damped { 1.5 * unit } else { 0.0 };
    let at = |share: f64, offset: f64| shifted(shifted(a, share * size, e), offset, n);
    if aside > 0.0 {
        for share in [0.2, 0.8] {
            group.line(at(share, -aside), at(share, aside), Pen::Load(1.1));
        }
        group.line(a, at(0.2, 0.0), Pen::Load(1.1));
        group.line(at(0.8, 0.0), b, Pen::Load(1.1));
    }
    let (from, to) = if aside > 0.0 { (0.2, 0.8) } else { (0.0, 1.0) };
    if elastic {
        let turns = (size / (3.4 * unit)).clamp(4.0, 14.0) as u32;
        let mut path = vec![at(from, -aside)];
        let lead = if aside > 0.0 { 0.04 } else { 0.12 };
        for k in 0..=2 * turns {
            let share = from + lead + (to - from - 2.0 * lead) * f64::from(k) / f64::from(2 * turns);
            let swing = match k {
                0 => 0.0,
                k if k == 2 * turns => 0.0,
                k if k % 2 == 0 => 1.2 * unit,
                _ => -1.2 * unit,
            };
            path.push(at(share, swing - aside));
        }
        path.push(at(to, -aside));
        group.path(&path, false, Pen::Load(1.1));
    }
    if damped {
        let half = 1.1 * unit;
        let (cup, piston) = (from + 0.35 * (to - from), from + 0.55 * (to - from));
        let end = from + 0.75 * (to - from);
        group.line(at(from, aside), at(cup, aside), Pen::Load(1.1));
        let walls =
            [at(end, aside - half), at(cup, aside - half), at(cup, aside + half), at(end, aside + half)];
        group.path(&walls, false, Pen::Load(1.1));
        group.line(at(piston, aside - 0.8 * half), at(piston, aside + 0.8 * half), Pen::Load(1.6));
        group.line(at(piston, aside), at(to, aside), Pen::Load(1.1));
    }
}

pub fn wheel(drawing: &mut Drawing, wheel: &Wheel) {
    let mut group = Group::new(JOINTS, -1.0, format!("{}, pitch circle", wheel.of));
    let view = &drawing.view;
    group.path(&circle(view, wheel.center, wheel.about, wheel.radius * view.scale), true, Pen::Broken(1.0));
    drawing.add(group);
}
