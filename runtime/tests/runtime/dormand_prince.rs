//! Dormand and Prince's method: its order, its steps, what it remembers, what lies between its steps.

use crate::double_pendulum::{DoublePendulum, Torque};
use crate::four_bar::FourBar;
use crate::space::{Counted, TUMBLING, Top, Turning, apart, largest, run};
use core::f64::consts::TAU;
use linkwright_runtime::quaternion::{exponential, product};
use linkwright_runtime::{
    Derivative, DormandPrince, Dynamics, Integrator, Interpolate, Layout, Method, Rejections, Rk4,
    Simulation, SimulationError, State, StateOf, StepFailure, Variables,
};

const FREE: Layout = Layout { linear: 1, rotations: 0, quaternions: 0, angles: &[] };

type Point = State<[f64; 1], [f64; 1]>;

/// A point with the acceleration f(t, x, v), which counts its evaluations.
struct Line<F> {
    acceleration: F,
    evaluations: u32,
}

impl<F: Fn(f64, f64, f64) -> f64> Variables<f64> for Line<F> {
    fn layout(&self) -> &Layout<'_> {
        &FREE
    }
    type Q = [f64; 1];
    type V = [f64; 1];
    type Z = ();
    type Gates = ();
    type Lambda = [f64; 0];
}

impl<F: Fn(f64, f64, f64) -> f64> Dynamics<f64> for Line<F> {
    type Variables = Self;

    fn variables(&self) -> &Self {
        self
    }

    fn derivative(&mut self, time: f64, state: &mut Point) -> Derivative<[f64; 1]> {
        self.evaluations += 1;
        Derivative { v: state.v, a: [(self.acceleration)(time, state.q[0], state.v[0])], z: () }
    }
}

fn line<F: Fn(f64, f64, f64) -> f64>(acceleration: F) -> Line<F> {
    Line { acceleration, evaluations: 0 }
}

fn memory<D: Dynamics<f64>>(_: &D) -> <DormandPrince as Method<f64>>::Memory<D::Variables> {
    DormandPrince::fixed().memory::<D::Variables>()
}

/// The state, the steps taken and the trials given up.
type Travelled<D> = (StateOf<<D as Dynamics<f64>>::Variables>, u32, Rejections);

/// Steps of the method's choice until `end`.
fn travel<D: Dynamics<f64>>(
    dynamics: &mut D,
    method: DormandPrince,
    start: StateOf<D::Variables>,
    end: f64,
) -> Result<Travelled<D>, StepFailure> {
    let mut memory = memory(dynamics);
    let (mut time, mut state, mut steps) = (0.0, start, 0);
    let mut all = Rejections::default();
    while time < end {
        let stepped = method.step(&mut memory, dynamics, time, end - time, &state)?;
        assert!(stepped.size > 0.0 && stepped.size <= end - time);
        time = if stepped.size == end - time { end } else { time + stepped.size };
        state = stepped.state;
        all.error += stepped.rejections.error;
        all.breakdown += stepped.rejections.breakdown;
        steps += 1;
    }
    Ok((state, steps, all))
}

#[test]
fn fifth_order_of_a_tumbling_body() {
    let exact = run(Top::free(), DormandPrince::fixed(), TUMBLING, 2.0, 3200);
    let check = run(Top::free(), Rk4, TUMBLING, 2.0, 12_800);
    assert!(apart(exact.q, check.q) < 1e-11);
    let errors = [100, 200, 400].map(|n| {
        let end = run(Top::free(), DormandPrince::fixed(), TUMBLING, 2.0, n);
        [apart(end.q, exact.q), largest(&end.v, &exact.v)]
    });
    for pair in errors.windows(2) {
        for (coarse, fine) in pair[0].into_iter().zip(pair[1]) {
            let order = (coarse / fine).log2();
            println!("order {order:.3} from {coarse:.2e} to {fine:.2e}");
            assert!((4.8..5.4).contains(&order), "{order}");
        }
    }
}

