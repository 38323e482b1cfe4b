//! What code written for one mechanism saves: v̇ and λ with Baumgarte's terms, and a step of RK4 with them, by the generic solver, dense
//! and sparse, beside the emitted code. States along the motion in rotation, all interleaved; the least of many short slices, f64.
//!
//! ```text
//! cargo bench -p linkwright-generic [-- PART OF A MODEL'S NAME]
//! ```

#[path = "../../benches/harness/mod.rs"]
mod harness;
#[path = "../tests/mapping/mod.rs"]
mod mapping;

use harness::least;
use linkwright::{Assemble, AssembleExt, Baumgarte, Fields, Report, Rk4, Simulation, StateOf, Vector};
use linkwright_generic::{Algebra, Formulation, Mechanism, State};
use std::hint::black_box;
use std::time::{Duration, Instant};

const STATES: usize = 32;
const ALPHA: f64 = 10.0;
/// A slice takes about so long, ns, or one call where that is longer.
const SLICE: f64 = 2e4;
/// All slices of a row of the table take about so long.
const WHOLE: Duration = Duration::from_secs(3);
/// Short, so that the motion stays where it is regular.
const STEP: f64 = 1e-7;

fn main() {
    let part = std::env::args().skip(1).find(|argument| !argument.starts_with('-')).unwrap_or_default();
    println!("{}", harness::machine());
    println!("µs, least of slices; in brackets how many times as long as the emitted code\n");
    println!(
        "{:<18}{:<12}{:>9}{:>10}{:>22}{:>22}",
        "model", "", "unknowns", "emitted", "generic, dense", "generic, sparse"
    );
    macro_rules! each {
        ($($model:path, $apart:expr;)*) => {$({
            use $model as Model;
            beside(&part, &Model::<f64>::default(), Model::<f64>::DEFINITION, $apart);
        })*};
    }
    each! {
        linkwright_models::four_bar::FourBar, 0.02;
        linkwright_models::andrews::Andrews, 4e-4;
        linkwright_models::n_four_bar::NFourBar10, 0.02;
        linkwright_models::n_four_bar::NFourBar40, 0.02;
        linkwright_models::panda::Panda, 0.01;
        linkwright_models::bricard::Bricard, 0.05;
        linkwright_models::stewart_platform::StewartPlatform, 0.005;
    }
}

