//! The loop that friction by reactions closes, written out: forces R that press and are affine in the sizes N of all of them,
//!
//! ```text
//! N_j = Σ_i |R_ji|,    R_ji = R̂_ji + Σ_k r_jik N_k        (N)
//! ```
//! One size that depends on itself alone is the root of a quadratic. Others are found by Newton's method from |R̂|, in a fixed number of
//! passes: with u = R/|R| a pass solves N_j − Σ_k (Σ_i u_ji·r_jik) N_k = Σ_i u_ji·R̂_ji, which is the tangent of |R|. Sizes that
//! depend on each other are solved together, all others one after the other.

use crate::symbolic::{Gradient, Scalar, Sheet};
use std::collections::BTreeMap;

/// Of each N the forces that press, each by its components: R̂ and, by N, r.
pub struct Coupled<'g> {
    pub forces: Vec<Vec<Vec<(Scalar<'g>, Gradient)>>>,
    /// ε² of √(R·R + ε²), N².
    pub smallest: f64,
}

/// N.
pub fn magnitudes<'g>(g: Sheet<'g>, coupled: &Coupled<'g>, passes: usize) -> Vec<Scalar<'g>> {
    let mut known: BTreeMap<usize, Scalar> = BTreeMap::new();
    for together in blocks(&coupled.dependences()) {
        let loop_ = coupled.of(&together, &known);
        let found = match &together[..] {
            [_] if !loop_.is_closed() => vec![loop_.size(g, &loop_.start[0])],
            [_] if loop_.start[0].len() == 1 => vec![loop_.root(g)],
            _ => loop_.iterated(g, passes),
        };
        known.extend(together.into_iter().zip(found));
    }
    known.into_values().collect()
}

impl<'g> Coupled<'g> {
    /// Which N each depends on.
    pub fn dependences(&self) -> Vec<Vec<usize>> {
        let of = |forces: &Vec<Vec<(Scalar, Gradient)>>| {
            let slopes = forces.iter().flatten().flat_map(|(_, slopes)| slopes.keys().copied());
            let mut of: Vec<usize> = slopes.collect();
            of.sort_unstable();
            of.dedup();
            of
        };
        self.forces.iter().map(of).collect()
    }

    /// Σ |R| of each, with these N.
    pub fn sizes(&self, g: Sheet<'g>, normals: &[Scalar<'g>]) -> Vec<Scalar<'g>> {
        let size = |forces: &Vec<Vec<(Scalar<'g>, Gradient)>>| {
            g.sum(forces.iter().map(|force| {
                let components = force.iter().map(|(start, by)| along(g, *start, by, normals).square());
                (g.sum(components) + self.smallest).sqrt()
            }))
        };
        self.forces.iter().map(size).collect()
    }

    /// Those that are found together, the others known.
    fn of(&self, together: &[usize], known: &BTreeMap<usize, Scalar<'g>>) -> Loop<'g> {
        let (mut start, mut slopes) = (Vec::new(), Vec::new());
        for which in together {
            let (mut starts, mut slope) = (Vec::new(), Vec::new());
            for force in &self.forces[*which] {
                let components = force.iter().map(|(own, by)| {
                    by.iter().fold(*own, |sum, (other, slope)| match known.get(other) {
                        Some(size) => sum + *slope * *size,
                        None => sum,
                    })
                });
                starts.push(components.collect::<Vec<_>>());
                let by = |(_, by): &(Scalar, Gradient)| {
                    let own = together.iter().enumerate();
                    own.filter_map(|(at, which)| Some((at, *by.get(which)?))).collect::<Gradient>()
                };
                slope.push(force.iter().map(by).collect::<Vec<_>>());
            }
            start.push(starts);
            slopes.push(slope);
        }
        Loop { start, slopes, smallest: self.smallest }
    }
}

/// Sizes that are found together.
struct Loop<'g> {
    /// R̂, of each N by forces and components.
    start: Vec<Vec<Vec<Scalar<'g>>>>,
    /// r, by N.
    slopes: Vec<Vec<Vec<Gradient>>>,
    smallest: f64,
}

impl<'g> Loop<'g> {
    fn is_closed(&self) -> bool {
        self.slopes.iter().flatten().flatten().any(|slopes| !slopes.is_empty())
    }

