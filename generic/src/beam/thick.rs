//! Timoshenko's shapes: sums of exponentials and waves that solve N″ − ψ′ + b² s² N = 0 and ψ″ + (N′ − ψ)/s² + b² r² ψ = 0 in ξ = x/L, where b is such that
//! four of them keep the conditions at both ends. r² = I/(A L²), s² = E I/(κ G A L²), b² = ρ A L⁴ ω²/(E I).

use super::shape::slices;
use std::f64::consts::FRAC_PI_2;

/// A mode: N and ψ by the parts e^(−αξ), e^(α(ξ − 1)), cos βξ, sin βξ.
#[derive(Clone, Debug)]
pub(crate) struct Sheared {
    waves: Waves,
    parts: [f64; 4],
}

#[derive(Clone, Copy, Debug)]
struct Waves {
    alpha: f64,
    beta: f64,
    /// ψ of each by N.
    falling: f64,
    waving: f64,
}

impl Sheared {
    /// N and ψ, or derivatives by ξ.
    pub fn at(&self, xi: f64, order: usize) -> [f64; 2] {
        self.waves.at(xi, order).map(|row| row.iter().zip(&self.parts).map(|(a, b)| a * b).sum())
    }
}

impl Waves {
    fn new(b: f64, r2: f64, s2: f64) -> Self {
        let root = ((r2 - s2).powi(2) + 4.0 / (b * b)).sqrt();
        let alpha = b * (0.5 * (root - r2 - s2)).sqrt();
        let beta = b * (0.5 * (root + r2 + s2)).sqrt();
        Waves { alpha, beta, falling: alpha + b * b * s2 / alpha, waving: beta - b * b * s2 / beta }
    }

    fn at(&self, xi: f64, order: usize) -> [[f64; 4]; 2] {
        let Waves { alpha, beta, falling, waving } = *self;
        let n = order as i32;
        let (down, up) = ((-alpha).powi(n) * (-alpha * xi).exp(), alpha.powi(n) * (alpha * (xi - 1.0)).exp());
        let (sin, cos) = (beta * xi + order as f64 * FRAC_PI_2).sin_cos();
        let (sin, cos) = (beta.powi(n) * sin, beta.powi(n) * cos);
        [[down, up, cos, sin], [-falling * down, falling * up, -waving * sin, waving * cos]]
    }

    /// What is zero at both ends.
    fn conditions(&self, shapes: &str) -> [[f64; 4]; 4] {
        let end = |xi: f64| {
            let ([n, psi], [n1, moment]) = (self.at(xi, 0), self.at(xi, 1));
            let shear = [0, 1, 2, 3].map(|k| n1[k] - psi[k]);
            match shapes {
                "pinned" => [n, moment],
                "clamped" if xi == 0.0 => [n, psi],
                _ => [moment, shear],
            }
        };
        let ([a, b], [c, d]) = (end(0.0), end(1.0));
        [a, b, c, d].map(|row| {
            let size = row.iter().map(|it| it * it).sum::<f64>().sqrt();
            row.map(|it| it / size)
        })
    }
}

/// The determinant, and what the matrix makes nothing of where that is zero: elimination with the largest pivots.
fn eliminated(mut rows: [[f64; 4]; 4]) -> (f64, [f64; 4]) {
    let mut order = [0, 1, 2, 3];
    let mut determinant = 1.0;
    for step in 0..4 {
        let places = (step..4).flat_map(|i| (step..4).map(move |k| (i, k)));
        let size = |(i, k): (usize, usize)| rows[i][order[k]].abs();
        let Some((row, column)) = places.max_by(|a, b| size(*a).total_cmp(&size(*b))) else { continue };
        if (row == step) != (column == step) {
            determinant = -determinant;
        }
        rows.swap(row, step);
        order.swap(column, step);
        let pivot = rows[step][order[step]];
        determinant *= pivot;
        let above = rows[step];
        for row in &mut rows[step + 1..] {
            let factor = if pivot == 0.0 { 0.0 } else { row[order[step]] / pivot };
            row.iter_mut().zip(&above).for_each(|(entry, above)| *entry -= factor * above);
        }
    }
    let mut parts = [0.0; 4];
    parts[order[3]] = 1.0;
    for step in (0..3).rev() {
        let sum: f64 = (step + 1..4).map(|k| rows[step][order[k]] * parts[order[k]]).sum();
        parts[order[step]] = -sum / rows[step][order[step]];
    }
    (determinant, parts)
}

/// The slowest modes: ∫ N² + r² ψ² = 1, of two hinges the amplitude 1; positive at the start, what is held there bent that way.
pub(super) fn modes(shapes: &str, count: usize, r2: f64, s2: f64) -> Vec<Sheared> {
    // In √b roots of slender beams are about π apart.
    let value = |root: f64| eliminated(Waves::new(root * root, r2, s2).conditions(shapes)).0;
    let (mut low, mut found) = (0.05, Vec::new());
    while found.len() < count && low < 200.0 {
        let (high, start) = (low + 0.02, value(low));
        if start * value(high) < 0.0 {
            let (mut below, mut above) = (low, high);
            for _ in 0..60 {
                let half = 0.5 * (below + above);
                if value(half) * start > 0.0 { below = half } else { above = half }
            }
            found.push(mode(shapes, (0.5 * (below + above)).powi(2), r2, s2));
        }
        low = high;
    }
    found
}

fn mode(shapes: &str, b: f64, r2: f64, s2: f64) -> Sheared {
    let waves = Waves::new(b, r2, s2);
    let parts = eliminated(waves.conditions(shapes)).1;
    let mut found = Sheared { waves, parts };
    let scale = if shapes == "pinned" {
        1.0 / parts[3]
    } else {
        let square = |xi: f64| {
            let [n, psi] = found.at(xi, 0);
            n * n + r2 * psi * psi
        };
        let mean: f64 = slices().iter().map(|(xi, weight)| weight * square(*xi)).sum();
        let sign = if shapes == "free" { found.at(0.0, 0)[0] } else { found.at(0.0, 1)[1] };
        sign.signum() / mean.sqrt()
    };
    found.parts.iter_mut().for_each(|part| *part *= scale);
    found
}
