//! Shapes that are polynomials and vanish at the start, with their direction in bending: Ritz's method in the space of all of them up to a
//! degree. That space has the exact deflection under a moment (ξ²) and a force (ξ³) at the end and under a load along the beam (ξ⁴), and the
//! exact stretch under a force (ξ) and a load along it (ξ²), which modes of vibration only sum up to.
//!
//! The basis is what Legendre's polynomials P_k(2ξ − 1) become when integrated once (axial) or twice (bending) from the start: its matrix of
//! stiffness is the unit matrix, and that of mass has no entries far from its diagonal, so that twelve shapes are found to rounding (Szabó, Babuška,
//! *Finite Element Analysis*, 3.1).

/// A polynomial and its derivatives, each by its coefficients of Legendre's polynomials on [0, 1].
#[derive(Clone, Debug)]
pub struct Polynomial {
    derivatives: Vec<Vec<f64>>,
}

/// A shape whose square has the mean 1, positive at the end, and the mean of its squared first or second derivative by ξ.
pub struct Found {
    pub shape: Polynomial,
    pub stiffness: f64,
}

impl Polynomial {
    /// The derivative of an order by ξ, up to that of the stiffness; what is zero but for rounding is zero.
    pub fn at(&self, share: f64, order: usize) -> f64 {
        let Some(coefficients) = self.derivatives.get(order) else { return f64::NAN };
        let x = 2.0 * share - 1.0;
        let (mut before, mut legendre, mut sum, mut size) = (0.0, 1.0, 0.0, 0.0);
        for (k, coefficient) in coefficients.iter().enumerate() {
            sum += coefficient * legendre;
            size += coefficient.abs();
            let k = k as f64;
            (before, legendre) = (legendre, ((2.0 * k + 1.0) * x * legendre - k * before) / (k + 1.0));
        }
        if sum.abs() < 1e-14 * size { 0.0 } else { sum }
    }
}

/// As many shapes, whose derivative of an order is any polynomial of a degree less than `count`: across to one another in mass and stiffness, the
/// slowest first.
pub fn shapes(count: usize, order: usize) -> Vec<Found> {
    // Row k: the integral of √(2k + 1) P_k, whose square has the mean 1.
    let unit = |k: usize| (0..=k).map(move |at| if at == k { (2.0 * k as f64 + 1.0).sqrt() } else { 0.0 });
    let stiff: Vec<Vec<f64>> = (0..count).map(|k| unit(k).collect()).collect();
    let soft: Vec<Vec<f64>> =
        stiff.iter().map(|row| (0..order).fold(row.clone(), |row, _| integrated(&row))).collect();
    let mean = |one: &[f64], other: &[f64]| -> f64 {
        one.iter().zip(other).enumerate().map(|(k, (a, b))| a * b / (2.0 * k as f64 + 1.0)).sum()
    };
    let mut mass: Vec<Vec<f64>> =
        soft.iter().map(|one| soft.iter().map(|other| mean(one, other)).collect()).collect();
    let vectors = diagonalised(&mut mass);
    let mut found: Vec<Found> = vectors
        .iter()
        .enumerate()
        .map(|(mode, vector)| {
            let square = mass[mode][mode];
            let mut sum = vec![0.0; count];
            for (row, part) in stiff.iter().zip(vector) {
                row.iter().zip(&mut sum).for_each(|(entry, sum)| *sum += part * entry / square.sqrt());
            }
            let mut derivatives = vec![sum];
            for _ in 0..order {
                derivatives.insert(0, integrated(&derivatives[0]));
            }
            let mut shape = Polynomial { derivatives };
            if shape.at(1.0, 0) < 0.0 {
                shape.derivatives.iter_mut().flatten().for_each(|entry| *entry = -*entry);
            }
            Found { shape, stiffness: 1.0 / square }
        })
        .collect();
    found.sort_by(|one, other| one.stiffness.total_cmp(&other.stiffness));
    found
}

/// ∫₀ P_k(2ξ − 1) dξ = (P_{k+1} − P_{k−1})/(2 (2k + 1)), and of P₀ (P₁ + P₀)/2.
fn integrated(coefficients: &[f64]) -> Vec<f64> {
    let mut integral = vec![0.0; coefficients.len() + 1];
    for (k, coefficient) in coefficients.iter().enumerate() {
        let part = 0.5 * coefficient / (2.0 * k as f64 + 1.0);
        integral[k + 1] += part;
        match k.checked_sub(1) {
            Some(before) => integral[before] -= part,
            None => integral[0] += part,
        }
    }
    integral
}

/// Eigenvectors of a symmetric matrix as rows; what is left of it is diagonal. Jacobi's rotations, which keep the digits of small eigenvalues
/// (Golub, Van Loan, *Matrix Computations*, 8.5).
fn diagonalised(matrix: &mut [Vec<f64>]) -> Vec<Vec<f64>> {
    let count = matrix.len();
    let mut vectors: Vec<Vec<f64>> =
        (0..count).map(|i| (0..count).map(|j| if i == j { 1.0 } else { 0.0 }).collect()).collect();
    // The sweeps converge quadratically: a handful are enough.
    for _ in 0..30 {
        let mut is_diagonal = true;
        for p in 0..count {
            for q in p + 1..count {
                let (pp, qq, pq) = (matrix[p][p], matrix[q][q], matrix[p][q]);
                if pq.abs() <= 1e-17 * (pp * qq).abs().sqrt() {
                    continue;
                }
                is_diagonal = false;
                let tau = 0.5 * (qq - pp) / pq;
                let tangent = tau.signum() / (tau.abs() + (1.0 + tau * tau).sqrt());
                let cos = 1.0 / (1.0 + tangent * tangent).sqrt();
                let sin = tangent * cos;
                for row in matrix.iter_mut() {
                    (row[p], row[q]) = (cos * row[p] - sin * row[q], sin * row[p] + cos * row[q]);
                }
                for k in 0..count {
                    let (a, b) = (matrix[p][k], matrix[q][k]);
                    (matrix[p][k], matrix[q][k]) = (cos * a - sin * b, sin * a + cos * b);
                    let (a, b) = (vectors[p][k], vectors[q][k]);
                    (vectors[p][k], vectors[q][k]) = (cos * a - sin * b, sin * a + cos * b);
                }
            }
        }
        if is_diagonal {
            break;
        }
    }
    vectors
}
