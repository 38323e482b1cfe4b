//! How the world is seen: the plane from above and to scale, space along one fixed direction, all lines parallel.

use super::vector::{Point, cross, dot, unit};
use crate::model::Space;

/// A point of the picture, px, y downwards.
pub type Spot = [f64; 2];

/// Turn about the way up, and height of the eye, of the axonometric projection: no edge of a cube hides another.
const AZIMUTH: f64 = 0.56;
const ELEVATION: f64 = 0.44;

/// Least and largest size of what is drawn, px.
const WIDTH: f64 = 580.0;
const HEIGHT: f64 = 380.0;
/// Around it, for symbols and names; below it, for axes and scale.
const MARGIN: f64 = 56.0;
const LEGEND: f64 = 28.0;
/// From so many names on a picture becomes larger.
const MANY: f64 = 30.0;

#[derive(Clone, Debug)]
pub struct View {
    pub space: Space,
    /// To the right, upwards and towards the eye, in the world.
    right: Point,
    rise: Point,
    pub toward: Point,
    /// px/m.
    pub scale: f64,
    origin: Spot,
    /// The width of the whole picture.
    pub width: f64,
    pub height: f64,
}

impl View {
    /// The view in which all points are in the picture, with room for so many names, and so much around it for other things, px.
    pub fn of(space: Space, up: Point, points: &[Point], names: usize, beside: f64) -> View {
        let toward = match space {
            Space::Planar => [0.0, 0.0, 1.0],
            Space::Spatial => eye(up),
        };
        let right = unit(cross(up, toward));
        let rise = cross(toward, right);
        let mut view =
            View { space, right, rise, toward, scale: 1.0, origin: [0.0; 2], width: 0.0, height: 0.0 };
        let (mut least, mut most) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for at in points.iter().map(|point| view.spot(*point)) {
            for k in 0..2 {
                (least[k], most[k]) = (least[k].min(at[k]), most[k].max(at[k]));
            }
        }
        if points.is_empty() {
            (least, most) = ([0.0; 2], [0.0; 2]);
        }
        let size = [most[0] - least[0], most[1] - least[1]];
        let room = (names as f64 / MANY).clamp(1.0, 1.7);
        let margin = room * MARGIN + beside;
        let fit = (room * WIDTH / size[0]).min(room * HEIGHT / size[1]);
        view.scale = if fit.is_finite() { fit } else { 100.0 };
        view.width = (view.scale * size[0]).max(160.0) + 2.0 * margin;
        view.height = (view.scale * size[1]).max(60.0) + 2.0 * margin + LEGEND;
        let middle = [0, 1].map(|k| view.scale * (least[k] + most[k]) / 2.0);
        view.origin = [view.width / 2.0 - middle[0], (view.height - LEGEND) / 2.0 - middle[1]];
        view
    }

    pub fn spot(&self, point: Point) -> Spot {
        let [x, y] = self.way(point);
        [self.origin[0] + x, self.origin[1] + y]
    }

    /// A vector of the world in the picture.
    pub fn way(&self, vector: Point) -> Spot {
        [self.scale * dot(self.right, vector), -self.scale * dot(self.rise, vector)]
    }

    /// How near to the eye; what is nearer is drawn later.
    pub fn nearness(&self, point: Point) -> f64 {
        dot(self.toward, point)
    }
}

/// Towards the eye, for a world with this way up.
fn eye(up: Point) -> Point {
    // x to the lower right and y into the picture where z is up; likewise for other axes, in their order.
    let upward = (0..3).find(|k| up[*k].abs() > 0.5).unwrap_or(2);
    let (mut a, mut b) = ([0.0; 3], [0.0; 3]);
    a[(upward + 1) % 3] = 1.0;
    b[(upward + 2) % 3] = up[upward];
    let (sin, cos) = (libm::sin(AZIMUTH), libm::cos(AZIMUTH));
    let level = libm::cos(ELEVATION);
    let high = libm::sin(ELEVATION);
    [0, 1, 2].map(|k| level * (sin * a[k] - cos * b[k]) + high * up[k])
}
