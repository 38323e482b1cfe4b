//! Vectors of numbers.

pub type V3 = [f64; 3];

pub fn dot(a: V3, b: V3) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

pub fn cross(a: V3, b: V3) -> V3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub fn difference(a: V3, b: V3) -> V3 {
    [0, 1, 2].map(|k| a[k] - b[k])
}

/// a + x b.
pub fn along(a: V3, x: f64, b: V3) -> V3 {
    [0, 1, 2].map(|k| a[k] + x * b[k])
}

pub fn scaled(x: f64, a: V3) -> V3 {
    a.map(|component| x * component)
}

pub fn length(a: V3) -> f64 {
    libm::sqrt(dot(a, a))
}

/// Of length one; what has no length stays as it is.
pub fn unit(a: V3) -> V3 {
    let length = length(a);
    if length > 0.0 { scaled(1.0 / length, a) } else { a }
}

/// The part of a that is across a unit vector.
pub fn across(a: V3, about: V3) -> V3 {
    along(a, -dot(a, about), about)
}
