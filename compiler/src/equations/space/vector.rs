//! Vectors and matrices of three components as nodes of the graph. Zeros and ones fold, so that what is aligned with an
//! axis costs nothing.

use crate::symbolic::{Bare, Graph, Node, On, Scalar, Sheet};
use std::ops::{Add, AddAssign, Mul, Neg, Sub};

pub type Vec3 = [Node; 3];
/// Rows.
pub type Mat3 = [[Node; 3]; 3];

pub fn zero(g: Sheet) -> On<Vec3> {
    g.on([g.zero().bare; 3])
}

/// Unit vector along an axis.
pub fn unit(g: Sheet, axis: usize) -> On<Vec3> {
    vector(|k| g.number(if k == axis { 1.0 } else { 0.0 }))
}

pub fn identity(g: Sheet) -> On<Mat3> {
    g.on([0, 1, 2].map(|k| unit(g, k).bare))
}

/// By its components.
pub fn vector<'g>(component: impl FnMut(usize) -> Scalar<'g>) -> On<'g, Vec3> {
    let components = [0, 1, 2].map(component);
    components[0].g.on(components.map(|component| component.bare))
}

pub fn transposed(m: &Mat3) -> Mat3 {
    std::array::from_fn(|i| std::array::from_fn(|j| m[j][i]))
}

pub fn column(m: &Mat3, k: usize) -> Vec3 {
    [m[0][k], m[1][k], m[2][k]]
}

impl<'g> On<'g, Vec3> {
    pub fn parts(self) -> [Scalar<'g>; 3] {
        self.bare.map(|part| self.g.on(part))
    }

    /// A component.
    pub fn at(self, k: usize) -> Scalar<'g> {
        self.g.on(self.bare[k])
    }

    pub fn is_zero(self) -> bool {
        is_zero(&self.g.graph(), self.bare)
    }

    pub fn dot(self, other: impl Bare<Vec3>) -> Scalar<'g> {
        let node = dot(&mut self.g.graph(), self.bare, other.bare());
        self.g.on(node)
    }

    pub fn cross(self, other: impl Bare<Vec3>) -> Self {
        let (a, b) = (self, self.g.on(other.bare()));
        if a.is_zero() || b.is_zero() {
            return zero(self.g);
        }
        vector(|k| {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            a.at(i) * b.at(j) - a.at(j) * b.at(i)
        })
    }

    /// Of length one.
    pub fn normalized(self) -> Self {
        let length = self.dot(self).sqrt();
        vector(|k| self.at(k) / length)
    }

    /// Turned about z. A constant that x and y have in common is left out of the turn: half of what is turned elsewhere is half of the result.
    pub fn turned_about_z(self, cos: Scalar<'g>, sin: Scalar<'g>) -> Self {
        let [x, y, z] = self.parts();
        let turned = |x: Scalar<'g>, y: Scalar<'g>| [cos * x - sin * y, sin * x + cos * y];
        let [x, y] = match x.common_coefficient(y) {
            Some((k, [x, y])) => turned(x, y).map(|part| k * part),
            None => turned(x, y),
        };
        self.g.on([x.bare, y.bare, z.bare])
    }
}

/// Most of what is multiplied is aligned with an axis.
fn dot(g: &mut Graph, a: Vec3, b: Vec3) -> Node {
    let mut sum = None;
    for k in 0..3 {
        if g.is_zero(a[k]) || g.is_zero(b[k]) {
            continue;
        }
        let product = g.mul(a[k], b[k]);
        sum = Some(sum.map_or(product, |sum| g.add(sum, product)));
    }
    sum.unwrap_or_else(|| g.constant(0.0))
}

fn is_zero(g: &Graph, a: Vec3) -> bool {
    a.iter().all(|part| g.is_zero(*part))
}

fn apply(g: &mut Graph, m: &Mat3, a: Vec3) -> Vec3 {
    if is_zero(g, a) { a } else { m.map(|row| dot(g, row, a)) }
}

