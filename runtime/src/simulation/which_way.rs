//! Which way something begins to slide that may go along several directions, as surfaces in space may: out of rest, or in an impact.
//!
//! ```text
//! w(u) = λ u,   u·u = 1,   λ ≥ 0          w the rates of the rows of one contact, whose force is y = −μ_k x u
//! ```
//! of all contacts that begin to slide together, u of each being unknown. x is as large as the ways let it be, and w with it. Passes first take x
//! as it is, for which every contact by itself has one solution (`along_several.rs`); where these go on for long, Newton's method takes over
//! from there. Its derivatives are exact, since what all ways let the forces be is linear in each of them.

use super::along_several;
use super::complementarity::{AXES, Few, Found, Problem, ROWS, Rub, Trial, Way, solved};
use crate::real::Real;
use crate::vector::{at, dot, put};

/// The most passes in which ways are turned, and the last change of them.
const TURNS: u32 = 40;
const TURNED: f64 = 1e-12;

/// After how many of these what is far off is given up, and Newton's method is tried, again and again.
const TRIED: u32 = 5;

/// By how much it may be off, as a part of the largest force and rate.
const FAR: f64 = 0.1;

/// The most passes of Newton's method.
const PASSES: u32 = 12;

/// What stands in for λ at least in its derivatives, as a part of μ x tr G.
const LEAST: f64 = 1e-9;

/// What each contact of one trial has, u and λ.
const UNKNOWN: usize = AXES + 1;

/// The forces and ways of a trial in which something begins to slide; nothing where none are found.
pub(super) fn begun<R: Real>(
    problem: &Problem<R>,
    right: &Few<R>,
    pressed: &Few<R>,
    trial: &Trial<R>,
) -> Option<Found<R>> {
    let mut trial = *trial;
    let begins = |place: usize| trial.begins >> place & 1 == 1;
    let unknown = |(place, way): (usize, &Way<R>)| begins(place) && *way == Way::Open;
    if trial.ways.iter().enumerate().any(unknown) {
        let held = problem.tried(right, pressed, trial.set, &trial.ways);
        for (place, (way, rub)) in trial.ways.iter_mut().zip(problem.rubbing()).enumerate() {
            if unknown((place, way)) {
                // Against what would hold it, to begin with.
                let holds = held.as_ref().map(|forces| rub.own(forces).map(|y| -y));
                *way = Way::Along(direction(&holds.unwrap_or_else(|| rub.own(right)))?);
            }
        }
    }
    let enough = R::from_f64(TURNED).max(R::from_f64(64.0) * R::EPSILON);
    for pass in 1..=TURNS {
        let forces = problem.tried(right, pressed, trial.set, &trial.ways)?;
        let (before, mut most) = (trial.ways, R::ZERO);
        let each = trial.ways.iter_mut().zip(problem.rubbing()).enumerate();
        for (way, rub) in each.filter(|(place, _)| begins(*place)).map(|(_, each)| each) {
            let turned = turned(problem, &rub, &forces, right, at(pressed, rub.pressed));
            let Some(turned) = turned else { continue };
            for (axis, turned) in turned.iter().enumerate() {
                most = most.max((*turned - way.along(axis)).abs());
            }
            *way = Way::Along(turned);
        }
        if R::any(most.less_equal(enough)) {
            return Some(Found { forces, ways: before });
        }
        if pass >= TRIED && is_far_off(problem, right, pressed, &trial, &forces) {
            return None;
        }
        if pass.is_multiple_of(TRIED)
            && let Some(found) = newton(problem, right, pressed, &trial)
        {
            return Some(found);
        }
    }
    None
}

