//! Accelerations and steps of RK4 in lanes beside the same alone, interleaved, and a whole batch on all threads: ns for each mechanism.
//!
//! ```text
//! RUSTFLAGS="-C target-cpu=native" cargo bench -p linkwright-batch --bench lanes [-- part of a model's name]
//! ```

use linkwright::lanes::{InScalars, InputsIn, StateIn};
use linkwright::{
    AssembleExt, F32x8, F32x16, F64x4, F64x8, Fields, LaneStepper, Lanes, Mechanism, Real, Rk4, Stepper,
    Vector,
};
use linkwright_batch::{Batch, Constant, Widest};
use linkwright_models::{
    andrews::Andrews, bricard::Bricard, double_pendulum::DoublePendulum, four_bar::FourBar, iiwa14::Iiwa14,
    n_four_bar::NFourBar10, stewart_platform::StewartPlatform,
};
use std::hint::black_box;
use std::time::Instant;

const SLICES: usize = 1500;
/// Calls in a slice.
const CALLS: usize = 64;
const H: f64 = 1e-7;

fn main() {
    println!(
        "ns for each mechanism, least of {SLICES} slices of {CALLS} calls, interleaved; how many times as fast as alone\n"
    );
    println!(
        "{:<18}{:>10}{:>10}{:>14}{:>14}{:>10}{:>14}{:>14}",
        "accelerations", "f64", "", "F64x4", "F64x8", "f32", "F32x8", "F32x16"
    );
    functions::<DoublePendulum>("double_pendulum");
    functions::<FourBar>("four_bar");
    functions::<Andrews>("andrews");
    functions::<Bricard>("bricard");
    functions::<NFourBar10>("n_four_bar_10");
    functions::<Iiwa14>("iiwa14");
    functions::<StewartPlatform>("stewart_platform");
    println!(
        "\n{:<18}{:>20}{:>14}{:>14}{:>10}{:>14}{:>14}",
        "steps of RK4", "f64", "F64x4", "F64x8", "f32", "F32x8", "F32x16"
    );
    steps::<DoublePendulum>("double_pendulum");
    steps::<FourBar>("four_bar");
    steps::<Andrews>("andrews");
    steps::<Bricard>("bricard");
    steps::<NFourBar10>("n_four_bar_10");
    steps::<Iiwa14>("iiwa14");
    steps::<StewartPlatform>("stewart_platform");
    println!("\nbatches of 4096, RK4, all threads, lanes of {}", Widest::LANES);
    batch::<FourBar>("four_bar");
    batch::<NFourBar10>("n_four_bar_10");
}

fn is_asked_for(name: &str) -> bool {
    let mut asked = std::env::args().skip(1).filter(|argument| !argument.starts_with("--")).peekable();
    asked.peek().is_none() || asked.any(|part| name.contains(&part))
}

/// ns of one call, the least so far.
struct Timed<'f> {
    call: Box<dyn FnMut() + 'f>,
    mechanisms: usize,
    least: f64,
}

fn timed<'f>(mechanisms: usize, call: impl FnMut() + 'f) -> Timed<'f> {
    Timed { call: Box::new(call), mechanisms, least: f64::INFINITY }
}

