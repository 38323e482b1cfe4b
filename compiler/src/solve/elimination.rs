//! Sparse LDLᵀ of the symmetric system, written into the graph.

use super::lu;
use crate::order::Order;
use crate::symbolic::{Node, Scalar, Sheet, all_bare};
use std::collections::BTreeMap;

/// A symmetric matrix by its non-zero entries (row ≥ column).
pub type Entries = BTreeMap<(usize, usize), Node>;

/// The factors of K as nodes.
#[derive(Clone, Debug)]
pub struct Factor {
    velocities: usize,
    steps: Vec<Step>,
    /// Smallest relative pivot: of rows d/S, of velocities d/P with P the sum of its positive terms; 1 if none needs watching.
    pub pivot: Node,
    /// The same of the velocities alone.
    pub velocity_pivot: Node,
}

/// A pivot: an unknown, or the rows of one vector.
#[derive(Clone, Debug)]
struct Step {
    unknowns: Vec<usize>,
    is_row: bool,
    /// P⁻¹ of velocities, −P⁻¹ of rows: positive definite, except where a pivot has broken down.
    inverse: Vec<Vec<Node>>,
    /// Columns of L below the pivot, an entry for each of the unknowns.
    column: Vec<(usize, Vec<Node>)>,
}

/// The diagonal entry of an unknown while it is being formed.
#[derive(Clone, Default)]
struct Diagonal<'g> {
    /// M's own entry and, for rows, the terms −D M⁻¹ Dᵀ: all of one sign.
    own: Vec<Scalar<'g>>,
    /// The terms that elimination takes away again.
    taken: Vec<Scalar<'g>>,
}

/// The properties of K that the factorisation has to know besides its entries.
pub struct Kind<'a> {
    pub velocities: usize,
    /// Whether velocity pivots are watched: those of M alone are positive with it.
    pub watch_velocities: bool,
    /// Sᵢ of each row: what its pivot is measured by, the same all along the motion.
    pub scales: &'a [Node],
    /// The pairs of rows that are the components of one vector, numbered alike.
    pub vectors: &'a [Option<usize>],
    /// c, of each row, where K has −c on the diagonal.
    pub compliance: Option<&'a [Node]>,
}

/// Factors K in the given order.
///
/// Two rows of one vector that follow one another are one pivot, a square with its inverse: one division in place of two that wait for each other.
/// Three would take more operations than they save.
///
/// A row's pivot is the difference of two sums of squares, d = P − N (+ c), and may vanish by cancellation, as in a flat
/// parallelogram, or as a whole, as along a distance that nothing can change. Relative to Sᵢ, the largest it can be along the motion, it
/// is a pivot of D M⁻¹ Dᵀ with its rows brought to length one: a product, its magnitude and a maximum watch it. Of two rows that are one pivot
/// the determinant is watched, relative to both their sizes: the product of what the two would have one after the other.
pub fn factor(g: Sheet, entries: &Entries, order: &Order, kind: &Kind) -> Factor {
    let mut active = Active::new(g, entries, order, kind);
    let vector = |unknown: usize| kind.vectors.get(unknown.checked_sub(kind.velocities)?).copied().flatten();
    let together = |one: &usize, other: &usize| vector(*one).is_some() && vector(*one) == vector(*other);
    let steps: Vec<Step> =
        order.sequence.chunk_by(together).map(|unknowns| active.eliminate(unknowns)).collect();
    let watched = active.watched;
    let of_velocities = watched.iter().filter(|watched| !watched.is_row);
    let velocity_pivot = smallest_pivot(g, &steps, of_velocities.copied().collect()).bare;
    let pivot = smallest_pivot(g, &steps, watched).bare;
    Factor { velocities: kind.velocities, steps, pivot, velocity_pivot }
}

/// K while it is eliminated.
struct Active<'a, 'g> {
    g: Sheet<'g>,
    kind: &'a Kind<'a>,
    diagonals: Vec<Diagonal<'g>>,
    /// The entries beside the diagonal, both triangles.
    rows: Vec<BTreeMap<usize, Scalar<'g>>>,
    watched: Vec<Watched<'g>>,
}

impl<'a, 'g> Active<'a, 'g> {
    fn new(g: Sheet<'g>, entries: &Entries, order: &Order, kind: &'a Kind) -> Self {
        let unknowns = order.sequence.iter().map(|unknown| unknown + 1).max().unwrap_or(0);
        let mut diagonals: Vec<Diagonal> = vec![Diagonal::default(); unknowns];
        let mut rows: Vec<BTreeMap<usize, Scalar>> = vec![BTreeMap::new(); unknowns];
        for ((i, j), entry) in entries {
            let entry = g.on(*entry);
            if i == j {
                diagonals[*i].own.push(entry);
            } else {
                rows[*i].insert(*j, entry);
                rows[*j].insert(*i, entry);
            }
        }
        Active { g, kind, diagonals, rows, watched: Vec::new() }
    }

