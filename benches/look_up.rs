//! Time of one look-up in a table, row and value, of 16 and of 4096 knots: at arguments that stay in one row, that ascend, and in no
//! order. Beside it a binary search with branches (`partition_point`) on the same rows.
//!
//! ```text
//! cargo bench --bench look_up
//! ```

mod harness;

use harness::median;
use linkwright::__private::v1::table;
use std::hint::black_box;
use std::time::Instant;

const ARGUMENTS: usize = 4096;
const SAMPLES: usize = 41;

fn main() {
    println!("{}", harness::machine());
    println!("ns per look-up and value, median of {SAMPLES} samples of {ARGUMENTS} arguments\n");
    println!("{:<12}{:<14}{:>10}{:>24}", "knots", "arguments", "table", "search with branches");
    beside::<32>(16);
    beside::<8192>(4096);
}

/// A table of so many knots, one unit apart, whose rows are filled up to a power of two.
fn beside<const ROWS: usize>(knots: usize) {
    let mut rows = Box::new([[f64::NAN; 5]; ROWS]);
    for (at, row) in rows.iter_mut().take(knots + 1).enumerate() {
        let base = at.saturating_sub(1) as f64;
        *row = [base, (0.1 * base).sin(), 0.1, -0.01, 0.001];
    }
    let end = knots as f64;
    // A linear congruence: the same on every machine.
    let mut seed = 1_u64;
    let mut random = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1_u64 << 53) as f64
    };
    let unordered: Vec<f64> = (0..ARGUMENTS).map(|_| end * random()).collect();
    let ascending: Vec<f64> = (0..ARGUMENTS).map(|k| end * k as f64 / ARGUMENTS as f64).collect();
    let resting: Vec<f64> = (0..ARGUMENTS).map(|k| 0.4 * end + 1e-4 * k as f64 / ARGUMENTS as f64).collect();
    for (name, arguments) in [("in one row", resting), ("ascending", ascending), ("in no order", unordered)] {
        let own = time(&arguments, |x| table::value(&rows, table::cell(&rows, x), x));
        let branches = time(&arguments, |x| {
            let row = rows[1..=knots].partition_point(|row| row[0] <= x);
            let [base, a, b, c, d] = rows[row];
            let s = x - base;
            ((d * s + c) * s + b) * s + a
        });
        println!("{knots:<12}{name:<14}{own:>10.2}{branches:>24.2}");
    }
}

/// ns, each look-up waiting for the one before it, as in a law.
fn time(arguments: &[f64], look_up: impl Fn(f64) -> f64) -> f64 {
    let sample = || {
        let begin = Instant::now();
        let sum = arguments.iter().fold(0.0, |sum, x| look_up(black_box(x + 1e-12 * sum)));
        black_box(sum);
        begin.elapsed().as_secs_f64() * 1e9 / arguments.len() as f64
    };
    median((0..SAMPLES).map(|_| sample()).collect())
}
