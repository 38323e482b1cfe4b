//! Points and directions of the world, as numbers.

/// World coordinates, m; z is 0 in the plane.
pub type Point = [f64; 3];

/// With zeros behind, and for what is no number.
pub fn pad(values: &[f64]) -> Point {
    let mut point = [0.0; 3];
    point.iter_mut().zip(values).for_each(|(own, value)| *own = if value.is_finite() { *value } else { 0.0 });
    point
}

/// A vector given along three axes.
pub fn apply(axes: &[Point; 3], x: Point) -> Point {
    [0, 1, 2].map(|k| axes[0][k] * x[0] + axes[1][k] * x[1] + axes[2][k] * x[2])
}

pub fn sum(a: Point, b: Point) -> Point {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub fn difference(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// a + k b.
pub fn along(a: Point, k: f64, b: Point) -> Point {
    [a[0] + k * b[0], a[1] + k * b[1], a[2] + k * b[2]]
}

pub fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn cross(a: Point, b: Point) -> Point {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub fn length(a: Point) -> f64 {
    dot(a, a).sqrt()
}

/// Of length one; zero stays zero.
pub fn unit(a: Point) -> Point {
    let size = length(a);
    if size > 0.0 { a.map(|x| x / size) } else { [0.0; 3] }
}
