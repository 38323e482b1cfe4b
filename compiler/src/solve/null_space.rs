//! The equations in independent velocities, written out: D = L U in the order that was chosen for it, a basis R of its null space,
//! and (Rᵀ M R) z̈ = Rᵀ (Q − M S γ).
//!
//! Which velocities are dependent is fixed here; where their pivots degrade the runtime solves by multipliers, or chooses others by tables.

use super::elimination::{self, Entries, Kind};
use super::lu::{self, Lu};
use super::stabilised::{Asked, Damping, stabilised, stabilised_by_estimate};
use super::stored::{frontier, symbols};
use super::symmetric::{Sparse, Symmetric, sparse};
use super::{Partition, Solution, friction};
use crate::equations::Equations;
use crate::order::{self, Pattern};
use crate::symbolic::{Node, Scalar, Sheet, all_bare};
use std::collections::BTreeMap;

/// The expressions that `options { emit = (null_space) }` asks for.
#[derive(Clone, Debug)]
pub struct NullSpace {
    /// The values of D = L U that are kept, and symbols for them and for right-hand sides of rows.
    pub kept: Vec<Node>,
    pub stand_ins: Vec<Node>,
    pub given_rows: Vec<Node>,
    /// The square of the smallest pivot, relative to the size of its rows to a power of two.
    pub partition_pivot: Node,
    /// Velocities with D v = rows, in symbols for what is kept, for the rows, and for v, whose independent entries count.
    pub dependent: Vec<Node>,
    /// v̇ and λ, and the smallest pivot; without stabilisation and with Baumgarte's.
    pub plain: Solution,
    pub stabilised: Solution,
    /// What rows ask with Baumgarte's terms: of the accelerations, or of what these are shifted to.
    pub asked: Vec<Node>,
    /// The values that both factorisations computed, of D and of Rᵀ M R.
    pub factored: Vec<Node>,
}

/// Writes out, with the n_v velocities split into dependent ones (D_d, m × m) and f = n_v − m independent ones, R (n_v × f) with
/// D R = 0 and 1 at the independent velocities, and S γ the accelerations with D S γ = γ and 0 there:
///
/// ```text
/// (Rᵀ M R) z̈ = Rᵀ (Q − M S γ),    v̇ = R z̈ + S γ,    D_dᵀ λ = (Q − M v̇)_d
/// ```
/// once with γ and once with γ − 2α (D v − ν) − β² Φ in its place;
/// v̇ in m/s² and rad/s², λ in N or N m. `massless`: M alone is singular, so that the pivots of Rᵀ M R are watched.
/// Source: García de Jalón, Bayo, *Kinematic and Dynamic Simulation of Multibody Systems*, 5.2.3.
/// `rows`: symbols for right-hand sides of rows, if there are some already. `damping`: how 2α (D v − ν) enters; by
/// an estimate if that is not said. `most`: so many operations are too many; nothing is written then.
pub fn null_space(
    equations: &Equations,
    partition: &Partition,
    massless: bool,
    rows: Option<&[Node]>,
    damping: Option<Damping>,
    most: usize,
) -> Option<NullSpace> {
    let g = equations.graph.sheet();
    let velocities = equations.layout.velocities();
    let own = equations
        .rows
        .iter()
        .map(|row| row.jet.columns.iter().map(|(at, column)| (*at, g.on(*column))).collect())
        .collect();
    let lu = lu::factor(g, own, velocities, partition);
    let Velocities { kept, dependent, rows: given_rows, stand_ins } = velocities_of(g, equations, &lu, rows);
    // R, a column for each independent velocity.
    let independent: Vec<usize> = (0..velocities).filter(|velocity| !lu.is_dependent[*velocity]).collect();
    let basis: Vec<Sparse> = independent.iter().map(|velocity| lu.column(g, *velocity)).collect();

    if least_operations(&basis, velocities) > most {
        return None;
    }

    let mass = Symmetric::new(g, velocities, &equations.mass);
    let products: Vec<Sparse> = basis.iter().map(|column| mass.times(column)).collect();
    let reduced = reduced(g, &basis, &products);
    let by_products = by_products(&lu, &mass, &products);
    let order = order::best(&Pattern::new(independent.len(), 0, reduced.keys().copied()));
    let kind =
        Kind { velocities: independent.len(), watch_velocities: massless, scales: &[], compliance: None };
    let factor = elimination::factor(g, &reduced, &order, &kind);
    let pivot = if factor.pivot == g.one().bare { lu.pivot } else { lu.pivot.min(g.on(factor.pivot)) }.bare;
    let forces = g.all(&equations.forces);
    let none = vec![g.zero(); velocities];
    let linear = |forces: &[Scalar<'_>], gamma: &[Scalar<'_>], shift: &[Scalar<'_>]| {
        // (Rᵀ M R) z̈ = Rᵀ (Q − M S γ); v̇ is less than R z̈ + S γ by the shift.
        let bias = lu.dependent(g, gamma, &none);
        let bias: Vec<Scalar> = bias.iter().zip(shift).map(|(bias, shift)| *bias - *shift).collect();
        let taken = mass.taken_from(forces, &bias);
        let loads = sparse(&taken);
        let right: Vec<Scalar> = basis.iter().map(|column| dot(g, column, &loads)).collect();
        // v̇ = R z̈ + S γ
        let mut z = none.clone();
        for (velocity, rate) in independent.iter().zip(factor.solve(g, &right)) {
            z[*velocity] = rate;
        }
        let acceleration = lu.combine(g, &basis, gamma, shift, &independent, &z);
        // D_dᵀ λ = (Q − M v̇)_d, and M v̇ = M S γ + (M R) z̈.
        let rest = if by_products {
            let mut rest = taken;
            for (velocity, product) in independent.iter().zip(&products) {
                product.iter().for_each(|(at, entry)| rest[*at] -= *entry * z[*velocity]);
            }
            rest
        } else {
            mass.taken_from(forces, &acceleration)
        };
        let lambda = lu.multipliers(g, rest, vec![g.zero(); equations.rows.len()]);
        Solution { acceleration: all_bare(&acceleration), lambda: all_bare(&lambda), pivot, left: Vec::new() }
    };
    let still = vec![g.zero(); equations.rows.len()];
    let columns = friction::columns(g, &equations.friction, velocities);
    let columns: Vec<Solution> = columns.iter().map(|column| linear(column, &still, &none)).collect();
    let solution = |gamma: &[Scalar<'_>], shift: &[Scalar<'_>]| {
        friction::rubbed(g, equations, linear(&forces, gamma, shift), &columns)
    };
    let plain = solution(&g.all(&equations.gamma), &none);
    let Asked { rows, shift } = match damping {
        Some(damping) => stabilised(equations, damping, &lu.is_dependent),
        None => {
            let of_independent = independent.iter().map(|velocity| mass.rows[*velocity].len() + 1);
            stabilised_by_estimate(equations, velocities + of_independent.sum::<usize>())
        }
    };
    let minus: Vec<Scalar> = g.all(&rows).into_iter().map(|x| -x).collect();
    let stabilised = solution(&minus, &g.all(&shift));
    let partition_pivot = lu.pivot.bare;
    let factored = lu.nodes().chain(factor.nodes()).collect();
    Some(NullSpace {
        asked: rows,
        factored,
        kept,
        given_rows,
        stand_ins,
        partition_pivot,
        dependent,
        plain,
        stabilised,
    })
}

