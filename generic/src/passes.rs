//! Friction by reactions in a fixed number of passes of Newton's method, as the compiler writes them out: for comparison where they have not ended.
//!
//! ```text
//! N_j = Σ_i |R_ji|,    R_ji = R̂_ji + Σ_k r_jik N_k,    u = R/|R|
//! N_j − Σ_k (Σ_i u_ji·r_jik) N_k = Σ_i u_ji·R̂_ji                                          a pass, from |R̂|
//! ```
//! R̂ and r are differences of linear solutions here. What depends on each other is found together, all else one after the other; what depends on
//! itself alone by one force is iterated to the end, for the compiler has a root.

use crate::error::Error;
use crate::friction::Friction;
use crate::load::Acts;
use crate::mechanism::Mechanism;
use crate::vector::*;
use std::collections::BTreeSet;

/// What of a force per force is rounding.
const NOTHING: f64 = 1e-12;
/// More passes than a single one needs.
const TO_THE_END: usize = 60;

/// Forces that press: of each friction some vectors.
type Forces = Vec<Vec<V3>>;

impl Mechanism {
    /// Friction by reactions takes this many passes of Newton's method from no friction, in place of iterating until nothing changes.
    pub fn set_friction_passes(&mut self, passes: Option<usize>) {
        self.friction_passes = passes;
    }

    /// v̇ and λ with the friction of so many passes, from those without any.
    pub(crate) fn rub_in_passes(
        &mut self,
        passes: usize,
        inputs: &[f64],
        a: &mut [f64],
        lambda: &mut [f64],
    ) -> Result<(), Error> {
        let count = self.frictions().count();
        let mut sizes = vec![0.0; count];
        let begun = self.pressed_by(&sizes, inputs, a, lambda)?;
        let largest = begun.iter().flatten().map(|force| norm(*force)).fold(1.0, f64::max);
        let mut slopes = Vec::with_capacity(count);
        for which in 0..count {
            sizes[which] = largest;
            let moved = self.pressed_by(&sizes, inputs, a, lambda)?;
            sizes[which] = 0.0;
            let by = |(moved, begun): (&V3, &V3)| times(1.0 / largest, minus(*moved, *begun));
            let of = |(moved, begun): (&Vec<V3>, &Vec<V3>)| moved.iter().zip(begun).map(by).collect();
            slopes.push(moved.iter().zip(&begun).map(of).collect::<Forces>());
        }
        let smallest: Vec<f64> = self.frictions().map(|friction| friction.smallest).collect();
        let together = Together { begun, slopes, smallest };
        for block in together.blocks() {
            together.find(&block, passes, &mut sizes);
        }
        self.pressed_by(&sizes, inputs, a, lambda)?;
        self.at.multipliers.clear();
        self.at.multipliers.extend_from_slice(lambda);
        self.at.sizes.clear();
        Ok(())
    }

    fn frictions(&self) -> impl Iterator<Item = &Friction> {
        self.definition.loads.iter().filter_map(|load| match &load.acts {
            Acts::Friction(friction) => Some(&**friction),
            _ => None,
        })
    }

    /// What presses where friction is that of these sizes; v̇ and λ with it.
    fn pressed_by(
        &mut self,
        sizes: &[f64],
        inputs: &[f64],
        a: &mut [f64],
        lambda: &mut [f64],
    ) -> Result<Forces, Error> {
        self.at.sizes.clear();
        self.at.sizes.extend_from_slice(sizes);
        let Mechanism { definition, coordinates, system, at, work, .. } = self;
        system.evaluate_forces(definition, coordinates, at, inputs);
        work.upper.copy_from_slice(&system.forces);
        let solved = system.solve(&work.upper, &work.lower, a, lambda);
        solved.map_err(|_| self.singular())?;
        self.at.multipliers.clear();
        self.at.multipliers.extend_from_slice(lambda);
        let mut scratch = std::mem::take(&mut self.work.scratch);
        let forces = self.frictions().map(|friction| friction.pressing(&self.at, &mut scratch)).collect();
        self.work.scratch = scratch;
        Ok(forces)
    }
}

/// R̂ of each, r by each, and ε.
struct Together {
    begun: Forces,
    slopes: Vec<Forces>,
    smallest: Vec<f64>,
}

