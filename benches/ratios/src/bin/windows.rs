//! Time of an evaluation and of a step for each window of ladders of unit rods (IFToMM A02), from 5 to 1000 windows in one run.
//!
//! ```text
//! cd benches/ratios && RUSTFLAGS="-C target-cpu=native" cargo run --release --bin windows
//! ```
//! An evaluation is v̇ and λ with Baumgarte's terms by the way that leads, at 8 states along the motion; a step is one of RK4 by a stepper. All
//! sizes take turns, and what is shown is the least of many slices of at least 20 µs and 64 calls; f64.

// Its definition is that of the models.
#[macro_use]
#[allow(dead_code)]
#[path = "../../../../models/src/n_four_bar.rs"]
mod n_four_bar;

use linkwright::{Assemble, AssembleExt};
use ratios::{Timed, least};

macro_rules! ladders {
    ($($name:ident $windows:literal),* $(,)?) => {
        $(
            n_four_bar! {
                /// A ladder of unit rods.
                $name, $windows
            }
        )*

        /// Each with its number of windows, smallest first.
        fn ladders() -> Vec<(usize, Timed)> {
            vec![$(($windows, ladder::<$name<f64>>())),*]
        }
    };
}

ladders!(Ladder5 5, Ladder10 10, Ladder20 20, Ladder40 40, Ladder100 100, Ladder200 200, Ladder400 400, Ladder1000 1000);

fn ladder<M: Assemble<f64, Inputs = ()> + AssembleExt<f64> + Default + Clone + 'static>() -> Timed {
    Timed::new(M::default(), (), 1e-3, 1e-5)
}

fn main() {
    let (windows, mut ladders): (Vec<usize>, Vec<Timed>) = ladders().into_iter().unzip();
    let least = least(&mut ladders);
    println!("| windows | evaluation, ns | a window | of that at 5 | step, ns | a window | of that at 5 |");
    println!("|---|---|---|---|---|---|---|");
    let each = |at: usize, which: usize| least[at][which] / windows[at] as f64;
    for (at, windows) in windows.iter().enumerate() {
        let [evaluation, step] = [0, 1].map(|which| {
            let (all, each, ratio) = (least[at][which], each(at, which), each(at, which) / each(0, which));
            format!("{all:.0} | {each:.1} | {ratio:.2}")
        });
        println!("| {windows} | {evaluation} | {step} |");
    }
}