/// Mechanisms of at most so many velocities keep what they computed in registers, or nearly so.
const SHORT: usize = 12;

/// Whether (M v̇)_d takes less by M R, which is there already, than by M; in long functions what is kept for it, an entry of Q − M S γ and one of M R
/// for each, is stored and loaded in between, which takes as long as two operations: a ladder of ten windows takes 97 ns in
/// place of 88 with 25 operations of 703 less.
fn by_products(lu: &Lu, mass: &Symmetric, products: &[Sparse]) -> bool {
    let velocities = mass.rows.len();
    let dependent = (0..velocities).filter(|velocity| lu.is_dependent[*velocity]);
    let by_mass: usize = dependent.clone().map(|velocity| mass.rows[velocity].len()).sum();
    let by_products = products.iter().flat_map(BTreeMap::keys).filter(|at| lu.is_dependent[**at]).count();
    let kept = if velocities > SHORT { 2 * dependent.count() } else { 0 };
    by_products + kept < by_mass
}

/// What Rᵀ M R takes at least: a product for each two columns that have a velocity in common, M being diagonal at best.
fn least_operations(basis: &[Sparse], velocities: usize) -> usize {
    let mut columns = vec![0; velocities];
    basis.iter().flat_map(BTreeMap::keys).for_each(|velocity| columns[*velocity] += 1);
    columns.iter().map(|many| many * (many + 1) / 2).sum()
}

/// The velocities with D v = rows, in symbols for what is kept of D = L U and for the rows.
struct Velocities {
    kept: Vec<Node>,
    stand_ins: Vec<Node>,
    rows: Vec<Node>,
    dependent: Vec<Node>,
}

fn velocities_of<'g>(g: Sheet<'g>, equations: &Equations, lu: &Lu<'g>, rows: Option<&[Node]>) -> Velocities {
    let rows = rows.map_or_else(|| symbols(g, "row", equations.rows.len()), <[Node]>::to_vec);
    let v = &equations.symbols.v;
    let dependent = all_bare(&lu.dependent(g, &g.all(&rows), &g.all(v)));
    let kept = frontier(&g.graph(), &dependent, &rows.iter().chain(v).copied().collect());
    let stand_ins = symbols(g, "lu", kept.len());
    let replaced = kept.iter().copied().zip(stand_ins.iter().copied()).collect();
    let dependent = g.graph().substitute(&dependent, &replaced);
    Velocities { kept, stand_ins, rows, dependent }
}

/// Rᵀ M R, the lower triangle, from R and M R by columns.
fn reduced<'g>(g: Sheet<'g>, basis: &[Sparse<'g>], products: &[Sparse<'g>]) -> Entries {
    let mut entries = Entries::new();
    for (a, column) in basis.iter().enumerate() {
        for (b, product) in products.iter().enumerate().take(a + 1) {
            let entry = dot(g, column, product);
            if entry.value() != Some(0.0) {
                entries.insert((a, b), entry.bare);
            }
        }
    }
    entries
}

fn dot<'g>(g: Sheet<'g>, a: &Sparse<'g>, b: &Sparse<'g>) -> Scalar<'g> {
    g.sum(a.iter().filter_map(|(at, x)| b.get(at).map(|y| *x * *y)))
}