/// Whether something pulls, goes inside or holds more than it may by so much that no turn of ways makes that good.
fn is_far_off<R: Real>(
    problem: &Problem<R>,
    right: &Few<R>,
    pressed: &Few<R>,
    trial: &Trial<R>,
    forces: &Few<R>,
) -> bool {
    let far = R::from_f64(FAR);
    let most = |of: &Few<R>| of.iter().fold(R::ZERO, |most, x| most.max(x.abs()));
    let (force, rate) = (far * most(forces), far * most(right));
    let pulls = |gap: usize| match trial.set >> gap & 1 == 1 {
        true => R::any(at(forces, gap).less(-force)),
        false => R::any((problem.row(gap, forces) + at(right, gap)).less(-rate)),
    };
    let tears = |(place, rub): (usize, Rub<R>)| {
        let holds = trial.begins >> place & 1 == 0 && trial.ways.get(place) == Some(&Way::Open);
        let bound = rub.holding * (at(forces, rub.pressed) + at(pressed, rub.pressed));
        holds && R::any(rub.size(forces).greater(bound + force))
    };
    (0..problem.gaps).any(pulls) || problem.rubbing().enumerate().any(tears)
}

/// Of a vector that is not zero.
fn direction<R: Real>(of: &[R; AXES]) -> Option<[R; AXES]> {
    let size = dot(of, of).sqrt();
    R::any(size.greater(R::ZERO)).then(|| of.map(|x| x / size))
}

/// The way in which one contact goes while what presses it and what the others do stays as it is; nothing where no way is known.
fn turned<R: Real>(
    problem: &Problem<R>,
    rub: &Rub<R>,
    forces: &Few<R>,
    right: &Few<R>,
    beside: R,
) -> Option<[R; AXES]> {
    let rates = problem.rates(rub, forces, right);
    let force = rub.sliding * (at(forces, rub.pressed) + beside);
    if !R::any(force.greater(R::ZERO)) {
        return direction(&rates);
    }
    // Its own rows alone, at the first places.
    let own: [Few<R>; ROWS] = core::array::from_fn(|i| {
        core::array::from_fn(|j| match problem.matrix.get(rub.row + i) {
            Some(row) if i < rub.axes && j < rub.axes => at(row, rub.row + j),
            _ => R::ZERO,
        })
    });
    let y = rub.own(forces);
    let open: Few<R> = core::array::from_fn(|i| match own.get(i) {
        Some(row) if i < rub.axes => {
            at(&rates, i) - row.iter().zip(&y).fold(R::ZERO, |sum, (g, y)| sum + *g * *y)
        }
        _ => R::ZERO,
    });
    let set = (1 << rub.axes) - 1;
    let y = match along_several::begun(&own, &open, set, force) {
        Some(y) => y,
        // As far as it holds.
        None => solved(&own, &open, 0, rub.axes, set)?,
    };
    direction(&core::array::from_fn(|axis| -at(&y, axis)))
}

