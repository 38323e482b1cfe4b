//! Bodies that deform by the modes of a finite element model, as numbers. Nothing here knows of graphs, definitions or files.
//!
//! A material point that is at r in the axes of the body's frame moves by Σ φ_j(r) p_j with the coordinates p of the modes. With the functions
//! f = (x, y, z, φ_1x, φ_1y, φ_1z, φ_2x, …) and their integrals over the mass, m, ∫ f dm and ∫ f fᵀ dm, kinetic energy, M and all
//! inertia forces are known: the invariants I1 to I9 (Shabana, *Dynamics of Multibody Systems*, 5.3; Wallrapp, *Standardization of flexible body
//! modeling*, 1994) are sums of their entries. What sections and nodes have by turning, T = ½ ω·J ω + ω·Σ B_j ṗ_j + ½ ṗ·D ṗ, is what the
//! inertia tensor, the angular momenta and the generalised mass have beyond these integrals.

mod linear;
mod points;
mod write;

#[cfg(test)]
mod tests;

pub use linear::{Square, cholesky, eigen, reduced as reduced_by, root};
pub use points::MassPoint;

/// What a file says, in the order of its modes, m, kg, s.
#[derive(Clone, Debug)]
pub struct Reduced {
    pub mass: f64,
    /// About the frame's origin, in its axes.
    pub inertia: [[f64; 3]; 3],
    /// ∫ φ_j dm and the angular momentum of each mode about the origin, ∫ r × φ_j dm and what turns.
    pub momentum: Vec<[f64; 3]>,
    pub angular_momentum: Vec<[f64; 3]>,
    /// ∫ r dm / m.
    pub center: [f64; 3],
    /// ∫ f fᵀ dm.
    pub moments: Square,
    pub generalised_mass: Square,
    pub stiffness: Square,
    pub nodes: Vec<Node>,
    /// Numbers of the modes, from 1, as they are in the file.
    pub numbers: Vec<usize>,
}

/// A place that has a name in the finite element model.
#[derive(Clone, Debug)]
pub struct Node {
    pub number: u64,
    pub at: [f64; 3],
    /// Of each mode: how it moves the node, 1, and how it turns it, 1/m.
    pub shifts: Vec<[f64; 3]>,
    pub turns: Vec<[f64; 3]>,
}

/// T = ½ ω·J ω + ω·Σ B_j ṗ_j + ½ ṗ·D ṗ.
#[derive(Clone, Debug)]
pub struct Rotary {
    pub inertia: [[f64; 3]; 3],
    pub momentum: Vec<[f64; 3]>,
    pub modal: Square,
}

/// What differs by less than this, of its own size, is the same.
pub const EQUAL: f64 = 1e-8;

impl Reduced {
    pub fn modes(&self) -> usize {
        self.numbers.len()
    }

    /// With some of its modes alone, by their numbers from 1.
    pub fn only(&self, modes: std::ops::RangeInclusive<usize>) -> Self {
        let kept: Vec<usize> = modes.map(|number| number - 1).collect();
        let rows = |of: &[[f64; 3]]| kept.iter().map(|mode| of[*mode]).collect::<Vec<_>>();
        let square = |of: &Square, kept: &[usize]| -> Square {
            kept.iter().map(|i| kept.iter().map(|k| of[*i][*k]).collect()).collect()
        };
        let functions: Vec<usize> =
            (0..3).chain(kept.iter().flat_map(|mode| (0..3).map(move |axis| 3 + 3 * mode + axis))).collect();
        let node =
            |node: &Node| Node { shifts: rows(&node.shifts), turns: rows(&node.turns), ..node.clone() };
        Reduced {
            momentum: rows(&self.momentum),
            angular_momentum: rows(&self.angular_momentum),
            moments: square(&self.moments, &functions),
            generalised_mass: square(&self.generalised_mass, &kept),
            stiffness: square(&self.stiffness, &kept),
            nodes: self.nodes.iter().map(node).collect(),
            numbers: kept.iter().map(|mode| self.numbers[*mode]).collect(),
            ..self.clone()
        }
    }

    /// ∫ f dm / m.
    pub fn first(&self) -> Vec<f64> {
        let modal = self.momentum.iter().flatten().map(|it| it / self.mass);
        self.center.iter().copied().chain(modal).collect()
    }

    /// ∫ f fᵀ dm / m.
    pub fn second(&self) -> Square {
        let row = |row: &Vec<f64>| row.iter().map(|it| it / self.mass).collect();
        self.moments.iter().map(row).collect()
    }

