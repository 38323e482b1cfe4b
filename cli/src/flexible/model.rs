//! A finite element model with six rows for each node, whose masses are lumped or the same along all axes.

use super::integrals::{Masses, Placed};
use super::market::Matrix;
use faer::Mat;

/// What differs by less than this of the largest entry is the same.
const EQUAL: f64 = 1e-8;

/// Rows of a node: along x, y, z and about x, y, z.
pub const ROWS: usize = 6;
/// Most rows of what is solved as a full matrix.
const MOST_ROWS: usize = 6000;

pub struct Model {
    pub nodes: Vec<Placed>,
    pub mass: Mat<f64>,
    pub stiffness: Mat<f64>,
    pub masses: Masses,
}

/// Lines of a number and three coordinates, between commas, semicolons or blanks; the first one may have names.
pub fn nodes(name: &str, text: &str) -> Result<Vec<Placed>, String> {
    let mut nodes: Vec<Placed> = Vec::new();
    for (index, line) in text.lines().enumerate() {
        let line = line.split('#').next().unwrap_or_default().trim();
        if line.is_empty() || index == 0 && line.starts_with(|c: char| c.is_alphabetic() || c == '"') {
            continue;
        }
        let at = |what: &str| format!("`{name}`, line {}: {what}", index + 1);
        let words: Vec<&str> =
            line.split([',', ';', ' ', '\t']).filter(|word| !word.trim().is_empty()).collect();
        let read = match words.as_slice() {
            [number, x, y, z] => number.parse().ok().zip(
                [x, y, z].map(|it| it.parse::<f64>().ok().filter(|it| it.is_finite())).into_iter().collect(),
            ),
            _ => None,
        };
        let Some((number, at_node)): Option<(u64, Vec<f64>)> = read else {
            return Err(at(&format!("a node is its number and x, y, z, found `{line}`")));
        };
        if nodes.iter().any(|(known, _)| *known == number) {
            return Err(at(&format!("node {number} is there already")));
        }
        nodes.push((number, [at_node[0], at_node[1], at_node[2]]));
    }
    if nodes.is_empty() {
        return Err(format!("`{name}` has no nodes"));
    }
    Ok(nodes)
}

impl Model {
    pub fn new(nodes: Vec<Placed>, mass: &Matrix, stiffness: &Matrix) -> Result<Self, String> {
        let rows = ROWS * nodes.len();
        for matrix in [mass, stiffness] {
            if matrix.rows != rows {
                let Matrix { name, rows: found, .. } = matrix;
                let count = nodes.len();
                return Err(format!(
                    "`{name}` has {found} rows, and {count} nodes have {rows}: six each, along x, y, z and about x, y, z"
                ));
            }
        }
        if rows > MOST_ROWS {
            return Err(format!(
                "{rows} rows are more than the {MOST_ROWS} that are solved at once: make the model coarser"
            ));
        }
        let [full, stiffness] = [symmetric(mass)?, symmetric(stiffness)?];
        let masses = masses(&nodes, &mass.name, &full)?;
        Ok(Model { nodes, mass: full, stiffness, masses })
    }

    /// Whether nothing resists a row and nothing is moved by it, as with turns of nodes of solids.
    pub fn is_empty(&self, row: usize) -> bool {
        (0..self.mass.nrows()).all(|k| self.mass[(row, k)] == 0.0 && self.stiffness[(row, k)] == 0.0)
    }

    pub fn node(&self, number: u64) -> Result<usize, String> {
        let found = self.nodes.iter().position(|(known, _)| *known == number);
        found.ok_or_else(|| format!("there is no node {number} among the {} of the file", self.nodes.len()))
    }
}

/// As a full matrix, which is symmetric.
fn symmetric(matrix: &Matrix) -> Result<Mat<f64>, String> {
    let mut full = Mat::<f64>::zeros(matrix.rows, matrix.rows);
    for (i, k, value) in &matrix.entries {
        full[(*i, *k)] += value;
    }
    for (i, k, _) in &matrix.entries {
        let (one, other) = (full[(*i, *k)], full[(*k, *i)]);
        let size = (full[(*i, *i)] * full[(*k, *k)]).abs().sqrt().max(one.abs()).max(other.abs());
        if (one - other).abs() > EQUAL * size {
            let Matrix { name, .. } = matrix;
            return Err(format!(
                "`{name}` is not symmetric: {one:e} in row {} and column {}, {other:e} in row {} and column {}; a matrix whose lower half alone \
                 is written is `symmetric` and not `general`",
                i + 1,
                k + 1,
                k + 1,
                i + 1
            ));
        }
    }
    Ok(full)
}

/// What the mass matrix moves and turns, where it moves alike along all axes and couples no turn with that.
fn masses(nodes: &[Placed], name: &str, full: &Mat<f64>) -> Result<Masses, String> {
    let largest = (0..full.nrows()).map(|row| full[(row, row)]).fold(0.0, f64::max);
    let mut masses = Masses { moved: Vec::new(), turned: Vec::new() };
    for (k, (number, _)) in nodes.iter().enumerate() {
        for (l, (other, _)) in nodes.iter().enumerate() {
            let at = |a: usize, b: usize| full[(ROWS * k + a, ROWS * l + b)];
            let own = at(0, 0);
            let rows = (0..ROWS).flat_map(|a| (0..ROWS).map(move |b| (a, b)));
            for (a, b) in rows.filter(|(a, b)| *a < 3 || *b < 3) {
                let expected = if a == b { own } else { 0.0 };
                if (at(a, b) - expected).abs() > EQUAL * largest {
                    return Err(not_lumped(name, [*number, *other], [a, b], at(a, b), expected));
                }
            }
            if own != 0.0 {
                masses.moved.push((k, l, own));
            }
            let inertia = [0, 1, 2].map(|a| [0, 1, 2].map(|b| at(3 + a, 3 + b)));
            if inertia.as_flattened().iter().any(|it| *it != 0.0) {
                masses.turned.push((k, l, inertia));
            }
        }
    }
    Ok(masses)
}

fn not_lumped(name: &str, nodes: [u64; 2], rows: [usize; 2], found: f64, expected: f64) -> String {
    let row = |k: usize| {
        let way = if k < 3 { "along" } else { "about" };
        format!("{way} {}", ["x", "y", "z"][k % 3])
    };
    format!(
        "`{name}` has {found:e} for nodes {} and {}, {} and {}, where {expected:e} is expected: what a mass matrix moves between its nodes is \
         known only where it is the same along x, y and z and leaves turns alone; let the code write lumped masses",
        nodes[0],
        nodes[1],
        row(rows[0]),
        row(rows[1])
    )
}
