//! Time of one evaluation of v̇ and λ, Baumgarte's terms included: 64 states along the motion in rotation, median of
//! 15 samples, f64.
//!
//! ```text
//! cargo bench --bench evaluation
//! benches/casadi/generate.sh && LINKWRIGHT_CASADI=target/casadi cargo bench --bench evaluation
//! ```
//! The second line also times C code that CasADi writes for the same mechanisms, in the same run and interleaved, so
//! that the ratio does not suffer from a clock that drifts. Both are called through a pointer.
//! `RUSTFLAGS="-C target-cpu=native"` lets the fused multiply-adds be instructions; the C code has `-march=native`.

mod casadi;
mod harness;

use casadi::Peer;
use harness::median;
use linkwright::{AssembleExt, Baumgarte, Mechanism, Simulation, State, Vector};
use linkwright_models as models;
use std::hint::black_box;
use std::time::Instant;

const STATES: usize = 64;
const SAMPLES: usize = 15;
const ALPHA: f64 = 10.0;

fn main() {
    println!("{}", harness::machine());
    println!("ns per evaluation of v̇ and λ (Baumgarte), median of {SAMPLES} samples over {STATES} states\n");
    println!(
        "{:<18}{:>12}{:>10}{:>14}{:>10}  accelerations agree to",
        "model", "operations", "ns", "CasADi C, ns", "ratio"
    );

    // The bodies in the order of the peer's angles: cranks, then couplers.
    macro_rules! evaluate {
        ($name:literal, $model:path, $step:expr, $order:expr) => {{
            let model = <$model>::default();
            let start = model.assemble(&<$model>::START).expect("the default start");
            let states = along_the_motion(&model, start, $step);
            let peer = Peer::open($name, &states, |state| {
                let (a, _) = acceleration(&model, state);
                let motions = model.motions(0.0, &state.q, &state.v, &a);
                let order: Vec<usize> = $order(<$model>::BODIES);
                let angles =
                    order.iter().map(|at| motions[*at].orientation[1].atan2(motions[*at].orientation[0]));
                let rates = order.iter().map(|at| motions[*at].rate);
                let accelerations = order.iter().map(|at| motions[*at].angular_acceleration);
                [angles.collect(), rates.collect(), accelerations.collect()]
            });
            report($name, <$model>::OPERATIONS, &model, &states, peer);
        }};
    }
    let cranks_first = |bodies: &[&str]| {
        let mut order: Vec<usize> = (0..bodies.len()).collect();
        order.sort_by_key(|at| bodies[*at].starts_with("coupler"));
        order
    };
    let none = |_: &[&str]| Vec::new();
    evaluate!("double_pendulum", models::double_pendulum::DoublePendulum, 0.05, none);
    evaluate!("four_bar", models::four_bar::FourBar, 0.05, cranks_first);
    evaluate!("n_four_bar_10", models::n_four_bar::NFourBar10, 0.05, cranks_first);
    evaluate!("n_four_bar_40", models::n_four_bar::NFourBar40, 0.05, cranks_first);
    evaluate!("andrews", models::andrews::Andrews, 4e-4, none);
}

/// States at equal distances in time.
fn along_the_motion<M>(model: &M, start: State<M::Q, M::V>, step: f64) -> Vec<State<M::Q, M::V>>
where
    M: linkwright::Assemble<f64, Inputs = ()>,
{
    let mut simulation =
        Simulation::new(model, start).formulation(Baumgarte { alpha: ALPHA, beta: ALPHA }).step(step / 50.0);
    (1..=STATES).map(|k| simulation.advance_until(step * k as f64).expect("a regular motion")).collect()
}

fn acceleration<M: Mechanism<f64, Inputs = ()>>(model: &M, state: &State<M::Q, M::V>) -> (M::V, M::Lambda) {
    let (mut a, mut lambda) = (M::V::zero(), M::Lambda::zero());
    model.acceleration_baumgarte(
        0.0,
        &state.q,
        &state.v,
        &(),
        2.0 * ALPHA,
        ALPHA * ALPHA,
        &mut a,
        &mut lambda,
    );
    (a, lambda)
}

fn report<M: Mechanism<f64, Inputs = ()>>(
    name: &str,
    operations: usize,
    model: &M,
    states: &[State<M::Q, M::V>],
    peer: Option<Peer>,
) {
    let (mut a, mut lambda) = (M::V::zero(), M::Lambda::zero());
    // Through a pointer, so that nothing is kept from one state to the next.
    type Function<M> = fn(
        &M,
        f64,
        &<M as Mechanism<f64>>::Q,
        &<M as Mechanism<f64>>::V,
        &(),
        f64,
        f64,
        &mut <M as Mechanism<f64>>::V,
        &mut <M as Mechanism<f64>>::Lambda,
    ) -> f64;
    let function: Function<M> = black_box(M::acceleration_baumgarte);
    let mut own = |at: usize| {
        let State { q, v } = &states[at];
        let pivot = function(model, 0.0, q, v, &(), 2.0 * ALPHA, ALPHA * ALPHA, &mut a, &mut lambda);
        black_box((pivot, &a, &lambda));
    };
    let rounds = rounds(&mut own);
    let Some(mut peer) = peer else {
        let own = median((0..SAMPLES).map(|_| sample(&mut own, rounds)).collect());
        println!("{name:<18}{operations:>12}{own:>10.1}");
        return;
    };
    let error = peer.error();
    let (mut ours, mut theirs, mut ratios) = (Vec::new(), Vec::new(), Vec::new());
    for _ in 0..SAMPLES {
        ours.push(sample(&mut own, rounds));
        theirs.push(sample(&mut |at| peer.call(at), rounds));
        ratios.push(theirs[theirs.len() - 1] / ours[ours.len() - 1]);
    }
    let (ours, theirs, ratio) = (median(ours), median(theirs), median(ratios));
    println!("{name:<18}{operations:>12}{ours:>10.1}{theirs:>14.1}{ratio:>10.2}  {error:.1e}");
}

/// How many rotations over all states make a sample of about 10 ms.
fn rounds(call: &mut impl FnMut(usize)) -> usize {
    let warm = sample(call, 100);
    (1e7 / (warm * STATES as f64)).ceil().max(1.0) as usize
}

/// ns per call.
fn sample(call: &mut impl FnMut(usize), rounds: usize) -> f64 {
    let start = Instant::now();
    for _ in 0..rounds {
        for at in 0..STATES {
            call(black_box(at));
        }
    }
    start.elapsed().as_nanos() as f64 / (rounds * STATES) as f64
}
