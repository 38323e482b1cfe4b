//! Bounds of Dormand and Prince's method and of samples: calls that had no end, or one that had nothing to do with the motion.

use crate::double_pendulum::{DoublePendulum, Torque};
use linkwright_runtime::{
    Derivative, DormandPrince, Dynamics, Event, Integrator, Layout, Method, Real, Rk4, Simulation,
    SimulationError, State, StateOf, StepFailure, SteppedOf, Variables,
};

type Swing<R = f64> = State<[R; 8], [R; 2]>;

fn swung<R: Real>() -> Swing<R> {
    let k = R::from_f64;
    State::new([1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0].map(k), [1.0, -2.0].map(k))
}

/// A run of the double pendulum to `end`: the error, or the steps and the state.
fn run<R: Real>(
    model: &DoublePendulum<R>,
    start: Swing<R>,
    method: DormandPrince<R>,
    step: f64,
    end: f64,
) -> Result<(u32, Swing<R>), SimulationError> {
    let mut simulation = Simulation::new(model, start)
        .sampled(|_, _| Torque { shoulder: R::ZERO })
        .integrator(method)
        .step(R::from_f64(step));
    let mut steps = 0;
    let outcome = simulation.run_until(R::from_f64(end), |_| steps += 1);
    let (time, state) = (simulation.time().to_f64(), *simulation.state());
    match outcome {
        Ok(state) => Ok((steps - 1, state)),
        Err(error) => {
            assert!(time.is_finite() && (state == start || time > 0.0), "{time} {state:?}");
            Err(error)
        }
    }
}

#[test]
fn a_start_that_is_no_number_is_named() {
    let model = DoublePendulum::<f64>::balanced();
    let method = DormandPrince::tolerance(1e-8);
    let start = State { v: [0.0, f64::NAN], ..swung() };
    let mut simulation = Simulation::new(&model, start)
        .sampled(|_, _| Torque { shoulder: 0.0 })
        .integrator(method)
        .start_time(f64::NAN)
        .step(0.1);
    assert!(matches!(simulation.advance().unwrap_err(), SimulationError::TimeNotFinite { .. }));
    let mut simulation = simulation.start_time(0.0);
    let error = simulation.advance_until(1.0).unwrap_err();
    assert!(matches!(error, SimulationError::NonFinite { what: "lower.rate", .. }), "{error:?}");
    // By itself the method ends too.
    let mut free = Free { evaluations: 0 };
    let mut memory = method.memory::<Free>();
    for (time, v) in [(f64::NAN, f64::NAN), (0.0, f64::NAN), (f64::NAN, 1.0)] {
        let state = State::new([0.0], [v]);
        free.evaluations = 0;
        let stepped = method.step(&mut memory, &mut free, time, 0.1, &state);
        assert!(stepped.is_ok() == v.is_finite() && free.evaluations <= 602, "{stepped:?}");
    }
}

/// A point that nothing acts on, which counts its evaluations.
struct Free {
    evaluations: u32,
}

impl Variables<f64> for Free {
    fn layout(&self) -> &Layout<'_> {
        &Layout { linear: 1, rotations: 0, quaternions: 0, angles: &[] }
    }
    type Q = [f64; 1];
    type V = [f64; 1];
    type Z = ();
    type Gates = ();
    type Lambda = [f64; 0];
}

impl Dynamics<f64> for Free {
    type Variables = Self;

    fn variables(&self) -> &Self {
        self
    }

    fn derivative(&mut self, _time: f64, state: &mut State<[f64; 1], [f64; 1]>) -> Derivative<[f64; 1]> {
        self.evaluations += 1;
        Derivative { v: state.v, a: [0.0], z: () }
    }
}

#[test]
fn tolerances_below_all_rounding_are_refused() {
    for method in [DormandPrince::tolerance(1e-40), DormandPrince::tolerances(1e-300, 1e-33)] {
        let error = run(&DoublePendulum::new(), swung(), method, 0.1, 1.0).unwrap_err();
        assert!(error.to_string().contains("at least a rounding of a rounding"), "{error}");
    }
    let single = run(&DoublePendulum::new(), swung(), DormandPrince::tolerance(1e-16_f32), 0.1, 1.0);
    assert!(matches!(single, Err(SimulationError::Setting(_))), "{single:?}");
    // One of the two is enough.
    for method in [DormandPrince::tolerances(1e-300, 1e-8), DormandPrince::tolerances(1e-8, 1e-300)] {
        let (steps, _) = run(&DoublePendulum::new(), swung(), method, 0.1, 1.0).unwrap();
        assert!((20..500).contains(&steps), "{steps}");
    }
}

