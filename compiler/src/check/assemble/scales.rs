//! The measure of a constraint row: a size that is fixed over the motion, so that a row that vanishes as a whole, as a
//! distance along which nothing can move, is seen to vanish.
//!
//! Two measures, both the largest over positions along the motion: |Dᵢ|² in the norm of M⁻¹, by which pivots of D M⁻¹ Dᵀ are
//! measured, and the largest entry of Dᵢ, by which pivots of D = L U are.

use super::{Ancestry, Assembly, Point};
use crate::equations::{Equations, Jet};
use crate::model::Mechanism;
use crate::solve::Massless;
use crate::solve::table::{Numeric, Table};
use crate::symbolic::Node;
use std::collections::BTreeMap;

/// Sᵢ of each row, expressions of the parameters: twice the largest Dᵢ M⁻¹ Dᵢᵀ along the motion at the default parameters, 1/kg for a
/// row in m; 1 for rows that take no part. Twice, because the largest eigenvalue of rows of length one that act together is above
/// one. Where massless bodies leave M singular it is M + ρ Dᵀ D of the rows that hold them.
///
/// A power of two at the defaults, so that measuring rounds nothing and rows alike are measured alike. With other parameters it goes
/// like Σⱼ Dᵢⱼ²/Mⱼⱼ at the position where the row was largest.
pub fn row_scales(
    mechanism: &Mechanism,
    equations: &Equations,
    assembly: &Assembly,
    massless: &Massless,
) -> Vec<Node> {
    let largest = largest(mechanism, equations, assembly, massless);
    let mut scales = Vec::new();
    for (row, found) in largest.into_iter().enumerate() {
        let scale = match found {
            Some(Largest { square, at }) => {
                let constant = libm::exp2(1.0 + libm::round(libm::log2(square)));
                varying(mechanism, equations, massless, row, &assembly.along[at], &assembly.phases, constant)
                    .unwrap_or_else(|| equations.graph.sheet().number(constant).bare)
            }
            None => equations.graph.sheet().number(1.0).bare,
        };
        scales.push(scale);
    }
    scales
}

/// Where along the motion a row is largest.
#[derive(Clone, Copy, Debug)]
struct Largest {
    /// Dᵢ M⁻¹ Dᵢᵀ.
    square: f64,
    /// Index of the position.
    at: usize,
}

/// The largest measure of each row, where it is above zero and below infinity.
fn largest(
    mechanism: &Mechanism,
    equations: &Equations,
    assembly: &Assembly,
    massless: &Massless,
) -> Vec<Option<Largest>> {
    let n = equations.symbols.v.len();
    let rows: Vec<usize> = (0..equations.rows.len()).filter(|row| !equations.idle.contains(row)).collect();
    let mut found = vec![None; equations.rows.len()];
    if rows.is_empty() {
        return found;
    }
    let columns = |row: usize| equations.rows[row].jet.columns.iter();
    let entries = rows.iter().flat_map(|row| columns(*row).map(|(_, node)| *node));
    let ancestry =
        Ancestry::of(equations, entries.chain(equations.mass.values().copied()).collect::<Vec<_>>());
    let squares = massless.rows.keys().flat_map(|row| {
        let keys: Vec<usize> = columns(*row).map(|(column, _)| *column).collect();
        keys.iter().flat_map(|i| keys.iter().map(|j| (*i, *j))).collect::<Vec<_>>()
    });
    let table = Table::new(n, 0, equations.mass.keys().copied().chain(squares));
    let mut point = Point::at_defaults(mechanism, equations, &assembly.phases);
    for (at, q) in assembly.along.iter().enumerate() {
        point.set_q(q);
        point.evaluate(&ancestry);
        let mass = equations.mass.iter().map(|((i, j), node)| (*i, *j, point.get(*node)));
        let mut matrix: Vec<(usize, usize, f64)> = mass.collect();
        for (row, rho) in &massless.rows {
            for (i, a) in columns(*row) {
                let below = columns(*row).filter(|(j, _)| *j <= i);
                let squares = below.map(|(j, b)| (*i, *j, rho * point.get(*a) * point.get(*b)));
                matrix.extend(squares);
            }
        }
        let factor = Numeric::factor(&table, matrix);
        for row in &rows {
            let entries = columns(*row).map(|(column, node)| (*column, point.get(*node)));
            let square = factor.inverse_square(entries);
            let known = found[*row].map_or(0.0, |known: Largest| known.square);
            if square.is_finite() && square > known {
                found[*row] = Some(Largest { square, at });
            }
        }
    }
    found
}

