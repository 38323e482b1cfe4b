//! Time of one evaluation of v̇ and λ as formulations ask it, Baumgarte's terms included: 64 states along the motion in rotation, the
//! least of 2000 slices of 20 µs, ratios of these and as medians of neighbouring slices, f64; for arms also of inverse dynamics and M. Beside it
//! stand the same by multipliers where independent velocities are asked first, and without Baumgarte's terms.
//!
//! ```text
//! cargo bench --bench evaluation [-- PART OF A MODEL'S NAME]
//! benches/casadi/generate.sh && LINKWRIGHT_CASADI=target/casadi cargo bench --bench evaluation
//! ```
//! The second line also times C code that CasADi writes for the same mechanisms, in the same run and interleaved, so
//! that the ratio does not suffer from a clock that drifts. Both are called through a pointer.
//! `RUSTFLAGS="-C target-cpu=native"` lets the fused multiply-adds be instructions; the C code then has `-march=native`.

#[macro_use]
mod casadi;
mod harness;
#[path = "harness/limits.rs"]
mod limits;

use casadi::{Peer, Turns};
use harness::{least, median};
use limits::{Limits, Processor, clock};
use linkwright::{
    Assemble, AssembleExt, Baumgarte, Fields, InputSource, Mechanism, Simulation, SpatialMotion, State,
    StateOf, Variables, Vector,
};
use linkwright_models as models;
use std::hint::black_box;
use std::time::Instant;

const STATES: usize = 64;
const SAMPLES: usize = 2000;
const ALPHA: f64 = 10.0;

fn main() {
    println!("{}", harness::machine());
    println!("ns per evaluation of v̇ and λ (Baumgarte), least of {SAMPLES} slices over {STATES} states\n");
    println!(
        "{:<28}{:>10}{:>9}  {:<22}{:>10}{:>9}{:>7}{:>8}  accelerations agree to",
        "model", "operations", "ns", "CasADi C", "operations", "ns", "ratio", "median"
    );
    let part = std::env::args().skip(1).find(|argument| !argument.starts_with('-')).unwrap_or_default();

    // Step between the states in s, constant inputs, names of peers and the model's state in their coordinates.
    macro_rules! evaluate {
        ($name:literal, $model:path, $step:expr, $inputs:expr) => {
            evaluate!($name, $model, $step, $inputs, [], |_, _, _| Default::default())
        };
        ($name:literal, $model:path, $step:expr, $inputs:expr, $peers:expr, $convert:expr) => {
            if $name.contains(&part) {
                let model = <$model>::default();
                let start = model.assemble(&<$model>::START).expect("the default start");
                let inputs = <<$model as Mechanism<f64>>::Inputs as Fields<f64>>::from_array($inputs);
                let states = along_the_motion(&model, start, inputs, $step);
                let names: &[&str] = &$peers;
                let peers = names.iter().filter_map(|name| {
                    Peer::open(name, ALPHA, &states, |state| {
                        let (a, _) = acceleration(&model, state, &inputs);
                        $convert(&model, state, &a)
                    })
                });
                report(
                    $name,
                    (<$model>::OPERATIONS, <$model>::SOURCE),
                    &model,
                    &states,
                    &inputs,
                    peers.collect(),
                );
            }
        };
    }
    // Also the two functions that controllers call.
    macro_rules! arm {
        ($name:literal, $model:path, $peers:expr) => {
            evaluate!($name, $model, 0.01, [0.0; 7], $peers, |_: &$model, state, a| arm(state, a));
            if $name.contains(&part) {
                let model = <$model>::default();
                let start = model.assemble(&<$model>::START).expect("the default start");
                let inputs = <<$model as Mechanism<f64>>::Inputs as Fields<f64>>::from_array([0.0; 7]);
                let states = along_the_motion(&model, start, inputs, 0.01);
                let function: fn(&$model, f64, &_, &_, &_) -> _ = black_box(<$model>::inverse_dynamics);
                alone("  inverse_dynamics", |at| {
                    black_box(function(&model, 0.0, &states[at], &inputs, &states[at].v));
                });
                type Mass = <$model as Mechanism<f64>>::Mass;
                let function: fn(&$model, f64, &_, &mut Mass) =
                    black_box(<$model as Mechanism<f64>>::mass_matrix);
                let mut mass: Mass = model.zero_mass();
                alone("  mass_matrix", |at| {
                    function(&model, 0.0, &states[at].q, &mut mass);
                    black_box(&mass);
                });
            }
        };
    }
    evaluate!("double_pendulum", models::double_pendulum::DoublePendulum, 0.05, []);
    {
        use models::four_bar::FourBar;
        use models::n_four_bar::{NFourBar10, NFourBar40};
        evaluate!("four_bar", FourBar, 0.05, [], ["four_bar"], bodies!(FourBar));
        evaluate!("n_four_bar_10", NFourBar10, 0.05, [], ["n_four_bar_10"], bodies!(NFourBar10));
        evaluate!("n_four_bar_40", NFourBar40, 0.05, [], ["n_four_bar_40"], bodies!(NFourBar40));
    }
    {
        use models::andrews::Andrews;
        let peers = ["andrews_ldl", "andrews_ldl_turns", "andrews_crank", "andrews_crank_turns"];
        evaluate!("andrews", Andrews, 4e-4, [], peers, bodies!(Andrews));
    }

    arm!("panda", models::panda::Panda, ["panda_aba", "panda_aba_turns", "panda_ldl", "panda_ldl_turns"]);
    arm!("iiwa14", models::iiwa14::Iiwa14, []);
    arm!("iiwa14_parametric", models::iiwa14::Iiwa14Parametric, []);
    {
        use models::bricard::Bricard;
        evaluate!(
            "bricard",
            Bricard,
            0.05,
            [],
            ["bricard", "bricard_turns"],
            |model: &Bricard, state: &State<_, _>, a: &_| {
                bricard(&model.motions(0.0, &state.q, &state.v, a))
            }
        );
    }
    use models::spatial_slider_crank::SpatialSliderCrankAxial;
    evaluate!("spatial_slider_crank_axial", SpatialSliderCrankAxial, 0.02, []);
    evaluate!("fourbar_1", models::spatial_four_bar::Fourbar1, 0.02, []);
    let thrusts = [4100.0, 4080.0, 4090.0, 4060.0, 4100.0, 4070.0];
    evaluate!("stewart_platform", models::stewart_platform::StewartPlatform, 0.01, thrusts);
    evaluate!("delta_robot", models::delta_robot::DeltaRobot, 0.005, [-15.0, -14.0, -16.0]);
    evaluate!("double_wishbone", models::double_wishbone::DoubleWishbone, 0.01, [10e3, 20.0]);
}