fn beside<M>(part: &str, model: &M, definition: &str, apart: f64)
where
    M: Assemble<f64, Gates = ()> + Report<f64> + Clone,
    M::Inputs: Fields<f64>,
{
    if !model.name().to_lowercase().contains(&part.to_lowercase()) {
        return;
    }
    let none = || M::Inputs::from_array(Vector::zeros(M::Inputs::NAMES.len()));
    let inputs = vec![0.0; M::Inputs::NAMES.len()];
    let terms = Baumgarte { alpha: ALPHA, beta: ALPHA };
    let formulation = Formulation::Baumgarte { alpha: ALPHA, beta: ALPHA };
    let states = along_the_motion(model, apart);
    let mut angles = Vec::new();
    let [dense, sparse] = [Algebra::Dense, Algebra::Sparse]
        .map(|algebra| Mechanism::with_algebra(definition, algebra).expect("it is there"));
    let unknowns = dense.velocity_count() + dense.row_count();
    let mapped: Vec<State> = states
        .iter()
        .map(|(time, state)| {
            let motions = mapping::bodies(model, *time, state, &model.zero_v(), &mut angles);
            mapping::state(&dense, &motions, state.z.as_slice())
        })
        .collect();

    let asked =
        black_box(if model.null_space_first() { M::null_space_baumgarte } else { M::acceleration_baumgarte });
    let (mut a, mut lambda, given) = (model.zero_v(), model.zero_lambda(), none());
    let emitted = |at: usize| {
        let (time, state) = &states[at];
        let pivot = asked(model, *time, state, &given, 2.0 * ALPHA, ALPHA * ALPHA, &mut a, &mut lambda);
        black_box((pivot, &a, &lambda));
    };
    let evaluation = |mut mechanism: Mechanism| {
        let (n, m) = (mechanism.velocity_count(), mechanism.row_count());
        let (mut a, mut lambda) = (vec![0.0; n], vec![0.0; m]);
        mechanism.keep_phases(states[0].0, &mapped[0].q).expect("a position");
        let (states, mapped, inputs) = (&states, &mapped, &inputs);
        move |at: usize| {
            let (time, State { q, v }) = (states[at].0, &mapped[at]);
            let solved = mechanism.acceleration(time, q, v, inputs, formulation, &mut a, &mut lambda);
            solved.expect("a regular state");
            black_box((&a, &lambda));
        }
    };
    let (first, second) = (evaluation(dense), evaluation(sparse));
    row(model.name(), "evaluation", unknowns, [Box::new(emitted), Box::new(first), Box::new(second)]);

    let mut plant = model.stepper(model.start(), (Rk4, terms));
    let given = none();
    let emitted = move |_: usize| {
        black_box(plant.step(black_box(&given), black_box(STEP)).expect("a regular motion"));
    };
    let steps = |algebra: Algebra| {
        let mut mechanism = Mechanism::with_algebra(definition, algebra).expect("it is there");
        mechanism.keep_phases(states[0].0, &mapped[0].q).expect("a position");
        let (mut state, inputs) = (mapped[0].clone(), &inputs);
        move |_: usize| {
            let stepped = mechanism.step(0.0, &mut state, inputs, formulation, black_box(STEP));
            stepped.expect("a regular motion");
        }
    };
    let (first, second) = (steps(Algebra::Dense), steps(Algebra::Sparse));
    row("", "step of RK4", unknowns, [Box::new(emitted), Box::new(first), Box::new(second)]);
}

/// One line of the table.
fn row(name: &str, what: &str, unknowns: usize, mut calls: [Box<dyn FnMut(usize) + '_>; 3]) {
    let rounds: Vec<usize> = calls
        .iter_mut()
        .map(|call| {
            let warm = (0..2).map(|_| slice(call, 1)).fold(f64::INFINITY, f64::min);
            (SLICE / warm).ceil().max(1.0) as usize
        })
        .collect();
    let begin = Instant::now();
    let mut samples = [const { Vec::new() }; 3];
    while begin.elapsed() < WHOLE {
        for ((call, rounds), samples) in calls.iter_mut().zip(&rounds).zip(&mut samples) {
            samples.push(slice(call, *rounds));
        }
    }
    let [emitted, dense, sparse] = samples.map(|samples| 1e-3 * least(&samples));
    let beside = |time: f64| format!("{time:.2} ({:.0})", time / emitted);
    println!("{name:<18}{what:<12}{unknowns:>9}{emitted:>10.3}{:>22}{:>22}", beside(dense), beside(sparse));
}

/// ns per call.
fn slice(call: &mut dyn FnMut(usize), rounds: usize) -> f64 {
    let start = Instant::now();
    for round in 0..rounds {
        call(black_box(round % STATES));
    }
    start.elapsed().as_nanos() as f64 / rounds as f64
}

/// States at equal distances in time.
fn along_the_motion<M>(model: &M, apart: f64) -> Vec<(f64, StateOf<M>)>
where
    M: Assemble<f64>,
    M::Inputs: Fields<f64>,
{
    let none = |_: f64, _: &StateOf<M>| M::Inputs::from_array(Vector::zeros(M::Inputs::NAMES.len()));
    let mut simulation = Simulation::new(model, model.start())
        .formulation(Baumgarte { alpha: ALPHA, beta: ALPHA })
        .sampled(none)
        .step(apart / 100.0);
    let times = (1..=STATES).map(|k| apart * k as f64);
    times.map(|time| (time, simulation.advance_until(time).expect("a regular motion"))).collect()
}
