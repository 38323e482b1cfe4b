//! Symbols of joints in space: hinges are cylinders about their axes, slides are blocks along them, balls are circles.

use super::canvas::{Group, Pen};
use super::shapes::{THIN, across, block, circle, cylinder, ground_line, plate, ring, shifted};
use super::view::{Spot, View};
use super::{BLOCKS, Drawing, JOINTS};
use crate::model::{Frame, JointWord};
use crate::page::sketch::Hinge;
use crate::page::vector::{Point, along, difference, dot};

pub fn joint(drawing: &mut Drawing, hinge: &Hinge) {
    let unit = drawing.unit;
    let view = drawing.view.clone();
    let at = view.spot(hinge.at);
    let nearness = view.nearness(hinge.at);
    let mut behind = Group::new(BLOCKS, nearness, hinge.name.clone());
    let mut before = Group::new(JOINTS, nearness, hinge.name.clone());
    for (place, on) in [(hinge.first, hinge.first_on), (hinge.second, hinge.second_on)] {
        if on == Frame::Ground {
            let foot = if on == hinge.first_on { rail_foot(&view, hinge, unit) } else { place };
            support(&mut before, view.spot(foot), unit);
        }
    }
    symbol(&mut behind, &mut before, &view, hinge, at, unit);
    drawing.add(behind);
    drawing.add(before);
    if hinge.kind == JointWord::Distance {
        drawing.block_path(&[view.spot(hinge.first), view.spot(hinge.second)], false);
    }
    drawing.block(at, 2.0 * unit, 2.0 * unit);
    if hinge.is_grounded() {
        drawing.block(shifted(at, 3.5 * unit, [0.0, 1.0]), 3.5 * unit, 1.5 * unit);
    }
}

fn symbol(behind: &mut Group, before: &mut Group, view: &View, hinge: &Hinge, at: Spot, unit: f64) {
    let (center, axis) = (hinge.at, hinge.axis);
    match hinge.kind {
        JointWord::Revolute => cylinder(before, view, center, axis, 1.3 * unit, 2.0 * unit),
        JointWord::Cylindrical => {
            rail(behind, view, hinge, unit);
            cylinder(before, view, center, axis, 1.4 * unit, 3.0 * unit);
        }
        JointWord::Screw => {
            rail(behind, view, hinge, unit);
            cylinder(before, view, center, axis, 1.4 * unit, 3.0 * unit);
            for k in [-1.5, 0.0, 1.5] {
                let ring = ring(view, along(center, k * unit / view.scale, axis), axis, 1.4 * unit, 0.0, 3.2);
                before.path(&ring, false, Pen::Line(0.8));
            }
        }
        JointWord::Prismatic => {
            rail(behind, view, hinge, unit);
            let [u, v] = across(axis);
            let long = |k: f64, e: Point| e.map(|x| k * unit / view.scale * x);
            block(before, view, center, [long(2.6, axis), long(1.3, u), long(1.3, v)], Pen::Outline(THIN));
        }
        JointWord::Universal => {
            before.circle(at, 1.9 * unit, Pen::Outline(THIN));
            for axis in [hinge.axis, hinge.second_axis] {
                let end = |k: f64| view.spot(along(center, k * unit / view.scale, axis));
                before.line(end(-1.9), end(1.9), Pen::Line(2.0));
            }
        }
        JointWord::ConstantVelocity => {
            before.circle(at, 1.9 * unit, Pen::Outline(THIN));
            before.path(&circle(view, center, axis, 1.9 * unit), true, Pen::Line(0.8));
            let end = |k: f64| view.spot(along(center, k * unit / view.scale, axis));
            before.line(end(-2.6), end(2.6), Pen::Line(2.0));
        }
        JointWord::Planar => {
            table(behind, view, hinge.first, axis, unit);
            before.path(&circle(view, center, axis, 1.6 * unit), true, Pen::Outline(THIN));
        }
        JointWord::PointOnPlane => {
            table(behind, view, hinge.first, axis, unit);
            ball(before, at, unit);
        }
        JointWord::PointOnLine => {
            let end = along(hinge.first, 1.0, axis);
            plate(behind, &[view.spot(hinge.first), view.spot(end)], 0.5 * unit);
            ball(before, at, unit);
        }
        JointWord::Distance => {
            let ends = [view.spot(hinge.first), view.spot(hinge.second)];
            plate(before, &ends, 0.45 * unit);
            ends.into_iter().for_each(|end| ball(before, end, 0.7 * unit));
        }
        JointWord::Fixed => {
            let halves = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
            block(before, view, center, halves.map(|e| e.map(|x| 1.1 * unit / view.scale * x)), Pen::Solid);
        }
        JointWord::Spherical => ball(before, at, unit),
    }
}

/// A ball in its socket.
fn ball(group: &mut Group, at: Spot, unit: f64) {
    group.circle(at, 1.6 * unit, Pen::Outline(THIN));
    group.circle(at, 0.8 * unit, Pen::Solid);
}

/// Length of a rail on either side of what slides on the ground, or of what would else be too short to be seen, units.
const RAIL: f64 = 9.0;

/// Along the axis: from the first place to the second, or around the second.
fn rail(group: &mut Group, view: &View, hinge: &Hinge, unit: f64) {
    let far = dot(difference(hinge.second, hinge.first), hinge.axis);
    let around = RAIL * unit / view.scale;
    let (from, to) = match hinge.is_grounded() || far.abs() < around {
        true => (far - around, far + around),
        false => (0.0, far),
    };
    let end = |k: f64| view.spot(along(hinge.first, k, hinge.axis));
    plate(group, &[end(from), end(to)], 0.5 * unit);
}

/// Where the ground holds the first place: its own, or the end of a rail that does not reach it.
fn rail_foot(view: &View, hinge: &Hinge, unit: f64) -> Point {
    let slides = matches!(hinge.kind, JointWord::Prismatic | JointWord::Cylindrical | JointWord::Screw);
    let far = dot(difference(hinge.second, hinge.first), hinge.axis);
    let around = RAIL * unit / view.scale;
    if slides && far.abs() > around {
        return along(hinge.first, far - around * far.signum(), hinge.axis);
    }
    hinge.first
}

/// A piece of the plane across an axis.
fn table(group: &mut Group, view: &View, center: Point, axis: Point, unit: f64) {
    let [u, v] = across(axis);
    let size = 7.0 * unit / view.scale;
    let corner = |a: f64, b: f64| view.spot(along(along(center, a * size, u), b * size, v));
    let corners = [corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
    group.path(&corners, true, Pen::Outline(0.8));
    group.path(&corners, true, Pen::Tint);
}

/// A foot on the ground.
fn support(group: &mut Group, at: Spot, unit: f64) {
    let down = [0.0, 1.0];
    let foot = shifted(at, 3.6 * unit, down);
    group.line(at, foot, Pen::Line(1.6));
    let wide = 2.8 * unit;
    ground_line(group, [foot[0] - wide, foot[1]], [foot[0] + wide, foot[1]], down, unit);
}
