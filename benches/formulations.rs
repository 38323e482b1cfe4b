//! Time of one step of Runge and Kutta's method under each formulation, relative to index 1, and wall time per simulated
//! second beside CasADi's C code.
//!
//! ```text
//! cargo bench --bench formulations [-- PART OF A MODEL'S NAME]
//! benches/casadi/generate.sh && LINKWRIGHT_CASADI=target/casadi cargo bench --bench formulations
//! ```
//! Samples of all formulations are interleaved, so that a clock that drifts does not matter to the ratios. In brackets: the
//! largest drift of the energy (J) and the largest violation of the constraints (m) of the run timed.

#[macro_use]
mod casadi;
mod harness;

use casadi::{Peer, Turns};
use harness::{largest, median};
use linkwright::{
    Assemble, AugmentedLagrangian, Baumgarte, Formulation, LagrangeIndex1, NullSpace, Partitioned, Penalty,
    Projected, Simulation, State, StateOf,
};
use linkwright_models::{n_four_bar::NFourBar10, tracked_vehicle::TrackedVehicle};
use std::hint::black_box;
use std::time::Instant;

const SAMPLES: usize = 9;
/// Steps of a sample; shorter runs are repeated.
const STEPS: usize = 10_000;
/// States along a run at which a peer's accelerations are compared before it is timed, and how far they may be off,
/// relative to the largest: states close to the ladders' flat positions are among them.
const COMPARED: usize = 10;
const AGREEMENT: f64 = 1e-8;

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
        let timed = formulations(&model, FourBar::START, (1e-3, 0.6), 20.0, true);
        report("four_bar, h = 1 ms, 0.6 s", timed);
        let run = Run { model: &model, start: FourBar::START, span: (1e-3, 10.0), rate: 20.0 };
        beside(&["four_bar"], &run, bodies!(FourBar));
    }
    if "n_four_bar_40".contains(&part) {
        let model = Ladder::<f64>::default();
        let timed = formulations(&model, Ladder::START, (1e-3, 0.6), 20.0, false);
        report("n_four_bar_40, h = 1 ms, 0.6 s", timed);
        let run = Run { model: &model, start: Ladder::START, span: (1e-3, 10.0), rate: 20.0 };
        beside(&["n_four_bar_40"], &run, bodies!(Ladder));
    }
    if "andrews".contains(&part) {
        let model = Andrews::<f64>::default();
        let timed = formulations(&model, Andrews::START, (1e-5, 0.03), 100.0, true);
        report("andrews, h = 10 µs, 0.03 s", timed);
        let run = Run { model: &model, start: Andrews::START, span: (1e-5, 0.03), rate: 100.0 };
        beside(&["andrews_ldl", "andrews_crank"], &run, bodies!(Andrews));
    }
    if "tracked_vehicle".contains(&part) {
        let (ladder, vehicle) = (NFourBar10::<f64>::default(), TrackedVehicle::<f64>::default());
        let (baumgarte, span) = (Baumgarte { alpha: 20.0, beta: 20.0 }, (1e-3, 0.6));
        let timed: Vec<Timed> = vec![
            ("n_four_bar_10, Baumgarte", run(&ladder, NFourBar10::START, baumgarte, span)),
            ("tracked_vehicle, index 1", run(&vehicle, TrackedVehicle::START, LagrangeIndex1, span)),
            ("tracked_vehicle, Baumgarte", run(&vehicle, TrackedVehicle::START, baumgarte, span)),
        ];
        report("tracked_vehicle beside n_four_bar_10, h = 1 ms, 0.6 s", timed);
    }
}

