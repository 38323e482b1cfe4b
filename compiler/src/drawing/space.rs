//! What the symbols of joints in space draw with: hinges are cylinders about their axes, slides are blocks along them, balls
//! are circles.

use super::Hinge;
use super::canvas::{Group, Pen};
use super::shapes::{self, THIN, across, plate};
use super::vector::{Point, along, difference, dot};
use super::view::{Spot, View};

/// Length of a rail on either side of what slides on the ground, or of what would else be too short to be seen, units.
const RAIL: f64 = 9.0;

/// The symbol of a joint in space.
pub struct Symbol<'a> {
    pub hinge: &'a Hinge,
    pub view: &'a View,
    /// Rails and tables.
    pub behind: Group,
    pub before: Group,
    /// Where it stands in the picture.
    pub at: Spot,
    /// Radius of a pin, px.
    pub unit: f64,
}

impl Symbol<'_> {
    /// The spot so many units from where the symbol stands, along a direction.
    pub fn beside(&self, units: f64, direction: Point) -> Spot {
        self.view.spot(along(self.hinge.at, units * self.unit / self.view.scale, direction))
    }

    /// About the axis; units.
    pub fn cylinder(&mut self, radius: f64, length: f64) {
        let Hinge { at, axis, .. } = *self.hinge;
        shapes::cylinder(&mut self.before, self.view, at, axis, radius * self.unit, length * self.unit);
    }

    /// Half edges in units, along directions of length one.
    pub fn block(&mut self, edges: [(f64, Point); 3], pen: Pen) {
        let edges = edges.map(|(k, e)| e.map(|x| k * self.unit / self.view.scale * x));
        shapes::block(&mut self.before, self.view, self.hinge.at, edges, pen);
    }

    /// A circle across the axis; units.
    pub fn disk(&mut self, radius: f64, pen: Pen) {
        let circle = shapes::circle(self.view, self.hinge.at, self.hinge.axis, radius * self.unit);
        self.before.path(&circle, true, pen);
    }

    /// A ball in its socket.
    pub fn ball(&mut self, at: Spot, size: f64) {
        self.before.circle(at, 1.6 * size, Pen::Outline(THIN));
        self.before.circle(at, 0.8 * size, Pen::Solid);
    }

    /// Along the axis: from the first place to the second, or around the second.
    pub fn rail(&mut self) {
        let (hinge, view) = (self.hinge, self.view);
        let far = dot(difference(hinge.second, hinge.first), hinge.axis);
        let around = RAIL * self.unit / view.scale;
        let (from, to) = match hinge.is_grounded() || far.abs() < around {
            true => (far - around, far + around),
            false => (0.0, far),
        };
        let end = |k: f64| view.spot(along(hinge.first, k, hinge.axis));
        plate(&mut self.behind, &[end(from), end(to)], 0.5 * self.unit);
    }

    /// A piece of the plane across the axis, through the first place.
    pub fn table(&mut self) {
        let (view, center) = (self.view, self.hinge.first);
        let [u, v] = across(self.hinge.axis);
        let size = 7.0 * self.unit / view.scale;
        let corner = |a: f64, b: f64| view.spot(along(along(center, a * size, u), b * size, v));
        let corners = [corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
        self.behind.path(&corners, true, Pen::Outline(0.8));
        self.behind.path(&corners, true, Pen::Tint(0.0));
    }
}

/// Where the ground holds the first place of what slides on a rail: its own, or the end of a rail that does not reach it.
pub fn rail_foot(view: &View, hinge: &Hinge, unit: f64) -> Point {
    let far = dot(difference(hinge.second, hinge.first), hinge.axis);
    let around = RAIL * unit / view.scale;
    if far.abs() > around {
        return along(hinge.first, far - around * far.signum(), hinge.axis);
    }
    hinge.first
}
