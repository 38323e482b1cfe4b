//! Nothing that runs with a model allocates: preparing, evaluating, assembling, kinematics, projecting, simulating,
//! in double and in single precision. Counted by an allocator that counts for each thread by itself, because tests run
//! beside each other.

#[path = "runtime_fuzz/methods.rs"]
mod methods;
#[path = "runtime_fuzz/random.rs"]
mod random;

use linkwright::{
    Actuators, Ali3p, Assemble, AssembleExt, AssemblyError, AugmentedLagrangian, Baumgarte, Corrected,
    DormandPrince, Event, ExplicitTrapezoidal, Fields, Formulation, GeneralisedAlpha, ImplicitTrapezoidal,
    InputSource, Integrator, LagrangeIndex1, Linearisation, Mechanism, MechanismDynamics, Motion, NullSpace,
    Partitioned, Penalty, Projected, Reading, Real, Reduced, Rk4, SemiImplicitEuler, Simulation,
    SimulationError, State, StateOf, StepMethod, Stepper, Tangent, Vector, actuation, coordinate,
    coordinate_rates, coordinate_values, equilibrium, measured, step_map, zero_order_hold,
};
use linkwright_models::{
    bricard::Bricard, double_pendulum::DoublePendulum, four_spherical_joints::FourSphericalJoints,
    heavy_top::HeavyTop, n_four_bar::NFourBar2, slider_crank::SliderCrank,
};
use mechanisms::registry::{At, Model, for_each};
use mechanisms::zoo::Workshop;
use mechanisms::zoo_tangent::for_each_with_tangent;
use methods::{Explicit, Means, Of, Way};
use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::hint::black_box;

/// The system's allocator, with a count of what this thread asked of it.
struct Counting;

#[global_allocator]
static ALLOCATOR: Counting = Counting;

thread_local! {
    static ALLOCATIONS: Cell<usize> = const { Cell::new(0) };
}

fn count() {
    // A thread that is ending has no counter any more, and nothing to prove.
    let _ = ALLOCATIONS.try_with(|allocations| allocations.set(allocations.get() + 1));
}

// SAFETY: every call is handed to the system's allocator as it came.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        count();
        unsafe { System.alloc(layout) }
    }
    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        count();
        unsafe { System.alloc_zeroed(layout) }
    }
    unsafe fn realloc(&self, block: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        count();
        unsafe { System.realloc(block, layout, size) }
    }
    unsafe fn dealloc(&self, block: *mut u8, layout: Layout) {
        unsafe { System.dealloc(block, layout) }
    }
}

/// Allocations of this thread while `work` ran.
fn allocations(work: impl FnOnce()) -> usize {
    let before = ALLOCATIONS.get();
    work();
    ALLOCATIONS.get() - before
}

/// The control: what does allocate is counted, and a thread does not count what another does.
#[test]
fn allocations_are_counted() {
    assert_eq!(allocations(|| drop(black_box(Box::new(1)))), 1);
    assert_eq!(allocations(|| drop(black_box(vec![0_u8; 100]))), 1);
    assert_eq!(allocations(|| black_box(Vec::from([1, 2, 3])).reserve_exact(1000)), 2);
    assert_eq!(allocations(|| black_box(())), 0);
    let other = std::thread::spawn(|| allocations(|| drop(black_box(Box::new(1)))));
    let mine = allocations(|| while !other.is_finished() {});
    assert_eq!((mine, other.join().expect("the thread only allocates")), (0, 1));
}

// The runtime has no `alloc` to call: what is left are formatting and collections of `std`, which depend on kinds and not on mechanisms.
for_each!(in sample, nothing_allocates);
for_each_with_tangent!(no_derivative_allocates);

for_each!(in sample, every_way_is_sound);