/// Every formulation on one model; partitioning, which has full matrices, only where these are small.
fn formulations<'m, M: Assemble<f64, Inputs = ()>>(
    model: &'m M,
    start: StateOf<M>,
    span: (f64, f64),
    rate: f64,
    small: bool,
) -> Vec<Timed<'m>> {
    let baumgarte = Baumgarte { alpha: rate, beta: rate };
    let penalty = Penalty { omega: rate, ..Penalty::for_model(model, 0.0, &start.q, span.0) };
    let iterated = AugmentedLagrangian::new(penalty);
    let mut timed = vec![
        ("Lagrange, index 1", run(model, start.clone(), LagrangeIndex1, span)),
        ("Baumgarte", run(model, start.clone(), baumgarte, span)),
        ("penalty", run(model, start.clone(), penalty, span)),
        ("augmented Lagrangian", run(model, start.clone(), iterated, span)),
        ("index 1, projected", run(model, start.clone(), Projected::after(LagrangeIndex1), span)),
        ("augmented Lagrangian, projected", run(model, start.clone(), Projected::after(iterated), span)),
        ("null space", run(model, start.clone(), NullSpace, span)),
    ];
    if small {
        timed.push(("coordinate partitioning", run(model, start.clone(), Partitioned::default(), span)));
    }
    timed
}