/// What needs more steps than anybody waits for ends after those that are allowed, and can be gone on with.
#[test]
fn the_steps_of_a_run_are_bounded() {
    let stiff = DoublePendulum { gravity: 1e30, ..DoublePendulum::new() };
    let method = DormandPrince::tolerance(1e-8).most_steps(2000);
    assert_eq!((method.steps, DormandPrince::tolerance(1e-8_f32).steps), (2000, 1_000_000));
    let error = run(&stiff, swung(), method, 0.1, 1.0).unwrap_err();
    let SimulationError::TooManySteps { time, end: 1.0, steps: 2000 } = error else { panic!("{error:?}") };
    assert!(time > 0.0 && time < 1e-9 && error.to_string().contains("`.most_steps(count)`"), "{error}");
    let error =
        run(&DoublePendulum::new(), swung(), DormandPrince::tolerance(1e-30).most_steps(500), 0.1, 1.0);
    assert!(
        matches!(error, Err(SimulationError::TooManySteps { .. } | SimulationError::StepUnderflow { .. })),
        "{error:?}"
    );

    let model = DoublePendulum::new();
    let (all, expected) = run(&model, swung(), DormandPrince::tolerance(1e-9), 0.1, 1.0).unwrap();
    let mut simulation = Simulation::new(&model, swung())
        .sampled(|_, _| Torque { shoulder: 0.0 })
        .integrator(DormandPrince::tolerance(1e-9).most_steps(20))
        .step(0.1);
    let mut calls = 0;
    let reached = loop {
        calls += 1;
        match simulation.advance_until(1.0) {
            Ok(state) => break state,
            Err(error) => {
                assert!(matches!(error, SimulationError::TooManySteps { steps: 20, .. }), "{error}")
            }
        }
    };
    assert_eq!((reached, calls), (expected, all.div_ceil(20)));
    // Steps as long as asked for are bounded by the run.
    let fixed = DormandPrince { steps: 1, ..DormandPrince::fixed() };
    assert_eq!(run(&model, swung(), fixed, 0.01, 1.0).unwrap().0, 100);
    let none = DormandPrince::tolerance(1e-8).most_steps(0);
    assert!(matches!(run(&model, swung(), none, 0.1, 1.0), Err(SimulationError::Setting(_))));
}

#[test]
fn a_least_step_can_be_set() {
    let model = DoublePendulum::new();
    for least in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let method = DormandPrince::tolerance(1e-8).least_step(least);
        assert!(
            matches!(run(&model, swung(), method, 0.1, 1.0), Err(SimulationError::Setting(_))),
            "{least}"
        );
    }
    let method = DormandPrince::tolerance(1e-12).least_step(0.02);
    let error = run(&model, swung(), method, 0.1, 1.0).unwrap_err();
    let SimulationError::StepUnderflow { step, rejections, .. } = error else { panic!("{error:?}") };
    assert!(
        step < 0.02 && rejections.error > 0 && error.to_string().contains("`.least_step(seconds)`"),
        "{error}"
    );
    // A wall is approached no nearer than that.
    let mut simulation = Simulation::new(&model, swung())
        .sampled(|time, _| Torque { shoulder: if time > 0.05 { f64::NAN } else { 0.0 } })
        .integrator(DormandPrince::tolerance(1e-8).least_step(1e-6))
        .step(0.1);
    let error = simulation.advance_until(1.0).unwrap_err();
    assert!(matches!(error, SimulationError::StepUnderflow { step, .. } if step > 2e-7), "{error:?}");
    assert!((simulation.time() - 0.05).abs() < 2e-6);
}

/// The largest step says nothing about the least: without a bound worth the name the motion is the same.
#[test]
fn the_least_step_does_not_depend_on_the_largest() {
    let model = DoublePendulum::new();
    let (steps, expected) = run(&model, swung(), DormandPrince::tolerance(1e-9), 1.0, 2.0).unwrap();
    for largest in [1e5, 1e15, 1e300, f64::MAX] {
        let method = DormandPrince::tolerance(1e-9);
        let mut simulation = Simulation::new(&model, swung())
            .sampled(|_, _| Torque { shoulder: 0.0 })
            .integrator(method)
            .step(largest);
        let first = simulation.advance().unwrap();
        assert!(first.size < 0.1 && first.rejections.total() < 5, "{first:?}");
        assert_eq!(run(&model, swung(), method, largest, 2.0).unwrap(), (steps, expected), "{largest:e}");
    }
    let single = DoublePendulum::<f32>::new();
    let (steps, expected) = run(&single, swung(), DormandPrince::tolerance(1e-5), 1.0, 2.0).unwrap();
    for largest in [1e5, 1e15, 1e38] {
        let found = run(&single, swung(), DormandPrince::tolerance(1e-5), largest, 2.0).unwrap();
        assert_eq!(found, (steps, expected), "{largest:e}");
    }
}

