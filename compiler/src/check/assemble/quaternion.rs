//! Unit quaternions in numbers, scalar first.

/// q ⊗ exp(δ/2), of length one.
pub fn turn(q: [f64; 4], delta: [f64; 3]) -> [f64; 4] {
    let angle = delta.iter().map(|x| x * x).sum::<f64>().sqrt();
    let ratio = if angle < 1e-8 { 0.5 } else { libm::sin(0.5 * angle) / angle };
    let [x, y, z] = delta.map(|x| ratio * x);
    normalized(product(q, [libm::cos(0.5 * angle), x, y, z]))
}

pub fn product([w, x, y, z]: [f64; 4], [a, b, c, d]: [f64; 4]) -> [f64; 4] {
    [
        w * a - x * b - y * c - z * d,
        w * b + x * a + y * d - z * c,
        w * c - x * d + y * a + z * b,
        w * d + x * c - y * b + z * a,
    ]
}

pub fn conjugate([w, x, y, z]: [f64; 4]) -> [f64; 4] {
    [w, -x, -y, -z]
}

pub fn normalized(q: [f64; 4]) -> [f64; 4] {
    let length = q.iter().map(|x| x * x).sum::<f64>().sqrt();
    if length > 0.0 { q.map(|x| x / length) } else { [1.0, 0.0, 0.0, 0.0] }
}

/// The quaternion of a rotation matrix, row by row (Shepperd, J. Guidance and Control 1, 1978): the largest part is found first.
pub fn of_matrix(a: [[f64; 3]; 3]) -> [f64; 4] {
    let trace = a[0][0] + a[1][1] + a[2][2];
    let parts = [trace, a[0][0], a[1][1], a[2][2]];
    let largest = (1..4).fold(0, |largest, k| if parts[k] > parts[largest] { k } else { largest });
    let mut q = [0.0; 4];
    q[largest] = 1.0 + 2.0 * parts[largest] - trace;
    let turned = |k: usize| a[(k + 1) % 3][k % 3] - a[k % 3][(k + 1) % 3];
    if largest == 0 {
        (q[1], q[2], q[3]) = (turned(1), turned(2), turned(0));
    } else {
        let (i, j, k) = (largest - 1, largest % 3, (largest + 1) % 3);
        q[0] = a[k][j] - a[j][k];
        q[1 + j] = a[j][i] + a[i][j];
        q[1 + k] = a[k][i] + a[i][k];
    }
    normalized(q)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn matrix([w, x, y, z]: [f64; 4]) -> [[f64; 3]; 3] {
        [
            [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
            [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
            [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
        ]
    }

    #[test]
    fn matrices_and_back() {
        for q in [[1.0, 2.0, -3.0, 0.5], [0.1, 2.0, 0.3, 0.2], [0.1, 0.2, 2.0, -1.0], [0.0, 0.1, 0.2, 3.0]] {
            let q = normalized(q);
            let back = of_matrix(matrix(q));
            let sign = if back[0] * q[0] + back[1] * q[1] + back[2] * q[2] + back[3] * q[3] < 0.0 {
                -1.0
            } else {
                1.0
            };
            for k in 0..4 {
                assert!((sign * back[k] - q[k]).abs() < 1e-15, "{q:?} came back as {back:?}");
            }
        }
    }

    #[test]
    fn turns_add_up() {
        let q = turn(turn([1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.3]), [0.0, 0.0, 0.4]);
        assert!((q[0] - libm::cos(0.35)).abs() < 1e-15 && (q[3] - libm::sin(0.35)).abs() < 1e-15);
    }
}
