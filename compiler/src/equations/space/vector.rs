//! Vectors and matrices of three components as nodes of the graph. Zeros and ones fold, so that what is aligned with an
//! axis costs nothing.

use crate::symbolic::{Graph, Node};

pub type Vec3 = [Node; 3];
/// Rows.
pub type Mat3 = [[Node; 3]; 3];

pub fn zero(g: &mut Graph) -> Vec3 {
    [g.constant(0.0); 3]
}

/// Unit vector along an axis.
pub fn unit(g: &mut Graph, axis: usize) -> Vec3 {
    std::array::from_fn(|k| g.constant(if k == axis { 1.0 } else { 0.0 }))
}

pub fn identity(g: &mut Graph) -> Mat3 {
    [unit(g, 0), unit(g, 1), unit(g, 2)]
}

pub fn add(g: &mut Graph, a: Vec3, b: Vec3) -> Vec3 {
    [g.add(a[0], b[0]), g.add(a[1], b[1]), g.add(a[2], b[2])]
}

pub fn sub(g: &mut Graph, a: Vec3, b: Vec3) -> Vec3 {
    [g.sub(a[0], b[0]), g.sub(a[1], b[1]), g.sub(a[2], b[2])]
}

pub fn neg(g: &mut Graph, a: Vec3) -> Vec3 {
    a.map(|x| g.neg(x))
}

pub fn scale(g: &mut Graph, factor: Node, a: Vec3) -> Vec3 {
    a.map(|x| g.mul(factor, x))
}

pub fn dot(g: &mut Graph, a: Vec3, b: Vec3) -> Node {
    let mut sum = None;
    for k in 0..3 {
        // Most of what is multiplied is aligned with an axis.
        if g.is_zero(a[k]) || g.is_zero(b[k]) {
            continue;
        }
        let product = g.mul(a[k], b[k]);
        sum = Some(match sum {
            Some(sum) => g.add(sum, product),
            None => product,
        });
    }
    sum.unwrap_or_else(|| g.constant(0.0))
}

pub fn cross(g: &mut Graph, a: Vec3, b: Vec3) -> Vec3 {
    if is_zero(g, a) || is_zero(g, b) {
        return zero(g);
    }
    std::array::from_fn(|k| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        let (left, right) = (g.mul(a[i], b[j]), g.mul(a[j], b[i]));
        g.sub(left, right)
    })
}

/// m a.
pub fn apply(g: &mut Graph, m: &Mat3, a: Vec3) -> Vec3 {
    if is_zero(g, a) {
        return a;
    }
    [dot(g, m[0], a), dot(g, m[1], a), dot(g, m[2], a)]
}

/// mᵀ a.
pub fn apply_transposed(g: &mut Graph, m: &Mat3, a: Vec3) -> Vec3 {
    let m = transposed(m);
    apply(g, &m, a)
}

pub fn transposed(m: &Mat3) -> Mat3 {
    std::array::from_fn(|i| std::array::from_fn(|j| m[j][i]))
}

/// a b.
pub fn product(g: &mut Graph, a: &Mat3, b: &Mat3) -> Mat3 {
    let columns = transposed(b).map(|column| apply(g, a, column));
    transposed(&columns)
}

/// a bᵀ.
pub fn product_transposed(g: &mut Graph, a: &Mat3, b: &Mat3) -> Mat3 {
    let b = transposed(b);
    product(g, a, &b)
}

pub fn column(m: &Mat3, k: usize) -> Vec3 {
    [m[0][k], m[1][k], m[2][k]]
}

pub fn is_zero(g: &Graph, a: Vec3) -> bool {
    a.iter().all(|x| g.is_zero(*x))
}

/// Turned about z by (cos, sin).
pub fn turn_z(g: &mut Graph, cos: Node, sin: Node, a: Vec3) -> Vec3 {
    let (cx, sy) = (g.mul(cos, a[0]), g.mul(sin, a[1]));
    let (sx, cy) = (g.mul(sin, a[0]), g.mul(cos, a[1]));
    [g.sub(cx, sy), g.add(sx, cy), a[2]]
}
