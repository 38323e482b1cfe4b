//! Positions along the motion that the joints admit, a long way from the start: by them rows are measured, and where some are
//! redundant, those are chosen that hold there.
//!
//! One walk: along a velocity that the joints admit, then back to the constraints on the shortest way, and on. With one
//! degree of freedom it goes round the cycle, with several it wanders. Nothing here depends on chance.

use super::point::{Point, retract};
use super::position::Problem;
use crate::equations::Equations;
use crate::solve::table::Numeric;

/// How far a walk goes.
#[derive(Clone, Copy, Debug)]
pub struct Walk {
    pub positions: usize,
    /// The largest change of a coordinate from one position to the next, rad, lengths in parts of the mechanism's size.
    pub stride: f64,
}

impl Walk {
    /// A few positions far apart, fewer of large mechanisms.
    pub fn far(equations: &Equations) -> Self {
        let unknowns = equations.symbols.v.len() + equations.rows.len();
        Walk { positions: (160 / unknowns.max(1)).clamp(3, 6), stride: 0.9 }
    }

    /// A cycle of a mechanism with one degree of freedom, position by position.
    pub fn around() -> Self {
        Walk { positions: 72, stride: 0.18 }
    }
}

/// c of [1 Dᵀ; D −c] in parts of the square of the largest row: rows that repeat others only nearly, as they do beside the
/// constraints, then ask for nothing.
const SOFTNESS: f64 = 1e-4;
/// A residual below this part of what a turn by 1 rad changes is on the constraints.
const CLOSED: f64 = 1e-13;
/// One that is left when corrections end is near enough.
const NEAR: f64 = 1e-10;
const CORRECTIONS: usize = 9;
/// How often a stride that does not arrive is halved.
const HALVINGS: usize = 3;
/// The amount added to a direction at each position, so that a walk with several freedoms wanders.
const WANDERING: f64 = 0.15;

/// The start and the positions after it, as many as were reached.
pub fn positions(point: &mut Point, joints: &Problem, q: &[f64], walk: Walk) -> Vec<Vec<f64>> {
    let equations = point.equations;
    let n = equations.symbols.v.len();
    let mut found = vec![q.to_vec()];
    if n == 0 {
        return found;
    }
    let size = joints.length(point, q);
    let mut along = wish(n, 1);
    // A direction that leads nowhere is replaced by another; each costs a place.
    for number in 1..=walk.positions {
        let last = found.last().map_or(q, Vec::as_slice).to_vec();
        let Some(tangent) = admissible(point, joints, &last, &along, size) else {
            along = wish(n, number + 1);
            continue;
        };
        let mut stride = walk.stride;
        let next = (0..HALVINGS).find_map(|_| {
            let step: Vec<f64> = tangent.iter().map(|x| stride * x).collect();
            stride *= 0.5;
            closed(point, joints, retract(equations, &last, &step))
        });
        match next {
            Some(next) => {
                let drift = wish(n, number);
                along = tangent.iter().zip(&drift).map(|(x, y)| x + WANDERING * y).collect();
                found.push(next);
            }
            None => along = wish(n, number + 1),
        }
    }
    found
}

/// Any direction, different for each number.
fn wish(velocities: usize, number: usize) -> Vec<f64> {
    (0..velocities).map(|k| libm::sin((number * (3 * k + 2)) as f64)).collect()
}

/// The velocities nearest to `wish` that the rows admit, the largest of them one.
fn admissible(point: &mut Point, joints: &Problem, q: &[f64], wish: &[f64], size: f64) -> Option<Vec<f64>> {
    let linear = point.equations.layout.linear.len();
    let (entries, mut rhs) = joints.unit_system(point, q);
    rhs[..wish.len()].copy_from_slice(wish);
    rhs[wish.len()..].iter_mut().for_each(|x| *x = 0.0);
    let mut tangent = Numeric::factor(joints.table(), entries).solve(&rhs);
    tangent.truncate(wish.len());
    let measured = tangent.iter().enumerate().map(|(k, x)| if k < linear { x.abs() / size } else { x.abs() });
    let length = measured.fold(0.0, f64::max);
    (length.is_finite() && length > 1e-6).then(|| tangent.into_iter().map(|x| x / length).collect())
}

/// The position on the constraints that is reached from `q`, each step the shortest: [1 Dᵀ; D −c] (δ, μ) = (0, −Φ).
fn closed(point: &mut Point, joints: &Problem, mut q: Vec<f64>) -> Option<Vec<f64>> {
    let equations = point.equations;
    let n = equations.symbols.v.len();
    let mut last = f64::INFINITY;
    for _ in 0..CORRECTIONS {
        let (mut entries, rhs) = joints.unit_system(point, &q);
        let mut squares = vec![0.0; rhs.len()];
        for (row, _, value) in entries.iter().filter(|(row, ..)| *row >= n) {
            squares[*row] += value * value;
        }
        let off = rhs[n..].iter().zip(&squares[n..]);
        let off = off.map(|(phi, square)| if *square > 0.0 { phi.abs() / square.sqrt() } else { phi.abs() });
        let off = off.fold(0.0, |most: f64, x| if x > most || x.is_nan() { x } else { most });
        if off < CLOSED || (off < NEAR && off > 0.5 * last) {
            return Some(q);
        }
        last = off;
        let largest = squares.iter().fold(0.0_f64, |most, x| most.max(*x));
        entries.extend((n..rhs.len()).map(|row| (row, row, -SOFTNESS * largest)));
        let step = Numeric::factor(joints.table(), entries).solve(&rhs);
        if !step[..n].iter().all(|x| x.is_finite()) {
            return None;
        }
        q = retract(equations, &q, &step[..n]);
    }
    (last < NEAR).then_some(q)
}