/// Newton's method for u and λ of all that begins; nothing where it does not end.
fn newton<R: Real>(
    problem: &Problem<R>,
    right: &Few<R>,
    pressed: &Few<R>,
    trial: &Trial<R>,
) -> Option<Found<R>> {
    let mut ways = trial.ways;
    let begins = |place: usize| trial.begins >> place & 1 == 1;
    let count = UNKNOWN * trial.begins.count_ones() as usize;
    let enough = R::from_f64(TURNED).max(R::from_f64(64.0) * R::EPSILON);
    let (gaps, all) = (problem.gaps, problem.count());
    for _ in 0..PASSES {
        let forces = problem.tried(right, pressed, trial.set, &ways)?;
        let (folded, held) = problem.folded(pressed, trial.set, &ways);
        let (mut slopes, mut left) = ([[R::ZERO; ROWS]; ROWS], [R::ZERO; ROWS]);
        let moving = || problem.rubbing().zip(ways).enumerate().filter(|(place, _)| begins(*place));
        for (block, (_, (rub, _))) in moving().enumerate() {
            let pressing = at(&forces, rub.pressed) + at(pressed, rub.pressed);
            for axis in 0..rub.axes {
                // By what a turn of u along one axis changes x, the forces that hold, and with them all others.
                let pushed: Few<R> = core::array::from_fn(|row| match problem.matrix.get(row) {
                    Some(entries) => -rub.sliding * pressing * at(entries, rub.row + axis),
                    None => R::ZERO,
                });
                let mut change = solved(&folded, &pushed, gaps, all, held)?;
                for (other, way) in problem.rubbing().zip(&ways).filter(|(_, way)| **way != Way::Open) {
                    let pressing = at(&change, other.pressed);
                    for (axis, row) in other.rows().enumerate() {
                        put(&mut change, row, -other.sliding * pressing * way.along(axis));
                    }
                }
                let own = at(&change, rub.row + axis) - rub.sliding * pressing;
                put(&mut change, rub.row + axis, own);
                for (row, (_, (other, _))) in moving().enumerate() {
                    for along in 0..other.axes {
                        let Some(entries) = slopes.get_mut(UNKNOWN * row + along) else { continue };
                        put(entries, UNKNOWN * block + axis, problem.row(other.row + along, &change));
                    }
                }
            }
        }
        for (block, (_, (rub, way))) in moving().enumerate() {
            let rates = problem.rates(&rub, &forces, right);
            let u: [R; AXES] = core::array::from_fn(|axis| way.along(axis));
            let size = dot(&u, &rates);
            let pressing = at(&forces, rub.pressed) + at(pressed, rub.pressed);
            let least = R::from_f64(LEAST) * (rub.sliding * pressing * problem.trace(&rub)).abs();
            let last = UNKNOWN * block + AXES;
            for axis in 0..AXES {
                let row = UNKNOWN * block + axis;
                put(&mut left, row, at(&rates, axis) - size * at(&u, axis));
                if let Some(entries) = slopes.get_mut(row) {
                    let own = at(entries, row) - size.max(least);
                    put(entries, row, own);
                    put(entries, last, -at(&u, axis));
                }
                if let Some(entries) = slopes.get_mut(last) {
                    put(entries, row, at(&u, axis));
                }
            }
        }
        let change = pivoted(&mut slopes, &mut left, count)?;
        let (mut most, mut next) = (R::ZERO, ways);
        for (block, (place, (_, way))) in moving().enumerate() {
            let turned: [R; AXES] =
                core::array::from_fn(|axis| way.along(axis) - at(&change, UNKNOWN * block + axis));
            let turned = direction(&turned)?;
            for (axis, turned) in turned.iter().enumerate() {
                most = most.max((*turned - way.along(axis)).abs());
            }
            if let Some(way) = next.get_mut(place) {
                *way = Way::Along(turned);
            }
        }
        ways = next;
        if R::any(most.less_equal(enough)) {
            let forces = problem.tried(right, pressed, trial.set, &ways)?;
            return Some(Found { forces, ways });
        }
    }
    None
}

/// A x = b of the first rows, by elimination with the largest pivot of each column; nothing where A is singular.
fn pivoted<R: Real>(matrix: &mut [Few<R>; ROWS], right: &mut Few<R>, count: usize) -> Option<Few<R>> {
    for pivot in 0..count {
        let size =
            |row: usize, matrix: &[Few<R>; ROWS]| matrix.get(row).map_or(R::ZERO, |row| at(row, pivot).abs());
        let best = (pivot..count).fold(pivot, |best, row| {
            if R::any(size(row, matrix).greater(size(best, matrix))) { row } else { best }
        });
        matrix.swap(pivot, best);
        right.swap(pivot, best);
        let row = *matrix.get(pivot)?;
        let diagonal = at(&row, pivot);
        // Written so that a NaN is singular.
        if !R::any(diagonal.abs().greater(R::ZERO)) {
            return None;
        }
        for below in (0..count).filter(|below| *below != pivot) {
            let target = matrix.get_mut(below)?;
            let factor = at(target, pivot) / diagonal;
            for (entry, above) in target.iter_mut().zip(&row).take(count) {
                *entry = *entry - factor * *above;
            }
            let value = at(right, below) - factor * at(right, pivot);
            put(right, below, value);
        }
    }
    let own = |row: usize| matrix.get(row).map_or(R::ONE, |entries| at(entries, row));
    Some(core::array::from_fn(|row| if row < count { at(right, row) / own(row) } else { R::ZERO }))
}

