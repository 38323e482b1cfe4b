//! Small linear systems, by Gauss with the largest pivot of each column relative to its row.

/// A pivot that is less, as a part of the largest entry of its row, is none.
const SINGULAR: f64 = 1e-10;

/// A = P L U.
pub(super) struct Eliminated {
    /// L below the diagonal, U on it and above.
    rows: Vec<Vec<f64>>,
    /// Which rows of A these are.
    which: Vec<usize>,
}

impl Eliminated {
    /// Or the first row of A without a pivot.
    pub fn of(mut rows: Vec<Vec<f64>>) -> Result<Self, usize> {
        let count = rows.len();
        let mut which: Vec<usize> = (0..count).collect();
        let largest: Vec<f64> =
            rows.iter().map(|row| row.iter().fold(0.0, |most: f64, entry| most.max(entry.abs()))).collect();
        for at in 0..count {
            let relative = |row: &usize| rows[*row][at].abs() / largest[which[*row]];
            let best = (at..count).max_by(|a, b| relative(a).total_cmp(&relative(b))).unwrap_or(at);
            // Written so that a NaN is none.
            if !(relative(&best) > SINGULAR && relative(&best).is_finite()) {
                return Err(which[best]);
            }
            rows.swap(at, best);
            which.swap(at, best);
            let (above, below) = rows.split_at_mut(at + 1);
            let pivot = &above[at];
            for row in below.iter_mut().filter(|row| row[at] != 0.0) {
                let factor = row[at] / pivot[at];
                row[at] = factor;
                row[at + 1..]
                    .iter_mut()
                    .zip(&pivot[at + 1..])
                    .for_each(|(entry, pivot)| *entry -= factor * pivot);
            }
        }
        Ok(Eliminated { rows, which })
    }

    pub fn size(&self) -> usize {
        self.rows.len()
    }

    /// x of A x = b.
    pub fn solve(&self, b: &[f64]) -> Vec<f64> {
        let count = self.rows.len();
        let mut x: Vec<f64> = self.which.iter().map(|row| b[*row]).collect();
        for at in 0..count {
            x[at] -= (0..at).map(|k| self.rows[at][k] * x[k]).sum::<f64>();
        }
        for at in (0..count).rev() {
            let known: f64 = (at + 1..count).map(|k| self.rows[at][k] * x[k]).sum();
            x[at] = (x[at] - known) / self.rows[at][at];
        }
        x
    }
}

/// x of A x = b, in rows [A b], or the first row without a pivot.
pub(super) fn eliminated(mut rows: Vec<Vec<f64>>) -> Result<Vec<f64>, usize> {
    let right: Vec<f64> = rows.iter_mut().map(|row| row.pop().unwrap_or(0.0)).collect();
    Ok(Eliminated::of(rows)?.solve(&right))
}