#[test]
fn the_least_of_largest_steps_is_a_step() {
    let model = DoublePendulum::new();
    for largest in [1e-310, f64::from_bits(1), 1e-300] {
        let mut simulation = Simulation::new(&model, swung())
            .sampled(|_, _| Torque { shoulder: 0.0 })
            .integrator(DormandPrince::tolerance(1e-8))
            .step(largest);
        match simulation.advance() {
            Ok(step) => assert!(step.size == largest && simulation.time() == largest),
            Err(error) => assert!(matches!(error, SimulationError::StepUnderflow { .. }), "{error:?}"),
        }
        let error = simulation.advance_until(1.0).unwrap_err();
        assert!(matches!(error, SimulationError::TooMany { what: "steps", .. }), "{error:?}");
    }
}

#[test]
fn samples_that_coincide_are_refused() {
    let model = DoublePendulum::new();
    let every = |interval: f64, end: f64| {
        Simulation::new(&model, swung())
            .sampled(|_, _| Torque { shoulder: 0.0 })
            .integrator(DormandPrince::tolerance(1e-8))
            .step(1e-3)
            .run_every(interval, end, |_| ())
            .unwrap_err()
    };
    let error = every(1e-17, 1.0);
    assert!(
        matches!(error, SimulationError::Setting(_)) && error.to_string().contains("samples coincide"),
        "{error}"
    );
    let error = every(1e-17, 1e-3);
    assert!(matches!(error, SimulationError::TooMany { what: "samples", .. }), "{error:?}");
    assert!(error.to_string().contains("take a nearer end, or a longer interval"), "{error}");
    let error = every(f64::from_bits(1), 1e-3);
    assert!(matches!(error, SimulationError::Setting(_)), "{error:?}");
}

/// In single precision 0.1 s is not a tenth: a sample that is due a rounding beside the end is the one at the end.
#[test]
fn the_last_sample_is_at_the_end() {
    let model = DoublePendulum::<f32>::balanced();
    for (interval, end, count) in
        [(0.1_f32, 100.0_f32, 1001), (0.01, 5.0, 501), (0.05, 2.0, 41), (0.3, 30.0, 101)]
    {
        let mut times = Vec::new();
        Simulation::new(&model, swung())
            .sampled(|_, _| Torque { shoulder: 0.0_f32 })
            .integrator(DormandPrince::tolerance(1e-4))
            .step(0.25)
            .run_every(interval, end, |sample| times.push(sample.time))
            .unwrap();
        assert_eq!((times.len(), times.last()), (count, Some(&end)), "{interval}");
        assert!(times.is_sorted_by(|a, b| a < b));
    }
}

/// Of an event that a method will not go to, the search ends.
#[test]
fn a_search_ends() {
    let model = DoublePendulum::<f64>::balanced();
    let start = State { v: [1.0, 1.0], ..swung() };
    let mut simulation = Simulation::new(&model, start)
        .sampled(|_, _| Torque { shoulder: 0.0 })
        .integrator(Hesitant)
        .step(1.0);
    let event = Event::of("upper").level(0.9).tolerance(1e-12);
    let error = simulation.run_until_event(1.0, &[event], |_| ()).unwrap_err();
    let SimulationError::EventNotLocated { time: 0.0, width, trials: 1000 } = error else {
        panic!("{error:?}")
    };
    assert!(width > 1e-12 && width < 1.0 && error.to_string().contains("larger tolerance"), "{error}");
    assert_eq!((simulation.time(), *simulation.state()), (0.0, start));
}

/// Takes a whole step, and of any other a ten-thousandth.
struct Hesitant;

impl Method<f64> for Hesitant {
    type Memory<X: Variables<f64>> = ();

    fn memory<X: Variables<f64>>(&self) {}
}

impl<D: Dynamics<f64>> Integrator<f64, D> for Hesitant {
    fn step(
        &self,
        memory: &mut (),
        dynamics: &mut D,
        time: f64,
        h: f64,
        state: &StateOf<D::Variables>,
    ) -> Result<SteppedOf<D::Variables>, StepFailure> {
        Rk4.step(memory, dynamics, time, if h < 1.0 { 1e-4 * h } else { h }, state)
    }
}
