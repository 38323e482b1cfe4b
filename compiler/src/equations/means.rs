//! Means over the mass of the functions that fields of a beam are sums of: x, the shapes N_j, and where bending draws places in
//! D_j = −Σ_k Γ_jk p_k and E = −ṗᵀ Γ ṗ. Of x and shapes they are constants, of D and E polynomials: that of D_j D_k is a linear form in the
//! products p_l p_m, that of D_j E is Σ_l p_l g_jl with g a linear form in ṗ_m ṗ_n. All n³ and more of their numbers are in these forms, which M,
//! forces and energies share.

use crate::beams::{Shortening, Slender};
use crate::symbolic::{Node, Scalar, Sheet};

/// The coordinate of a mode and its rate.
#[derive(Clone, Copy, Debug)]
pub struct Bent {
    pub value: Node,
    pub rate: Node,
}

/// In the order x, N, D, E; without D and E of a beam that does not stiffen.
pub struct Means<'g> {
    g: Sheet<'g>,
    first: Vec<Scalar<'g>>,
    second: Vec<Vec<Scalar<'g>>>,
}

impl<'g> Means<'g> {
    pub fn new(g: Sheet<'g>, slender: &Slender, modes: &[Bent]) -> Self {
        let constants = 1 + modes.len();
        let numbers = |row: &[f64]| row[..constants].iter().map(|mean| g.number(*mean)).collect();
        let first = numbers(&slender.first);
        let second = slender.second[..constants].iter().map(|row| numbers(row)).collect();
        let mut means = Means { g, first, second };
        if !slender.shortenings.is_empty() {
            means.stiffen(slender, modes);
        }
        means
    }

    /// Of functions whose means are constants.
    pub fn of_constants(g: Sheet<'g>, first: &[f64], second: &[Vec<f64>]) -> Self {
        let numbers = |row: &[f64]| row.iter().map(|mean| g.number(*mean)).collect();
        Means { g, first: numbers(first), second: second.iter().map(|row| numbers(row)).collect() }
    }

    /// ∫ φ_i over the mass, by the mass.
    pub fn first(&self, i: usize) -> Scalar<'g> {
        self.first[i]
    }

    /// ∫ φ_i φ_k over the mass, by the mass.
    pub fn second(&self, i: usize, k: usize) -> Scalar<'g> {
        self.second[i][k]
    }

    /// Adds D and E.
    fn stiffen(&mut self, slender: &Slender, modes: &[Bent]) {
        let g = self.g;
        let value = |mode: usize| g.on(modes[mode].value);
        let drawn_by =
            |row: &[f64], j: usize| g.sum((0..modes.len()).map(|k| -gamma(slender, row, j, k) * value(k)));
        let faster = |row: &[f64]| {
            g.sum(slender.shortenings.iter().enumerate().map(|(index, Shortening { modes: (m, n), .. })| {
                let times = if m == n { 1.0 } else { 2.0 };
                let mean = row[1 + modes.len() + index];
                -(times * mean) * (g.on(modes[*m].rate) * modes[*n].rate)
            }))
        };
        // Of a row of the constants, that of a function with all others.
        let beyond = |row: &[f64]| {
            (0..modes.len()).map(|j| drawn_by(row, j)).chain([faster(row)]).collect::<Vec<Scalar>>()
        };
        self.first.extend(beyond(&slender.first));
        for (own, row) in self.second.iter_mut().zip(&slender.second) {
            own.extend(beyond(row));
        }
        for j in 0..modes.len() {
            let constants = &self.second[..1 + modes.len()];
            let mut own: Vec<Scalar> = constants.iter().map(|row| row[1 + modes.len() + j]).collect();
            for k in 0..modes.len() {
                let pairs = (0..modes.len()).flat_map(|l| (l..modes.len()).map(move |m| (l, m)));
                let both = |l: usize, m: usize| {
                    let row = slender.shortening_of(j, l).map(|at| &slender.second[at]);
                    row.map_or(0.0, |row| gamma(slender, row, k, m))
                };
                own.push(g.sum(pairs.map(|(l, m)| {
                    let mean = if l == m { both(l, m) } else { both(l, m) + both(m, l) };
                    mean * (value(l) * value(m).bare)
                })));
            }
            let with = |l: usize| slender.shortening_of(j, l).map(|at| (l, &slender.second[at]));
            let terms = (0..modes.len()).filter_map(with);
            own.push(g.sum(terms.map(|(l, row)| -(value(l) * faster(row)))));
            self.second.push(own);
        }
        let last: Vec<Scalar> = self.second.iter().map(|row| row[1 + 2 * modes.len()]).collect();
        // Two accelerations are never multiplied with one another.
        self.second.push(last);
    }
}

/// The mean with Γ_jk out of those with all functions.
fn gamma(slender: &Slender, row: &[f64], j: usize, k: usize) -> f64 {
    slender.shortening_of(j, k).map_or(0.0, |at| row[at])
}
