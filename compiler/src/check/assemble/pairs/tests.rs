//! Pairs of made-up rows.

use super::*;

fn rows(entries: &[&[f64]]) -> Rows {
    let of_row = |row: &&[f64]| row.iter().copied().enumerate().filter(|(_, entry)| *entry != 0.0).collect();
    entries.iter().map(of_row).enumerate().collect()
}

/// Row by row the velocity of its number; everything of size one.
fn four() -> ([Pivot; ROWS], Partition) {
    let chosen = Partition { scales: vec![1.0; 6], row_sizes: vec![1.0; 5], ..Partition::default() };
    ([0, 1, 2, 3].map(|at| Pivot { row: at, velocity: at }), chosen)
}

fn taken(along: &[Rows], before: &[Vec<Pivot>]) -> Option<[Vec<(usize, usize)>; 2]> {
    let (four, chosen) = four();
    let pairs = best(&chosen, before, &four, along)?;
    Some(pairs.map(|pair| pair.iter().map(|pivot| (pivot.row, pivot.velocity)).collect()))
}

#[test]
fn determinants() {
    let (four, _) = four();
    let square = rows(&[&[2.0, -1.0, 3.0], &[4.0, -2.0, 1.0], &[0.5, 2.0, -3.0]]);
    // By the first row.
    let known = 2.0 * (6.0 - 2.0) + (-12.0 - 0.5) + 3.0 * (8.0 + 1.0);
    assert!((determinant(&square, &four[..3]) - known).abs() < 1e-13);
    assert!(determinant(&square, &four[..2]).abs() < 1e-15);
    assert_eq!(determinant(&rows(&[&[0.0, 1.0], &[1.0, 0.0]]), &four[..2]), -1.0);
}

/// Two squares beside each other, and an independent velocity. One entry of each square makes a block without others, which takes less than the
/// squares, where it is half as regular at least; nothing takes less than what is taken.
#[test]
fn the_pairs_that_take_least_are_taken() {
    let along = [rows(&[
        &[1.0, 0.5, 0.0, 0.0, 0.1],
        &[-0.5, 1.0, 0.0, 0.0, 0.0],
        &[0.0, 0.0, 1.0, 0.4, 0.0],
        &[0.0, 0.0, -0.4, 1.0, 0.3],
    ])];
    let (four, chosen) = four();
    let pairs = best(&chosen, &[], &four, &along).expect("they are as regular as three and one");
    let of = |blocks: &[Vec<Pivot>; 2]| smaller(&chosen, &along, blocks)[0];
    assert!(of(&pairs) >= AS_REGULAR * of(&[four[..3].to_vec(), four[3..].to_vec()]));
    let squares = [four[..2].to_vec(), four[2..].to_vec()];
    let alone = [vec![four[1], four[2]], vec![four[0], four[3]]];
    let [taken, squares, alone] = [&pairs, &squares, &alone].map(|pairs| products(&along[0], pairs));
    assert!(taken == alone && alone < squares, "{taken}, {alone}, {squares}");
}

/// The first square is nothing at the second position, where all four rows together are regular: other pairs are taken.
#[test]
fn a_pair_that_vanishes_along_the_motion_is_not_taken() {
    let at = |x: f64| {
        rows(&[
            &[1.0, x, 1.0, 0.0, 0.1],
            &[x, 1.0, 0.0, 1.0, 0.0],
            &[0.5, 0.0, 1.0, 0.4, 0.0],
            &[0.0, 0.7, -0.4, 1.0, 0.3],
        ])
    };
    let (four, chosen) = four();
    let along = [at(0.0), at(1.0)];
    assert!(determinant(&along[1], &four).abs() > 0.1);
    let vector = [four[..3].to_vec(), four[3..].to_vec()];
    let of_vector = smaller(&chosen, &along, &vector);
    let pairs = taken(&along, &[]).expect("some are as regular");
    assert!(!pairs.contains(&vec![(0, 0), (1, 1)]), "{pairs:?}");
    let blocks = pairs.map(|pair| pair.iter().map(|(row, at)| Pivot { row: *row, velocity: *at }).collect());
    for (pairs, vector) in smaller(&chosen, &along, &blocks).iter().zip(&of_vector) {
        assert!(*pairs >= AS_REGULAR * vector, "{pairs} in place of {vector}");
    }
}

/// What comes before is taken out first: the rows that are left are those of the test above.
#[test]
fn rows_before_are_taken_out() {
    let own = [
        &[1.0, 0.5, 0.0, 0.0, 0.1, 0.0][..],
        &[-0.5, 1.0, 0.0, 0.0, 0.0, 0.0],
        &[0.0, 0.0, 1.0, 0.4, 0.0, 0.0],
        &[0.0, 0.0, -0.4, 1.0, 0.3, 0.0],
    ];
    let mut all: Vec<Vec<f64>> = own.map(<[f64]>::to_vec).to_vec();
    all.push(vec![0.3, 0.2, 0.0, 0.0, 0.0, 2.0]);
    all[0] = all[0].iter().zip(&all[4]).map(|(x, y)| x + 0.25 * y).collect();
    let all: Vec<&[f64]> = all.iter().map(Vec::as_slice).collect();
    let before = [vec![Pivot { row: 4, velocity: 5 }]];
    let left = without(&rows(&all), &[1.0; 6], &before).expect("2 is no nothing");
    for (row, entries) in own.iter().enumerate() {
        for (column, entry) in entries.iter().enumerate() {
            let found = left[&row].get(&column).copied().unwrap_or(0.0);
            assert!((found - entry).abs() < 1e-15, "{row}, {column}: {found}");
        }
    }
    assert_eq!(taken(&[rows(&all)], &before), taken(&[rows(&own)], &[]));
}

/// By hand: two full squares with one column beside the first.
#[test]
fn products_by_structure() {
    let full = rows(&[
        &[1.0, 1.0, 0.0, 0.0, 1.0],
        &[1.0, 1.0, 0.0, 0.0, 0.0],
        &[0.0, 0.0, 1.0, 1.0, 0.0],
        &[1.0, 0.0, 1.0, 1.0, 0.0],
    ]);
    let (four, _) = four();
    // Four entries of the inverse, made and used three times; two of U, made by one product each and used three times; one of L,
    // used three times, and for one of D.
    let first = 4 * 4 + 2 + 2 * 3 + 3 + 1;
    // Four entries of the inverse; beside it the entry that came in, two of U.
    let second = 4 * 4 + 2 + 2 * 3;
    assert_eq!(products(&full, &[four[..2].to_vec(), four[2..].to_vec()]), first + second);
}
