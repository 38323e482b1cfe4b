//! Time of one step of Runge and Kutta's method under each formulation, relative to index 1, and wall time per simulated
//! second beside CasADi's C code.
//!
//! ```text
//! cargo bench --bench formulations [-- PART OF A MODEL'S NAME]
//! benches/casadi/generate.sh && LINKWRIGHT_CASADI=target/casadi cargo bench --bench formulations
//! ```
//! Samples of all formulations are interleaved, so that a clock that drifts does not matter to the ratios. In brackets: the
//! largest drift of the energy (J) and the largest violation of the constraints (m) of the run timed.

mod casadi;
mod harness;

use casadi::Peer;
use harness::median;
use linkwright::{
    Assemble, AugmentedLagrangian, Baumgarte, Formulation, LagrangeIndex1, NullSpace, Partitioned, Penalty,
    Projected, Simulation, State,
};
use std::hint::black_box;
use std::time::Instant;

const SAMPLES: usize = 9;
/// Steps of a sample; shorter runs are repeated.
const STEPS: usize = 10_000;
/// Baumgarte's coefficients here and of the peers, 1/s.
const ALPHA: f64 = 20.0;

linkwright::mechanism! {
    /// Four-bar of unit rods (IFToMM A02 with one window), with what the formulations ask for written out.
    planar FourBar {
        gravity [m/s^2] = (0, -9.81);
        rod crank { mass [kg] = 1; length [m] = 1; }
        rod coupler { mass [kg] = 1; length [m] = 1; }
        rod rocker { mass [kg] = 1; length [m] = 1; }
        joint crank_pin: revolute(ground(0, 0) [m], crank.start);
        joint rocker_pin: revolute(ground(1, 0) [m], rocker.start);
        joint left: revolute(crank.end, coupler.start);
        joint right: revolute(coupler.end, rocker.end);
        start { crank_pin.angle [deg] = 90; crank_pin.rate [rad/s] = -1; rocker_pin.angle [deg] ~ 90; coupler.angle [rad] ~ 0; }
        options { emit = (penalty, projection, null_space); }
    }
}

linkwright::mechanism! {
    /// Forty windows of unit rods (IFToMM A02).
    planar Ladder {
        const N = 40;
        gravity [m/s^2] = (0, -9.81);
        repeat i in 0..N+1 {
            rod crank[i] { mass [kg] = 1; length [m] = 1; }
            joint pin[i]: revolute(ground(i, 0) [m], crank[i].start);
        }
        repeat i in 0..N {
            rod coupler[i] { mass [kg] = 1; length [m] = 1; }
            joint left[i]: revolute(crank[i].end, coupler[i].start);
            joint right[i]: revolute(coupler[i].end, crank[i+1].end);
            start { coupler[i].angle [rad] ~ 0; pin[i+1].angle [deg] ~ 90; }
        }
        start { pin[0].angle [deg] = 90; pin[0].rate [rad/s] = -1; }
        options { emit = (penalty, projection, null_space); }
    }
}

use linkwright_models::andrews::Andrews;

/// A formulation's name and what times a run under it: seconds a step, energy drift, violation.
type Timed<'m> = (&'static str, Box<dyn FnMut() -> [f64; 3] + 'm>);

fn main() {
    println!("{}", harness::machine());
    println!("one step of RK4, median of {SAMPLES} samples\n");
    let part = std::env::args().skip(1).find(|argument| !argument.starts_with('-')).unwrap_or_default();
    if "four_bar".contains(&part) {
        let model = FourBar::<f64>::default();
        let timed = formulations(&model, FourBar::START, (1e-3, 0.6), ALPHA, true);
        report("four_bar, h = 1 ms, 0.6 s", timed);
        let [angle, rate] = [std::f64::consts::FRAC_PI_2, -1.0];
        beside("four_bar", &model, FourBar::START, vec![angle, angle, 0.0], vec![rate, rate, 0.0]);
    }
    if "n_four_bar_40".contains(&part) {
        let model = Ladder::<f64>::default();
        let timed = formulations(&model, Ladder::START, (1e-3, 0.6), ALPHA, false);
        report("n_four_bar_40, h = 1 ms, 0.6 s", timed);
        let (mut angles, mut rates) = (vec![std::f64::consts::FRAC_PI_2; 41], vec![-1.0; 41]);
        angles.extend([0.0; 40]);
        rates.extend([0.0; 40]);
        beside("n_four_bar_40", &model, Ladder::START, angles, rates);
    }
    if "andrews".contains(&part) {
        let model = Andrews::<f64>::default();
        report("andrews, h = 10 µs, 0.03 s", formulations(&model, Andrews::START, (1e-5, 0.03), 100.0, true));
    }
}

/// Every formulation on one model; those with full matrices only where these are small.
fn formulations<'m, M: Assemble<f64, Inputs = ()>>(
    model: &'m M,
    start: State<M::Q, M::V>,
    span: (f64, f64),
    rate: f64,
    small: bool,
) -> Vec<Timed<'m>> {
    let baumgarte = Baumgarte { alpha: rate, beta: rate };
    let penalty = Penalty { omega: rate, ..Penalty::for_model(model, 0.0, &start.q, span.0) };
    let iterated = AugmentedLagrangian::new(penalty);
    let mut timed = vec![
        ("Lagrange, index 1", run(model, start, LagrangeIndex1, span)),
        ("Baumgarte", run(model, start, baumgarte, span)),
        ("penalty", run(model, start, penalty, span)),
        ("augmented Lagrangian", run(model, start, iterated, span)),
        ("index 1, projected", run(model, start, Projected::after(LagrangeIndex1), span)),
        ("augmented Lagrangian, projected", run(model, start, Projected::after(iterated), span)),
    ];
    if small {
        timed.push(("null space", run(model, start, NullSpace, span)));
        timed.push(("coordinate partitioning", run(model, start, Partitioned::default(), span)));
    }
    timed
}