    /// √(R·R + ε²).
    fn length(&self, g: Sheet<'g>, force: &[Scalar<'g>]) -> Scalar<'g> {
        (g.sum(force.iter().map(|component| component.square())) + self.smallest).sqrt()
    }

    fn size(&self, g: Sheet<'g>, forces: &[Vec<Scalar<'g>>]) -> Scalar<'g> {
        g.sum(forces.iter().map(|force| self.length(g, force)))
    }

    /// N² = |R̂ + r N|² + ε²: (1 − r·r) N² − 2 R̂·r N − (R̂·R̂ + ε²) = 0, the positive root.
    fn root(&self, g: Sheet<'g>) -> Scalar<'g> {
        let start = &self.start[0][0];
        let slopes: Vec<Scalar> = self.slopes[0][0].iter().map(|by| slope(g, by, 0)).collect();
        let rest = 1.0 - g.sum(slopes.iter().map(|slope| slope.square()));
        let half = g.sum(start.iter().zip(&slopes).map(|(r, slope)| *r * *slope));
        let square = g.sum(start.iter().map(|r| r.square())) + self.smallest;
        (half + (half.square() + rest * square).sqrt()) / rest
    }

    fn iterated(&self, g: Sheet<'g>, passes: usize) -> Vec<Scalar<'g>> {
        let mut sizes: Vec<Scalar> = self.start.iter().map(|forces| self.size(g, forces)).collect();
        for _ in 0..passes {
            let mut rows: Vec<BTreeMap<usize, Scalar>> = Vec::new();
            let mut right = Vec::new();
            for (own, (starts, slopes)) in self.start.iter().zip(&self.slopes).enumerate() {
                let mut row = BTreeMap::from([(own, g.one())]);
                let mut sum = g.zero();
                for (start, by) in starts.iter().zip(slopes) {
                    let force: Vec<Scalar> =
                        start.iter().zip(by).map(|(start, by)| along(g, *start, by, &sizes)).collect();
                    let inverse = self.length(g, &force).reciprocal();
                    for ((component, start), by) in force.iter().zip(start).zip(by) {
                        let unit = *component * inverse;
                        sum += unit * *start;
                        for (other, slope) in by {
                            let entry = row.get(other).copied().unwrap_or_else(|| g.zero());
                            row.insert(*other, entry - unit * *slope);
                        }
                    }
                }
                rows.push(row);
                right.push(sum);
            }
            sizes = solved(g, rows, right);
        }
        sizes
    }
}

/// R̂ + Σ r N.
fn along<'g>(g: Sheet<'g>, start: Scalar<'g>, by: &Gradient, sizes: &[Scalar<'g>]) -> Scalar<'g> {
    by.iter().fold(start, |sum, (which, slope)| sum + g.on(*slope) * sizes[*which])
}

fn slope<'g>(g: Sheet<'g>, by: &Gradient, which: usize) -> Scalar<'g> {
    by.get(&which).map_or_else(|| g.zero(), |slope| g.on(*slope))
}

/// Gauss's elimination in the order of the unknowns: where the loop has one solution its matrix is near one.
fn solved<'g>(
    g: Sheet<'g>,
    mut rows: Vec<BTreeMap<usize, Scalar<'g>>>,
    mut right: Vec<Scalar<'g>>,
) -> Vec<Scalar<'g>> {
    let size = rows.len();
    let mut inverses = Vec::new();
    for pivot in 0..size {
        let row = rows[pivot].clone();
        let inverse = row.get(&pivot).copied().unwrap_or_else(|| g.one()).reciprocal();
        inverses.push(inverse);
        for below in pivot + 1..size {
            let Some(entry) = rows[below].remove(&pivot) else { continue };
            let factor = entry * inverse;
            for (column, value) in row.range(pivot + 1..) {
                let own = rows[below].get(column).copied().unwrap_or_else(|| g.zero());
                rows[below].insert(*column, own - factor * *value);
            }
            right[below] = right[below] - factor * right[pivot];
        }
    }
    for pivot in (0..size).rev() {
        let rest = rows[pivot].range(pivot + 1..);
        let rest = rest.fold(right[pivot], |rest, (column, value)| rest - *value * right[*column]);
        right[pivot] = rest * inverses[pivot];
    }
    right
}

/// Parts of what depends on each other, in an order in which each depends on those before it.
pub fn blocks(dependences: &[Vec<usize>]) -> Vec<Vec<usize>> {
    let size = dependences.len();
    let mut reach = vec![vec![false; size]; size];
    for (from, to) in dependences.iter().enumerate() {
        to.iter().for_each(|to| reach[from][*to] = true);
    }
    for via in 0..size {
        let further = reach[via].clone();
        for own in reach.iter_mut().filter(|own| own[via]) {
            own.iter_mut().zip(&further).for_each(|(to, further)| *to |= further);
        }
    }
    let mut taken = vec![false; size];
    let mut found = Vec::new();
    while let Some(next) = (0..size).find(|own| {
        !taken[*own] && (0..size).all(|other| !reach[*own][other] || taken[other] || reach[other][*own])
    }) {
        let block: Vec<usize> =
            (0..size).filter(|other| *other == next || reach[next][*other] && reach[*other][next]).collect();
        block.iter().for_each(|own| taken[*own] = true);
        found.push(block);
    }
    found
}
