//! Which rows of a redundant mechanism are taken where.
//!
//! At a position let N (m × k, orthonormal columns) span the left null space of D, rows brought to the same size. Without the k rows
//! of a set K the others still hold all that D holds if and only if N_K, the rows of N in K, is regular, and the least
//! eigenvalue of what they hold is at least σ² of that of D, σ the least singular value of N_K (by the CS decomposition: Golub,
//! Van Loan, *Matrix Computations*, 2.5.4). So σ says how well a set can be left out. One set that serves all along the motion
//! is best; where there is none, as in a parallelogram with three cranks, whose internal force turns with them, there are
//! several, a chart each, and the mechanism takes at each position the one that serves best there.

use super::redundancy::{Basis, TAKES_PART};

/// A set left out all along the motion is left out for good if σ stays above this.
const HOLDS: f64 = 0.1;
/// Where none stays above that, the best one will do if it stays above this.
const SUFFICES: f64 = 0.03;
/// Together the charts must keep σ above this.
const SERVES: f64 = 0.02;
/// Sets that are compared; where there are more, those of the rows that take part most.
const MOST_SETS: usize = 400;
const MOST_CHARTS: usize = 4;
/// Rows that switch, taken or not: the determinant of as many is written out for each chart.
const MOST_SLOTS: usize = 6;

/// The sets of rows to be left out, the best alone first.
#[derive(Clone, Debug, PartialEq)]
pub struct Charts {
    /// Indices into the rows that were asked about, ascending; all of one length.
    pub sets: Vec<Vec<usize>>,
    /// The least σ along the motion of the best of them at each position.
    pub least: f64,
}

/// Charts for rows whose left null spaces at the positions along the motion are `spaces`, the first `near` of them near the start: of
/// sets that hold everywhere the one is taken that holds best there. `None` where rows that may not be left out are all that repeat.
pub fn choose(
    spaces: &[Basis],
    near: usize,
    rows: usize,
    droppable: impl Fn(usize) -> bool,
) -> Option<Charts> {
    let count = spaces.iter().map(Vec::len).min()?;
    // Where more is lost the mechanism is at a singular position, and no choice helps.
    let near = spaces.iter().take(near).filter(|space| space.len() == count).count();
    let spaces: Vec<&Basis> = spaces.iter().filter(|space| space.len() == count).collect();
    if count == 0 {
        return None;
    }
    let share = |row: usize| {
        spaces.iter().map(|space| space.iter().map(|w| w[row] * w[row]).sum::<f64>()).fold(0.0, f64::max)
    };
    let mut candidates: Vec<usize> =
        (0..rows).filter(|row| droppable(*row) && share(*row) > TAKES_PART).collect();
    // The rows that take part most, if there are too many to compare all sets.
    candidates.sort_by(|a, b| rounded(share(*b)).total_cmp(&rounded(share(*a))).then(a.cmp(b)));
    while candidates.len() > count && sets(candidates.len(), count) > MOST_SETS {
        candidates.pop();
    }
    candidates.sort_unstable();
    let sets = subsets(&candidates, count);
    let quality: Vec<Vec<f64>> =
        sets.iter().map(|set| spaces.iter().map(|space| least_singular(space, set)).collect()).collect();
    let beside = |set: usize| least(quality[set].iter().take(near.max(1)).copied());
    let holding = (0..sets.len()).filter(|set| least(quality[*set].iter().copied()) >= HOLDS);
    let best = holding.reduce(|best, set| if beside(set) > beside(best) + 1e-6 { set } else { best });
    let alone = |set: usize| least(quality[set].iter().copied());
    let most = (0..sets.len()).reduce(|best, set| if alone(set) > alone(best) + 1e-6 { set } else { best });
    if let Some(set) = best.or(most.filter(|set| alone(*set) >= SUFFICES)) {
        return Some(Charts { sets: vec![sets[set].clone()], least: alone(set) });
    }
    let mut covered = vec![0.0_f64; spaces.len()];
    let mut charts: Vec<usize> = Vec::new();
    // In turn the one that helps most where those before serve worst.
    while charts.len() < MOST_CHARTS {
        let with = |set: usize| least(covered.iter().zip(&quality[set]).map(|(a, b)| a.max(*b)));
        let mut best: Option<(f64, usize)> = None;
        for set in 0..sets.len() {
            let found = with(set);
            // Rounding must not decide between sets that serve alike.
            if best.is_none_or(|(known, _)| found > known * (1.0 + 1e-6) + 1e-12) {
                best = Some((found, set));
            }
        }
        let (found, set) = best?;
        if !charts.is_empty() && found <= least(covered.iter().copied()) {
            break;
        }
        charts.push(set);
        covered.iter_mut().zip(&quality[set]).for_each(|(a, b)| *a = a.max(*b));
        if found >= HOLDS {
            break;
        }
    }
    if charts.len() > 1
        && let Some((a, b)) = pair(&quality)
        && least(quality[a].iter().zip(&quality[b]).map(|(a, b)| a.max(*b))) >= HOLDS
    {
        charts = vec![a, b];
        covered = quality[a].iter().zip(&quality[b]).map(|(a, b)| a.max(*b)).collect();
    }
    let least = least(covered.into_iter());
    Some(Charts { sets: charts.into_iter().map(|set| sets[set].clone()).collect(), least })
}

