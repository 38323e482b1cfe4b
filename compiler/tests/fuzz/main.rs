//! Definitions that nobody would write: none may panic, take long, overflow the stack, give a message without a place
//! or code that is none.
//!
//! Here the regressions in `corpus/` and a few mutants with a fixed seed; many more by
//!
//! ```text
//! cargo run --profile fuzz -p linkwright-compiler --example fuzz -- --cases 100000 --seed 1
//! ```
//! which prints what it finds as small as it gets, to be kept in `corpus/`.

mod cases;
mod judge;
mod minimise;
mod mutate;
mod random;
mod seeds;
mod soup;
mod tokens;

use judge::{Verdict, judge};
use std::time::{Duration, Instant};

/// What a thread of rustc has at least.
const STACK: usize = 2 << 20;

/// Runs on a thread with a small stack.
fn on_small_stack(run: impl FnOnce() + Send + 'static) {
    let thread = std::thread::Builder::new().stack_size(STACK).spawn(run).expect("a thread");
    if thread.join().is_err() {
        panic!("see above");
    }
}

/// The least of two runs, since a busy machine makes one long.
fn judged(text: &str) -> Result<Verdict, String> {
    let bound = Duration::from_secs(10);
    for _ in 0..2 {
        let start = Instant::now();
        let verdict = judge(text)?;
        if start.elapsed() < bound {
            return Ok(verdict);
        }
    }
    Err(format!("it takes more than {bound:?}"))
}

#[test]
fn regressions_stay_repaired() {
    on_small_stack(|| {
        let corpus = seeds::regressions();
        assert!(!corpus.is_empty());
        for (file, text) in corpus {
            if let Err(fault) = judged(&text) {
                panic!("{}: {fault}", file.display());
            }
        }
    });
}

#[test]
fn mutants_do_no_harm() {
    on_small_stack(|| {
        let mut seeds = seeds::all();
        // Small ones only: the compiler is not optimised here.
        seeds.retain(|seed| seed.tokens.len() < 400);
        let (mut items, mut errors) = (0, 0);
        for number in 0..250 {
            let text = cases::case(&seeds, 1, number);
            match judged(&text) {
                Ok(verdict) => {
                    items += usize::from(verdict == Verdict::Items);
                    errors += usize::from(verdict == Verdict::Errors);
                }
                Err(fault) => panic!("case {number}: {fault}\n{text}"),
            }
        }
        // Neither all wrong nor all right, or mutation has lost its sense.
        assert!(items > 20 && errors > 100, "{items} expansions and {errors} refusals");
    });
}

#[test]
fn a_failing_case_is_cut_down() {
    let text = "planar Name { const A = 1 ; rod b { mass [ kg ] = ( 1 + 2 ) ; } output o [ m ] = b . x ; }";
    let least = minimise::minimise(text, |text| text.contains("kg") && text.contains('+'));
    assert_eq!(least.split_whitespace().collect::<Vec<_>>(), ["kg", "+"]);
}