#[test]
fn a_uniform_rotation_in_space_is_exact() {
    let (axis, rate) = ([0.48, -0.6, 0.64], 314.0);
    let begin = exponential([0.5, -1.0, 0.2]);
    let round = || Top { inertia: [2.0; 3], moment: [0.0; 3] };
    let start = State::new(begin, axis.map(|entry: f64| entry * rate));
    let (s, c) = (0.5_f64 * 10.0 * rate).sin_cos();
    let expected = product(begin, [c, s * axis[0], s * axis[1], s * axis[2]]);
    let end = run(round(), DormandPrince::fixed(), start, 10.0, 10_000);
    assert!(apart(end.q, expected) < 2e-9 && end.v == start.v, "{}", apart(end.q, expected));
    let (end, steps, _) = travel(&mut round(), DormandPrince::tolerance(1e-8), start, 10.0).unwrap();
    assert!(apart(end.q, expected) < 5e-9 && steps < 120, "{} in {steps} steps", apart(end.q, expected));
}

#[test]
fn a_counted_angle_follows_the_integral_of_its_rate() {
    let v = [0.8 * 3.0 + 0.6 * 0.7, 0.4, 3.0, -0.7];
    let start = State::new([0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0], v);
    let method = DormandPrince::tolerance(1e-9);
    for end in [
        run(Counted(Top::free()), DormandPrince::fixed(), start, 20.0, 400),
        travel(&mut Counted(Top::free()), method, start, 20.0).unwrap().0,
    ] {
        let counted = TAU * end.q[5] + end.q[6];
        assert!(end.q[0].abs() > 7.0 && (counted - end.q[0]).abs() < 1e-12, "{counted} {}", end.q[0]);
    }
}

/// Local errors under the tolerance add up to a global one in proportion to it, over eight decades.
#[test]
fn the_error_follows_the_tolerance() {
    let exact = run(Top::free(), DormandPrince::fixed(), TUMBLING, 10.0, 5_000);
    let found: Vec<(f64, f64)> = (4..=11)
        .map(|digits| {
            let tolerance = 10.0_f64.powi(-digits);
            let method = DormandPrince::tolerance(tolerance);
            let (end, steps, rejections) = travel(&mut Top::free(), method, TUMBLING, 10.0).unwrap();
            let error = apart(end.q, exact.q).max(largest(&end.v, &exact.v));
            println!("{tolerance:.0e}: {error:.2e} in {steps} steps, {} given up", rejections.total());
            assert!(error < 30.0 * tolerance && error > 0.01 * tolerance, "{tolerance:e}: {error:e}");
            (error, f64::from(steps))
        })
        .collect();
    for pair in found.windows(2) {
        let ratio = pair[0].0 / pair[1].0;
        assert!((3.0..30.0).contains(&ratio), "a decade of tolerance is {ratio} of error");
        // h ~ tolerance^(1/5)
        let steps = pair[1].1 / pair[0].1;
        assert!((1.3..1.9).contains(&steps), "a decade of tolerance is {steps} of steps");
    }
}

/// A fast spin with a slow precession has increments of a few tenths: the terms of dexp⁻¹ left out stay below the error.
#[test]
fn a_fast_top_follows_the_tolerance() {
    let inertia = [0.234375 + 15.0, 0.46875, 0.234375 + 15.0];
    let top = || Top { inertia, moment: [0.0, 15.0 * 9.81, 0.0] };
    let start = State::new([1.0, 0.0, 0.0, 0.0], [0.0, 150.0, -4.61538]);
    let expected = [0.58456062406948, -0.70066289541215, 0.38432575302288, 0.14019307880051];
    for digits in 4..=10 {
        let tolerance = 10.0_f64.powi(-digits);
        let (end, steps, rejections) =
            travel(&mut top(), DormandPrince::tolerance(tolerance), start, 0.5).unwrap();
        let error = apart(end.q, expected);
        println!("{tolerance:.0e}: {error:.2e} in {steps} steps, {} given up", rejections.total());
        assert!((10.0 * tolerance..30.0 * tolerance).contains(&error), "{tolerance:e}: {error:e}");
    }
}

