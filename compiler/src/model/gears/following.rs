//! Which pairs the pairs before them fix, and whether their teeth then meet.
//!
//! The rows Σ z θ = c + 2πk have whole factors. Gauss' elimination in fractions finds each row that is a sum of others, Σ w_j row_j = 0
//! with whole w_j without a common divisor: then Σ w_j c_j is a whole number of turns, or no k makes the teeth meet. For a sun, planets
//! and a ring that is the condition of assembly, (z_s + z_r)(ψ_i − ψ_j) = 2πk.

use super::pair::remainder;
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// A fraction.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Ratio {
    over: i128,
    under: i128,
}

impl Ratio {
    const ZERO: Ratio = Ratio { over: 0, under: 1 };

    fn new(over: i128, under: i128) -> Option<Ratio> {
        let divisor = divisor(over, under);
        if divisor == 0 {
            return None;
        }
        let sign = if under < 0 { -1 } else { 1 };
        Some(Ratio { over: sign * over / divisor, under: sign * under / divisor })
    }

    fn times(self, other: Ratio) -> Option<Ratio> {
        Ratio::new(self.over.checked_mul(other.over)?, self.under.checked_mul(other.under)?)
    }

    fn minus(self, other: Ratio) -> Option<Ratio> {
        let over = self.over.checked_mul(other.under)?.checked_sub(other.over.checked_mul(self.under)?)?;
        Ratio::new(over, self.under.checked_mul(other.under)?)
    }
}

fn divisor(a: i128, b: i128) -> i128 {
    let (mut a, mut b) = (a.abs(), b.abs());
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}

/// A row of whole factors by what turns, and its constant.
pub struct Row {
    pub factors: BTreeMap<usize, i64>,
    pub constant: f64,
}

/// A row that others fix.
#[derive(Clone, Debug)]
pub struct Follows {
    /// The rows before it, with factors such that their sum and the row add up to nothing.
    pub of: Vec<(usize, f64)>,
    /// How far its teeth are from meeting, in teeth; zero where they meet.
    pub apart: f64,
}

type Sparse = BTreeMap<usize, Ratio>;

/// Of each row whether those before it fix it.
pub fn follow(rows: &[Row]) -> Vec<Option<Follows>> {
    // Each with its first factor 1, and what it is the sum of.
    let mut reduced: Vec<(usize, Sparse, Sparse)> = Vec::new();
    let mut found = Vec::new();
    for (at, row) in rows.iter().enumerate() {
        match reduce(row, at, &reduced) {
            Some((factors, parts)) => match factors.iter().next() {
                Some((pivot, lead)) => {
                    let (pivot, lead) = (*pivot, *lead);
                    let scaled = Ratio::new(lead.under, lead.over);
                    let scale = |sparse: Sparse| -> Option<Sparse> {
                        sparse.into_iter().map(|(key, value)| Some((key, value.times(scaled?)?))).collect()
                    };
                    if let (Some(factors), Some(parts)) = (scale(factors), scale(parts)) {
                        reduced.push((pivot, factors, parts));
                    }
                    found.push(None);
                }
                None => found.push(Some(dependent(rows, at, &parts))),
            },
            // Numbers of teeth whose products are beyond all bounds: they are taken as they are.
            None => found.push(None),
        }
    }
    found
}

fn reduce(row: &Row, at: usize, reduced: &[(usize, Sparse, Sparse)]) -> Option<(Sparse, Sparse)> {
    let whole = |value: &i64| Ratio { over: i128::from(*value), under: 1 };
    let mut factors: Sparse =
        row.factors.iter().filter(|(_, it)| **it != 0).map(|(key, it)| (*key, whole(it))).collect();
    let mut parts = Sparse::from([(at, Ratio { over: 1, under: 1 })]);
    for (pivot, own, of) in reduced {
        let Some(factor) = factors.get(pivot).copied() else { continue };
        for (target, source) in [(&mut factors, own), (&mut parts, of)] {
            for (key, value) in source {
                let difference =
                    target.get(key).copied().unwrap_or(Ratio::ZERO).minus(factor.times(*value)?)?;
                if difference.over == 0 {
                    target.remove(key);
                } else {
                    target.insert(*key, difference);
                }
            }
        }
    }
    Some((factors, parts))
}

fn dependent(rows: &[Row], at: usize, parts: &Sparse) -> Follows {
    let common =
        parts.values().fold(1_i128, |common, part| common / divisor(common, part.under) * part.under);
    let whole: Vec<(usize, i128)> =
        parts.iter().map(|(row, part)| (*row, part.over * (common / part.under))).collect();
    let shared = whole.iter().fold(0, |shared, (_, factor)| divisor(shared, *factor)).max(1);
    let sum: f64 = whole.iter().map(|(row, factor)| (factor / shared) as f64 * rows[*row].constant).sum();
    let own = whole.iter().find(|(row, _)| *row == at).map_or(1, |(_, factor)| factor / shared);
    let turns = remainder(sum) / TAU / own as f64;
    let factor = |part: &Ratio| part.over as f64 / part.under as f64;
    Follows {
        of: parts.iter().filter(|(row, _)| **row != at).map(|(row, part)| (*row, factor(part))).collect(),
        apart: if turns.abs() < 1e-6 { 0.0 } else { turns },
    }
}