/// Every formulation with every explicit integrator: steps, an event, accelerations, reactions and inverse dynamics neither allocate
/// nor panic, and give finite numbers. Chosen at run time, so that a model is compiled three times for all of them. The implicit
/// integrators, which use no formulation's accelerations, are under [`no_derivative_allocates`].
fn every_way_is_sound<M: Model>() {
    let model = M::standard();
    let start = model.start();
    let penalty = Penalty::for_model(&model, 0.0, &start.q, 1e-4);
    let baumgarte = Baumgarte { alpha: 10.0, beta: 10.0 };
    let rows = [
        Way::Index1(LagrangeIndex1),
        Way::Baumgarte(baumgarte),
        Way::Partitioned(Partitioned::default()),
        Way::ProjectedIndex1(Projected::after(LagrangeIndex1)),
        Way::ProjectedBaumgarte(Projected::after(baumgarte)),
    ];
    let velocities = [
        Way::Penalty(penalty),
        Way::Augmented(AugmentedLagrangian::new(penalty)),
        Way::ProjectedPenalty(Projected::after(penalty)),
    ];
    for means in [Means::Rk4, Means::SemiImplicitEuler, Means::ExplicitTrapezoidal, Means::adaptive(1e-6)] {
        for way in rows {
            sound::<M, 0>(&model, Of(way), means);
        }
        for way in velocities {
            sound::<M, 1>(&model, Of(way), means);
        }
        for way in [Way::NullSpace(NullSpace), Way::ProjectedNullSpace(Projected::after(NullSpace))] {
            sound::<M, 2>(&model, Of(way), means);
        }
    }
}

fn sound<M: Model, const PIVOT: u8>(model: &M, way: Of<PIVOT>, means: Means) {
    let start = model.start();
    let mut outcome = Ok(true);
    // Rods that vibrate along their axis leave the constraints in longer steps.
    let step = if ["FlexibleSliderCrank", "Stiffened"].contains(&model.name()) { 1e-6 } else { 1e-4 };
    let allocated = allocations(|| {
        let simulation = Simulation::new(model, start).formulation(way).input_source(Still);
        let mut simulation = simulation.integrator(Explicit(means)).step(step).step_over_breakdowns();
        outcome = (|| {
            for _ in 0..2 {
                simulation.advance()?;
            }
            if let Some(&output) = M::Outputs::NAMES.first() {
                simulation.run_until_event(4.0 * step, &[Event::of(output)], |_| ())?;
            }
            let (a, lambda) = (simulation.acceleration()?, simulation.multipliers()?);
            let State { q, v, z, gates } = *simulation.state();
            let at = At {
                time: simulation.time(),
                q,
                v,
                z,
                gates,
                u: M::Inputs::from_array(Vector::zeros(M::Inputs::NAMES.len())),
            };
            let moving = q.first_not_finite().is_none() && v.first_not_finite().is_none();
            Ok::<_, SimulationError>(moving && model.derived_finite(&at, &a, &lambda))
        })();
    });
    assert_eq!(allocated, 0, "{}: {way:?}, {means:?}", model.name());
    assert_eq!(outcome, Ok(true), "{}: {way:?}, {means:?}", model.name());
}

fn no_derivative_allocates<M: Model<Single: Tangent<f32>> + Tangent<f64>>() {
    nothing_allocates::<M>();
    linearisations(&M::standard());
    linearisations(&M::single());
    implicit(&M::standard());
    implicit(&M::single());
}

fn implicit<R: Real, M: Tangent<R>>(model: &M) {
    steps(model, "generalised-alpha", LagrangeIndex1, GeneralisedAlpha::new(R::from_f64(0.8)));
    steps(model, "implicit trapezoidal", LagrangeIndex1, ImplicitTrapezoidal::<R>::default());
    steps(model, "ALI3-P", LagrangeIndex1, Ali3p::new(R::from_f64(1e8)));
}

fn linearisations<R: Real, M: Tangent<R>>(model: &M) {
    let start = model.start();
    let (t, u) = (R::ZERO, M::Inputs::from_array(Vector::zeros(M::Inputs::NAMES.len())));
    assert!(Linearisation::at(model, t, &start, &u).is_ok(), "{}", model.name());
    let derived = allocations(|| {
        let Ok(here) = Linearisation::at(model, t, &start, &u) else { return };
        black_box((here.by_position(0), here.by_velocity(0), here.by_input(0)));
        black_box(here.by_parameters().column(0));
        black_box(here.state_space().is_ok());
        black_box(here.output_matrices().is_ok());
        if let Ok(space) = here.state_space() {
            black_box(zero_order_hold(&space.a, &space.b, R::from_f64(1e-3)).is_ok());
        }
        black_box(step_map(model, &Rk4, (t, &start), &u, R::from_f64(1e-3)).is_ok());
        black_box(equilibrium(model, t, &start.q, &u).is_ok());
        black_box(actuation(model, t, &start, here.acceleration(), &u, M::Inputs::NAMES).is_ok());
        black_box(actuation(model, t, &start, here.acceleration(), &u, &["none such"]).is_ok());
    });
    assert_eq!(derived, 0, "{}: linearise", model.name());
}

