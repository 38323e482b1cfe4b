//! Small symmetric matrices: factors, eigenvalues, roots.

/// Row after row.
pub type Square = Vec<Vec<f64>>;

/// Sweeps of Jacobi's rotations, which converge quadratically: six are enough for a hundred rows.
const SWEEPS: usize = 60;

/// L of M = L Lᵀ; `None` where M is not positive definite.
pub fn cholesky(matrix: &Square) -> Option<Square> {
    let n = matrix.len();
    let mut l = vec![vec![0.0; n]; n];
    for i in 0..n {
        for k in 0..=i {
            let sum: f64 = (0..k).map(|m| l[i][m] * l[k][m]).sum();
            let rest = matrix[i][k] - sum;
            if i > k {
                l[i][k] = rest / l[k][k];
            } else if rest > 0.0 {
                l[i][i] = rest.sqrt();
            } else {
                return None;
            }
        }
    }
    Some(l)
}

/// L⁻¹ K L⁻ᵀ.
pub fn reduced(l: &Square, stiffness: &Square) -> Square {
    let solved = |columns: &Square| -> Square {
        let mut rows = columns.clone();
        for (i, factors) in l.iter().enumerate() {
            let (before, from) = rows.split_at_mut(i);
            for (row, factor) in before.iter().zip(factors) {
                from[0].iter_mut().zip(row).for_each(|(entry, above)| *entry -= factor * above);
            }
            from[0].iter_mut().for_each(|entry| *entry /= factors[i]);
        }
        rows
    };
    solved(&transposed(&solved(stiffness)))
}

fn transposed(matrix: &Square) -> Square {
    (0..matrix.len()).map(|i| matrix.iter().map(|row| row[i]).collect()).collect()
}

/// Eigenvalues and eigenvectors, column by column, of a symmetric matrix, by Jacobi's rotations (Golub, Van Loan, *Matrix Computations*, 8.5).
pub fn eigen(matrix: &Square) -> (Vec<f64>, Square) {
    let n = matrix.len();
    let mut a = matrix.clone();
    let mut v: Square = (0..n).map(|i| (0..n).map(|k| f64::from(u8::from(i == k))).collect()).collect();
    for _ in 0..SWEEPS {
        let off: f64 = (0..n).flat_map(|i| (0..i).map(move |k| (i, k))).map(|(i, k)| a[i][k].powi(2)).sum();
        let on: f64 = (0..n).map(|i| a[i][i].powi(2)).sum();
        if off <= 1e-34 * on {
            break;
        }
        for p in 0..n {
            for q in p + 1..n {
                if a[p][q] == 0.0 {
                    continue;
                }
                let tau = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
                let t = if tau == 0.0 { 1.0 } else { tau.signum() / (tau.abs() + tau.hypot(1.0)) };
                let c = 1.0 / t.hypot(1.0);
                let s = t * c;
                for row in &mut a {
                    (row[p], row[q]) = (c * row[p] - s * row[q], s * row[p] + c * row[q]);
                }
                let (before, from) = a.split_at_mut(q);
                for (x, y) in before[p].iter_mut().zip(&mut from[0]) {
                    (*x, *y) = (c * *x - s * *y, s * *x + c * *y);
                }
                for row in &mut v {
                    (row[p], row[q]) = (c * row[p] - s * row[q], s * row[p] + c * row[q]);
                }
            }
        }
    }
    ((0..n).map(|i| a[i][i]).collect(), v)
}

/// The root of a matrix without negative eigenvalues; those that are negative by rounding count as nothing.
pub fn root(matrix: &Square) -> Square {
    let n = matrix.len();
    let (values, v) = eigen(matrix);
    let roots: Vec<f64> = values.iter().map(|value| value.max(0.0).sqrt()).collect();
    let entry = |i: usize, k: usize| -> f64 { (0..n).map(|m| v[i][m] * roots[m] * v[k][m]).sum() };
    (0..n).map(|i| (0..n).map(|k| entry(i, k)).collect()).collect()
}