#[test]
fn the_end_of_a_step_is_the_start_of_the_next() {
    let mut swing = line(|_, x, _| -x);
    let method = DormandPrince::fixed();
    let fresh = memory(&swing);
    let mut memory = fresh;
    let mut state = State::new([1.0], [0.0]);
    let step = |memory: &mut _, swing: &mut _, time: f64, state: &Point| -> Point {
        method.step(memory, swing, time, 0.1, state).unwrap().state
    };
    for k in 0..10 {
        state = step(&mut memory, &mut swing, 0.1 * f64::from(k), &state);
    }
    assert_eq!(swing.evaluations, 7 + 9 * 6);
    // Another state, or another time, is evaluated again.
    let before = memory;
    let other = State::new([state.q[0] + 1e-15], state.v);
    step(&mut memory, &mut swing, 1.0, &other);
    assert_eq!(swing.evaluations, 61 + 7);
    memory = before;
    step(&mut memory, &mut swing, 2.0, &state);
    assert_eq!(swing.evaluations, 68 + 7);
    // With what is remembered, the same to the bit as without.
    memory = before;
    let with = step(&mut memory, &mut swing, 1.0, &state);
    let without = step(&mut fresh.clone(), &mut swing, 1.0, &state);
    assert_eq!((with, swing.evaluations), (without, 75 + 6 + 7));
}

/// An evaluation for each stage but the first, at the start, in Euler's step; as many for a trial given up.
#[test]
fn evaluations_are_counted() {
    let mut swing = line(|_, x, _| -x);
    let start = State::new([1.0], [0.0]);
    let (end, steps, rejections) = travel(&mut swing, DormandPrince::tolerance(1e-8), start, TAU).unwrap();
    assert_eq!(swing.evaluations, 2 + 6 * (steps + rejections.total()));
    println!("a period of a swing: {} evaluations, off by {:.1e}", swing.evaluations, end.q[0] - 1.0);
    assert!((end.q[0] - 1.0).abs() < 1e-7 && swing.evaluations < 400, "{} {end:?}", swing.evaluations);
}

#[test]
fn the_continuous_extension_is_of_order_4() {
    let exact = |time: f64| run(Top::free(), DormandPrince::fixed(), TUMBLING, time, 500);
    let begin = exact(0.5);
    let off = |h: f64| {
        let method = DormandPrince::fixed();
        let mut memory = memory(&Top::free());
        let end = method.step(&mut memory, &mut Top::free(), 0.5, h, &begin).unwrap().state;
        assert_eq!(DormandPrince::size::<Top>(&memory), Some(h));
        let at = |elapsed: f64| -> Turning { DormandPrince::at(&memory, &Top::free(), elapsed).unwrap() };
        assert!(largest(&at(0.0).q, &begin.q) < 1e-15 && at(0.0).v == begin.v);
        assert!(largest(&at(h).q, &end.q) < 1e-15 && largest(&at(h).v, &end.v) < 1e-14);
        [0.25, 0.5, 0.75].map(|part| {
            let (found, expected) = (at(part * h), exact(0.5 + part * h));
            apart(found.q, expected.q).max(largest(&found.v, &expected.v))
        })
    };
    for (coarse, fine) in off(0.1).into_iter().zip(off(0.05)) {
        let order = (coarse / fine).log2();
        println!("local order {order:.2} from {coarse:.1e} to {fine:.1e}");
        assert!((4.7..5.4).contains(&order), "an error of h⁵ in a step is order 4: {order}");
    }
}

#[test]
fn a_jump_is_stepped_to_and_passed() {
    let mut brake = line(|t, _, _| if t < 1.0 { 1.0 } else { -1.0 });
    let start = State::new([0.0], [0.0]);
    let (end, _, rejections) = travel(&mut brake, DormandPrince::tolerance(1e-9), start, 2.0).unwrap();
    assert!((end.q[0] - 1.0).abs() < 3e-7 && end.v[0].abs() < 3e-7, "{end:?}");
    assert!(rejections.error > 3, "{rejections:?}");
}

