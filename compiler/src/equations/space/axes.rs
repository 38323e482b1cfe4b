//! Axes of places and joints: rotation matrices from what the definition gives.
//!
//! All of it is constant, or changes with parameters only. Where an axis lies along an axis of its body the matrix is
//! an exact signed permutation, which costs nothing wherever it is applied.

use super::vector::{self, Mat3, Vec3};
use crate::equations::Laws;
use crate::model::{Axes, Vector, fold};
use crate::symbolic::{Graph, Node, Unary};

/// B: the axes of a place as columns, in the axes of what it belongs to.
pub fn matrix(g: &mut Graph, laws: &Laws, axes: &Axes) -> Mat3 {
    match axes {
        Axes::Parallel => vector::identity(g),
        Axes::Directed { axis, reference: None } => joint_frame(g, laws, axis),
        Axes::Directed { axis, reference: Some(reference) } => {
            let (axis, reference) = (laws.vector(g, axis), laws.vector(g, reference));
            framed(g, axis, reference)
        }
        Axes::Turned(turns) => {
            let mut matrix = vector::identity(g);
            for (about, angle) in turns {
                let angle = laws.value(g, angle);
                let turn = about_axis(g, *about, angle);
                matrix = vector::product(g, &matrix, &turn);
            }
            matrix
        }
    }
}

/// J(a): z along `axis`, x as near as can be to the axis of the place that follows the one `axis` is nearest to.
pub fn joint_frame(g: &mut Graph, laws: &Laws, axis: &Vector) -> Mat3 {
    let defaults: Vec<f64> = laws.mechanism.parameters.iter().map(|parameter| parameter.default).collect();
    let sizes = [0, 1, 2].map(|k| fold::evaluate(&axis[k], &defaults).unwrap_or(0.0).abs());
    let nearest = (1..3).fold(0, |nearest, k| if sizes[k] > sizes[nearest] { k } else { nearest });
    let (axis, reference) = (laws.vector(g, axis), vector::unit(g, (nearest + 1) % 3));
    framed(g, axis, reference)
}

/// z along `axis`, x along `reference` less its part along z, y = z × x; as columns.
fn framed(g: &mut Graph, axis: Vec3, reference: Vec3) -> Mat3 {
    let z = normalized(g, axis);
    let along = vector::dot(g, reference, z);
    let part = vector::scale(g, along, z);
    let x = vector::sub(g, reference, part);
    let x = normalized(g, x);
    let y = vector::cross(g, z, x);
    vector::transposed(&[x, y, z])
}

pub fn normalized(g: &mut Graph, a: Vec3) -> Vec3 {
    let square = vector::dot(g, a, a);
    let length = g.unary(Unary::Sqrt, square);
    a.map(|x| g.div(x, length))
}

fn about_axis(g: &mut Graph, axis: usize, angle: Node) -> Mat3 {
    let [cos, sin] = exact(g, angle);
    let mut matrix = vector::identity(g);
    let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
    (matrix[i][i], matrix[j][j]) = (cos, cos);
    (matrix[i][j], matrix[j][i]) = (g.neg(sin), sin);
    matrix
}

/// (cos, sin) of a constant angle; of right angles exactly, because π in a float is not π.
fn exact(g: &mut Graph, angle: Node) -> [Node; 2] {
    let values = [g.unary(Unary::Cos, angle), g.unary(Unary::Sin, angle)];
    values.map(|node| match g.value(node) {
        Some(value) if (value - value.round()).abs() < 4e-16 => g.constant(value.round()),
        _ => node,
    })
}
