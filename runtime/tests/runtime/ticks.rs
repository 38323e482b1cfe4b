//! The clock over many ticks: what is integrated is what it shows, and what it shows is exact.
//!
//! A balanced body turns with 1 rad/s, so that its angle is the time that was integrated.

use crate::double_pendulum::{DoublePendulum, Torque};
use core::cell::{Cell, RefCell};
use linkwright_runtime::{
    DormandPrince, Dynamics, Event, Integrator, Method, Real, Rk4, Simulation, SimulationError, State,
    StateOf, StepFailure, Stepped, SteppedOf, Variables,
};

/// Both bodies at 0 rad, 1 rad/s.
fn turning<R: Real>() -> State<[R; 8], [R; 2]> {
    let (zero, one) = (R::ZERO, R::ONE);
    State::new([one, zero, one, zero, zero, zero, zero, zero], [one, one])
}

/// Steps and the angle turned, of ticks that are advanced by naming their ends.
fn ticked<R: Real>(begin: f64, tick: f64, h: f64, ticks: u32) -> (u32, f64) {
    let model = DoublePendulum::<R>::balanced();
    let mut steps = 0;
    let mut simulation = Simulation::new(&model, turning::<R>())
        .held(|_, _| {
            steps += 1;
            Torque { shoulder: R::ZERO }
        })
        .start_time(R::from_f64(begin))
        .step(R::from_f64(h));
    for k in 1..=ticks {
        simulation.advance_until(R::from_f64(begin + f64::from(k) * tick)).unwrap();
    }
    let angle = simulation.state().q[5].to_f64();
    (steps, angle)
}

#[test]
fn no_motion_is_skipped_in_single_precision() {
    for (begin, tick, h) in [(300.0, 1e-3, 1e-4), (1000.0, 1e-3, 1e-4), (3600.0, 1e-2, 1e-3)] {
        let (steps, angle) = ticked::<f32>(begin, tick, h, 100);
        // What lies between the two times that the clock showed, as `f32` has them.
        let elapsed = f64::from((begin + 100.0 * tick) as f32) - f64::from(begin as f32);
        println!("from {begin} s: {steps} steps, {angle} s of {elapsed} s");
        assert!((angle - elapsed).abs() < 1e-3 * elapsed, "{angle} {elapsed}");
        assert!(f64::from(steps) >= elapsed / h && f64::from(steps) < elapsed / h + 101.0, "{steps}");
    }
}

/// A pendulum swings as it does from time zero in double precision, whatever the time is and however it is advanced.
#[test]
fn a_pendulum_swings_the_same_at_every_time() {
    let start = |upper: f64| [upper.cos(), upper.sin(), upper.cos(), upper.sin(), 0.0, upper, 0.0, 0.0];
    let (tick, h, ticks) = (1e-3_f32, 1e-4_f32, 1000);
    let model = DoublePendulum::<f64>::new();
    let mut exact = Simulation::new(&model, State::new(start(0.7), [0.0; 2]))
        .sampled(|_, _| Torque { shoulder: 0.0 })
        .step(h.into());
    let model = DoublePendulum::<f32>::new();
    let expected = exact.advance_for(ticks as f64 * f64::from(tick)).unwrap();
    for begin in [0.0_f32, 300.0, 1000.0, 3600.0, 86_400.0, 604_800.0] {
        let start = State::new(start(0.7).map(|x| x as f32), [0.0; 2]);
        let mut simulation = Simulation::new(&model, start)
            .sampled(|_, _| Torque { shoulder: 0.0_f32 })
            .start_time(begin)
            .step(h);
        for _ in 0..ticks {
            simulation.advance_for(tick).unwrap();
        }
        let found = simulation.state();
        for (found, expected) in found.v.iter().zip(&expected.v) {
            assert!((f64::from(*found) - expected).abs() < 2e-3, "from {begin} s: {found} {expected}");
        }
    }
}

#[test]
fn no_motion_is_skipped_at_large_times() {
    // Times near 1e17 s are 16 s apart.
    let (steps, angle) = ticked::<f64>(1e17, 16.0, 0.5, 2);
    assert!(steps == 64 && (angle - (32.0 - 10.0 * core::f64::consts::PI)).abs() < 1e-9, "{steps} {angle}");
}