impl<'g> On<'g, Mat3> {
    pub fn row(self, k: usize) -> On<'g, Vec3> {
        self.g.on(self.bare[k])
    }

    pub fn column(self, k: usize) -> On<'g, Vec3> {
        self.g.on(column(&self.bare, k))
    }

    pub fn transposed(self) -> Self {
        self.g.on(transposed(&self.bare))
    }

    pub fn map_rows(self, f: impl Fn(On<'g, Vec3>) -> On<'g, Vec3>) -> Self {
        self.g.on(self.bare.map(|row| f(self.g.on(row)).bare))
    }

    pub fn map_columns(self, f: impl Fn(On<'g, Vec3>) -> On<'g, Vec3>) -> Self {
        self.transposed().map_rows(f).transposed()
    }
}

impl<'g, B: Bare<Vec3>> Add<B> for On<'g, Vec3> {
    type Output = Self;
    fn add(self, other: B) -> Self {
        let (a, b, mut g) = (self.bare, other.bare(), self.g.graph());
        self.g.on([0, 1, 2].map(|k| g.add(a[k], b[k])))
    }
}

impl<'g, B: Bare<Vec3>> Sub<B> for On<'g, Vec3> {
    type Output = Self;
    fn sub(self, other: B) -> Self {
        let (a, b, mut g) = (self.bare, other.bare(), self.g.graph());
        self.g.on([0, 1, 2].map(|k| g.sub(a[k], b[k])))
    }
}

impl<'g, B: Bare<Vec3>> AddAssign<B> for On<'g, Vec3> {
    fn add_assign(&mut self, other: B) {
        *self = *self + other;
    }
}

impl<'g> Neg for On<'g, Vec3> {
    type Output = Self;
    fn neg(self) -> Self {
        let mut g = self.g.graph();
        self.g.on(self.bare.map(|part| g.neg(part)))
    }
}

impl<'g> Mul<Vec3> for Scalar<'g> {
    type Output = On<'g, Vec3>;
    fn mul(self, vector: Vec3) -> On<'g, Vec3> {
        let mut g = self.g.graph();
        self.g.on(vector.map(|part| g.mul(self.bare, part)))
    }
}

impl<'g> Mul<On<'g, Vec3>> for Scalar<'g> {
    type Output = On<'g, Vec3>;
    fn mul(self, vector: On<'g, Vec3>) -> On<'g, Vec3> {
        self * vector.bare
    }
}

impl<'g> Mul<On<'g, Vec3>> for f64 {
    type Output = On<'g, Vec3>;
    fn mul(self, vector: On<'g, Vec3>) -> On<'g, Vec3> {
        vector.g.number(self) * vector.bare
    }
}

impl<'g> Mul<On<'g, Vec3>> for Mat3 {
    type Output = On<'g, Vec3>;
    fn mul(self, vector: On<'g, Vec3>) -> On<'g, Vec3> {
        let product = apply(&mut vector.g.graph(), &self, vector.bare);
        vector.g.on(product)
    }
}

impl<'g> Mul<On<'g, Vec3>> for On<'g, Mat3> {
    type Output = On<'g, Vec3>;
    fn mul(self, vector: On<'g, Vec3>) -> On<'g, Vec3> {
        self.bare * vector
    }
}

impl<'g> Mul<Vec3> for On<'g, Mat3> {
    type Output = On<'g, Vec3>;
    fn mul(self, vector: Vec3) -> On<'g, Vec3> {
        self.bare * self.g.on(vector)
    }
}

impl<'g, B: Bare<Mat3>> Mul<B> for On<'g, Mat3> {
    type Output = On<'g, Mat3>;
    fn mul(self, other: B) -> On<'g, Mat3> {
        let mut g = self.g.graph();
        let columns = transposed(&other.bare()).map(|column| apply(&mut g, &self.bare, column));
        self.g.on(transposed(&columns))
    }
}
