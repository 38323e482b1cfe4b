//! What M and the inertia forces of a deforming body take of a finite element model: sums over its nodes.

use super::model::ROWS;
use linkwright_compiler::modal::{Node, Reduced, Square};

/// A node by its number and its place, m.
pub type Placed = (u64, [f64; 3]);

/// The mass matrix of nodes k and l, where it moves them alike along all axes and leaves turns alone.
pub struct Masses {
    /// m_kl, kg.
    pub moved: Vec<(usize, usize, f64)>,
    /// J_kl of what turns, kg m².
    pub turned: Vec<(usize, usize, [[f64; 3]; 3])>,
}

/// Modes by their shapes, each a number for each row of the model.
pub struct Modes<'m> {
    pub nodes: &'m [Placed],
    pub masses: &'m Masses,
    pub shapes: &'m [Vec<f64>],
}

impl Modes<'_> {
    /// ∫ f fᵀ dm = Σ m_kl f_k f_lᵀ with f = (x, y, z, φ_1x, …), and of what turns Σ J_kl, Σ J_kl ψ_l, for the nodes that are kept.
    pub fn reduced(&self, generalised_mass: Square, stiffness: Square, kept: &[usize]) -> Reduced {
        let n = self.shapes.len();
        let values = self.values();
        let mut moments = vec![vec![0.0; values.len()]; values.len()];
        for i in 0..values.len() {
            for k in 0..=i {
                let sum = self.moved(|node| values[i][node], |node| values[k][node]);
                (moments[i][k], moments[k][i]) = (sum, sum);
            }
        }
        let mass = self.moved(|_| 1.0, |_| 1.0);
        let first: Vec<f64> = values.iter().map(|row| self.moved(|_| 1.0, |node| row[node])).collect();
        let trace = moments[0][0] + moments[1][1] + moments[2][2];
        let placed = |i: usize, k: usize| if i == k { trace - moments[i][i] } else { -moments[i][k] };
        // (r × φ)_a = r_b φ_c − r_c φ_b.
        let swept = |mode: usize, a: usize| {
            let (b, c) = ((a + 1) % 3, (a + 2) % 3);
            moments[b][3 + 3 * mode + c] - moments[c][3 + 3 * mode + b]
        };
        let turn = |mode: usize, node: usize, b: usize| self.shapes[mode][ROWS * node + 3 + b];
        Reduced {
            mass,
            center: [0, 1, 2].map(|axis| first[axis] / mass),
            inertia: [0, 1, 2].map(|i| {
                [0, 1, 2].map(|k| placed(i, k) + self.turned(i, |_, b| f64::from(u8::from(b == k))))
            }),
            momentum: (0..n).map(|j| [0, 1, 2].map(|axis| first[3 + 3 * j + axis])).collect(),
            angular_momentum: (0..n)
                .map(|j| [0, 1, 2].map(|a| swept(j, a) + self.turned(a, |node, b| turn(j, node, b))))
                .collect(),
            generalised_mass,
            stiffness,
            nodes: kept.iter().map(|node| self.node(*node)).collect(),
            numbers: (1..=n).collect(),
            moments,
        }
    }

    /// f, function by function, of each node.
    fn values(&self) -> Vec<Vec<f64>> {
        let places = (0..3).map(|axis| self.nodes.iter().map(|node| node.1[axis]).collect());
        let shapes = self.shapes.iter().flat_map(|shape| {
            (0..3).map(|axis| shape.iter().skip(axis).step_by(ROWS).copied().collect::<Vec<f64>>())
        });
        places.chain(shapes).collect()
    }

    fn moved(&self, a: impl Fn(usize) -> f64, b: impl Fn(usize) -> f64) -> f64 {
        self.masses.moved.iter().map(|(k, l, mass)| mass * a(*k) * b(*l)).sum()
    }

    /// e_a · Σ J_kl ψ_l.
    fn turned(&self, a: usize, turn: impl Fn(usize, usize) -> f64) -> f64 {
        let about = |l: usize, row: &[f64; 3]| -> f64 { (0..3).map(|b| row[b] * turn(l, b)).sum() };
        self.masses.turned.iter().map(|(_, l, inertia)| about(*l, &inertia[a])).sum()
    }

    fn node(&self, node: usize) -> Node {
        let rows = |from: usize| {
            self.shapes.iter().map(|shape| [0, 1, 2].map(|axis| shape[ROWS * node + from + axis])).collect()
        };
        Node { number: self.nodes[node].0, at: self.nodes[node].1, shifts: rows(0), turns: rows(3) }
    }
}