    /// Takes a pivot P out: L ← K P⁻¹, K ← K − L Kᵀ.
    fn eliminate(&mut self, pivots: &[usize]) -> Step {
        let (g, velocities) = (self.g, self.kind.velocities);
        let is_row = pivots[0] >= velocities;
        let inverse = self.inverse(pivots);
        let around = self.around(pivots);
        let sign = |product: Scalar<'g>| if is_row { -product } else { product };
        let along = |entries: &[Scalar<'g>]| match &inverse[..] {
            [own] => vec![entries[0] * sign(own[0])],
            all => all.iter().map(|row| sign(lu::product(g, entries, row))).collect(),
        };
        let column: Vec<(usize, Vec<Scalar>)> =
            around.iter().map(|(unknown, entries)| (*unknown, along(entries))).collect();
        for (at, (i, l)) in column.iter().enumerate() {
            // −K_ip K_ip / d adds to a row's magnitude if d > 0 and takes from it if d < 0; the reverse for a velocity.
            let update = sign(lu::product(g, l, &around[i]));
            let diagonal = &mut self.diagonals[*i];
            if (*i >= velocities) != is_row {
                diagonal.own.push(update)
            } else {
                diagonal.taken.push(update)
            }
            for (j, _) in &column[at + 1..] {
                let product = lu::product(g, l, &around[j]);
                let updated = self.rows[*i].get(j).copied().unwrap_or(g.zero()) - product;
                self.rows[*i].insert(*j, updated);
                self.rows[*j].insert(*i, updated);
            }
        }
        let column = column.into_iter().map(|(unknown, l)| (unknown, all_bare(&l))).collect();
        let inverse = inverse.iter().map(|row| all_bare(row)).collect();
        Step { unknowns: pivots.to_vec(), is_row, inverse, column }
    }

    /// P⁻¹ of velocities, −P⁻¹ of rows, positive definite; watched where it may break down.
    fn inverse(&mut self, pivots: &[usize]) -> Vec<Vec<Scalar<'g>>> {
        let Active { g, kind, .. } = *self;
        let is_row = pivots[0] >= kind.velocities;
        // The diagonal entries, the sizes that they are measured by, and whether the determinant is a difference.
        let (mut diagonal, mut scale, mut is_difference) = (Vec::new(), g.one(), pivots.len() > 1);
        for pivot in pivots {
            let Diagonal { own, taken } = std::mem::take(&mut self.diagonals[*pivot]);
            let positive = g.sum(own);
            let mut magnitude = taken.iter().fold(positive, |sum, term| sum - *term);
            if let (true, Some(compliance)) = (is_row, kind.compliance) {
                magnitude += compliance[*pivot - kind.velocities];
            }
            is_difference |= !taken.is_empty();
            scale = scale * if is_row { g.on(kind.scales[*pivot - kind.velocities]) } else { positive };
            diagonal.push(magnitude);
        }
        let entry = |(i, one): (usize, &usize), (j, other): (usize, &usize)| match self.rows[*one].get(other)
        {
            _ if i == j => diagonal[i],
            Some(entry) if is_row => -*entry,
            Some(entry) => *entry,
            None => g.zero(),
        };
        let all = || pivots.iter().enumerate();
        let square: Vec<Vec<Scalar>> =
            all().map(|one| all().map(|other| entry(one, other)).collect()).collect();
        let (determinant, inverse) = lu::invert(g, &square);
        if is_row || kind.watch_velocities && is_difference {
            let inverse = determinant.reciprocal();
            self.watched.push(Watched { unknown: pivots[0], scale, inverse, is_row, is_difference });
        }
        inverse
    }

    /// Takes out the entries of the rows and columns of pivots beside them: by unknown, one for each of the pivots.
    fn around(&mut self, pivots: &[usize]) -> BTreeMap<usize, Vec<Scalar<'g>>> {
        let mut around: BTreeMap<usize, Vec<Scalar>> = BTreeMap::new();
        for (at, pivot) in pivots.iter().enumerate() {
            for (unknown, entry) in std::mem::take(&mut self.rows[*pivot]) {
                if !pivots.contains(&unknown) {
                    around.entry(unknown).or_insert_with(|| vec![self.g.zero(); pivots.len()])[at] = entry;
                    self.rows[unknown].remove(pivot);
                }
            }
        }
        around
    }
}