/// Durations add up exactly, in steps that are all of their size; what the clock shows is their exact sum, rounded once.
fn durations<R: Real>(begin: f64, tick: f64, ticks: u32) {
    let model = DoublePendulum::<R>::balanced();
    let (start, tick) = (R::from_f64(begin), R::from_f64(tick));
    let mut steps = 0;
    let mut simulation = Simulation::new(&model, turning::<R>())
        .held(|_, _| {
            steps += 1;
            Torque { shoulder: R::ZERO }
        })
        .start_time(start)
        .step(tick);
    for k in 1..=ticks {
        simulation.advance_for(tick).unwrap();
        if R::EPSILON.to_f64() > 1e-10 {
            // Of two `f32` this is exact.
            let exact = start.to_f64() + f64::from(k) * tick.to_f64();
            assert_eq!(simulation.time(), R::from_f64(exact), "after {k} ticks from {begin} s");
        }
    }
    let [turns, angle] = [4, 5].map(|i| simulation.state().q[i].to_f64());
    let elapsed = f64::from(ticks) * tick.to_f64();
    let turned = turns * core::f64::consts::TAU + angle;
    assert!((turned - elapsed).abs() < f64::from(ticks) * R::EPSILON.to_f64(), "{turned} {elapsed}");
    assert_eq!(steps, ticks);
}

#[test]
fn a_hundred_thousand_ticks_are_counted_exactly() {
    durations::<f32>(0.0, 1e-3, 100_000);
    durations::<f32>(86_400.0, 1e-3, 100_000);
    durations::<f32>(604_800.0, 1e-4, 20_000);
    durations::<f64>(0.0, 1e-3, 20_000);
    durations::<f64>(1e12, 1e-4, 20_000);
}

/// A method that tells what it was asked for: times, and the sum of the sizes.
struct Asked<'a> {
    sum: &'a Cell<f64>,
    steps: &'a Cell<u32>,
    largest: &'a Cell<f64>,
}

impl<R: Real> Method<R> for Asked<'_> {
    type Memory<X: Variables<R>> = ();

    fn memory<X: Variables<R>>(&self) {}
}

impl<R: Real, D: Dynamics<R>> Integrator<R, D> for Asked<'_> {
    fn step(
        &self,
        memory: &mut (),
        dynamics: &mut D,
        time: R,
        h: R,
        state: &StateOf<D::Variables, R>,
    ) -> Result<SteppedOf<D::Variables, R>, StepFailure<R>> {
        assert!(h > R::ZERO);
        self.sum.set(self.sum.get() + h.to_f64());
        self.steps.set(self.steps.get() + 1);
        self.largest.set(self.largest.get().max(h.to_f64()));
        Rk4.step(memory, dynamics, time, h, state)
    }
}

/// Of runs to named ends, of durations and of steps, mixed, the sizes of the steps sum to what the clock shows.
#[test]
fn sizes_sum_to_what_the_clock_shows() {
    let model = DoublePendulum::<f32>::balanced();
    for (begin, h) in [(0.0_f32, 1e-3_f32), (7.7, 3e-4), (-2.0, 1e-3), (300.0, 1e-4), (86_400.0, 2e-3)] {
        let (sum, steps, largest) = (Cell::new(0.0), Cell::new(0), Cell::new(0.0));
        let mut simulation = Simulation::new(&model, turning::<f32>())
            .sampled(|_, _| Torque { shoulder: 0.0_f32 })
            .integrator(Asked { sum: &sum, steps: &steps, largest: &largest })
            .start_time(begin)
            .step(h);
        let (mut expected, mut asked) = (f64::from(begin), 0.0);
        for k in 0..1500_u32 {
            let odd = 1e-3 + 1.2345e-6 * (k * 7919 % 1000) as f32;
            match k % 4 {
                0 => {
                    simulation.advance_for(odd).unwrap();
                    (expected, asked) = (expected + f64::from(odd), asked + f64::from(odd));
                }
                1 => {
                    simulation.advance_steps(3).unwrap();
                    (expected, asked) = (expected + 3.0 * f64::from(h), asked + 3.0 * f64::from(h));
                }
                2 => {
                    let end = simulation.time() + 1e-2;
                    simulation.advance_until(end).unwrap();
                    (expected, asked) = (f64::from(end), asked + f64::from(end) - expected);
                    assert_eq!(simulation.time(), end);
                }
                _ => {
                    let end = simulation.time() + 5e-3;
                    simulation.run_until(end, |_| ()).unwrap();
                    (expected, asked) = (f64::from(end), asked + f64::from(end) - expected);
                }
            }
            assert_eq!(simulation.time(), expected as f32, "{begin} {h}: call {k}");
            let off = sum.get() + f64::from(begin) - expected;
            assert!(off.abs() < f64::from(h * f32::EPSILON), "{begin} {h}: {off:e} after {k} calls");
        }
        assert!(largest.get() <= 1.0101 * f64::from(h), "{}", largest.get());
        assert!(f64::from(steps.get()) <= asked / f64::from(h) + 1500.0, "{} steps", steps.get());
    }
}

