//! What the symbols of planar joints draw with.

use super::Hinge;
use super::canvas::{Group, Pen};
use super::shapes::{THIN, ground_line, shifted};
use super::view::Spot;

pub const DOWN: Spot = [0.0, 1.0];

/// The symbol of a planar joint.
pub struct Symbol<'a> {
    pub hinge: &'a Hinge,
    /// Grounds, rails and their blocks, behind the bodies.
    pub behind: Group,
    /// Pins and blocks, before them.
    pub before: Group,
    pub first: Spot,
    pub second: Spot,
    /// A metre along the axis.
    pub way: Spot,
    /// Radius of a pin, px.
    pub unit: f64,
}

impl Symbol<'_> {
    /// A pin at the second place, held where one of the places is the ground's.
    pub fn pin(&mut self) {
        if self.hinge.is_grounded() {
            self.pin_support(self.second);
        }
        self.before.circle(self.second, self.unit, Pen::Outline(1.3 * THIN));
    }

    /// A triangle on the ground.
    pub fn pin_support(&mut self, at: Spot) {
        let (group, unit) = (&mut self.behind, self.unit);
        let foot = shifted(at, 3.4 * unit, DOWN);
        let (left, right) = ([foot[0] - 2.0 * unit, foot[1]], [foot[0] + 2.0 * unit, foot[1]]);
        group.path(&[at, left, right], true, Pen::Outline(THIN));
        let wide = 1.3 * unit;
        ground_line(group, [left[0] - wide, left[1]], [right[0] + wide, right[1]], DOWN, unit);
    }

    /// The ground under the second place.
    pub fn floor(&mut self) {
        let foot = shifted(self.second, 1.2 * self.unit, DOWN);
        let wide = 3.0 * self.unit;
        let (left, right) = ([foot[0] - wide, foot[1]], [foot[0] + wide, foot[1]]);
        ground_line(&mut self.behind, left, right, DOWN, self.unit);
    }
}
