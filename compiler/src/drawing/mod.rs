//! What drawings are made of: points of the world, how they are seen, shapes, and what the symbols of elements draw with.
//! Which parts a picture shows, and where they stand, is left to `page`.

pub mod canvas;
pub mod load;
pub mod plane;
pub mod shapes;
pub mod space;
pub mod vector;
pub mod view;

use crate::forms::JointForm;
use crate::model::Frame;
use vector::Point;

/// A joint as it is drawn.
#[derive(Clone, Debug)]
pub struct Hinge {
    pub name: String,
    pub form: &'static JointForm,
    pub first: Point,
    pub second: Point,
    pub first_on: Frame,
    pub second_on: Frame,
    /// Along the joint's axis, of length one; along a line, as long as that.
    pub axis: Point,
    /// Its second direction, or the same.
    pub second_axis: Point,
    /// Where its symbol stands.
    pub at: Point,
}

impl Hinge {
    pub fn is_grounded(&self) -> bool {
        self.first_on == Frame::Ground || self.second_on == Frame::Ground
    }
}