fn steps_to<R: Real>(begin: R, h: R, end: R) -> u32 {
    let model = DoublePendulum::<R>::balanced();
    let (sum, steps, largest) = (Cell::new(0.0), Cell::new(0), Cell::new(0.0));
    let mut simulation = Simulation::new(&model, turning::<R>())
        .sampled(|_, _| Torque { shoulder: R::ZERO })
        .integrator(Asked { sum: &sum, steps: &steps, largest: &largest })
        .start_time(begin)
        .step(h);
    simulation.advance_until(end).unwrap();
    assert!(simulation.time() == end);
    let apart = end.to_f64() - begin.to_f64();
    assert!((sum.get() - apart).abs() <= (h * R::EPSILON).to_f64() + 1e-13 * apart, "{h:?}");
    steps.get()
}

/// Where the time is a multiple of the step size but for rounding, there is no step more and none less.
#[test]
fn multiples_leave_no_sliver() {
    for h in [1e-3, 1e-4, 3e-3, 0.1, 0.3, 1.0 / 3.0, 7e-5] {
        for n in (1..60).chain([99, 100, 101, 333, 1000]) {
            let end = f64::from(n) * h;
            assert_eq!(steps_to::<f64>(0.0, h, end), n, "{n} steps of {h}");
            assert_eq!(steps_to::<f32>(0.0, h as f32, end as f32), n, "{n} steps of {h}, single precision");
            assert_eq!(steps_to::<f64>(-end, h, 0.0), n, "{n} steps of {h} to zero");
        }
    }
    // What is less than a hundredth of a step is taken along, what is more is a step.
    let h = 0.25;
    for (end, steps) in [(1.002, 4), (1.004, 5), (0.999, 4), (0.2, 1), (1e-9, 1)] {
        assert_eq!(steps_to::<f64>(0.0, h, end), steps, "{end}");
    }
}

/// A run to where the clock stands already does nothing, whatever its sum has beyond the rounding.
#[test]
fn a_run_to_the_present_time_takes_no_step() {
    let model = DoublePendulum::<f64>::balanced();
    for (h, n) in [(1e-3, 1000), (0.1, 3), (0.7e-3, 1000), (0.1, 10)] {
        let mut steps = 0;
        let mut simulation = Simulation::new(&model, turning::<f64>())
            .held(|_, _| {
                steps += 1;
                Torque { shoulder: 0.0 }
            })
            .step(h);
        simulation.advance_steps(n).unwrap();
        let time = simulation.time();
        simulation.advance_until(time).unwrap();
        simulation.advance_for(0.0).unwrap();
        assert!(simulation.time() == time && simulation.samples(time).count() == 1);
        simulation.advance_for(h).unwrap();
        // The sample asked for the inputs of the step after it.
        assert_eq!(steps, n as u32 + 1, "{h}");
    }
}

/// Laws of time are asked at the clock rounded once, and motion goes on between two times that `f32` can tell apart.
#[test]
fn steps_below_the_distance_of_times() {
    let model = DoublePendulum::<f32>::balanced();
    let times = RefCell::new(Vec::new());
    let mut simulation = Simulation::new(&model, turning::<f32>())
        .held(|time: f32, _| {
            times.borrow_mut().push(time);
            Torque { shoulder: 0.0 }
        })
        .start_time(86_400.0)
        .step(1e-4);
    simulation.advance_steps(1000).unwrap();
    for (k, &time) in times.borrow().iter().enumerate() {
        assert_eq!(time, (86_400.0 + k as f64 * f64::from(1e-4_f32)) as f32);
    }
    let angle = simulation.state().q[5];
    assert!((angle - 0.1).abs() < 1e-5, "{angle}");
    // `end` can name every 8 ms.
    simulation.advance_until(86_400.0 + 0.125).unwrap();
    let angle = simulation.state().q[5];
    assert!((angle - 0.125).abs() < 1e-5, "{angle}");
}

