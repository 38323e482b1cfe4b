//! Calls of the runtime that nobody would make: none may panic, fail to come back, be Ok with what is no number, or change anything
//! where it is an error.
//!
//! Here what went wrong once and a few thousand calls with a fixed seed; many more by
//!
//! ```text
//! cargo run --profile fuzz --example runtime_fuzz -- --cases 200000 --seed 1
//! ```
//! which prints what it finds as the number of a case, to be kept in `FOUND`.

mod judge;
mod methods;
mod models;
mod random;

use judge::judge;

/// Seed and number of cases that went wrong once, by what was wrong.
const FOUND: [(&str, u64, u64); 3] = [
    ("an end of minus zero, reached as zero, was taken for another time", 7, 868),
    ("a step below the distance of neighbouring times was taken to stand", 7, 92_354),
    ("two such steps were", 7, 131_946),
];

#[test]
fn regressions_stay_repaired() {
    for (name, seed, number) in FOUND {
        if let Err(fault) = judge(seed, number) {
            panic!("{name}: {fault}");
        }
    }
}

#[test]
fn no_call_does_harm() {
    let hook = std::panic::take_hook();
    // What is thrown on purpose is not written.
    std::panic::set_hook(Box::new(|_| ()));
    let (mut calls, mut good, mut faults) = (0, 0, Vec::new());
    for number in 0..600 {
        match judge(1, number) {
            Ok(verdict) => (calls, good) = (calls + verdict.calls, good + verdict.good),
            Err(fault) => faults.push(format!("case {number}: {fault}")),
        }
    }
    std::panic::set_hook(hook);
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    // Neither all wrong nor all right, or the numbers have lost their sense.
    assert!(calls > 2000 && good > calls / 10 && good < calls, "{calls} calls, {good} of them Ok");
}