/// The inputs that drive a mechanism, its equations in independent coordinates, and states that were measured.
#[test]
fn no_control_allocates() {
    let model = SliderCrank::<f64>::default();
    let (start, none) = (model.start(), <SliderCrank as Mechanism<f64>>::Inputs::from_array([0.0; 2]));
    let found = allocations(|| {
        let Ok(reduced) = Reduced::at(&model, 0.0, &start, &none) else { return };
        let Ok(actuators) = Actuators::named(&model, ["torque", "gas"]) else { return };
        let a = reduced.acceleration(&[3.0]);
        assert!(actuators.inputs_for(&model, (0.0, &start), &a, &none).is_ok());
        assert!(actuators.inputs_for(&model, (0.0, &start), &a.map(|x| x + 1.0), &none).is_err());
        let Ok(main) = coordinate(&model, "main.angle") else { return };
        let position = coordinate_values(&model, 0.0, &start.q).as_slice()[usize::from(main)];
        let rate = coordinate_rates(&model, 0.0, &start.q, &start.v).as_slice()[usize::from(main)];
        assert!(measured(&model, 0.0, &start, &[Reading { coordinate: main, position, rate }]).is_ok());
    });
    assert_eq!(found, 0);
}

fn nothing_allocates<M: Model>() {
    let model = M::standard();
    let parameters = M::standard().parameter_values();
    let prepared = allocations(|| {
        black_box(M::prepared(&parameters).is_ok());
    });
    assert_eq!(prepared, 0, "{}: prepare", model.name());
    evaluations(&M::standard());
    simulations(&M::standard());
    steppers(&M::standard());
}

for_each!(in sample, nothing_allocates_in_single_precision);

fn nothing_allocates_in_single_precision<M: Model>() {
    evaluations(&M::single());
    simulations(&M::single());
}

/// The methods of a stepper, and all that it does beside steps.
fn steppers<M: Model>(model: &M) {
    fn stepped<M: Model, S: StepMethod<f64, M>>(model: &M, method: S) {
        let mut plant = Stepper::new(M::standard(), model.start(), method);
        let inputs = M::Inputs::from_array(Vector::zeros(M::Inputs::NAMES.len()));
        let found = allocations(|| {
            if !model.takes_whole_steps() {
                assert!(plant.step(&inputs, 1e-4).is_err());
                return;
            }
            assert!(plant.step(&inputs, 1e-4).is_ok());
            assert!(plant.substeps(&inputs, 1e-4, 2).is_ok());
            let saved = plant.save();
            assert!(plant.restore(&saved).is_ok() && plant.set_state(0.0, model.start()).is_ok());
            black_box((
                plant.outputs(&inputs),
                plant.near_singular(),
                plant.energy(),
                plant.assemble().is_ok(),
            ));
        });
        assert_eq!(found, 0, "{}: stepper", model.name());
    }
    stepped(model, Rk4);
    stepped(model, (ExplicitTrapezoidal, NullSpace));
    stepped(model, (SemiImplicitEuler, Corrected::after(LagrangeIndex1)));
}

/// Every formulation and integrator, on loops with and without a factorisation of their own, with massless bodies, in space.
#[test]
fn formulations_and_integrators_do_not_allocate() {
    formulations(&NFourBar2::<f64>::default());
    formulations(&NFourBar2::<f32>::default());
    formulations(&Workshop::<f64>::default());
    formulations(&Workshop::<f32>::default());
    formulations(&Bricard::<f64>::default());
    formulations(&FourSphericalJoints::<f64>::default());
    formulations(&FourSphericalJoints::<f32>::default());
}

fn formulations<R: Real, M>(model: &M)
where
    M: Assemble<R, Inputs: Fields<R>>,
{
    let h = R::from_f64(1e-3);
    let penalty = Penalty::for_model(model, R::ZERO, &model.start_q(), h);
    let iterated = AugmentedLagrangian::new(penalty);
    steps(model, "index 1", LagrangeIndex1, Rk4);
    steps(model, "penalty", penalty, Rk4);
    steps(model, "augmented Lagrangian", iterated, ExplicitTrapezoidal);
    steps(model, "index 1, projected", Projected::after(LagrangeIndex1), ExplicitTrapezoidal);
    steps(model, "null space", NullSpace, Rk4);
    steps(model, "partitioned", Partitioned::default(), SemiImplicitEuler);
}

