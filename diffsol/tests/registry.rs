//! Every shipped mechanism under diffsol's explicit and implicit solvers against Linkwright's RK4, over a short time.

use linkwright::{Assemble, AssembleExt, Baumgarte, Fields, Simulation, Vector};
use linkwright_diffsol::{Error, Method, Settings, StateOf, problem, solve};

const END: f64 = 0.005;

/// Both inputs are zero; positions agree to the tolerance, velocities relative to the largest.
fn moves_alike<M: Assemble<f64>>(name: &str, model: &M)
where
    M::Inputs: Fields<f64>,
{
    let start = model.start();
    let inputs = |_: f64, _: &StateOf<M>| M::Inputs::from_array(Vector::zeros(M::Inputs::NAMES.len()));
    let baumgarte = Baumgarte { alpha: 10.0, beta: 10.0 };
    // Steel on steel, whose vibrations are shorter than what suits the others.
    let is_stiff =
        ["loose_wrist", "planetary_stage", "planetary_stage_held", "princeton_beam"].contains(&name);
    let h = if is_stiff { 5e-7 } else { 1e-5 };
    // Teeth between grams vibrate at 55 kHz, short strips at tens of them: errors of the tolerance add up over some periods only.
    let is_fast = name.starts_with("planetary_stage") || name == "princeton_beam";
    let end = if is_fast { END / 50.0 } else { END };
    let mut simulation = Simulation::new(model, start.clone()).formulation(baumgarte).sampled(inputs).step(h);
    let expected = simulation.advance_until(end).unwrap_or_else(|error| panic!("{name}: {error}"));
    let settings = Settings { relative: 1e-8, absolute: 1e-8, baumgarte, ..Settings::default() };
    if model.is_rigid() {
        let refused = problem(model, 0.0, &start, inputs, &settings).err();
        assert!(matches!(refused, Some(Error::RigidContact { .. })), "{name}: {refused:?}");
        return;
    }
    let problem =
        problem(model, 0.0, &start, inputs, &settings).unwrap_or_else(|error| panic!("{name}: {error}"));
    for method in [Method::Tsit45, Method::Bdf] {
        let states = solve(&problem, method, &[end]);
        let found = states.unwrap_or_else(|error| panic!("{name} {method:?}: {error}")).remove(0);
        let position = found.q.plus(-1.0, &expected.q).max_abs();
        let velocity = found.v.plus(-1.0, &expected.v).max_abs() / (1.0 + expected.v.max_abs());
        println!("{name} {method:?}: {position:.1e} {velocity:.1e}");
        assert!(position < 1e-6 && velocity < 1e-6, "{name} {method:?}: {position:.1e} {velocity:.1e}");
    }
}

macro_rules! all {
    ($($name:ident: $model:path),* $(,)?) => {
        $(#[test] fn $name() {
            moves_alike(stringify!($name), &<$model>::default());
        })*
    };
}

linkwright_models::for_each_model!(all);
