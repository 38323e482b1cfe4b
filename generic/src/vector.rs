//! Vectors and rotations of three dimensions, which the plane is a part of. Knows nothing of bodies.

/// Components along x, y, z.
pub(crate) type V3 = [f64; 3];
/// A matrix by its rows; of axes the columns are the axes.
pub(crate) type M3 = [V3; 3];

pub(crate) const ZERO: V3 = [0.0; 3];
pub(crate) const IDENTITY: M3 = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// The unit vector along coordinate axis `k`.
pub(crate) fn unit_axis(k: usize) -> V3 {
    IDENTITY[k]
}

pub(crate) fn plus(a: V3, b: V3) -> V3 {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub(crate) fn minus(a: V3, b: V3) -> V3 {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub(crate) fn times(factor: f64, a: V3) -> V3 {
    [factor * a[0], factor * a[1], factor * a[2]]
}

pub(crate) fn dot(a: V3, b: V3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn cross(a: V3, b: V3) -> V3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(crate) fn norm(a: V3) -> f64 {
    dot(a, a).sqrt()
}

/// M a.
pub(crate) fn turned(m: &M3, a: V3) -> V3 {
    [dot(m[0], a), dot(m[1], a), dot(m[2], a)]
}

/// Mᵀ a.
pub(crate) fn turned_back(m: &M3, a: V3) -> V3 {
    [0, 1, 2].map(|j| m[0][j] * a[0] + m[1][j] * a[1] + m[2][j] * a[2])
}

pub(crate) fn product(a: &M3, b: &M3) -> M3 {
    a.map(|row| turned_back(b, row))
}

pub(crate) fn transposed(a: &M3) -> M3 {
    [0, 1, 2].map(|k| column(a, k))
}

pub(crate) fn column(a: &M3, k: usize) -> V3 {
    [a[0][k], a[1][k], a[2][k]]
}

pub(crate) fn from_columns(x: V3, y: V3, z: V3) -> M3 {
    transposed(&[x, y, z])
}

/// a/|a|; `None` where it has no direction.
pub(crate) fn unit(a: V3) -> Option<V3> {
    let length = norm(a);
    (length > 0.0 && length.is_finite()).then(|| times(1.0 / length, a))
}

/// A turn about coordinate axis `k`, counter-clockwise.
pub(crate) fn turn_about(k: usize, angle: f64) -> M3 {
    let (s, c) = angle.sin_cos();
    let (i, j) = ((k + 1) % 3, (k + 2) % 3);
    let mut turn = [ZERO; 3];
    turn[k][k] = 1.0;
    turn[i][i] = c;
    turn[j][j] = c;
    turn[i][j] = -s;
    turn[j][i] = s;
    turn
}

/// Axes with z along `axis` and x along `reference` less its part along z.
pub(crate) fn frame_about(axis: V3, reference: V3) -> Option<M3> {
    let z = unit(axis)?;
    let x = unit(minus(reference, times(dot(reference, z), z)))?;
    Some(from_columns(x, cross(z, x), z))
}

/// J(a): axes with z along a; x towards the coordinate axis behind the one that a is nearest to.
pub(crate) fn canonical_frame(axis: V3) -> Option<M3> {
    let nearest = (0..3).fold(0, |most, k| if axis[k].abs() > axis[most].abs() { k } else { most });
    frame_about(axis, unit_axis((nearest + 1) % 3))
}

/// The rotation matrix of a unit quaternion (w, x, y, z).
pub(crate) fn rotation([w, x, y, z]: [f64; 4]) -> M3 {
    [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
        [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
        [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
    ]
}

/// p ⊗ r of quaternions.
pub(crate) fn quaternion_product([w, x, y, z]: [f64; 4], [a, b, c, d]: [f64; 4]) -> [f64; 4] {
    [
        w * a - x * b - y * c - z * d,
        w * b + x * a + y * d - z * c,
        w * c - x * d + y * a + z * b,
        w * d + x * c - y * b + z * a,
    ]
}

/// The quaternion at length one; `None` where it has none.
pub(crate) fn unit_quaternion(p: [f64; 4]) -> Option<[f64; 4]> {
    let length = p.iter().map(|x| x * x).sum::<f64>().sqrt();
    (length > 0.0 && length.is_finite()).then(|| p.map(|x| x / length))
}

/// The quaternion of a turn by the vector u: the exponential.
pub(crate) fn quaternion_of_turn(u: V3) -> [f64; 4] {
    let half = 0.5 * norm(u);
    // sin(h)/h, without a quotient of zeros.
    let ratio = if half < 1e-4 { 1.0 - half * half / 6.0 } else { half.sin() / half };
    let [x, y, z] = times(0.5 * ratio, u);
    [half.cos(), x, y, z]
}

/// The unit quaternion of a rotation matrix: the largest column of the symmetric matrix 4 p pᵀ (Bar-Itzhack 2000).
pub(crate) fn quaternion_of(a: &M3) -> Option<[f64; 4]> {
    let trace = a[0][0] + a[1][1] + a[2][2];
    let mut squares = [1.0 + trace; 4];
    for k in 0..3 {
        squares[k + 1] = 1.0 + 2.0 * a[k][k] - trace;
    }
    let largest = (0..4).fold(0, |most, k| if squares[k] > squares[most] { k } else { most });
    let mut p = [0.0; 4];
    if largest == 0 {
        p = [squares[0], a[2][1] - a[1][2], a[0][2] - a[2][0], a[1][0] - a[0][1]];
    } else {
        let i = largest - 1;
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        p[0] = a[k][j] - a[j][k];
        p[i + 1] = squares[largest];
        p[j + 1] = a[i][j] + a[j][i];
        p[k + 1] = a[i][k] + a[k][i];
    }
    unit_quaternion(p)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rotation_comes_back_from_its_quaternion() {
        for turn in [[0.3, -0.2, 0.9], [3.0, 0.1, 0.0], [0.0, -3.1, 0.2], [0.1, 0.2, 3.0]] {
            let p = quaternion_of_turn(turn);
            let back = quaternion_of(&rotation(p)).expect("a rotation");
            let sign = if back.iter().zip(p).map(|(a, b)| a * b).sum::<f64>() < 0.0 { -1.0 } else { 1.0 };
            assert!(back.iter().zip(p).all(|(a, b)| (sign * a - b).abs() < 1e-14));
        }
    }

    #[test]
    fn a_canonical_frame_is_right_handed_about_its_axis() {
        for axis in [[0.0, 0.0, 2.0], [1.0, -3.0, 0.5], [-1.0, 0.0, 0.0]] {
            let frame = canonical_frame(axis).expect("an axis");
            let [x, y, z] = [0, 1, 2].map(|k| column(&frame, k));
            assert!((dot(z, axis) - norm(axis)).abs() < 1e-15);
            assert!(norm(minus(cross(x, y), z)) < 1e-15);
        }
        assert_eq!(canonical_frame(ZERO), None);
    }
}