/// Takes turns; ns for each mechanism.
fn measure<const N: usize>(mut all: [Timed<'_>; N]) -> [f64; N] {
    for _ in 0..SLICES {
        for Timed { call, mechanisms, least } in &mut all {
            let begin = Instant::now();
            (0..CALLS).for_each(|_| call());
            let ns = 1e9 * begin.elapsed().as_secs_f64() / (CALLS * *mechanisms) as f64;
            *least = least.min(ns);
        }
    }
    all.map(|timed| timed.least)
}

fn no_inputs<R: Real, M: Mechanism<R, Inputs: Fields<R>>>(model: &M) -> M::Inputs {
    M::Inputs::from_array(Vector::zeros(model.input_names().len()))
}

fn functions<M: InScalars>(name: &str) {
    if !is_asked_for(name) {
        return;
    }
    let call = [
        evaluation::<M, f64>(),
        evaluation::<M, F64x4>(),
        evaluation::<M, F64x8>(),
        evaluation::<M, f32>(),
        evaluation::<M, F32x8>(),
        evaluation::<M, F32x16>(),
    ];
    report(name, measure(call));
}

fn report(name: &str, [f64, f64x4, f64x8, f32, f32x8, f32x16]: [f64; 6]) {
    let beside = |one: f64, all: f64| format!("{all:.2} ({:.1})", one / all);
    println!(
        "{name:<18}{f64:>20.1}{:>14}{:>14}{f32:>10.1}{:>14}{:>14}",
        beside(f64, f64x4),
        beside(f64, f64x8),
        beside(f32, f32x8),
        beside(f32, f32x16)
    );
}

/// Accelerations with Baumgarte's terms by the way that leads, at states one after the other.
fn evaluation<'f, M: InScalars + 'f, R: Real>() -> Timed<'f> {
    let model = M::In::<R>::default();
    let inputs = no_inputs::<R, _>(&model);
    let states: Vec<StateIn<M, R>> = (0..CALLS).map(|index| near::<M, R>(&model, index)).collect();
    let (mut a, mut lambda, mut next) = (model.zero_v(), model.zero_lambda(), 0);
    let function = if model.null_space_first() {
        M::In::<R>::null_space_baumgarte
    } else {
        M::In::<R>::acceleration_baumgarte
    };
    let (alpha, beta) = (R::from_f64(20.0), R::from_f64(100.0));
    timed(R::LANES, move || {
        next = (next + 1) % CALLS;
        let pivot =
            black_box(function)(&model, R::ZERO, &states[next], &inputs, alpha, beta, &mut a, &mut lambda);
        black_box((pivot, &a, &lambda));
    })
}

/// The start with other velocities.
fn near<M: InScalars, R: Real>(model: &M::In<R>, index: usize) -> StateIn<M, R> {
    let mut state = model.start();
    for (k, v) in state.v.as_mut_slice().iter_mut().enumerate() {
        *v = *v + R::from_f64(0.01 * ((7 * index + 3 * k) % 11) as f64);
    }
    state
}

fn steps<M: InScalars>(name: &str) {
    if !is_asked_for(name) {
        return;
    }
    let call = [
        alone::<M, f64>(),
        in_lanes::<M, F64x4>(),
        in_lanes::<M, F64x8>(),
        alone::<M, f32>(),
        in_lanes::<M, F32x8>(),
        in_lanes::<M, F32x16>(),
    ];
    report(name, measure(call));
}

fn alone<'f, M: InScalars + 'f, R: Real>() -> Timed<'f> {
    let model = M::In::<R>::default();
    let inputs = no_inputs::<R, _>(&model);
    let mut stepper = Stepper::<_, _, R>::new(model.clone(), model.start(), Rk4);
    timed(1, move || assert!(black_box(stepper.step(&inputs, black_box(R::from_f64(H)))).is_ok()))
}

fn in_lanes<'f, M: InScalars + 'f, L: Lanes>() -> Timed<'f> {
    let model = M::In::<L::Scalar>::default();
    let mut steppers = LaneStepper::<M, _, L>::new(&model, &model.start(), Rk4);
    let inputs: InputsIn<M, L> = no_inputs::<L, _>(steppers.models());
    timed(L::LANES, move || {
        let ticks = steppers.step(black_box(&inputs), black_box(L::from_f64(H)));
        assert_eq!(black_box(ticks).failed().next(), None);
    })
}

fn batch<M: InScalars>(name: &str) {
    if !is_asked_for(name) {
        return;
    }
    const MEMBERS: usize = 4096;
    const STEPS: usize = 100;
    let model = M::In::<f64>::default();
    let inputs = Constant(no_inputs::<f64, _>(&model));
    let mut batch = Batch::<M, _>::alike(MEMBERS, &model, &model.start(), Rk4).expect("there are members");
    let mut least = f64::INFINITY;
    for _ in 0..10 {
        let begin = Instant::now();
        let summary = batch.run(&inputs, H, STEPS);
        least = least.min(1e9 * begin.elapsed().as_secs_f64() / summary.steps as f64);
    }
    println!("{name:<18}{least:>10.2} ns a step, {:.1} million steps a second", 1e3 / least);
}