/// Steps that succeed, and one that does not.
fn steps<R, M, F, I>(model: &M, name: &str, formulation: F, integrator: I)
where
    R: Real,
    M: Assemble<R, Inputs: Fields<R>>,
    F: Formulation<R, M> + Copy,
    I: for<'m> Integrator<R, MechanismDynamics<'m, M, R, F, Still>> + Copy,
{
    let h = R::from_f64(1e-3);
    let (mut taken, mut refused) = (0, false);
    let stepped = allocations(|| {
        let start = model.start();
        let simulation = Simulation::new(model, start).input_source(Still).formulation(formulation);
        let mut simulation = simulation.integrator(integrator).step(h).step_over_breakdowns();
        for _ in 0..3 {
            taken += u32::from(black_box(simulation.advance()).is_ok());
        }
        black_box((simulation.near_singular(), simulation.multipliers().is_ok()));
        let mut broken = model.start();
        broken.v.as_mut_slice().fill(R::from_f64(f64::NAN));
        let simulation = Simulation::new(model, broken).input_source(Still).formulation(formulation);
        let mut simulation = simulation.integrator(integrator).step(h).accept_inconsistent_start();
        refused = black_box(simulation.advance()).is_err();
    });
    // What follows from reactions is rounded to more than an implicit method asks for in single precision, at some positions of some mechanisms.
    let is_implicit = ["generalised-alpha", "implicit trapezoidal", "ALI3-P"].contains(&name);
    let may_refuse = size_of::<R>() == 4 && is_implicit;
    assert_eq!((stepped, refused), (0, true), "{}: {name}", model.name());
    assert!(taken == 3 || may_refuse, "{}: {name}: {taken} steps", model.name());
}

/// No inputs, or zeros.
#[derive(Clone, Copy)]
struct Still;

impl<R: Real, M: Mechanism<R, Inputs: Fields<R>>> InputSource<R, M> for Still {
    const HELD: bool = true;

    fn sample(&mut self, _time: R, _state: &StateOf<M, R>) -> M::Inputs {
        M::Inputs::from_array(Vector::zeros(M::Inputs::NAMES.len()))
    }
}

/// Steps of the method's choice, samples and states between them, events, and their errors, on a tree, a loop, a body in
/// space and a mechanism with inputs.
#[test]
fn adaptive_runs_and_events_do_not_allocate() {
    adaptive_runs(&DoublePendulum::<f64>::default());
    adaptive_runs(&DoublePendulum::<f32>::default());
    adaptive_runs(&FourSphericalJoints::<f64>::default());
    adaptive_runs(&FourSphericalJoints::<f32>::default());
    adaptive_runs(&HeavyTop::<f64>::default());
    adaptive_runs(&HeavyTop::<f32>::default());
    adaptive_runs(&SliderCrank::<f64>::default());
    adaptive_runs(&SliderCrank::<f32>::default());
}

fn adaptive_runs<R: Real, M>(model: &M)
where
    M: Assemble<R, Inputs: Fields<R>, Outputs: Fields<R>>,
{
    let start = model.start();
    let output = M::Outputs::NAMES[0];
    let (h, end) = (R::from_f64(0.01), R::from_f64(0.1));
    let mut happened = 0;
    let ran = allocations(|| {
        let ones = |_: R, _: &StateOf<M, R>| {
            let mut values = <M::Inputs as Fields<R>>::Array::zeros(M::Inputs::NAMES.len());
            values.as_mut_slice().fill(R::ONE);
            M::Inputs::from_array(values)
        };
        let method = DormandPrince::tolerance(R::from_f64(1e-4));
        let mut simulation = Simulation::new(model, start).sampled(ones).integrator(method).step(h);
        let mut count = 0;
        let run = simulation.run_every(R::from_f64(0.03), end, |sample| {
            black_box(sample.energy());
            count += 1;
        });
        assert!(run.is_ok() && count == 4, "{}: {:?}", model.name(), run.err());
        black_box(simulation.interpolate(end - R::from_f64(1e-4)).is_ok());
        // A level between its values at two times is crossed.
        let value = |simulation: &mut Simulation<'_, M, R, _, _, _>| {
            simulation.sample().outputs.to_array().as_slice()[0]
        };
        let begun = value(&mut simulation);
        let mut further = Simulation::new(model, simulation.state().clone())
            .sampled(ones)
            .integrator(method)
            .step(h)
            .start_time(end)
            .accept_inconsistent_start()
            .unwrap_from(simulation.sample().outputs);
        assert!(further.advance_until(end + h).is_ok());
        let level = (begun + value(&mut further)) * R::from_f64(0.5);
        let event = Event::of(output).level(level).tolerance(R::from_f64(1e-5));
        let found = simulation.run_until_event(end + h, &[event], |sample| _ = black_box(sample.energy()));
        happened += usize::from(matches!(found, Ok(Some(_))));
        let wrong = simulation.run_until_event(end + h, &[Event::of("no such output")], |_| ());
        assert!(wrong.is_err());
        assert!(simulation.advance_for(h).is_ok() && simulation.advance_steps(2).is_ok());
    });
    assert_eq!((ran, happened), (0, 1), "{}: run adaptively", model.name());
}