/// Slopes whose norm overflows propose no step; the least one is taken, and grows.
#[test]
fn a_first_step_is_found_for_huge_slopes() {
    for huge in [1e200, -1e300] {
        let start = State::new([0.0], [0.0]);
        let mut fast = line(|_, _, _| huge);
        let (end, steps, _) = travel(&mut fast, DormandPrince::tolerance(1e-8), start, 1.0).unwrap();
        assert!((end.q[0] / huge - 0.5).abs() < 1e-14 && steps < 30, "{end:?} in {steps}");
    }
}

#[test]
fn what_is_not_finite_is_approached_and_then_an_error() {
    let mut wall = line(|_, x, _| if x < 1.0 { 0.0 } else { f64::NAN });
    let start = State::new([0.0], [1.0]);
    let mut memory = memory(&wall);
    let (mut time, mut state) = (0.0, start);
    let failure = loop {
        match DormandPrince::tolerance(1e-6).step(&mut memory, &mut wall, time, 10.0, &state) {
            Ok(stepped) => (time, state) = (time + stepped.size, stepped.state),
            Err(failure) => break failure,
        }
    };
    assert!((time - 1.0).abs() < 1e-13, "{time}");
    let StepFailure::Underflow { size, rejections } = failure else { panic!("{failure:?}") };
    assert!(size < 1e-14 && rejections.breakdown > 0 && rejections.error == 0, "{failure:?}");

    let mut nowhere = line(|_, _, _| f64::NAN);
    let failure = travel(&mut nowhere, DormandPrince::tolerance(1e-6), start, 1.0).unwrap_err();
    assert_eq!(failure, StepFailure::Breakdown);
}

/// A uniform motion whose equations have no solution at some times, or at some evaluations.
struct Singular {
    at: fn(f64, u32) -> bool,
    failed: bool,
    evaluations: u32,
}

impl Variables<f64> for Singular {
    fn layout(&self) -> &Layout<'_> {
        &FREE
    }
    type Q = [f64; 1];
    type V = [f64; 1];
    type Z = ();
    type Gates = ();
    type Lambda = [f64; 0];
}

impl Dynamics<f64> for Singular {
    type Variables = Self;

    fn variables(&self) -> &Self {
        self
    }

    fn derivative(&mut self, time: f64, state: &mut Point) -> Derivative<[f64; 1]> {
        self.evaluations += 1;
        self.failed |= (self.at)(time, self.evaluations);
        Derivative { v: state.v, a: [0.0], z: () }
    }
    fn begin_trial(&mut self, _size: f64) {
        self.failed = false;
    }
    fn broke_down(&self) -> bool {
        self.failed
    }
}

#[test]
fn a_stage_that_breaks_down_is_tried_again() {
    let singular = |at: fn(f64, u32) -> bool| Singular { at, failed: false, evaluations: 0 };
    let start = State::new([0.0], [1.0]);
    let method = DormandPrince::tolerance(1e-6);
    // Stage 4 of the second step.
    let mut once = singular(|_, evaluation| evaluation == 2 + 6 + 3);
    let (end, steps, rejections) = travel(&mut once, method, start, 1.0).unwrap();
    assert!((end.q[0] - 1.0).abs() < 1e-15);
    assert_eq!(rejections, Rejections { breakdown: 1, ..Rejections::default() });
    assert_eq!(once.evaluations, 2 + 6 * steps + 3, "the trial ended where it broke down");

    let mut wall = singular(|time, _| time > 0.3);
    let failure = travel(&mut wall, method, start, 1.0).unwrap_err();
    assert!(matches!(failure, StepFailure::Underflow { rejections, .. } if rejections.breakdown > 0));
    let mut start_itself = singular(|_, _| true);
    assert_eq!(travel(&mut start_itself, method, start, 1.0).unwrap_err(), StepFailure::Breakdown);
    let mut fixed = singular(|time, _| time > 0.3);
    let failure = travel(&mut fixed, DormandPrince::fixed(), start, 1.0).unwrap_err();
    assert_eq!(failure, StepFailure::Breakdown);
}

