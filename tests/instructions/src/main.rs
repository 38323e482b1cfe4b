//! What is counted under valgrind, between entering and leaving [`counted`]:
//!
//! ```text
//! instructions look_up KNOTS ARGUMENT     a thousand look-ups of one argument in a table of so many knots
//! instructions evaluation MODEL           a hundred accelerations with Baumgarte's terms, by the way that leads
//! instructions step MODEL                 a hundred steps of RK4 with Baumgarte's terms
//! instructions models                     writes the names of the models
//! instructions files                      writes those of the files that they stand in
//! ```

mod look_up;

use linkwright::{Assemble, AssembleExt, Fields, Rk4, Vector};
use linkwright_models::{andrews, bricard, double_pendulum, four_bar, n_four_bar, panda};
use std::hint::black_box;

const TIMES: usize = 100;

macro_rules! models {
    ($($name:ident: $file:ident::$model:ident),* $(,)?) => {
        const MODELS: &[&str] = &[$(stringify!($name)),*];
        const FILES: &[&str] = &[$(stringify!($file)),*];

        fn of_model(what: &str, model: &str) {
            match (what, model) {
                $(
                    ("evaluation", stringify!($name)) => evaluation::<$file::$model>(),
                    ("step", stringify!($name)) => step::<$file::$model>(),
                )*
                _ => panic!("{what} {model} is none of these: look_up, evaluation, step; {MODELS:?}"),
            }
        }
    };
}

models!(
    double_pendulum: double_pendulum::DoublePendulum,
    four_bar: four_bar::FourBar,
    n_four_bar_10: n_four_bar::NFourBar10,
    n_four_bar_40: n_four_bar::NFourBar40,
    andrews: andrews::Andrews,
    panda: panda::Panda,
    bricard: bricard::Bricard,
);

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match arguments[..] {
        ["models"] => MODELS.iter().for_each(|model| println!("{model}")),
        ["files"] => {
            let mut files = FILES.to_vec();
            files.dedup();
            files.iter().for_each(|file| println!("{file}"));
        }
        ["look_up", knots, argument] => look_up::look_up(knots, argument),
        [what, model] => of_model(what, model),
        _ => panic!("instructions look_up KNOTS ARGUMENT, or evaluation or step and one of {MODELS:?}"),
    }
}

/// What is counted.
#[inline(never)]
fn counted(times: usize, mut call: impl FnMut()) {
    (0..times).for_each(|_| call());
}

fn none<M: Assemble<f64, Inputs: Fields<f64>>>() -> M::Inputs {
    M::Inputs::from_array(Vector::zeros(M::Inputs::NAMES.len()))
}

fn evaluation<M: Assemble<f64, Inputs: Fields<f64>> + Default>() {
    let model = black_box(M::default());
    let (state, inputs) = (model.start(), none::<M>());
    let (mut a, mut lambda) = (model.zero_v(), model.zero_lambda());
    let function = if model.null_space_first() { M::null_space_baumgarte } else { M::acceleration_baumgarte };
    counted(TIMES, || {
        let pivot =
            black_box(function)(&model, 0.0, black_box(&state), &inputs, 20.0, 100.0, &mut a, &mut lambda);
        black_box((pivot, &a, &lambda));
    });
}

fn step<M: Assemble<f64, Inputs: Fields<f64>> + Default + Clone>() {
    let model = M::default();
    let inputs = none::<M>();
    let mut stepper = model.stepper(model.start(), Rk4);
    counted(TIMES, || assert!(black_box(stepper.step(&inputs, black_box(1e-7))).is_ok()));
}