fn evaluations<R: Real, M>(model: &M)
where
    M: Assemble<R, Inputs: Fields<R>>,
{
    let start = model.start();
    let State { q, v, .. } = &start;
    let (t, u) = (R::ZERO, M::Inputs::from_array(Vector::zeros(M::Inputs::NAMES.len())));
    let (mut mass, mut jacobian) = (model.zero_mass(), model.zero_jacobian());
    let (mut a, mut lambda) = (model.zero_v(), model.zero_lambda());
    let evaluated = allocations(|| {
        model.mass_matrix(t, q, &mut mass);
        model.constraints(t, q, &mut lambda);
        model.constraint_jacobian(t, q, &mut jacobian);
        model.nu(t, q, &mut lambda);
        model.gamma(t, q, v, &mut lambda);
        model.forces(t, &start, &u, &mut a);
        black_box((model.kinetic_energy(t, q, v), model.potential_energy(t, &start)));
        black_box(model.acceleration(t, &start, &u, &mut a, &mut lambda));
        black_box(model.acceleration_baumgarte(t, &start, &u, R::ONE, R::ONE, &mut a, &mut lambda));
        let mut outputs = model.outputs(t, &start, &u);
        let previous = outputs.clone();
        model.unwrap(&mut outputs, &previous);
        black_box(outputs);
    });
    assert_eq!(evaluated, 0, "{}: evaluate", model.name());

    // The ways that succeed are those that are counted.
    let ways = [model.assemble(&start).err(), model.project(t, &start).err()];
    for error in ways.into_iter().flatten() {
        // Masses a million times apart are more than single precision can weigh against each other, and it says so.
        let double = f64::EPSILON.sqrt();
        let is_too_fine = matches!(error, AssemblyError::RankDeficient { pivot, .. } if pivot > double && pivot < R::EPSILON.to_f64().sqrt());
        assert!(is_too_fine, "{}: {error:?}", model.name());
    }
    // Errors, too, are made without allocating.
    let assembled = allocations(|| {
        black_box(model.assemble(&start).is_ok());
        black_box(model.project(t, &start).is_ok());
        let still = Motion { position: R::ZERO, rate: R::ZERO, acceleration: R::ZERO };
        let given = [still; 64];
        black_box(model.kinematics(t, q, &given[..model.independent().len().min(64)]).is_ok());
        black_box(model.kinematics(t, q, &[]).is_ok());
    });
    assert_eq!(assembled, 0, "{}: assemble", model.name());
}

fn simulations<R: Real, M>(model: &M)
where
    M: Assemble<R, Inputs: Fields<R>>,
{
    let start = model.start();
    let baumgarte = Baumgarte { alpha: R::from_f64(10.0), beta: R::from_f64(10.0) };
    let (h, end) = (R::from_f64(1e-4), R::from_f64(5e-4));
    let none = |_: R, _: &StateOf<M, R>| M::Inputs::from_array(Vector::zeros(M::Inputs::NAMES.len()));
    let first = Simulation::new(model, start.clone()).formulation(baumgarte).sampled(none).step(h).advance();
    assert!(first.is_ok(), "{}: {:?}", model.name(), first.err());
    let simulated = allocations(|| {
        let none = |_: R, _: &StateOf<M, R>| M::Inputs::from_array(Vector::zeros(M::Inputs::NAMES.len()));
        let mut simulation =
            Simulation::new(model, start.clone()).formulation(baumgarte).sampled(none).step(h);
        black_box(simulation.advance().is_ok());
        black_box(simulation.run_until(end, |sample| _ = black_box(sample.energy())).is_ok());
        black_box((simulation.energy(), simulation.constraint_residual(), simulation.multipliers().is_ok()));
        let mut simulation = simulation.integrator(SemiImplicitEuler).held(none);
        black_box(simulation.advance().is_ok());
        black_box(simulation.samples(end + end).filter(|sample| sample.is_ok()).count());
    });
    assert_eq!(simulated, 0, "{}: simulate", model.name());
}