#[test]
fn a_singular_start_names_the_joint() {
    let model = FourBar { lengths: [0.2, 0.4, 0.2], ground: 0.4, ..FourBar::new() };
    let start = State::new(model.rough([0.0; 3]), [0.0; 9]);
    for method in [DormandPrince::fixed(), DormandPrince::tolerance(1e-8)] {
        let mut simulation = Simulation::new(&model, start).integrator(method).step(1e-3);
        let error = simulation.advance().unwrap_err();
        assert!(
            matches!(error, SimulationError::Breakdown { time: 0.0, pivot, .. } if pivot < 1e-14),
            "{error:?}"
        );
        assert_eq!((simulation.time(), simulation.state()), (0.0, &start));
    }
}

/// An input that is no number from some time on is stepped to as near as the clock can tell.
#[test]
fn what_no_step_can_pass_is_an_error_with_its_reasons() {
    let model = DoublePendulum::new();
    let mut simulation = Simulation::new(&model, SWUNG)
        .sampled(|time, _| Torque { shoulder: if time > 0.05 { f64::NAN } else { 0.0 } })
        .integrator(DormandPrince::tolerance(1e-8))
        .step(0.1);
    let error = simulation.advance_until(1.0).unwrap_err();
    let SimulationError::StepUnderflow { time, step, rejections } = error else { panic!("{error:?}") };
    assert!((time - 0.05).abs() < 1e-12 && step < 1e-15 && rejections.breakdown > 0, "{error:?}");
    assert!(error.to_string().contains("no step from t = 0.0"), "{error}");
    assert_eq!(simulation.time(), time);
    let mut simulation = simulation.sampled(|_, _| Torque { shoulder: f64::NAN });
    let error = simulation.advance().unwrap_err();
    assert!(matches!(error, SimulationError::NonFinite { .. }), "{error:?}");
}

#[test]
fn tolerances_are_checked() {
    for tolerance in [0.0, -1e-6, f64::NAN, f64::INFINITY] {
        for method in [DormandPrince::tolerances(tolerance, 1e-6), DormandPrince::tolerances(1e-6, tolerance)]
        {
            let error = method.check().unwrap_err();
            assert!(error.what.contains("tolerance"), "{error}");
        }
    }
    assert!(<DormandPrince as Method<f64>>::check(&DormandPrince::fixed()).is_ok());
}

fn free(_: f64, _: &State<[f64; 8], [f64; 2]>) -> Torque {
    Torque { shoulder: 0.0 }
}

const SWUNG: State<[f64; 8], [f64; 2]> = State::new([1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0], [1.0, -2.0]);

/// Inputs that are held change with the step, so the accelerations at its start are new.
#[test]
fn held_inputs_are_new_in_every_step() {
    let model = DoublePendulum::new();
    let push = |time: f64, _: &State<_, _>| Torque { shoulder: 3.0 * time };
    let simulation = || Simulation::new(&model, SWUNG).held(push).step(0.002);
    let dormand = simulation().integrator(DormandPrince::fixed()).advance_until(0.2).unwrap();
    let rk4 = simulation().advance_until(0.2).unwrap();
    // Both follow the same steps of the input; accelerations of the step before would be off by 1e-3.
    assert!(largest(&dormand.q, &rk4.q) < 1e-9 && largest(&dormand.v, &rk4.v) < 1e-8, "{dormand:?} {rk4:?}");
}

/// The step asked for is the largest; sampled inputs are asked for at the stages; the end is met.
#[test]
fn the_simulation_takes_its_steps() {
    let model = DoublePendulum::new();
    let mut simulation =
        Simulation::new(&model, SWUNG).sampled(free).integrator(DormandPrince::tolerance(1e-10)).step(0.02);
    let energy = simulation.energy();
    let mut last = 0.0;
    let (mut short, mut longest) = (0, 0.0_f64);
    simulation
        .run_until(3.0, |sample| {
            longest = longest.max(sample.time - last);
            short += u32::from(sample.time - last < 0.015);
            last = sample.time;
        })
        .unwrap();
    assert_eq!((simulation.time(), last), (3.0, 3.0));
    assert!(longest < 0.02 + 1e-12 && short > 10, "{longest} {short}");
    let drift = (simulation.energy() - energy).abs();
    assert!(drift < 1e-8, "{drift}");
    let step = simulation.advance().unwrap();
    assert!(step.size <= 0.02 && step.rejections.total() < 5);
}

