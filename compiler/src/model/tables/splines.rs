//! Slopes at the knots of splines: those that make the second derivative continuous, by elimination in a band of three
//! (de Boor, A Practical Guide to Splines, chapter IV).

/// One equation: factors of the slope before, at and behind a knot, and the right-hand side.
type Row = [f64; 4];

/// The second derivative is the same on both sides of an inner knot.
fn joined(h: [f64; 2], s: [f64; 2]) -> Row {
    [h[1], 2.0 * (h[0] + h[1]), h[0], 3.0 * (h[1] * s[0] + h[0] * s[1])]
}

fn inner(widths: &[f64], secants: &[f64]) -> impl Iterator<Item = Row> {
    widths.windows(2).zip(secants.windows(2)).map(|(h, s)| joined([h[0], h[1]], [s[0], s[1]]))
}

/// Not-a-knot: the third derivative too is continuous at the first and the last inner knot.
pub(super) fn cubic(widths: &[f64], secants: &[f64]) -> Vec<f64> {
    let end = |h: [f64; 2], s: [f64; 2]| {
        let d = h[0] + h[1];
        [h[1], d, ((h[0] + 2.0 * d) * h[1] * s[0] + h[0] * h[0] * s[1]) / d]
    };
    let n = widths.len() + 1;
    let [at, behind, first] = end([widths[0], widths[1]], [secants[0], secants[1]]);
    let mut rows = vec![[0.0, at, behind, first]];
    rows.extend(inner(widths, secants));
    let [at, before, last] = end([widths[n - 2], widths[n - 3]], [secants[n - 2], secants[n - 3]]);
    rows.push([before, at, 0.0, last]);
    solve(&rows, |row| row[3])
}

/// The second derivative is zero at both ends.
pub(super) fn natural(widths: &[f64], secants: &[f64]) -> Vec<f64> {
    let n = widths.len() + 1;
    let mut rows = vec![[0.0, 2.0, 1.0, 3.0 * secants[0]]];
    rows.extend(inner(widths, secants));
    rows.push([1.0, 2.0, 0.0, 3.0 * secants[n - 2]]);
    solve(&rows, |row| row[3])
}

/// The last knot is the first one, a period later.
pub(super) fn periodic(widths: &[f64], secants: &[f64]) -> Vec<f64> {
    let n = widths.len();
    let first = joined([widths[n - 1], widths[0]], [secants[n - 1], secants[0]]);
    let mut rows = vec![first];
    rows.extend(inner(widths, secants));
    let slopes = match rows.as_slice() {
        // The only neighbour of a knot is itself, or the other one on both sides.
        [_] => vec![0.0],
        [[a, b, c, r], [d, e, f, s]] => {
            let (across, back) = (a + c, d + f);
            let determinant = b * e - across * back;
            vec![(r * e - across * s) / determinant, (b * s - back * r) / determinant]
        }
        _ => cyclic(&mut rows),
    };
    slopes.iter().chain(&slopes[..1]).copied().collect()
}

/// The band with corners, as a band and one dyad (Sherman and Morrison).
fn cyclic(rows: &mut [Row]) -> Vec<f64> {
    let last = rows.len() - 1;
    let (upper, lower) = (rows[0][0], rows[last][2]);
    let shift = -rows[0][1];
    rows[0][1] -= shift;
    rows[last][1] -= lower * upper / shift;
    let plain = solve(rows, |row| row[3]);
    let mut corner: Vec<Row> = rows.to_vec();
    corner.iter_mut().for_each(|row| row[3] = 0.0);
    (corner[0][3], corner[last][3]) = (shift, lower);
    let dyad = solve(&corner, |row| row[3]);
    let along = |x: &[f64]| x[0] + upper / shift * x[last];
    let share = along(&plain) / (1.0 + along(&dyad));
    plain.iter().zip(&dyad).map(|(plain, dyad)| plain - share * dyad).collect()
}

/// A band of three, without pivoting: the rows of splines dominate.
fn solve(rows: &[Row], right: impl Fn(&Row) -> f64) -> Vec<f64> {
    let mut reduced: Vec<[f64; 2]> = Vec::with_capacity(rows.len());
    let mut before = [0.0; 2];
    for row in rows {
        let pivot = row[1] - row[0] * before[0];
        before = [row[2] / pivot, (right(row) - row[0] * before[1]) / pivot];
        reduced.push(before);
    }
    let mut solution = vec![0.0; rows.len()];
    let mut behind = 0.0;
    for (index, [factor, right]) in reduced.iter().enumerate().rev() {
        behind = right - factor * behind;
        solution[index] = behind;
    }
    solution
}