fn run<'m, M, F>(
    model: &'m M,
    start: State<M::Q, M::V>,
    formulation: F,
    (h, end): (f64, f64),
) -> Box<dyn FnMut() -> [f64; 3] + 'm>
where
    M: Assemble<f64, Inputs = ()>,
    F: Formulation<f64, M> + Copy + 'm,
{
    let steps = (end / h).round() as usize;
    let repeats = (STEPS / steps).max(1);
    Box::new(move || {
        let (mut drift, mut off, mut seconds) = (0.0_f64, 0.0_f64, 0.0);
        for _ in 0..repeats {
            let simulation = Simulation::new(model, start).formulation(formulation);
            let mut simulation = simulation.step(h).step_over_breakdowns();
            let begin = simulation.energy();
            // Looked at ten times, between the timed stretches.
            for _ in 0..10 {
                let clock = Instant::now();
                for _ in 0..steps / 10 {
                    if let Err(error) = black_box(simulation.advance()) {
                        panic!("{}: {error}", M::NAME);
                    }
                }
                seconds += clock.elapsed().as_secs_f64();
                drift = drift.max((simulation.energy() - begin).abs());
                off = off.max(simulation.constraint_residual().position);
            }
        }
        [seconds / (repeats * steps) as f64, drift, off]
    })
}

fn report(title: &str, mut timed: Vec<Timed<'_>>) {
    println!("{title}");
    let mut samples = vec![Vec::new(); timed.len()];
    let mut found = vec![[0.0; 2]; timed.len()];
    for _ in 0..SAMPLES {
        for (at, (_, run)) in timed.iter_mut().enumerate() {
            let [seconds, drift, off] = run();
            samples[at].push(seconds);
            found[at] = [drift, off];
        }
    }
    for (at, (name, _)) in timed.iter().enumerate() {
        let ratio = median(samples[at].iter().zip(&samples[0]).map(|(own, first)| own / first).collect());
        let ns = 1e9 * median(samples[at].clone());
        let [drift, off] = found[at];
        println!("  {name:<34}{ns:>10.1} ns{ratio:>8.2}   [{drift:.0e}; {off:.0e}]");
    }
    println!();
}

/// Wall time per simulated second under Baumgarte's stabilisation, and that of CasADi's function in the same method.
fn beside<M: Assemble<f64, Inputs = ()>>(
    name: &str,
    model: &M,
    start: State<M::Q, M::V>,
    angles: Vec<f64>,
    rates: Vec<f64>,
) {
    let (h, end) = (1e-3, 10.0);
    let accelerations = vec![0.0; angles.len()];
    let states = [[angles, rates, accelerations]];
    let Some(mut peer) = Peer::open(name, &states, Clone::clone) else { return };
    let mut own = run(model, start, Baumgarte { alpha: ALPHA, beta: ALPHA }, (h, end));
    let (mut ours, mut theirs, mut found) = (Vec::new(), Vec::new(), [0.0; 2]);
    for _ in 0..SAMPLES {
        let [seconds, drift, off] = own();
        found = [drift, off];
        ours.push(seconds);
        theirs.push(peer_run(&mut peer, &states[0], h, end));
    }
    let ratio = median(theirs.iter().zip(&ours).map(|(their, our)| their / our).collect());
    let per_second = |samples: Vec<f64>| 1e3 * median(samples) / h;
    println!(
        "  Baumgarte, per second of a run of 10 s: {:.3} ms [{:.0e} J; {:.0e} m], CasADi's C {:.3} ms, ratio {ratio:.2}\n",
        per_second(ours),
        found[0],
        found[1],
        per_second(theirs)
    );
}

/// Seconds a step of the same method in CasADi's coordinates.
fn peer_run(peer: &mut Peer, [angles, rates, _]: &[Vec<f64>; 3], h: f64, end: f64) -> f64 {
    let (mut q, mut v) = (angles.clone(), rates.clone());
    let n = q.len();
    let (mut at, mut speed) = (q.clone(), v.clone());
    let mut slopes = vec![vec![0.0; 2 * n]; 4];
    let steps = (end / h).round() as usize;
    let clock = Instant::now();
    for _ in 0..steps {
        for stage in 0..4 {
            let part = [0.0, 0.5 * h, 0.5 * h, h][stage];
            for i in 0..n {
                let before = stage.max(1) - 1;
                at[i] = q[i] + part * slopes[before][i];
                speed[i] = v[i] + part * slopes[before][n + i];
            }
            let accelerations = peer.evaluate(&at, &speed);
            slopes[stage][n..].copy_from_slice(accelerations);
            slopes[stage][..n].copy_from_slice(&speed);
        }
        for i in 0..n {
            let mean =
                |i: usize| h / 6.0 * (slopes[0][i] + 2.0 * slopes[1][i] + 2.0 * slopes[2][i] + slopes[3][i]);
            let (dq, dv) = (mean(i), mean(n + i));
            (q[i], v[i]) = (q[i] + dq, v[i] + dv);
        }
    }
    black_box((&q, &v));
    clock.elapsed().as_secs_f64() / steps as f64
}
