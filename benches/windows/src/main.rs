//! Time of an evaluation and of a step for each window of ladders of unit rods (IFToMM A02), from 5 to 1000 windows in one run.
//!
//! ```text
//! cd benches/windows && RUSTFLAGS="-C target-cpu=native" cargo run --release
//! ```
//! An evaluation is v̇ and λ with Baumgarte's terms by the way that leads, at 64 states along the motion; a step is one of RK4 by a stepper. All
//! sizes take turns, and what is shown is the least of many slices of at least 20 µs; f64.

// Its definition is that of the models.
#[macro_use]
#[allow(dead_code)]
#[path = "../../../models/src/n_four_bar.rs"]
mod n_four_bar;

use linkwright::{Assemble, AssembleExt, Rk4, StateOf};
use std::hint::black_box;
use std::time::Instant;

const STATES: usize = 64;
const ROUNDS: usize = 400;
/// Of a slice, ns.
const SLICE: f64 = 20e3;

macro_rules! ladders {
    ($($name:ident $windows:literal),* $(,)?) => {
        $(
            n_four_bar! {
                /// A ladder of unit rods.
                $name, $windows
            }
        )*

        /// Each by its number of windows, smallest first.
        fn ladders() -> Vec<Ladder> {
            vec![$(ladder::<$name<f64>>($windows)),*]
        }
    };
}

ladders!(Ladder5 5, Ladder10 10, Ladder20 20, Ladder40 40, Ladder100 100, Ladder200 200, Ladder400 400, Ladder1000 1000);

/// What is timed of one ladder: so many evaluations, so many steps.
struct Ladder {
    windows: usize,
    evaluations: Box<dyn FnMut(usize)>,
    steps: Box<dyn FnMut(usize)>,
}

fn ladder<M>(windows: usize) -> Ladder
where
    M: Assemble<f64, Inputs = ()> + AssembleExt<f64> + Default + Clone + 'static,
    StateOf<M, f64>: Clone,
{
    let model: &'static M = Box::leak(Box::new(M::default()));
    let mut stepper = model.clone().stepper(model.start(), Rk4);
    let states: Vec<StateOf<M, f64>> = (0..STATES)
        .map(|_| {
            (0..10).for_each(|_| assert!(stepper.step(&(), 1e-3).is_ok(), "{windows} windows move"));
            stepper.state().clone()
        })
        .collect();
    let function = if model.null_space_first() { M::null_space_baumgarte } else { M::acceleration_baumgarte };
    let (mut a, mut lambda, mut at) = (model.zero_v(), model.zero_lambda(), 0);
    let evaluations = move |count: usize| {
        for _ in 0..count {
            at = (at + 1) % STATES;
            let pivot = black_box(function)(
                model,
                0.0,
                black_box(&states[at]),
                &(),
                20.0,
                100.0,
                &mut a,
                &mut lambda,
            );
            black_box((pivot, &a, &lambda));
        }
    };
    let mut stepper = model.clone().stepper(model.start(), Rk4);
    let steps = move |count: usize| {
        (0..count).for_each(|_| assert!(black_box(stepper.step(&(), black_box(1e-5))).is_ok()));
    };
    Ladder { windows, evaluations: Box::new(evaluations), steps: Box::new(steps) }
}

/// ns of each of so many calls.
fn time(call: &mut dyn FnMut(usize), count: usize) -> f64 {
    let start = Instant::now();
    call(count);
    start.elapsed().as_nanos() as f64 / count as f64
}

fn main() {
    let mut ladders = ladders();
    let counts: Vec<[usize; 2]> = ladders
        .iter_mut()
        .map(|it| {
            let each = [time(&mut it.evaluations, 20), time(&mut it.steps, 20)];
            each.map(|each| (SLICE / each).ceil() as usize)
        })
        .collect();
    let mut least = vec![[f64::INFINITY; 2]; ladders.len()];
    for _ in 0..ROUNDS {
        for ((it, counts), least) in ladders.iter_mut().zip(&counts).zip(&mut least) {
            least[0] = least[0].min(time(&mut it.evaluations, counts[0]));
            least[1] = least[1].min(time(&mut it.steps, counts[1]));
        }
    }
    println!("| windows | evaluation, ns | a window | of that at 5 | step, ns | a window | of that at 5 |");
    println!("|---|---|---|---|---|---|---|");
    let each = |at: usize, which: usize| least[at][which] / ladders[at].windows as f64;
    for (at, it) in ladders.iter().enumerate() {
        let [evaluation, step] = [0, 1].map(|which| {
            let (all, each, ratio) = (least[at][which], each(at, which), each(at, which) / each(0, which));
            format!("{all:.0} | {each:.1} | {ratio:.2}")
        });
        println!("| {} | {evaluation} | {step} |", it.windows);
    }
}
