//! Looks up one argument in a table of so many knots, a thousand times: `instructions KNOTS ARGUMENT`. What runs between
//! entering and leaving [`counted`] is the same whatever the argument.

use linkwright::__private::v1::table;
use std::hint::black_box;

const TIMES: usize = 1000;

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [knots, argument] = &arguments[..] else { panic!("instructions KNOTS ARGUMENT") };
    let x = argument.parse().expect("an argument is a number");
    let value = match knots.as_str() {
        "16" => counted(&rows::<32>(16), x),
        "4096" => counted(&rows::<8192>(4096), x),
        _ => panic!("there are tables of 16 and of 4096 knots"),
    };
    println!("{value}");
}

#[inline(never)]
fn counted<const ROWS: usize>(rows: &[[f64; 5]; ROWS], x: f64) -> f64 {
    let mut sum = 0.0;
    for _ in 0..TIMES {
        let x = black_box(x);
        sum += table::value(rows, table::cell(rows, x), x);
    }
    sum
}

/// A table of so many knots, one unit apart, whose rows are filled up to a power of two.
fn rows<const ROWS: usize>(knots: usize) -> Box<[[f64; 5]; ROWS]> {
    let mut rows = Box::new([[f64::NAN; 5]; ROWS]);
    for (at, row) in rows.iter_mut().take(knots + 1).enumerate() {
        *row = [at.saturating_sub(1) as f64, 1.0, 0.1, -0.01, 0.001];
    }
    rows
}