#[cfg(test)]
mod tests {
    use super::super::complementarity::RIGID_TOUCHING;
    use super::*;

    /// G = J M⁻¹ Jᵀ of contacts with these normals, by a matrix of rows that depend on each other as given numbers say.
    fn problem(normals: &[[f64; 3]], coupled: f64, grip: f64) -> Problem<f64> {
        let count = normals.len();
        // J of each contact along the axes, of bodies with eight coordinates.
        let row = |contact: usize, axis: usize| -> [f64; 8] {
            core::array::from_fn(|column| {
                let far = ((7 * contact + 3 * axis + 5 * column) % 11) as f64 / 11.0 - 0.4;
                if column == (3 * contact + axis) % 8 { 1.0 } else { coupled * far }
            })
        };
        let along = |contact: usize, way: &[f64; 3]| -> [f64; 8] {
            core::array::from_fn(|column| (0..3).map(|axis| way[axis] * row(contact, axis)[column]).sum())
        };
        let mut rows = [[0.0; 8]; ROWS];
        let (mut rubs, mut next) = ([None; RIGID_TOUCHING], count);
        for (contact, normal) in normals.iter().enumerate() {
            let size = normal.iter().map(|x| x * x).sum::<f64>().sqrt();
            let n = normal.map(|x| x / size);
            rows[contact] = along(contact, &n);
            rubs[contact] = Some(Rub {
                pressed: contact,
                row: next,
                axes: 3,
                holding: grip,
                sliding: 0.9 * grip,
                way: Way::Open,
            });
            for axis in 0..3 {
                let across: [f64; 3] =
                    core::array::from_fn(|k| f64::from(u8::from(k == axis)) - n[axis] * n[k]);
                rows[next] = along(contact, &across);
                next += 1;
            }
        }
        let matrix = core::array::from_fn(|i| core::array::from_fn(|j| dot(&rows[i], &rows[j])));
        Problem { matrix, gaps: count, rubs }
    }

    /// Right sides in the range of the rows: what a push along all coordinates does.
    fn pushed(problem: &Problem<f64>, seed: usize) -> Few<f64> {
        let mut by = [0.0; ROWS];
        let across = if seed.is_multiple_of(2) { 2.0 } else { 0.3 };
        for (place, by) in by.iter_mut().enumerate().take(problem.count()) {
            let part = ((seed * 37 + place * 53) % 97) as f64 / 97.0 - 0.5;
            *by = if place < problem.gaps { -1.0 - part } else { across * part };
        }
        core::array::from_fn(|row| problem.row(row, &by))
    }

    #[test]
    fn what_is_found_obeys_coulombs_law() {
        let normals = [[0.0, 0.0, 1.0], [0.6, 0.0, 0.8], [1.0, 1.0, 1.0], [-0.2, 0.9, 0.1]];
        let (mut slid, mut held, mut none) = (0, 0, 0);
        for count in 1..=4 {
            for (coupled, grip) in [(0.0, 0.3), (0.3, 0.3), (0.6, 0.2), (0.6, 0.5), (0.9, 0.4)] {
                let incomplete = problem(&normals[..count], coupled, grip);
                let problem = incomplete.clone().completed();
                for seed in 0..[12, 12, 8, 2][count - 1] {
                    let right = pushed(&incomplete, seed);
                    let Some(found) = problem.complementary(&right, &[0.0; ROWS], (1 << count) - 1, None)
                    else {
                        none += 1;
                        continue;
                    };
                    let scale = right.iter().fold(0.0_f64, |most, c| most.max(c.abs()));
                    for (rub, way) in problem.rubbing().zip(&found.ways) {
                        let (x, y) = (found.forces[rub.pressed], rub.own(&found.forces));
                        let gap = problem.row(rub.pressed, &found.forces) + right[rub.pressed];
                        assert!(x >= 0.0 && gap >= -1e-10 * scale && x * gap.abs() <= 1e-9 * scale * scale);
                        let w = problem.rates(&rub, &found.forces, &right);
                        let n = normals[rub.pressed];
                        let aside = dot(&n, &y) / dot(&n, &n).sqrt();
                        assert!(aside.abs() <= 1e-9 * (x + 1e-9), "{aside} of {x}");
                        let speed = dot(&w, &w).sqrt();
                        if x == 0.0 {
                            continue;
                        }
                        match way {
                            Way::Open => {
                                held += 1;
                                assert!(speed <= 1e-9 * scale && rub.size(&found.forces) <= rub.holding * x);
                            }
                            Way::Along(u) => {
                                slid += 1;
                                assert!((rub.size(&found.forces) - rub.sliding * x).abs() <= 1e-12 * x);
                                for (w, u) in w.iter().zip(u) {
                                    assert!((w - speed * u).abs() <= 1e-9 * scale, "{w} {speed} {u}");
                                }
                            }
                        }
                    }
                }
            }
        }
        assert!(slid > 150 && held > 100 && none == 0, "{slid} slide, {held} hold, {none} have no solution");
    }

