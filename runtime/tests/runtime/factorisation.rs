//! The table-driven LDLᵀ against a dense solution, on random sparse KKT matrices.

use linkwright_runtime::Elimination;
use linkwright_runtime::ldl::Ldl;

/// Velocities and rows of the random systems.
const V: usize = 12;
const ROWS: usize = 7;
const N: usize = V + ROWS;
const ENTRIES: usize = N * (N - 1) / 2;

/// Numbers in (−1, 1) that are the same in every run (Knuth's MMIX generator).
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// The tables for a pattern, in the given order, with the fill of a symbolic elimination.
fn tables(pattern: &[[bool; N]; N], order: [u16; N]) -> &'static Elimination<'static> {
    let mut filled = [[false; N]; N];
    for i in 0..N {
        for j in 0..N {
            filled[i][j] = pattern[order[i] as usize][order[j] as usize];
        }
    }
    for k in 0..N {
        let below: Vec<usize> = (k + 1..N).filter(|&i| filled[i][k]).collect();
        for &i in &below {
            for &j in &below {
                filled[i][j] = true;
            }
        }
    }
    let mut position = [0; N];
    let (mut row_start, mut columns) = (vec![0], vec![]);
    for (k, &unknown) in order.iter().enumerate() {
        position[unknown as usize] = k as u16;
        columns.extend((0..k).filter(|&j| filled[k][j]).map(|j| j as u16));
        row_start.push(columns.len() as u32);
    }
    Box::leak(Box::new(Elimination {
        order: Box::leak(Box::new(order)),
        position: Box::leak(Box::new(position)),
        row_start: row_start.leak(),
        columns: columns.leak(),
    }))
}

/// K x = b by Gauss elimination with row exchanges.
fn dense_solve(mut k: [[f64; N]; N], mut b: [f64; N]) -> [f64; N] {
    for i in 0..N {
        let pivot = (i..N).max_by(|&r, &s| k[r][i].abs().total_cmp(&k[s][i].abs())).unwrap();
        k.swap(i, pivot);
        b.swap(i, pivot);
        for r in i + 1..N {
            let factor = k[r][i] / k[i][i];
            let above = k[i];
            for (entry, above) in k[r].iter_mut().zip(above).skip(i) {
                *entry -= factor * above;
            }
            b[r] -= factor * b[i];
        }
    }
    for i in (0..N).rev() {
        b[i] = (b[i] - (i + 1..N).map(|j| k[i][j] * b[j]).sum::<f64>()) / k[i][i];
    }
    b
}

/// M with some couplings between neighbours, D with four entries in each row.
fn random_kkt(random: &mut Random) -> [[f64; N]; N] {
    let mut k = [[0.0; N]; N];
    for i in 0..V {
        k[i][i] = 1.5 + random.next();
        if i % 3 == 2 {
            let coupling = 0.3 * random.next();
            (k[i][i - 1], k[i - 1][i]) = (coupling, coupling);
        }
    }
    for row in 0..ROWS {
        for offset in [0, 1, 3, 5] {
            let (i, j) = (V + row, (row * 5 / 3 + offset) % V);
            let entry = random.next();
            (k[i][j], k[j][i]) = (entry, entry);
        }
    }
    k
}

/// Each row right after the last of its velocities: the rule of the tables.
fn interleaved(pattern: &[[bool; N]; N]) -> [u16; N] {
    let mut order = vec![];
    let mut placed = [false; N];
    for velocity in 0..V {
        order.push(velocity as u16);
        placed[velocity] = true;
        for row in V..N {
            if !placed[row] && (0..V).all(|j| !pattern[row][j] || placed[j]) {
                order.push(row as u16);
                placed[row] = true;
            }
        }
    }
    order.try_into().unwrap()
}

#[test]
fn agrees_with_a_dense_solution() {
    let mut random = Random(7);
    for _ in 0..50 {
        let k = random_kkt(&mut random);
        let pattern = k.map(|row| row.map(|entry| entry != 0.0));
        let tables = tables(&pattern, interleaved(&pattern));
        // The numbers of the tables are fewer than those of a full triangle; the rest stays unused.
        let padded: &'static Elimination<'static> =
            Box::leak(Box::new(Elimination { columns: pad(tables.columns), ..*tables }));
        let mut factor = Ldl::<f64, [f64; ENTRIES], [f64; N]>::new(padded);
        for i in 0..N {
            for j in 0..=i {
                if pattern[i][j] {
                    factor.add(padded, i, j, k[i][j]);
                }
            }
        }
        let right: [f64; N] = std::array::from_fn(|_| random.next());
        let pivot = factor.factor(padded);
        assert!(pivot.value > 1e-6, "{pivot:?}");
        let (sparse, dense) = (factor.solve(padded, &right), dense_solve(k, right));
        let scale = dense.iter().fold(1.0_f64, |largest, x| largest.max(x.abs()));
        for (sparse, dense) in sparse.iter().zip(dense) {
            assert!((sparse - dense).abs() <= 1e-11 * scale, "{sparse} {dense}");
        }
    }
}

/// Fills up to the length of the storage.
fn pad(columns: &'static [u16]) -> &'static [u16] {
    let mut columns = columns.to_vec();
    columns.resize(ENTRIES, 0);
    columns.leak()
}

#[test]
fn a_dependent_row_is_named() {
    // Two equal rows over two velocities.
    static TABLES: Elimination<'static> = Elimination {
        order: &[0, 1, 2, 3],
        position: &[0, 1, 2, 3],
        row_start: &[0, 0, 0, 2, 5],
        columns: &[0, 1, 0, 1, 2],
    };
    let mut k = Ldl::<f64, [f64; 5], [f64; 4]>::new(&TABLES);
    for (i, j, value) in [(0, 0, 2.0), (1, 1, 3.0), (2, 0, 0.7), (2, 1, 0.1), (3, 0, 0.7), (3, 1, 0.1)] {
        k.add(&TABLES, i, j, value);
    }
    let pivot = k.factor(&TABLES);
    assert!(pivot.value < 1e-15 && pivot.unknown == 3, "{pivot:?}");
}

#[test]
fn a_velocity_without_mass_or_constraint_is_named() {
    static TABLES: Elimination<'static> =
        Elimination { order: &[0, 1], position: &[0, 1], row_start: &[0, 0, 0], columns: &[] };
    let mut k = Ldl::<f64, [f64; 0], [f64; 2]>::new(&TABLES);
    k.add(&TABLES, 0, 0, 2.0);
    let pivot = k.factor(&TABLES);
    assert_eq!((pivot.value, pivot.unknown), (0.0, 1));
}