/// Angles, rates and accelerations of a chain of revolutes in tree coordinates.
fn arm<Q: Vector<f64>, V: Vector<f64>>(state: &State<Q, V>, a: &V) -> Turns {
    let angles = state.q.as_slice().chunks(2).map(|turn| turn[1].atan2(turn[0]));
    [angles.collect(), state.v.as_slice().to_vec(), a.as_slice().to_vec()]
}

/// The angles of hinges 1 and 2, then 6, 5 and 4, from the ground outwards; hinge 3 is cut. An angle is zero where the
/// bodies' axes are parallel, so that a hinge's axis has the same components in both bodies' axes.
fn bricard(rods: &[SpatialMotion<f64>]) -> Turns {
    /// Bodies before and behind (none: the ground) and the number of the axis.
    const HINGES: [(Option<usize>, Option<usize>, usize); 5] = [
        (None, Some(0), 1),
        (Some(0), Some(1), 2),
        (None, Some(4), 0),
        (Some(4), Some(3), 2),
        (Some(3), Some(2), 1),
    ];
    const WORLD: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let mut turns = Turns::default();
    for (before, behind, axis) in HINGES {
        let [first, second] = [before, behind].map(|body| body.map(|at| &rods[at]));
        let [a, b] = [first, second].map(|body| body.map_or(WORLD, |rod| rod.orientation));
        let along =
            |column: usize, other: usize| (0..3).map(|row| a[row][column] * b[row][other]).sum::<f64>();
        let (x, y) = ((axis + 1) % 3, (axis + 2) % 3);
        turns[0].push(along(y, x).atan2(along(x, x)));
        let rate = |body: Option<&SpatialMotion<f64>>| body.map_or(0.0, |rod| rod.rate[axis]);
        let change =
            |body: Option<&SpatialMotion<f64>>| body.map_or(0.0, |rod| rod.angular_acceleration[axis]);
        turns[1].push(rate(second) - rate(first));
        turns[2].push(change(second) - change(first));
    }
    turns
}

/// Inputs that do not change.
struct Constant<I>(I);

impl<M: Mechanism<f64>> InputSource<f64, M> for Constant<M::Inputs> {
    const HELD: bool = true;

    fn sample(&mut self, _: f64, _: &StateOf<M>) -> M::Inputs {
        self.0.clone()
    }
}

/// States at equal distances in time.
fn along_the_motion<M: Assemble<f64>>(
    model: &M,
    start: StateOf<M>,
    inputs: M::Inputs,
    step: f64,
) -> Vec<StateOf<M>> {
    let mut simulation = Simulation::new(model, start)
        .input_source(Constant(inputs))
        .formulation(Baumgarte { alpha: ALPHA, beta: ALPHA })
        .step(step / 200.0);
    (1..=STATES).map(|k| simulation.advance_until(step * k as f64).expect("a regular motion")).collect()
}

fn acceleration<M: Mechanism<f64>>(model: &M, state: &StateOf<M>, inputs: &M::Inputs) -> (M::V, M::Lambda) {
    let (mut a, mut lambda) = (model.zero_v(), model.zero_lambda());
    model.acceleration_baumgarte(0.0, state, inputs, 2.0 * ALPHA, ALPHA * ALPHA, &mut a, &mut lambda);
    (a, lambda)
}