    /// A brick on its four corners, pulled along the floor with a force, N, that its friction holds or not.
    fn brick(pull: [f64; 2], grip: f64) -> (Problem<f64>, Few<f64>) {
        let (mass, inertia, high) = (2.0, [0.02, 0.03, 0.04], 0.05);
        let corners = [[0.1, 0.08], [-0.1, 0.08], [-0.1, -0.08], [0.1, -0.08]];
        // J of a point at r along an axis e: e and r × e.
        let row = |[x, y]: [f64; 2], axis: usize| -> [f64; 6] {
            let r = [x, y, -high];
            let e: [f64; 3] = core::array::from_fn(|k| f64::from(u8::from(k == axis)));
            let turn: [f64; 3] = core::array::from_fn(|k| {
                let (j, l) = ((k + 1) % 3, (k + 2) % 3);
                r[j] * e[l] - r[l] * e[j]
            });
            core::array::from_fn(|k| if k < 3 { e[k] } else { turn[k - 3] })
        };
        let mut rows = [[0.0; 6]; ROWS];
        let mut rubs = [None; RIGID_TOUCHING];
        for (contact, corner) in corners.into_iter().enumerate() {
            rows[contact] = row(corner, 2);
            let first = 4 + 3 * contact;
            (rows[first], rows[first + 1]) = (row(corner, 0), row(corner, 1));
            let rub =
                Rub { pressed: contact, row: first, axes: 3, holding: grip, sliding: grip, way: Way::Open };
            rubs[contact] = Some(rub);
        }
        let inverse: [f64; 6] =
            core::array::from_fn(|k| if k < 3 { 1.0 / mass } else { 1.0 / inertia[k - 3] });
        let between = |a: &[f64; 6], b: &[f64; 6]| (0..6).map(|k| a[k] * inverse[k] * b[k]).sum();
        let matrix = core::array::from_fn(|i| core::array::from_fn(|j| between(&rows[i], &rows[j])));
        let free = [pull[0] / mass, pull[1] / mass, -9.81, 0.0, 0.0, 0.0];
        let right = core::array::from_fn(|i| (0..6).map(|k| rows[i][k] * free[k]).sum());
        (Problem { matrix, gaps: 4, rubs }.completed(), right)
    }

    #[test]
    fn a_brick_holds_as_much_as_all_its_corners_do() {
        let limit = 0.5 * 2.0 * 9.81;
        for (along, share) in
            [([1.0, 0.0], 0.75), ([0.6, -0.8], 0.75), ([0.0, 1.0], 0.999), ([0.8, 0.6], 1.001)]
        {
            let (problem, right) = brick(along.map(|part| part * share * limit), 0.5);
            let found = problem.complementary(&right, &[0.0; ROWS], 15, None).expect("it holds or slides");
            let whole: [f64; 2] =
                core::array::from_fn(|axis| problem.rubbing().map(|rub| rub.own(&found.forces)[axis]).sum());
            for (whole, along) in whole.iter().zip(along) {
                assert!((whole + share.min(1.0) * limit * along).abs() < 1e-9 * limit, "{share}: {whole}");
            }
        }
    }
}
