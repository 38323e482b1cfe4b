//! A few points that weigh alike and have the same integrals as the whole body, so that energies can be summed over points.

use super::{Reduced, eigen};

/// One of them: its place, and how each mode moves it.
pub struct MassPoint {
    /// Part of the mass.
    pub share: f64,
    pub at: [f64; 3],
    pub shifts: Vec<[f64; 3]>,
}

impl Reduced {
    /// With C = ∫ (1, f)(1, f)ᵀ dm / m = F Fᵀ, as many points as F has columns: a reflection of the columns makes their first entries equal, and
    /// times the root of their number they are the points' (1, f).
    pub fn points(&self) -> Vec<MassPoint> {
        let whole = self.whole();
        let count = whole.len();
        // Functions of sizes of their own, so that what is small keeps its digits.
        let sizes: Vec<f64> = (0..count).map(|i| whole[i][i].max(0.0).sqrt()).collect();
        let over = |i: usize| if sizes[i] > 0.0 { 1.0 / sizes[i] } else { 0.0 };
        let scaled = (0..count).map(|i| (0..count).map(|k| whole[i][k] * over(i) * over(k)).collect());
        let (values, v) = eigen(&scaled.collect());
        let column = |k: usize| -> Vec<f64> {
            let root = values[k].max(0.0).sqrt();
            (0..count).map(|i| sizes[i] * v[i][k] * root).collect()
        };
        let mut columns: Vec<Vec<f64>> = (0..count).map(column).collect();
        reflect(&mut columns);
        let number = (count as f64).sqrt();
        let point = |column: &Vec<f64>| {
            let at = |i: usize| number * column[i];
            MassPoint {
                share: 1.0 / count as f64,
                at: [at(1), at(2), at(3)],
                shifts: (0..self.modes()).map(|j| [4, 5, 6].map(|axis| at(3 * j + axis))).collect(),
            }
        };
        columns.iter().map(point).collect()
    }
}

/// Householder's reflection that makes the first entries of columns equal, whose squares add up to one.
fn reflect(columns: &mut [Vec<f64>]) {
    let equal = 1.0 / (columns.len() as f64).sqrt();
    let way: Vec<f64> = columns.iter().map(|column| column[0] - equal).collect();
    let square: f64 = way.iter().map(|it| it * it).sum();
    if square < 1e-30 {
        return;
    }
    for row in 0..columns[0].len() {
        let along: f64 = columns.iter().zip(&way).map(|(column, way)| column[row] * way).sum();
        let factor = 2.0 * along / square;
        columns.iter_mut().zip(&way).for_each(|(column, way)| column[row] -= factor * way);
    }
}
