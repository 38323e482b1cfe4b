//! The engine, interpreted and as machine code, beside the compiled mechanism: one evaluation of the accelerations, in turns.
//! `cargo bench -p linkwright-native`; for the instructions that this processor has, with `RUSTFLAGS="-C target-cpu=native"`.

use linkwright::{Assemble, Fields, Mechanism, State, StateOf, Vector};
use linkwright_compiler::compile;
use linkwright_engine::{Engine, List, Numbers};
use linkwright_native::Native;
use std::hint::black_box;
use std::sync::Arc;
use std::time::Instant;

/// Rounds, of which the quickest counts.
const ROUNDS: usize = 30;

fn main() {
    println!(
        "| mechanism | operations | compiled, ns | interpreted | machine code | first call, ms |\n|---|---|---|---|---|---|"
    );
    macro_rules! each {
        ($($name:literal $model:path),*) => { $( beside($name, <$model>::default(), <$model>::SOURCE); )* };
    }
    each!(
        "four-bar" linkwright_models::four_bar::FourBar,
        "ladder of 10" linkwright_models::n_four_bar::NFourBar10,
        "arm" linkwright_models::panda::Panda
    );
}

fn beside<M>(name: &str, model: M, source: &str)
where
    M: Assemble<f64, Inputs: Fields<f64>, Gates = ()>,
{
    let compiled = compile(source.parse().expect("tokens"), None).expect("it is well");
    let engine: Engine = Engine::of(&compiled).expect("it fits");
    let native = Native::new().expect("this processor is known");
    let native: Engine = Engine::translated(&compiled, Arc::new(native)).expect("it fits");
    let list = |values: &[f64]| List::of(values);
    let start: StateOf<M> =
        State { q: model.start_q(), v: model.start_v(), z: model.start_internal(), gates: () };
    let own = State {
        q: list(start.q.as_slice()),
        v: list(start.v.as_slice()),
        z: list(start.z.as_slice()),
        gates: list(&[]),
    };
    let none = vec![0.0; engine.input_names().len()];
    let u = {
        let mut array = <M::Inputs as Fields<f64>>::Array::zeros(none.len());
        array.as_mut_slice().fill(0.0);
        M::Inputs::from_array(array)
    };
    let own_u = Numbers::of(&none);
    let leads = model.null_space_first();
    let count = linkwright_compiler::schedule::count(compiled.programs.get(compiled.default_solution()));
    let repeats = 200_000 / count.total().max(1);
    let compiled_once = |a: &mut M::V, lambda: &mut M::Lambda| {
        let state = black_box(&start);
        black_box(if leads {
            model.null_space_baumgarte(0.0, state, &u, 20.0, 100.0, a, lambda)
        } else {
            model.acceleration_baumgarte(0.0, state, &u, 20.0, 100.0, a, lambda)
        });
    };
    let engine_once = |engine: &Engine, a: &mut List, lambda: &mut List| {
        let state = black_box(&own);
        black_box(if leads {
            engine.null_space_baumgarte(0.0, state, &own_u, 20.0, 100.0, a, lambda)
        } else {
            engine.acceleration_baumgarte(0.0, state, &own_u, 20.0, 100.0, a, lambda)
        });
    };
    let (mut a, mut lambda) = (engine.zero_v(), engine.zero_lambda());
    let begun = Instant::now();
    engine_once(&native, &mut a, &mut lambda);
    let first = begun.elapsed().as_secs_f64() * 1e3;
    let (mut b, mut mu) = (a.clone(), lambda.clone());
    let mut best = [f64::INFINITY; 3];
    for _ in 0..ROUNDS {
        let (mut own_a, mut own_lambda) = (model.zero_v(), model.zero_lambda());
        let mut runs: [&mut dyn FnMut(); 3] = [
            &mut || (0..repeats).for_each(|_| compiled_once(&mut own_a, &mut own_lambda)),
            &mut || (0..repeats).for_each(|_| engine_once(&engine, &mut a, &mut lambda)),
            &mut || (0..repeats).for_each(|_| engine_once(&native, &mut b, &mut mu)),
        ];
        for (best, run) in best.iter_mut().zip(&mut runs) {
            let begun = Instant::now();
            run();
            *best = best.min(begun.elapsed().as_nanos() as f64 / repeats as f64);
        }
    }
    let [compiled, interpreted, native] = best;
    println!(
        "| {name} | {} | {compiled:.1} | {interpreted:.1} ({:.1}) | {native:.1} ({:.2}) | {first:.1} |",
        count.total(),
        interpreted / compiled,
        native / compiled
    );
}