#[test]
fn a_time_that_stands_or_is_none_is_refused() {
    fn refused<R: Real>(begin: f64, h: f64) -> Vec<SimulationError> {
        let model = DoublePendulum::<R>::balanced();
        let start = turning::<R>();
        let (begin, h) = (R::from_f64(begin), R::from_f64(h));
        let mut simulation = Simulation::new(&model, start)
            .sampled(|_, _| Torque { shoulder: R::ZERO })
            .integrator(DormandPrince::fixed())
            .start_time(begin)
            .step(h);
        let further = begin + h + h;
        let errors = vec![
            simulation.advance().unwrap_err(),
            simulation.advance_steps(2).unwrap_err(),
            simulation.advance_for(h).unwrap_err(),
            simulation.advance_until(further).unwrap_err(),
            simulation.run_until(further, |_| panic!("nothing is shown")).unwrap_err(),
            simulation.run_every(h, further, |_| panic!("nothing is shown")).unwrap_err(),
            simulation.run_until_event(further, &[], |_| panic!("nothing is shown")).unwrap_err(),
            simulation.samples(further).next().unwrap().map(|_| ()).unwrap_err(),
        ];
        assert_eq!(*simulation.state(), start);
        assert!(simulation.time() == begin || begin.to_f64().is_nan());
        errors
    }
    for begin in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for error in refused::<f64>(begin, 1e-3).into_iter().chain(refused::<f32>(begin, 1e-3)) {
            assert!(matches!(error, SimulationError::TimeNotFinite { .. }), "{error:?}");
            assert!(error.to_string().contains("`.start_time(seconds)` a finite number"), "{error}");
        }
    }
    for error in
        [refused::<f64>(1e20, 1e-3), refused::<f64>(-1e19, 1e-4), refused::<f32>(1e12, 1e-3)].concat()
    {
        let SimulationError::TimeStands { step, least, .. } = error else { panic!("{error:?}") };
        assert!(step < least && error.to_string().contains("later origin"), "{error}");
    }
    for error in refused::<f64>(1.7e308, 1e307).into_iter().chain(refused::<f32>(3.3e38, 2e37)) {
        assert!(matches!(error, SimulationError::TimeNotFinite { .. }), "{error:?}");
    }
    // At 1e17 s times are 16 s apart: a step of a millisecond is still counted.
    let model = DoublePendulum::<f64>::balanced();
    let mut simulation = Simulation::new(&model, turning::<f64>())
        .sampled(|_, _| Torque { shoulder: 0.0 })
        .start_time(1e17)
        .step(1e-3);
    simulation.advance_steps(16_000).unwrap();
    assert_eq!(simulation.time(), 1e17 + 16.0);
}

#[test]
fn durations_and_counts_are_checked() {
    let model = DoublePendulum::<f64>::balanced();
    let mut simulation =
        Simulation::new(&model, turning::<f64>()).sampled(|_, _| Torque { shoulder: 0.0 }).step(1e-3);
    assert!(matches!(
        Simulation::new(&model, turning::<f64>())
            .sampled(|_, _| Torque { shoulder: 0.0 })
            .advance_for(1.0)
            .unwrap_err(),
        SimulationError::StepMissing
    ));
    for seconds in [-1.0, f64::NAN, f64::INFINITY] {
        let error = simulation.advance_for(seconds).unwrap_err();
        assert!(error.to_string().starts_with("the time to advance for is"), "{error}");
    }
    let error = simulation.advance_steps(1 << 54).unwrap_err();
    let SimulationError::TooMany { what: "steps", count, most } = error else { panic!("{error:?}") };
    assert!(count == 2.0 * most && error.to_string().contains("longer steps"), "{error}");
    for end in [1e13, 1e300, f64::MAX] {
        let error = simulation.advance_until(end).unwrap_err();
        assert!(error.to_string().contains("steps, more than 9.0e15"), "{error}");
        assert!(
            simulation.run_until_event(end, &[], |_| ()).is_err() && simulation.advance_for(end).is_err()
        );
    }
    // The least double: a step at zero, and nothing beside a second.
    let mut tiny = simulation.step(f64::from_bits(1));
    assert!(matches!(tiny.advance_until(1.0).unwrap_err(), SimulationError::TooMany { .. }));
    assert!(matches!(tiny.advance_for(1.0).unwrap_err(), SimulationError::TooMany { .. }));
    assert_eq!(tiny.advance().unwrap().time, f64::from_bits(1));
    let mut simulation = tiny.step(1e-3);
    simulation.advance_until(1.0).unwrap();
    let error = simulation.advance_for(1e-30).unwrap_err();
    assert!(matches!(error, SimulationError::TimeStands { .. }), "{error}");
    assert_eq!(simulation.time(), 1.0);
}

