//! Symbols of planar joints.

use super::canvas::{Group, Pen};
use super::shapes::{THIN, away, ground_line, heading, plate, rectangle, shifted};
use super::view::Spot;
use super::{BLOCKS, Drawing, GROUND, JOINTS};
use crate::model::{Frame, JointWord};
use crate::page::sketch::Hinge;

const DOWN: Spot = [0.0, 1.0];

pub fn joint(drawing: &mut Drawing, hinge: &Hinge) {
    let unit = drawing.unit;
    let (first, second) = (drawing.view.spot(hinge.first), drawing.view.spot(hinge.second));
    let way = drawing.view.way(hinge.axis);
    // Grounds, rails and their blocks behind the bodies, pins before them.
    let is_slide = hinge.kind == JointWord::Prismatic;
    let mut behind = Group::new(GROUND, 0.0, hinge.name.clone());
    let mut before = Group::new(if is_slide { BLOCKS } else { JOINTS }, 0.0, hinge.name.clone());
    match hinge.kind {
        JointWord::Prismatic => {
            let e = heading([0.0; 2], way).unwrap_or([1.0, 0.0]);
            slider(&mut behind, &mut before, hinge, [first, second, e], unit);
        }
        JointWord::PointOnLine => slot(&mut before, hinge, first, shifted(first, 1.0, way), second, unit),
        JointWord::Distance => {
            plate(&mut before, &[first, second], 0.45 * unit);
            for (at, on) in [(first, hinge.first_on), (second, hinge.second_on)] {
                if on == Frame::Ground {
                    pin_support(&mut behind, at, unit);
                }
                before.circle(at, 0.8 * unit, Pen::Outline(THIN));
            }
            drawing.block_path(&[first, second], false);
        }
        JointWord::Fixed => {
            if hinge.is_grounded() {
                let foot = shifted(second, 1.2 * unit, DOWN);
                let wide = 3.0 * unit;
                ground_line(&mut behind, [foot[0] - wide, foot[1]], [foot[0] + wide, foot[1]], DOWN, unit);
            }
            before.path(&rectangle(second, [1.0, 0.0], 1.2 * unit, 1.2 * unit), true, Pen::Solid);
        }
        JointWord::Revolute
        | JointWord::Cylindrical
        | JointWord::Screw
        | JointWord::Universal
        | JointWord::Spherical
        | JointWord::Planar
        | JointWord::ConstantVelocity
        | JointWord::PointOnPlane => {
            if hinge.is_grounded() {
                pin_support(&mut behind, second, unit);
            }
            before.circle(second, unit, Pen::Outline(1.3 * THIN));
        }
    }
    drawing.add(behind);
    drawing.add(before);
    if hinge.is_grounded() {
        let depth = if is_slide { 2.5 } else { 4.5 };
        drawing.block(shifted(second, depth / 2.0 * unit, DOWN), 3.2 * unit, depth / 2.0 * unit);
    }
    drawing.block(second, 1.4 * unit, 1.4 * unit);
}

/// A triangle on the ground.
fn pin_support(group: &mut Group, at: Spot, unit: f64) {
    let foot = shifted(at, 3.4 * unit, DOWN);
    let (left, right) = ([foot[0] - 2.0 * unit, foot[1]], [foot[0] + 2.0 * unit, foot[1]]);
    group.path(&[at, left, right], true, Pen::Outline(THIN));
    let wide = 1.3 * unit;
    ground_line(group, [left[0] - wide, left[1]], [right[0] + wide, right[1]], DOWN, unit);
}

/// The rail is the first body's, the block the second's.
fn slider(behind: &mut Group, before: &mut Group, hinge: &Hinge, [first, second, e]: [Spot; 3], unit: f64) {
    let n = if e[0] >= 0.0 { [-e[1], e[0]] } else { [e[1], -e[0]] };
    let far = (second[0] - first[0]) * e[0] + (second[1] - first[1]) * e[1];
    let (least, most) = match hinge.is_grounded() {
        true => (far - 9.0 * unit, far + 9.0 * unit),
        false => (far.min(0.0) - 7.0 * unit, far.max(0.0) + 7.0 * unit),
    };
    let rail = |from: f64, aside: f64| shifted(shifted(first, from, e), aside, n);
    if hinge.first_on == Frame::Ground {
        let below = 1.8 * unit;
        ground_line(behind, rail(least, below), rail(most, below), n, unit);
    } else {
        plate(behind, &[rail(least, 0.0), rail(most, 0.0)], 0.5 * unit);
    }
    let block = rectangle(second, e, 2.8 * unit, 1.8 * unit);
    before.path(&block, true, Pen::Outline(THIN));
    if hinge.first_on == Frame::Ground {
        before.path(&block, true, Pen::Tint);
    } else {
        // What slides through it is seen.
        before.line(shifted(second, -2.8 * unit, e), shifted(second, 2.8 * unit, e), Pen::Line(0.8));
    }
    if hinge.second_on == Frame::Ground {
        let (a, b) = (shifted(second, 1.8 * unit, n), 2.8 * unit);
        ground_line(before, shifted(a, -b, e), shifted(a, b, e), n, unit);
    }
}

/// The line is a slot in which a pin carries a block.
fn slot(group: &mut Group, hinge: &Hinge, from: Spot, to: Spot, pin: Spot, unit: f64) {
    let Some(e) = heading(from, to) else { return };
    let position = (pin[0] - from[0]) * e[0] + (pin[1] - from[1]) * e[1];
    let is_ground = hinge.first_on == Frame::Ground;
    // In a bar it stays within the bar.
    let (beyond, aside) = if is_ground { (3.0, 1.5) } else { (0.0, 0.4) };
    let least = position.min(0.0) - beyond * unit;
    let most = position.max(away(from, to)) + beyond * unit;
    let n = [-e[1], e[0]];
    for side in [-aside, aside] {
        let at = |along: f64| shifted(shifted(from, along, e), side * unit, n);
        if is_ground {
            let into = if side < 0.0 { [e[1], -e[0]] } else { n };
            ground_line(group, at(least), at(most), into, unit);
        } else {
            group.line(at(least), at(most), Pen::Line(0.8));
        }
    }
    let block = rectangle(pin, e, 2.4 * unit, 1.5 * unit);
    group.path(&block, true, Pen::Outline(THIN));
    group.circle(pin, 0.8 * unit, Pen::Outline(THIN));
}