/// `constant` times what the parameters make of the row at `q`; `None` where they have no say.
fn varying(
    mechanism: &Mechanism,
    equations: &Equations,
    massless: &Massless,
    row: usize,
    q: &[f64],
    phases: &[f64],
    constant: f64,
) -> Option<Node> {
    if equations.symbols.parameters.is_empty() {
        return None;
    }
    let columns: Vec<(usize, Node)> = of(&equations.rows[row].jet);
    let held: Vec<(f64, Vec<(usize, Node)>)> =
        massless.rows.iter().map(|(row, rho)| (*rho, of(&equations.rows[*row].jet))).collect();
    let (positions, time) = (equations.symbols.q.clone(), equations.symbols.time);
    let mass: Vec<Option<Node>> =
        columns.iter().map(|(column, _)| equations.mass.get(&(*column, *column)).copied()).collect();
    let g = equations.graph.sheet();
    let size = {
        let mut here: BTreeMap<Node, Node> = BTreeMap::new();
        for (symbol, value) in positions.into_iter().zip(q) {
            here.insert(symbol, g.number(*value).bare);
        }
        here.insert(time, g.zero().bare);
        // Σⱼ Dᵢⱼ²/Mⱼⱼ
        let terms = columns.iter().zip(mass).map(|((column, entry), mass)| {
            let mut inertia: Vec<_> = mass.map(|mass| g.on(mass)).into_iter().collect();
            for (rho, entries) in &held {
                let own = entries.iter().filter(|(other, _)| other == column);
                inertia.extend(own.map(|(_, entry)| *rho * g.on(*entry).square()));
            }
            let inertia = g.sum(inertia);
            g.on(*entry).square() / inertia
        });
        let sum = g.sum(terms).bare;
        let size = g.on(g.graph().substitute(&[sum], &here)[0]);
        size.value().is_none().then_some(size.bare)?
    };
    let at_defaults = at_defaults(mechanism, equations, size, phases);
    let factor = constant / at_defaults;
    let usable = factor.is_finite() && factor > 0.0;
    usable.then(|| (factor * g.on(size)).bare)
}

fn of(jet: &Jet) -> Vec<(usize, Node)> {
    jet.columns.iter().map(|(column, node)| (*column, *node)).collect()
}

fn at_defaults(mechanism: &Mechanism, equations: &Equations, node: Node, phases: &[f64]) -> f64 {
    let mut point = Point::at_defaults(mechanism, equations, phases);
    point.evaluate(&Ancestry::of(equations, [node]));
    point.get(node)
}

/// The largest entry of each row of D along the motion, entries multiplied by the `scales` of their columns. One of a row that is zero
/// everywhere.
pub fn row_sizes(
    mechanism: &Mechanism,
    equations: &Equations,
    assembly: &Assembly,
    scales: &[f64],
) -> Vec<f64> {
    let mut sizes = vec![0.0_f64; equations.rows.len()];
    let columns = equations.rows.iter().flat_map(|row| row.jet.columns.values().copied());
    let ancestry = Ancestry::of(equations, columns);
    let mut point = Point::at_defaults(mechanism, equations, &assembly.phases);
    for q in &assembly.along {
        point.set_q(q);
        point.evaluate(&ancestry);
        for (size, row) in sizes.iter_mut().zip(&equations.rows) {
            let entries = row.jet.columns.iter();
            *size =
                entries.map(|(column, node)| point.get(*node).abs() * scales[*column]).fold(*size, f64::max);
        }
    }
    sizes.into_iter().map(|size| if size > 0.0 && size.is_finite() { size } else { 1.0 }).collect()
}

/// The largest entry of each column of D along the motion.
pub fn column_sizes(mechanism: &Mechanism, equations: &Equations, assembly: &Assembly) -> Vec<f64> {
    let mut sizes = vec![0.0_f64; equations.layout.velocities()];
    let columns = || equations.rows.iter().flat_map(|row| row.jet.columns.iter());
    let ancestry = Ancestry::of(equations, columns().map(|(_, node)| *node));
    let mut point = Point::at_defaults(mechanism, equations, &assembly.phases);
    for q in &assembly.along {
        point.set_q(q);
        point.evaluate(&ancestry);
        for (column, node) in columns() {
            sizes[*column] = sizes[*column].max(point.get(*node).abs());
        }
    }
    sizes
}
