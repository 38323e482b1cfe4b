//! Time of the quick return whose coupler bends, three modes, beside that of the rigid one, in double and single precision.
//!
//! ```text
//! cd benches/ratios && RUSTFLAGS="-C target-cpu=native" cargo run --release --bin flexible
//! ```
//! Evaluations are at states of the first 13 ms, steps take 5 µs: the third mode, at 1416 Hz, allows 318.

#[allow(dead_code)]
#[path = "../../../../models/src/flexible_quick_return.rs"]
mod flexible_quick_return;
#[allow(dead_code, rustdoc::broken_intra_doc_links)]
#[path = "../../../../models/src/quick_return.rs"]
mod quick_return;

use flexible_quick_return::{FlexibleQuickReturn, FlexibleQuickReturnInputs};
use quick_return::{QuickReturn, QuickReturnInputs};
use ratios::{Timed, least};

const APART: f64 = 20e-6;
const STEP: f64 = 5e-6;

fn main() {
    macro_rules! pair {
        ($scalar:ty) => {{
            let (drive, cutting): ($scalar, $scalar) = (10.0, 1.0);
            let (apart, step) = (APART as $scalar, STEP as $scalar);
            [
                Timed::new(
                    QuickReturn::<$scalar>::default(),
                    QuickReturnInputs { drive, cutting },
                    apart,
                    step,
                ),
                Timed::new(
                    FlexibleQuickReturn::<$scalar>::default(),
                    FlexibleQuickReturnInputs { drive, cutting },
                    apart,
                    step,
                ),
            ]
        }};
    }
    let mut all: Vec<Timed> = pair!(f64).into_iter().chain(pair!(f32)).collect();
    let least = least(&mut all);
    println!("| | evaluation, ns: rigid | three modes | ratio | step, ns: rigid | three modes | ratio |");
    println!("|---|---|---|---|---|---|---|");
    for (scalar, pair) in [("f64", &least[..2]), ("f32", &least[2..])] {
        let [evaluation, step] = [0, 1].map(|which| {
            let [rigid, bent] = [pair[0][which], pair[1][which]];
            format!("{rigid:.1} | {bent:.1} | {:.2}", bent / rigid)
        });
        println!("| {scalar} | {evaluation} | {step} |");
    }
}