impl Charts {
    /// Whether they serve all along the motion, and switch few enough rows to be written out.
    pub fn hold(&self) -> bool {
        let mut switched: Vec<usize> = self.sets.concat();
        switched.sort_unstable();
        switched.dedup();
        let left_out = self.sets.first().map_or(0, Vec::len);
        self.least >= SERVES
            && (self.sets.len() == 1 || left_out.max(switched.len() - left_out) <= MOST_SLOTS)
    }
}

/// The two sets of which the better one at each position is best where it is worst.
fn pair(quality: &[Vec<f64>]) -> Option<(usize, usize)> {
    let mut best: Option<(f64, (usize, usize))> = None;
    for (a, of_a) in quality.iter().enumerate() {
        for (b, of_b) in quality.iter().enumerate().skip(a + 1) {
            let found = least(of_a.iter().zip(of_b).map(|(x, y)| x.max(*y)));
            if best.is_none_or(|(known, _)| found > known * (1.0 + 1e-6) + 1e-12) {
                best = Some((found, (a, b)));
            }
        }
    }
    best.map(|(_, pair)| pair)
}

fn least(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(f64::INFINITY, f64::min)
}

/// To six digits, so that rounding decides nothing.
fn rounded(share: f64) -> f64 {
    libm::round(share * 1e6) / 1e6
}

/// The number of sets of `count` among `of`; saturates.
fn sets(of: usize, count: usize) -> usize {
    (0..count).fold(1_usize, |product, k| product.saturating_mul(of - k) / (k + 1))
}

/// All sets of `count` candidates, ascending.
fn subsets(candidates: &[usize], count: usize) -> Vec<Vec<usize>> {
    if count == 0 {
        return vec![Vec::new()];
    }
    let mut found = Vec::new();
    for (at, first) in candidates.iter().enumerate() {
        for rest in subsets(&candidates[at + 1..], count - 1) {
            found.push([vec![*first], rest].concat());
        }
    }
    found
}

/// The least singular value of the rows `set` of a basis: the root of the least eigenvalue of N_K N_Kᵀ, by Jacobi's rotations.
fn least_singular(space: &Basis, set: &[usize]) -> f64 {
    let size = set.len();
    let mut a: Vec<Vec<f64>> =
        set.iter().map(|i| set.iter().map(|j| space.iter().map(|w| w[*i] * w[*j]).sum()).collect()).collect();
    for _ in 0..SWEEPS {
        let mut off = 0.0;
        for p in 0..size {
            for q in p + 1..size {
                off += a[p][q] * a[p][q];
                rotate(&mut a, p, q);
            }
        }
        if off < 1e-26 {
            break;
        }
    }
    least((0..size).map(|k| a[k][k])).max(0.0).sqrt()
}