fn run<'m, M, F>(
    model: &'m M,
    start: StateOf<M>,
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
            let simulation = Simulation::new(model, start.clone()).formulation(formulation);
            let mut simulation = simulation.step(h).step_over_breakdowns();
            let begin = simulation.energy();
            // Looked at ten times, between the timed stretches.
            for _ in 0..10 {
                let clock = Instant::now();
                for _ in 0..steps / 10 {
                    if let Err(error) = black_box(simulation.advance()) {
                        panic!("{}: {error}", model.name());
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

/// A run under Baumgarte's stabilisation: step and end in s, α = β in 1/s.
struct Run<'m, M: Assemble<f64>> {
    model: &'m M,
    start: StateOf<M>,
    span: (f64, f64),
    rate: f64,
}

impl<M: Assemble<f64, Inputs = ()>> Run<'_, M> {
    /// The start and states at equal distances to the end, in the coordinates of `convert`.
    fn states(&self, convert: impl Fn(&M, &StateOf<M>, &M::V) -> Turns) -> Vec<Turns> {
        let (model, rate, (h, end)) = (self.model, self.rate, self.span);
        let simulation =
            Simulation::new(model, self.start.clone()).formulation(Baumgarte { alpha: rate, beta: rate });
        let mut simulation = simulation.step(h).step_over_breakdowns();
        let later = (1..=COMPARED).map(|k| {
            simulation.advance_until(end * k as f64 / COMPARED as f64).expect("a run that is timed below")
        });
        let states = std::iter::once(self.start.clone()).chain(later);
        let turns = |state: StateOf<M>| {
            let (mut a, mut lambda) = (model.zero_v(), model.zero_lambda());
            model.acceleration_baumgarte(0.0, &state, &(), 2.0 * rate, rate * rate, &mut a, &mut lambda);
            convert(model, &state, &a)
        };
        states.map(turns).collect()
    }
}

/// Wall time per simulated second, and that of CasADi's functions in the same method, after a look whether they compute the
/// same accelerations.
fn beside<M: Assemble<f64, Inputs = ()>>(
    names: &[&str],
    timed: &Run<'_, M>,
    convert: impl Fn(&M, &StateOf<M>, &M::V) -> Turns,
) {
    let states = timed.states(convert);
    // At the ladders' start all accelerations are zero.
    let compared = &states[1..];
    let mut peers: Vec<Peer> =
        names.iter().filter_map(|name| Peer::open(name, timed.rate, compared, Clone::clone)).collect();
    if peers.is_empty() {
        return;
    }
    let errors: Vec<f64> = peers.iter_mut().map(Peer::error).collect();
    for (peer, error) in peers.iter().zip(&errors) {
        assert!(*error < AGREEMENT, "{}: accelerations are {error:.1e} off, not to be timed", peer.name);
    }
    let baumgarte = Baumgarte { alpha: timed.rate, beta: timed.rate };
    let mut own: Vec<Timed> = vec![
        ("ours, Baumgarte", run(timed.model, timed.start.clone(), baumgarte, timed.span)),
        ("ours, null space", run(timed.model, timed.start.clone(), NullSpace, timed.span)),
    ];
    let mut ours = vec![Vec::new(); own.len()];
    let mut off = vec![[0.0; 2]; own.len()];
    let (mut theirs, mut ends) = (vec![Vec::new(); peers.len()], vec![0.0; peers.len()]);
    for _ in 0..SAMPLES {
        for (at, (_, run)) in own.iter_mut().enumerate() {
            let [seconds, found @ ..] = run();
            off[at] = found;
            ours[at].push(seconds);
        }
        for (at, peer) in peers.iter_mut().enumerate() {
            let (seconds, end) = peer_run(peer, &states[0], timed.span);
            theirs[at].push(seconds);
            ends[at] = apart(&end, &states[COMPARED][0]);
        }
    }
    let (h, end) = timed.span;
    let per_second = |samples: &[f64]| 1e3 * median(samples.to_vec()) / h;
    let rate = timed.rate;
    println!("  ms per second of a run of {end} s, Baumgarte {rate}/s");
    for (((name, _), ours), [drift, violation]) in own.iter().zip(&ours).zip(off) {
        println!("  {name:<34}{:>10.3} ms{:>15}[{drift:.0e}; {violation:.0e}]", per_second(ours), "");
    }
    for (at, peer) in peers.iter().enumerate() {
        let ratio =
            |ours: &[f64]| median(theirs[at].iter().zip(ours).map(|(their, our)| their / our).collect());
        println!(
            "  {:<34}{:>10.3} ms{:>7.2}{:>7.2}   accelerations agree to {:.0e}, ends to {:.0e} rad",
            format!("CasADi's C, {}", peer.name),
            per_second(&theirs[at]),
            ratio(&ours[0]),
            ratio(&ours[1]),
            errors[at],
            ends[at]
        );
    }
    println!();
}

/// Largest difference between angles, whole turns aside.
fn apart(angles: &[f64], others: &[f64]) -> f64 {
    largest(angles.iter().zip(others).map(|(a, b)| 2.0 * (0.5 * (a - b)).sin().abs()))
}

/// Seconds a step of the same method in CasADi's coordinates, and the last angles.
fn peer_run(peer: &mut Peer, [angles, rates, _]: &Turns, (h, end): (f64, f64)) -> (f64, Vec<f64>) {
    let steps = (end / h).round() as usize;
    let repeats = (STEPS / steps).max(1);
    let (mut last, mut seconds) = (Vec::new(), 0.0);
    for _ in 0..repeats {
        let mut state = [angles.as_slice(), rates].concat();
        let clock = Instant::now();
        rk4(peer, &mut state, h, steps);
        seconds += clock.elapsed().as_secs_f64();
        last = black_box(state);
    }
    last.truncate(angles.len());
    (seconds / (repeats * steps) as f64, last)
}

/// As one writes it by hand for a vector of angles and rates.
fn rk4(peer: &mut Peer, state: &mut [f64], h: f64, steps: usize) {
    let half = state.len() / 2;
    let mut slopes = vec![0.0; state.len()];
    let (mut at, mut sum) = (slopes.clone(), slopes.clone());
    for _ in 0..steps {
        at.copy_from_slice(state);
        sum.fill(0.0);
        for (weight, part) in [(1.0, 0.5 * h), (2.0, 0.5 * h), (2.0, h), (1.0, 0.0)] {
            let (angles, rates) = at.split_at(half);
            slopes[half..].copy_from_slice(peer.evaluate(angles, rates));
            slopes[..half].copy_from_slice(rates);
            for (((at, sum), state), slope) in at.iter_mut().zip(&mut sum).zip(&*state).zip(&slopes) {
                *sum += weight * slope;
                *at = state + part * slope;
            }
        }
        for (state, sum) in state.iter_mut().zip(&sum) {
            *state += h / 6.0 * sum;
        }
    }
}
