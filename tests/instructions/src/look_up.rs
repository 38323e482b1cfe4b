//! Looking up in tables.

use linkwright::__private::v1::table;
use std::hint::black_box;

const TIMES: usize = 1000;

/// Looks up one argument in a table of so many knots. What runs is the same whatever the argument.
pub fn look_up(knots: &str, argument: &str) {
    let x: f64 = argument.parse().expect("an argument is a number");
    match knots {
        "16" => of_rows(&rows::<32>(16), x),
        "4096" => of_rows(&rows::<8192>(4096), x),
        _ => panic!("there are tables of 16 and of 4096 knots"),
    }
}

fn of_rows<const ROWS: usize>(rows: &[[f64; 5]; ROWS], x: f64) {
    let mut sum = 0.0;
    super::counted(TIMES, || {
        let x = black_box(x);
        sum += table::value(rows, table::cell(rows, x), x);
    });
    println!("{sum}");
}

/// A table of so many knots, one unit apart, whose rows are filled up to a power of two.
fn rows<const ROWS: usize>(knots: usize) -> Box<[[f64; 5]; ROWS]> {
    let mut rows = Box::new([[f64::NAN; 5]; ROWS]);
    for (at, row) in rows.iter_mut().take(knots + 1).enumerate() {
        *row = [at.saturating_sub(1) as f64, 1.0, 0.1, -0.01, 0.001];
    }
    rows
}