const SWEEPS: usize = 12;

/// Makes a[p][q] zero (Golub, Van Loan, *Matrix Computations*, 8.5.2).
fn rotate(a: &mut [Vec<f64>], p: usize, q: usize) {
    if a[p][q] == 0.0 {
        return;
    }
    let tau = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
    let sign = if tau < 0.0 { -1.0 } else { 1.0 };
    let t = sign / (tau.abs() + (1.0 + tau * tau).sqrt());
    let c = 1.0 / (1.0 + t * t).sqrt();
    let s = t * c;
    for row in a.iter_mut() {
        (row[p], row[q]) = (c * row[p] - s * row[q], s * row[p] + c * row[q]);
    }
    let (above, below) = a.split_at_mut(q);
    for (x, y) in above[p].iter_mut().zip(&mut below[0]) {
        (*x, *y) = (c * *x - s * *y, s * *x + c * *y);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Positions round a cycle, with one repeated row each.
    fn cycle(w: impl Fn(f64) -> Vec<f64>) -> Vec<Basis> {
        (0..40).map(|k| vec![w(f64::from(k) * std::f64::consts::TAU / 40.0 + 0.01)]).collect()
    }

    #[test]
    fn a_row_that_always_takes_part_is_left_out_for_good() {
        let spaces = cycle(|a| vec![0.6 * a.cos(), 0.8, 0.6 * a.sin()]);
        let charts = choose(&spaces, 1, 3, |_| true).expect("rows repeat");
        assert_eq!(charts.sets, [[1]]);
        assert!((charts.least - 0.8).abs() < 1e-9 && charts.hold());
    }

    #[test]
    fn a_direction_that_turns_needs_two_charts() {
        let spaces = cycle(|a| vec![0.0, a.cos(), a.sin()]);
        let charts = choose(&spaces, 1, 3, |_| true).expect("rows repeat");
        assert_eq!(charts.sets, [[1], [2]]);
        assert!((charts.least - 0.5_f64.sqrt()).abs() < 0.02, "{}", charts.least);
    }

    #[test]
    fn rows_that_must_stay_are_not_left_out() {
        let spaces = cycle(|a| vec![0.6 * a.cos(), 0.8, 0.6 * a.sin()]);
        let charts = choose(&spaces, 1, 3, |row| row != 1).expect("rows repeat");
        assert_eq!(charts.sets, [[0], [2]]);
        assert_eq!(choose(&spaces, 1, 3, |_| false), None);
    }

    /// As many rows switch as are in some set; what is in none is taken everywhere.
    #[test]
    fn more_rows_than_are_written_out_do_not_switch() {
        let six = |first: usize| (first..first + 6).collect::<Vec<_>>();
        let charts = |sets: Vec<Vec<usize>>| Charts { sets, least: 0.5 };
        assert!(charts(vec![six(0), six(6)]).hold());
        // Six left out of thirteen are seven taken.
        assert!(!charts(vec![six(0), six(6), six(7)]).hold());
        let seven = |first: usize| (first..first + 7).collect::<Vec<_>>();
        assert!(!charts(vec![seven(0), seven(1)]).hold());
        // One set for good does not switch, however large.
        assert!(charts(vec![seven(0)]).hold());
    }

    #[test]
    fn sets_are_counted_and_listed_alike() {
        for (of, count) in [(5, 3), (6, 1), (7, 7), (12, 2)] {
            let candidates: Vec<usize> = (0..of).collect();
            assert_eq!(subsets(&candidates, count).len(), sets(of, count));
        }
    }
}
