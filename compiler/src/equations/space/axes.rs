//! Axes of places and joints: rotation matrices from what the definition gives.
//!
//! All of it is constant, or changes with parameters only. Where an axis lies along an axis of its body the matrix is
//! an exact signed permutation, which costs nothing wherever it is applied.

use super::vector::{self, Mat3, Vec3};
use crate::equations::Laws;
use crate::model::{Axes, Vector, fold};
use crate::symbolic::{On, Scalar};

/// B: the axes of a place as columns, in the axes of what it belongs to.
pub fn matrix<'g>(laws: &Laws<'g>, axes: &Axes) -> On<'g, Mat3> {
    match axes {
        Axes::Parallel => vector::identity(laws.g),
        Axes::Directed { axis, reference: None } => joint_frame(laws, axis),
        Axes::Directed { axis, reference: Some(reference) } => {
            framed(laws.vector(axis), laws.vector(reference))
        }
        Axes::Turned(turns) => turns.iter().fold(vector::identity(laws.g), |matrix, (about, angle)| {
            matrix * about_axis(*about, laws.value(angle))
        }),
    }
}

/// J(a): z along `axis`, x as near as can be to the axis of the place that follows the one `axis` is nearest to.
pub fn joint_frame<'g>(laws: &Laws<'g>, axis: &Vector) -> On<'g, Mat3> {
    let defaults: Vec<f64> = laws.mechanism.parameters.iter().map(|parameter| parameter.default).collect();
    let sizes = [0, 1, 2].map(|k| fold::evaluate(&axis[k], &defaults).unwrap_or(0.0).abs());
    let nearest = (1..3).fold(0, |nearest, k| if sizes[k] > sizes[nearest] { k } else { nearest });
    framed(laws.vector(axis), vector::unit(laws.g, (nearest + 1) % 3))
}

/// z along `axis`, x along `reference` less its part along z, y = z × x; as columns.
fn framed<'g>(axis: On<'g, Vec3>, reference: On<'g, Vec3>) -> On<'g, Mat3> {
    let z = axis.normalized();
    let x = (reference - reference.dot(z) * z).normalized();
    let y = z.cross(x);
    x.g.on([x.bare, y.bare, z.bare]).transposed()
}

fn about_axis(axis: usize, angle: Scalar) -> On<Mat3> {
    let [cos, sin] = exact(angle);
    let mut matrix = vector::identity(angle.g);
    let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
    let entries = &mut matrix.bare;
    (entries[i][i], entries[j][j]) = (cos.bare, cos.bare);
    (entries[i][j], entries[j][i]) = ((-sin).bare, sin.bare);
    matrix
}

/// (cos, sin) of a constant angle; of right angles exactly, because π in a float is not π.
fn exact(angle: Scalar) -> [Scalar; 2] {
    [angle.cos(), angle.sin()].map(|part| match part.value() {
        Some(value) if (value - value.round()).abs() < 4e-16 => angle.g.number(value.round()),
        _ => part,
    })
}
