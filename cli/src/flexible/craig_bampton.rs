//! Craig and Bampton's modes (AIAA J. 6, 1968): for each row of the interface the shape that the rest takes by itself when that row alone moves by one,
//! Ψ = −K_ii⁻¹ K_ib, and natural modes with the interface clamped, K_ii φ = ω² M_ii φ, the slowest of them, with Φᵀ M_ii Φ = 1 kg.

use super::integrals::Modes;
use super::model::{Model, ROWS};
use faer::linalg::solvers::Solve;
use faer::{Mat, Side};
use linkwright_compiler::modal::{Reduced, Square};

/// Of an entry of the stiffness, what is left of it by elimination alone.
const ROUNDING: f64 = 1e-11;

pub fn reduced(model: &Model, held: &[u64], interface: &[u64], modes: usize) -> Result<Reduced, String> {
    let held: Vec<usize> = held.iter().map(|node| model.node(*node)).collect::<Result<_, _>>()?;
    let joined: Vec<usize> = interface.iter().map(|node| model.node(*node)).collect::<Result<_, _>>()?;
    if let Some(node) = joined.iter().find(|node| held.contains(node)) {
        return Err(format!(
            "node {} is held, and does not move: leave it out of --interface",
            model.nodes[*node].0
        ));
    }
    let rows = |node: usize| (ROWS * node..ROWS * node + ROWS).filter(|row| !model.is_empty(*row));
    let boundary: Vec<usize> = joined.iter().flat_map(|node| rows(*node)).collect();
    let inner: Vec<usize> = (0..model.nodes.len())
        .filter(|node| !held.contains(node) && !joined.contains(node))
        .flat_map(rows)
        .collect();
    if boundary.is_empty() && modes == 0 {
        return Err("nothing is left to move: name nodes by --interface, or a number of --modes".to_string());
    }
    if modes > inner.len() {
        return Err(format!("{} rows between the nodes have as many modes, and not {modes}", inner.len()));
    }
    let shapes = shapes(model, &boundary, &inner, modes)?;
    let kept: Vec<usize> = held.iter().chain(&joined).copied().collect();
    let modes = Modes { nodes: &model.nodes, masses: &model.masses, shapes: &shapes };
    Ok(modes.reduced(product(&model.mass, &shapes), product(&model.stiffness, &shapes), &kept))
}

/// Mode by mode, a number for each row of the model.
pub fn shapes(
    model: &Model,
    boundary: &[usize],
    inner: &[usize],
    modes: usize,
) -> Result<Vec<Vec<f64>>, String> {
    let part = |of: &Mat<f64>, rows: &[usize], columns: &[usize]| {
        Mat::from_fn(rows.len(), columns.len(), |i, k| of[(rows[i], columns[k])])
    };
    let mut found: Vec<Vec<f64>> = Vec::new();
    let mut push = |of: &dyn Fn(usize) -> f64, moved: Option<usize>| {
        let mut shape = vec![0.0; ROWS * model.nodes.len()];
        inner.iter().enumerate().for_each(|(i, row)| shape[*row] = of(i));
        if let Some(row) = moved {
            shape[row] = 1.0;
        }
        found.push(shape);
    };
    if inner.is_empty() {
        boundary.iter().for_each(|row| push(&|_| 0.0, Some(*row)));
        return Ok(found);
    }
    let loose = || {
        "the stiffness is not positive definite where nodes are held and joined: hold enough nodes, and leave loose ones out".to_string()
    };
    let stiffness = part(&model.stiffness, inner, inner);
    let factor = stiffness.llt(Side::Lower).map_err(|_| loose())?;
    // A pivot that is nothing but rounding belongs to a motion that nothing resists.
    let is_rounding = |row: usize| factor.L()[(row, row)].powi(2) < ROUNDING * stiffness[(row, row)];
    if (0..inner.len()).any(is_rounding) {
        return Err(loose());
    }
    let moved = factor.solve(&part(&model.stiffness, inner, boundary));
    for (k, row) in boundary.iter().enumerate() {
        push(&|i| -moved[(i, k)], Some(*row));
    }
    if modes == 0 {
        return Ok(found);
    }
    // With K = L Lᵀ: L⁻¹ M L⁻ᵀ y = y/ω², which takes rows without mass; φ = L⁻ᵀ y.
    let lower = factor.L();
    let solve = |mut of: Mat<f64>| {
        lower.solve_lower_triangular_in_place(&mut of);
        of
    };
    let half = solve(part(&model.mass, inner, inner));
    let whole = solve(half.transpose().to_owned());
    let failed = || "the natural modes were not found".to_string();
    let solved = whole.self_adjoint_eigen(Side::Lower).map_err(|_| failed())?;
    let (vectors, values) = (solved.U(), solved.S());
    let count = inner.len();
    let mut natural = Mat::from_fn(count, modes, |i, k| vectors[(i, count - 1 - k)]);
    lower.transpose().solve_upper_triangular_in_place(&mut natural);
    for k in 0..modes {
        // φᵀ M φ = μ yᵀ y, 1/ω².
        let square = values[count - 1 - k];
        if square <= 1e-14 * values[count - 1] {
            return Err(format!(
                "{k} of the rows between the nodes have mass, and not {modes}: ask for fewer --modes"
            ));
        }
        push(&|i| natural[(i, k)] / square.sqrt(), None);
    }
    Ok(found)
}

/// Σᵀ A Σ with the shapes as columns.
fn product(of: &Mat<f64>, shapes: &[Vec<f64>]) -> Square {
    let times = |shape: &Vec<f64>| -> Vec<f64> {
        let row = |i: usize| shape.iter().enumerate().map(|(k, value)| of[(i, k)] * value).sum();
        (0..of.nrows()).map(row).collect()
    };
    let times: Vec<Vec<f64>> = shapes.iter().map(times).collect();
    let dot = |a: &[f64], b: &[f64]| -> f64 { a.iter().zip(b).map(|(a, b)| a * b).sum() };
    let entry = |j: usize, k: usize| dot(&shapes[j.max(k)], &times[j.min(k)]);
    (0..shapes.len()).map(|j| (0..shapes.len()).map(|k| entry(j, k)).collect()).collect()
}