#[test]
fn states_between_the_steps() {
    let model = DoublePendulum::new();
    let build = || Simulation::new(&model, SWUNG).sampled(free).integrator(DormandPrince::tolerance(1e-9));
    let mut simulation = build().step(0.1);
    let none = simulation.interpolate(0.05).unwrap_err();
    assert_eq!(none, SimulationError::NotCovered { time: 0.05, from: 0.0, to: 0.0 });
    assert_eq!(simulation.interpolate(0.0).unwrap(), SWUNG);
    simulation.advance_until(0.4).unwrap();
    let step = simulation.advance().unwrap();
    let (from, to) = (step.time - step.size, step.time);
    for part in [0.1, 0.5, 0.9] {
        let time = from + part * step.size;
        let found = simulation.interpolate(time).unwrap();
        let expected = build().step(0.1).advance_until(time).unwrap();
        assert!(largest(&found.q, &expected.q) < 1e-7 && largest(&found.v, &expected.v) < 1e-7, "{part}");
    }
    assert_eq!(simulation.interpolate(to).unwrap(), *simulation.state());
    // A step that ends at zero, where the time has no rounding of its own.
    let mut before = build().step(0.1).start_time(-0.3);
    before.advance_until(0.0).unwrap();
    assert!(before.interpolate(-1e-3).is_ok(), "{:?}", before.interpolate(-1e-3));
    for outside in [from - 1e-9, to + 1e-9, f64::NAN] {
        let error = simulation.interpolate(outside).unwrap_err();
        assert!(matches!(error, SimulationError::NotCovered { .. }), "{error:?}");
        assert!(error.to_string().contains("the last step went from"), "{error}");
    }
}

#[test]
fn samples_at_even_times() {
    let model = DoublePendulum::new();
    let build = || Simulation::new(&model, SWUNG).sampled(free).integrator(DormandPrince::tolerance(1e-9));
    let mut steps = 0;
    build().step(0.1).run_until(1.0, |_| steps += 1).unwrap();
    for (interval, count) in [(0.01, 101), (0.3, 4), (0.125, 9), (1.0, 2), (7.0, 1)] {
        let mut times = Vec::new();
        let mut simulation = build().step(0.1);
        let end = simulation
            .run_every(interval, 1.0, |sample| {
                times.push(sample.time);
                let expected = build().step(0.1).advance_until(sample.time).unwrap();
                assert!(largest(&sample.state.q, &expected.q) < 1e-7, "{}", sample.time);
            })
            .unwrap();
        assert_eq!(times.len(), count, "{interval}: {times:?}");
        for (k, time) in times.iter().enumerate() {
            assert!((time - k as f64 * interval).abs() < 1e-15, "{interval}: {time}");
        }
        assert!(simulation.time() == 1.0 && end == *simulation.state());
        assert_eq!(end, build().step(0.1).advance_until(1.0).unwrap(), "steps are those without samples");
    }
    for interval in [0.0, -1.0, f64::NAN] {
        let error = build().step(0.1).run_every(interval, 1.0, |_| ()).unwrap_err();
        assert!(matches!(error, SimulationError::Setting(_)), "{error:?}");
    }
}

#[test]
fn single_precision_runs() {
    let model = DoublePendulum::<f32>::new();
    let start = State::new([1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0], [0.0; 2]);
    let mut simulation = Simulation::new(&model, start)
        .sampled(|_, _| Torque { shoulder: 0.0_f32 })
        .integrator(DormandPrince::tolerance(1e-5))
        .step(0.1);
    let before = simulation.energy();
    let mut count = 0;
    simulation.run_every(0.05, 2.0, |_| count += 1).unwrap();
    assert_eq!(count, 41);
    assert!((simulation.energy() - before).abs() < 1e-3, "{}", simulation.energy() - before);
}