    /// ∫ (1, f) (1, f)ᵀ dm / m.
    pub fn whole(&self) -> Square {
        let first = self.first();
        let head: Vec<f64> = std::iter::once(1.0).chain(first.iter().copied()).collect();
        let rows = first.iter().zip(self.second());
        std::iter::once(head)
            .chain(rows.map(|(one, row)| std::iter::once(*one).chain(row).collect()))
            .collect()
    }

    /// What is beyond the integrals of places.
    pub fn rotary(&self) -> Rotary {
        let s = &self.moments;
        let trace = s[0][0] + s[1][1] + s[2][2];
        let placed = |i: usize, k: usize| if i == k { trace - s[i][i] } else { -s[i][k] };
        let scale = |i: usize| placed(i, i).abs() + self.inertia[i][i].abs();
        let difference =
            |i: usize, k: usize| crisp(self.inertia[i][k] - placed(i, k), (scale(i) * scale(k)).sqrt());
        let size =
            |mode: usize| (self.generalised_mass[mode][mode] * (scale(0) + scale(1) + scale(2))).sqrt();
        // (r × φ)_a = r_b φ_c − r_c φ_b.
        let turned = |mode: usize, a: usize| {
            let (b, c) = ((a + 1) % 3, (a + 2) % 3);
            let placed = s[b][3 + 3 * mode + c] - s[c][3 + 3 * mode + b];
            crisp(self.angular_momentum[mode][a] - placed, size(mode))
        };
        let beyond = |j: usize, k: usize| {
            let placed: f64 = (0..3).map(|axis| s[3 + 3 * j + axis][3 + 3 * k + axis]).sum();
            let own = |mode: usize| self.generalised_mass[mode][mode].abs();
            crisp(self.generalised_mass[j][k] - placed, (own(j) * own(k)).sqrt())
        };
        let modes = 0..self.modes();
        Rotary {
            inertia: [0, 1, 2].map(|i| [0, 1, 2].map(|k| difference(i, k))),
            momentum: modes.clone().map(|mode| [0, 1, 2].map(|a| turned(mode, a))).collect(),
            modal: modes.clone().map(|j| modes.clone().map(|k| beyond(j, k)).collect()).collect(),
        }
    }

    /// The tensor about the centre of mass: moments, and products as they stand in the tensor.
    pub fn about_center(&self) -> ([f64; 3], [f64; 3]) {
        let [x, y, z] = self.center;
        let square = x * x + y * y + z * z;
        let at = |i: usize, k: usize| {
            let own = if i == k { square } else { 0.0 };
            let moved = self.mass * (own - self.center[i] * self.center[k]);
            let value = self.inertia[i][k] - moved;
            // Of points on a line, rounding.
            if value.abs() < 1e-13 * moved.abs() { 0.0 } else { value }
        };
        ([at(0, 0), at(1, 1), at(2, 2)], [at(0, 1), at(0, 2), at(1, 2)])
    }

    /// √(K_jj/M_jj), rad/s: of each mode while the others are held.
    pub fn rates(&self) -> Vec<f64> {
        (0..self.modes()).map(|j| (self.stiffness[j][j] / self.generalised_mass[j][j]).sqrt()).collect()
    }

    /// C that gives each natural mode of M and K the damping ratio 1, N s/m: 2 L √(L⁻¹ K L⁻ᵀ) Lᵀ with M = L Lᵀ.
    pub fn critical_damping(&self) -> Square {
        let Some(l) = cholesky(&self.generalised_mass) else { return Vec::new() };
        let root = root(&linear::reduced(&l, &self.stiffness));
        let n = self.modes();
        let half = |i: usize, k: usize| -> f64 { (0..n).map(|m| l[i][m] * root[m][k]).sum() };
        let entry = |i: usize, k: usize| -> f64 { (0..n).map(|m| 2.0 * half(i, m) * l[k][m]).sum() };
        let size = |i: usize| 2.0 * (self.stiffness[i][i] * self.generalised_mass[i][i]).sqrt();
        let tidy = |i: usize, k: usize| {
            let value = if i <= k { entry(i, k) } else { entry(k, i) };
            if value.abs() < 1e-13 * (size(i) * size(k)).sqrt() { 0.0 } else { value }
        };
        (0..n).map(|i| (0..n).map(|k| tidy(i, k)).collect()).collect()
    }

    /// The node at a place, by its index.
    pub fn node_at(&self, at: [f64; 3]) -> Option<usize> {
        self.nodes.iter().position(|node| node.at == at)
    }
}

/// What is nothing but for rounding in the file.
fn crisp(value: f64, size: f64) -> f64 {
    if value.abs() < EQUAL * size { 0.0 } else { value }
}
