//! Bodies and places in the world at one position, in numbers.

use super::point::{Ancestry, Point};
use crate::model::{Frame, Mechanism, Place, Vector, fold};

pub type Vec3 = [f64; 3];

/// Where the bodies are; in the plane z is 0.
pub struct World<'a> {
    mechanism: &'a Mechanism,
    defaults: Vec<f64>,
    /// Centres of mass, and the axes of the bodies as columns.
    pub bodies: Vec<(Vec3, [Vec3; 3])>,
}

impl<'a> World<'a> {
    pub fn at(mechanism: &'a Mechanism, point: &mut Point, q: &[f64]) -> Self {
        let motions = &point.equations.motions;
        let nodes =
            motions.iter().flat_map(|motion| motion.position.iter().chain(&motion.orientation).copied());
        point.set_q(q);
        point.evaluate(&Ancestry::of(point.equations, nodes.collect::<Vec<_>>()));
        let bodies = motions.iter().map(|motion| {
            let mut center = [0.0; 3];
            center.iter_mut().zip(&motion.position).for_each(|(x, node)| *x = point.get(*node));
            let axes: Vec<f64> = motion.orientation.iter().map(|node| point.get(*node)).collect();
            let axes = match axes.as_slice() {
                [c, s] => [[*c, -s, 0.0], [*s, *c, 0.0], [0.0, 0.0, 1.0]],
                matrix => [0, 1, 2].map(|i| [0, 1, 2].map(|j| matrix[3 * i + j])),
            };
            (center, axes)
        });
        World { mechanism, defaults: mechanism.defaults(), bodies: bodies.collect() }
    }

    /// `None` of places that move with time.
    pub fn place(&self, place: &Place) -> Option<Vec3> {
        let at = self.numbers(&place.at)?;
        let Frame::Body(body) = place.frame else { return Some(at) };
        let arm = sub(at, self.numbers(&self.mechanism.bodies[body.0].center)?);
        Some(add(self.bodies[body.0].0, self.turned(place.frame, arm)))
    }

    /// From the axes of a body to those of the world.
    pub fn turned(&self, frame: Frame, vector: Vec3) -> Vec3 {
        let Frame::Body(body) = frame else { return vector };
        self.bodies[body.0].1.map(|row| dot(row, vector))
    }

    fn numbers(&self, vector: &Vector) -> Option<Vec3> {
        let [x, y, z] = vector.each_ref().map(|x| fold::evaluate(x, &self.defaults));
        Some([x?, y?, z?])
    }
}

pub fn add(a: Vec3, b: Vec3) -> Vec3 {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub fn sub(a: Vec3, b: Vec3) -> Vec3 {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub fn cross(a: Vec3, b: Vec3) -> Vec3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub fn dot(a: Vec3, b: Vec3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn length(a: Vec3) -> f64 {
    dot(a, a).sqrt()
}