/// A pivot to be watched.
#[derive(Clone, Copy)]
struct Watched<'g> {
    unknown: usize,
    /// The size that d is divided by.
    scale: Scalar<'g>,
    /// 1/d.
    inverse: Scalar<'g>,
    is_row: bool,
    /// Whether d is a difference: where it has broken down its sign is that of rounding.
    is_difference: bool,
}

/// min d/S, as 1/max(S/d); rows of the same S are compared before they are measured, along the tree of the elimination: what one
/// row does repeats with the elimination along a chain of them.
fn smallest_pivot<'g>(g: Sheet<'g>, steps: &[Step], watched: Vec<Watched<'g>>) -> Scalar<'g> {
    let mut worst: Option<Scalar> = None;
    for (at, first) in watched.iter().enumerate() {
        let alike = |other: &&Watched| other.scale.bare == first.scale.bare;
        if watched[..at].iter().any(|earlier| alike(&earlier)) {
            continue;
        }
        let inverse = along_tree(steps, watched[at..].iter().filter(alike));
        let ratio = inverse.map(|inverse| first.scale * inverse);
        worst = match (worst, ratio) {
            (Some(worst), Some(ratio)) => Some(worst.max(ratio)),
            (worst, ratio) => worst.or(ratio),
        };
    }
    worst.map_or_else(|| g.one(), Scalar::reciprocal)
}

/// The largest of |1/d|: of each with what was found before it, handed on to the next unknown that it acts on.
fn along_tree<'a, 'g: 'a>(
    steps: &[Step],
    watched: impl Iterator<Item = &'a Watched<'g>>,
) -> Option<Scalar<'g>> {
    let mut found: BTreeMap<usize, Scalar> =
        watched.map(|known| (known.unknown, known.magnitude())).collect();
    let mut position = BTreeMap::new();
    position.extend(
        steps
            .iter()
            .enumerate()
            .flat_map(|(at, step)| step.unknowns.iter().map(move |unknown| (*unknown, at))),
    );
    let mut most: Option<Scalar> = None;
    let larger = |one: Option<Scalar<'g>>, other: Scalar<'g>| one.map_or(other, |one| one.max(other));
    for step in steps {
        let Some(own) = found.remove(&step.unknowns[0]) else { continue };
        match step.column.iter().map(|(unknown, _)| *unknown).min_by_key(|unknown| position.get(unknown)) {
            Some(next) => {
                let next = steps[position[&next]].unknowns[0];
                let other = found.remove(&next);
                found.insert(next, larger(other, own));
            }
            None => most = Some(larger(most, own)),
        }
    }
    most
}

impl<'g> Watched<'g> {
    /// |1/d|.
    fn magnitude(&self) -> Scalar<'g> {
        if self.is_difference { self.inverse.abs() } else { self.inverse }
    }
}

impl Factor {
    /// All that was computed for it.
    pub fn nodes(&self) -> Vec<Node> {
        let columns =
            self.steps.iter().flat_map(|step| step.column.iter().flat_map(|(_, l)| l.iter().copied()));
        columns.chain(self.steps.iter().flat_map(|step| step.inverse.iter().flatten().copied())).collect()
    }

    /// K x = [Q; γ], given Q and, for the rows, −γ: with that sign no multiplier has to be negated at the end.
    pub fn solve<'g>(&self, g: Sheet<'g>, forces_and_minus_gamma: &[Scalar<'g>]) -> Vec<Scalar<'g>> {
        let mut x = forces_and_minus_gamma.to_vec();
        for step in &self.steps {
            for (unknown, l) in &step.column {
                let product = g.sum(l.iter().zip(&step.unknowns).map(|(l, own)| g.on(*l) * x[*own]));
                if step.is_row == (*unknown >= self.velocities) {
                    x[*unknown] -= product;
                } else {
                    x[*unknown] += product;
                }
            }
        }
        for step in self.steps.iter().rev() {
            let own: Vec<Scalar> = step.unknowns.iter().map(|unknown| x[*unknown]).collect();
            for (at, unknown) in step.unknowns.iter().enumerate() {
                let value = g.sum(step.inverse[at].iter().zip(&own).map(|(entry, own)| *own * *entry));
                x[*unknown] =
                    step.column.iter().fold(value, |value, (unknown, l)| value - l[at] * x[*unknown]);
            }
        }
        x
    }
}