fn report<M: Assemble<f64>>(
    name: &str,
    (operations, source): (usize, &str),
    model: &M,
    states: &[StateOf<M>],
    inputs: &M::Inputs,
    mut peers: Vec<Peer>,
) {
    let asked = if model.null_space_first() { M::null_space_baumgarte } else { M::acceleration_baumgarte };
    let mut own = stabilised(model, states, inputs, black_box(asked));
    let rounds = rounds(&mut own);
    let errors: Vec<f64> = peers.iter_mut().map(Peer::error).collect();
    let mut ours = Vec::new();
    let mut theirs = vec![Vec::new(); peers.len()];
    for _ in 0..SAMPLES {
        ours.push(sample(&mut own, rounds));
        for (peer, theirs) in peers.iter_mut().zip(&mut theirs) {
            theirs.push(sample(&mut |at| peer.call(at), rounds));
        }
    }
    print!("{name:<28}{operations:>10}{:>9.1}", least(&ours));
    for (at, ((peer, theirs), error)) in peers.iter().zip(theirs).zip(errors).enumerate() {
        let middle = median(theirs.iter().zip(&ours).map(|(their, our)| their / our).collect());
        let before = if at == 0 { String::new() } else { format!("\n{:47}", "") };
        let (name, operations, ns) = (&peer.name, &peer.operations, least(&theirs));
        let ratio = ns / least(&ours);
        print!("{before}  {name:<22}{operations:>10}{ns:>9.1}{ratio:>7.2}{middle:>8.2}  {error:.1e}");
    }
    println!();
    bounds(source, least(&ours));
    if model.null_space_first() {
        let asked = black_box(M::acceleration_baumgarte as Stabilised<M>);
        beside("  by multipliers", stabilised(model, states, inputs, asked), &mut own, rounds);
    }
    if model.row_count() > 0 {
        let plain = if model.null_space_first() { M::null_space } else { M::acceleration };
        let plain: Plain<M> = black_box(plain);
        let (mut a, mut lambda) = (model.zero_v(), model.zero_lambda());
        let call = |at: usize| {
            let pivot = plain(model, 0.0, &states[at], inputs, &mut a, &mut lambda);
            black_box((pivot, &a, &lambda));
        };
        beside("  without Baumgarte's terms", call, &mut own, rounds);
    }
}

/// What the processor could do at best, and how far from it the evaluation is.
fn bounds(source: &str, ns: f64) {
    let processor = Processor::here();
    let limits = Limits::of(source, |compiled| compiled.default_solution(), &processor);
    let clock = clock();
    let Limits { ports, latency, front_end } = limits;
    println!(
        "{:<38}{:>9.1}  {:.2} times the bound; {}: {ports:.0} cycles by ports, {front_end:.0} by the front end, {latency:.0} of latency, at {clock:.2} GHz",
        "  bound on throughput",
        limits.throughput() / clock,
        ns * clock / limits.throughput(),
        processor.name
    );
}

/// Through a pointer, so that nothing is kept from one state to the next.
type Stabilised<M> = fn(
    &M,
    f64,
    &StateOf<M>,
    &<M as Mechanism<f64>>::Inputs,
    f64,
    f64,
    &mut <M as Variables<f64>>::V,
    &mut <M as Variables<f64>>::Lambda,
) -> f64;

type Plain<M> = fn(
    &M,
    f64,
    &StateOf<M>,
    &<M as Mechanism<f64>>::Inputs,
    &mut <M as Variables<f64>>::V,
    &mut <M as Variables<f64>>::Lambda,
) -> f64;

fn stabilised<M: Mechanism<f64>>(
    model: &M,
    states: &[StateOf<M>],
    inputs: &M::Inputs,
    function: Stabilised<M>,
) -> impl FnMut(usize) {
    let (mut a, mut lambda) = (model.zero_v(), model.zero_lambda());
    move |at: usize| {
        let pivot =
            function(model, 0.0, &states[at], inputs, 2.0 * ALPHA, ALPHA * ALPHA, &mut a, &mut lambda);
        black_box((pivot, &a, &lambda));
    }
}

/// Another function beside that which formulations ask.
fn beside(name: &str, mut call: impl FnMut(usize), other: &mut impl FnMut(usize), rounds: usize) {
    let pairs: Vec<(f64, f64)> =
        (0..SAMPLES).map(|_| (sample(&mut call, rounds), sample(other, rounds))).collect();
    let ns: Vec<f64> = pairs.iter().map(|pair| pair.0).collect();
    let ratio = median(pairs.iter().map(|(call, other)| call / other).collect());
    println!("{name:<38}{:>9.1}  {ratio:.2} times as long", least(&ns));
}

/// A function of its own, without peers.
fn alone(name: &str, mut call: impl FnMut(usize)) {
    let rounds = rounds(&mut call);
    let samples: Vec<f64> = (0..SAMPLES).map(|_| sample(&mut call, rounds)).collect();
    println!("{name:<38}{:>9.1}", least(&samples));
}

/// How many rotations over all states make a sample of about 20 µs.
fn rounds(call: &mut impl FnMut(usize)) -> usize {
    let warm = sample(call, 100);
    (2e4 / (warm * STATES as f64)).ceil().max(1.0) as usize
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
