//! How far a beam draws its places in as it bends: by −½ pᵀ Γ(x) p along the axis, with Γ_jk = ∫ N_j′ N_k′ dx, because the axis keeps
//! its length. That is of second order in the coordinates, and what an axial force does to bending, as in a beam that is spun or under a thrust,
//! follows from it (Kane, Ryan, Banerjee, J. Guidance 10, 1987; Wallrapp, Schwertassek, Int. J. Numer. Meth. Eng. 32, 1991).
//!
//! Γ are functions along the axis as shapes are, and all products have their means: T is the whole ½ ∫ |ṙ|² of these places.

use super::{Mode, Shapes, Slender, gauss};

/// Γ of two modes of one way of bending, of which the first is not behind the second.
#[derive(Clone, Copy, Debug)]
pub struct Shortening {
    pub modes: (usize, usize),
    /// Mean over the length of the integral from the start on, 1/m, where the frame is to stay in the centre of mass: shapes `free`.
    offset: f64,
    /// Of what size Γ is at most, 1/m, to tell what is zero but for rounding.
    size: f64,
}

impl Slender {
    /// With Γ behind the shapes in the means.
    pub fn stiffened(mut self) -> Self {
        // What moves across two ways has slopes across one another.
        let way = |mode: usize| self.modes[mode].way;
        let bending: Vec<usize> = (0..self.modes.len()).filter(|mode| way(*mode).bends()).collect();
        let pairs = bending.iter().flat_map(|j| bending.iter().map(move |k| (*j, *k)));
        let pairs: Vec<(usize, usize)> = pairs.filter(|(j, k)| j <= k && way(*j) == way(*k)).collect();
        let shapes = self.first.len();
        let functions = |(share, weight): (f64, f64)| {
            let mut values = vec![self.from + share * self.length];
            values.extend(self.modes.iter().map(|mode| mode.shape.at(share, 0)));
            values.extend(self.drawn(&pairs, share));
            (weight, values)
        };
        let mut along: Vec<(f64, Vec<f64>)> = gauss::finest().points().map(functions).collect();
        let ends = self.drawn(&pairs, 1.0);
        let own = |mode: usize| ends[pairs.iter().position(|pair| *pair == (mode, mode)).unwrap_or(0)];
        let is_free = self.shapes == Shapes::Free;
        let shortening = |(index, modes): (usize, &(usize, usize))| {
            let mean: f64 = along.iter().map(|(weight, values)| weight * values[shapes + index]).sum();
            let size = (own(modes.0) * own(modes.1)).sqrt();
            let offset = if is_free { mean } else { 0.0 };
            Shortening { modes: *modes, offset, size }
        };
        self.shortenings = pairs.iter().enumerate().map(shortening).collect();
        for (_, values) in &mut along {
            values[shapes..].iter_mut().zip(&self.shortenings).for_each(|(value, it)| *value -= it.offset);
        }
        let mean = |i: usize, k: usize| -> f64 {
            along.iter().map(|(weight, values)| weight * values[i] * values[k]).sum()
        };
        let count = shapes + pairs.len();
        let sizes: Vec<f64> = (0..count).map(|i| mean(i, i).sqrt()).collect();
        for i in shapes..count {
            let whole: f64 = along.iter().map(|(weight, values)| weight * values[i]).sum();
            self.first.push(if is_free { 0.0 } else { crisp(whole, sizes[i]) });
            let row: Vec<f64> = (0..=i).map(|k| crisp(mean(i, k), sizes[i] * sizes[k])).collect();
            self.second.iter_mut().zip(&row).for_each(|(other, entry)| other.push(*entry));
            self.second.push(row);
        }
        self
    }

    /// Each Γ at x, 1/m, in the order of `shortenings`.
    pub fn shortenings_at(&self, x: f64) -> Vec<f64> {
        let pairs: Vec<(usize, usize)> = self.shortenings.iter().map(|it| it.modes).collect();
        let sums = self.drawn(&pairs, self.share(x));
        self.shortenings.iter().zip(sums).map(|(it, sum)| crisp(sum - it.offset, it.size)).collect()
    }

    /// Where Γ of two modes stands among the means.
    pub fn shortening_of(&self, j: usize, k: usize) -> Option<usize> {
        let modes = (j.min(k), j.max(k));
        let index = self.shortenings.iter().position(|it| it.modes == modes)?;
        Some(1 + self.modes.len() + index)
    }

    /// ∫ N_j′ N_k′ over a part of the length from the start on, pair by pair.
    fn drawn(&self, pairs: &[(usize, usize)], share: f64) -> Vec<f64> {
        let mut sums = vec![0.0; pairs.len()];
        for (part, weight) in gauss::finest().points() {
            let slope = |mode: &Mode| mode.shape.at(share * part, 1) / self.length;
            let slopes: Vec<f64> = self.modes.iter().map(slope).collect();
            for (sum, (j, k)) in sums.iter_mut().zip(pairs) {
                *sum += share * self.length * weight * slopes[*j] * slopes[*k];
            }
        }
        sums
    }
}

/// What is zero by the parity of shapes is that to the last digit.
fn crisp(value: f64, scale: f64) -> f64 {
    if value.abs() < 1e-13 * scale { 0.0 } else { value }
}