impl Together {
    fn depends(&self, which: usize, on: usize) -> bool {
        self.slopes[on][which].iter().any(|slope| norm(*slope) > NOTHING)
    }

    /// Parts that depend on each other, each after those on which it depends.
    fn blocks(&self) -> Vec<Vec<usize>> {
        let count = self.begun.len();
        let reached = |from: usize| {
            let mut found = BTreeSet::new();
            let mut open = vec![from];
            while let Some(next) = open.pop() {
                open.extend((0..count).filter(|on| self.depends(next, *on) && found.insert(*on)));
            }
            found
        };
        let reach: Vec<BTreeSet<usize>> = (0..count).map(reached).collect();
        let is_with = |a: usize, b: usize| a == b || reach[a].contains(&b) && reach[b].contains(&a);
        let mut blocks: Vec<Vec<usize>> = Vec::new();
        for which in 0..count {
            let block: Vec<usize> = (0..count).filter(|other| is_with(which, *other)).collect();
            if block[0] == which {
                blocks.push(block);
            }
        }
        // What is reached from one is less than what is reached from another that depends on it.
        blocks.sort_by_key(|block| reach[block[0]].len());
        blocks
    }

    /// The forces on one, with these sizes.
    fn forces(&self, which: usize, sizes: &[f64]) -> Vec<V3> {
        let mut forces = self.begun[which].clone();
        for (slopes, size) in self.slopes.iter().zip(sizes) {
            for (force, slope) in forces.iter_mut().zip(&slopes[which]) {
                *force = plus(*force, times(*size, *slope));
            }
        }
        forces
    }

    fn length(&self, which: usize, force: V3) -> f64 {
        norm(force).hypot(self.smallest[which])
    }

    fn find(&self, block: &[usize], passes: usize, sizes: &mut [f64]) {
        // Of those of the block still zero.
        let begun: Vec<Vec<V3>> = block.iter().map(|which| self.forces(*which, sizes)).collect();
        let size = |(which, forces): (&usize, &Vec<V3>)| {
            forces.iter().map(|force| self.length(*which, *force)).sum::<f64>()
        };
        let found: Vec<f64> = block.iter().zip(&begun).map(size).collect();
        block.iter().zip(found).for_each(|(which, size)| sizes[*which] = size);
        let alone = block.len() == 1;
        if alone && !self.depends(block[0], block[0]) {
            return;
        }
        let has_root = alone && begun[0].len() == 1;
        for _ in 0..if has_root { TO_THE_END } else { passes } {
            let mut rows = Vec::with_capacity(block.len());
            for (at, which) in block.iter().enumerate() {
                let mut row = vec![0.0; block.len() + 1];
                row[at] = 1.0;
                for (i, force) in self.forces(*which, sizes).into_iter().enumerate() {
                    let along = times(1.0 / self.length(*which, force), force);
                    for (entry, by) in row.iter_mut().zip(block) {
                        *entry -= dot(along, self.slopes[*by][*which][i]);
                    }
                    row[block.len()] += dot(along, begun[at][i]);
                }
                rows.push(row);
            }
            block.iter().zip(solved(rows)).for_each(|(which, size)| sizes[*which] = size);
        }
    }
}

/// Gauss's elimination with pivots, of rows with the right-hand side behind.
fn solved(mut rows: Vec<Vec<f64>>) -> Vec<f64> {
    let count = rows.len();
    for at in 0..count {
        let largest = (at..count).max_by(|a, b| rows[*a][at].abs().total_cmp(&rows[*b][at].abs()));
        rows.swap(at, largest.unwrap_or(at));
        let pivot = rows[at].clone();
        for row in &mut rows[at + 1..] {
            let factor = row[at] / pivot[at];
            row.iter_mut().zip(&pivot).skip(at).for_each(|(entry, own)| *entry -= factor * own);
        }
    }
    let mut x = vec![0.0; count];
    for at in (0..count).rev() {
        let rest = (at + 1..count).map(|k| rows[at][k] * x[k]).sum::<f64>();
        x[at] = (rows[at][count] - rest) / rows[at][at];
    }
    x
}