/// A method that stands still, runs ahead or back.
struct Wrong(f64);

impl Method<f64> for Wrong {
    type Memory<X: Variables<f64>> = ();

    fn memory<X: Variables<f64>>(&self) {}
}

impl<D: Dynamics<f64>> Integrator<f64, D> for Wrong {
    fn step(
        &self,
        memory: &mut (),
        dynamics: &mut D,
        time: f64,
        h: f64,
        state: &StateOf<D::Variables>,
    ) -> Result<SteppedOf<D::Variables>, StepFailure> {
        let stepped = Rk4.step(memory, dynamics, time, h, state)?;
        Ok(Stepped { size: self.0 * h, ..stepped })
    }
}

#[test]
fn a_method_cannot_keep_a_run_from_ending() {
    let model = DoublePendulum::<f64>::balanced();
    for part in [0.0, -1.0, 2.0, f64::NAN] {
        let mut simulation = Simulation::new(&model, turning::<f64>())
            .sampled(|_, _| Torque { shoulder: 0.0 })
            .integrator(Wrong(part))
            .step(1e-3);
        let error = simulation.advance_until(1.0).unwrap_err();
        assert!(matches!(error, SimulationError::StepUnderflow { .. }), "{error:?}");
        assert_eq!((simulation.time(), *simulation.state()), (0.0, turning::<f64>()));
    }
}

/// Between the steps and at events times are counted from the step's beginning, where `f32` has one every 8 ms.
#[test]
fn dense_output_and_events_after_a_day_in_single_precision() {
    let model = DoublePendulum::<f32>::balanced();
    let begin = 86_400.0_f32;
    let build = || {
        Simulation::new(&model, turning::<f32>())
            .sampled(|_, _| Torque { shoulder: 0.0_f32 })
            .start_time(begin)
    };
    let mut simulation = build().integrator(DormandPrince::tolerance(1e-6)).step(0.05);
    let mut count = 0;
    simulation
        .run_every(0.031_25, begin + 2.0, |sample| {
            assert_eq!(sample.time, begin + 0.031_25 * count as f32);
            let off = sample.state.q[5] - (sample.time - begin);
            assert!(off.abs() < 2e-6, "{off} at {}", sample.time);
            count += 1;
        })
        .unwrap();
    assert_eq!(count, 65);
    // The least step is not four roundings of the time, 41 ms, here.
    let step = build().integrator(DormandPrince::tolerance(1e-6)).step(1e-3).advance().unwrap();
    assert_eq!(step.size, 1e-3);
    let mut simulation = build().step(0.1);
    for level in [0.012_345_f32, 0.02, 0.111, 0.5] {
        let event = Event::of("upper").level(level).tolerance(1e-6);
        let found = simulation.run_until_event(begin + 1.0, &[event], |_| ()).unwrap().unwrap();
        let past = simulation.sample().outputs.upper - level;
        assert!((0.0..2e-6).contains(&past), "{past} at {}", found.time);
        assert!(found.time == simulation.time() && (found.time - begin - level).abs() <= 4e-3);
    }
    simulation.advance_until(begin + 1.0).unwrap();
    assert!((simulation.state().q[5] - 1.0).abs() < 2e-6);
}

/// Another start time is another motion: nothing is known of a step before it.
#[test]
fn a_new_start_time_forgets_the_last_step() {
    let model = DoublePendulum::<f64>::balanced();
    let mut simulation = Simulation::new(&model, turning::<f64>())
        .sampled(|_, _| Torque { shoulder: 0.0 })
        .integrator(DormandPrince::tolerance(1e-8))
        .step(0.1);
    simulation.advance_until(1.0).unwrap();
    assert!(simulation.interpolate(0.95).is_ok());
    let simulation = simulation.start_time(1.0 + 1e-15);
    let error = simulation.interpolate(0.95).unwrap_err();
    assert!(matches!(error, SimulationError::NotCovered { .. }), "{error}");
}
