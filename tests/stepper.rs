//! Steppers: every model moves as under a simulation, keeps its constraints, goes on from what was saved, and refuses what makes no
//! sense without losing its state.

use linkwright::{
    AssembleExt, Baumgarte, Corrected, ExplicitTrapezoidal, Fields, FixedStep, Formulation, Integrator,
    LagrangeIndex1, Mechanism, MechanismDynamics, NullSpace, Projected, Rk4, SemiImplicitEuler, Simulation,
    State, StateOf, StepError, StepMethod, Stepper, Vector, mechanism,
};
use linkwright_models::four_bar::FourBar;
use linkwright_models::general_four_bar::ParametricFourBar;
use linkwright_models::slider_crank::{SliderCrank, SliderCrankInputs};
use mechanisms::registry::{Model, for_each};
use std::sync::Mutex;

const STEPS: usize = 12;
const H: f64 = 1e-4;

fn no_inputs<M: Model>(model: &M) -> M::Inputs {
    M::Inputs::from_array(Vector::zeros(model.input_names().len()))
}

for_each!(it_moves_as_a_simulation);

fn it_moves_as_a_simulation<M: Model>() {
    let (model, inputs) = (M::standard(), no_inputs(&M::standard()));
    if !model.takes_whole_steps() {
        let mut plant = Stepper::new(M::standard(), model.start(), Rk4);
        assert_eq!(plant.step(&inputs, H), Err(StepError::HeldGates), "{}", model.name());
        assert!(*plant.state() == model.start() && plant.time() == 0.0);
        return;
    }
    as_simulated::<M, _, _>(Rk4, Baumgarte { alpha: 30.0, beta: 40.0 });
}

for_each!(in zoo, every_method_moves_as_a_simulation);

fn every_method_moves_as_a_simulation<M: Model>() {
    if !M::standard().takes_whole_steps() {
        return;
    }
    as_simulated::<M, _, _>(SemiImplicitEuler, LagrangeIndex1);
    as_simulated::<M, _, _>(ExplicitTrapezoidal, NullSpace);
    as_simulated::<M, _, _>(Rk4, Projected::after(LagrangeIndex1));
}

/// To the bit, as long as the simulation goes.
fn as_simulated<M: Model, I, F>(integrator: I, formulation: F)
where
    F: Formulation<f64, M> + Copy,
    I: FixedStep<f64> + Copy,
    for<'m> I: Integrator<
            f64,
            MechanismDynamics<
                'm,
                M,
                f64,
                F,
                linkwright::input::HeldOrSampled<
                    linkwright::input::OnceAStep,
                    fn(f64, &StateOf<M>) -> M::Inputs,
                >,
            >,
        >,
{
    let model = M::standard();
    let inputs = no_inputs(&model);
    let mut plant = Stepper::new(M::standard(), model.start(), (integrator, formulation));
    let held: fn(f64, &StateOf<M>) -> M::Inputs =
        |_, _| M::Inputs::from_array(Vector::zeros(M::Inputs::NAMES.len()));
    let simulation = Simulation::new(&model, model.start()).formulation(formulation).integrator(integrator);
    let mut simulation = simulation.held(held).step(H).accept_inconsistent_start();
    for _ in 0..STEPS {
        let Ok(step) = simulation.advance() else { return };
        let tick = plant.step(&inputs, H).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!((tick.time, tick.moved), (step.time, step.moved));
        let (found, expected) = (plant.state(), simulation.state());
        assert!(
            found.q == expected.q && found.v == expected.v && found.z == expected.z,
            "{found:?} {expected:?}"
        );
    }
}

for_each!(constraints_are_kept);

/// One step of Newton's iteration leaves the square of what a step brings.
fn constraints_are_kept<M: Model>() {
    let model = M::standard();
    if !model.takes_whole_steps() {
        return;
    }
    let inputs = no_inputs(&model);
    let mut plant = Stepper::new(M::standard(), model.start(), (Rk4, Corrected::after(LagrangeIndex1)));
    let mut alone = Stepper::new(M::standard(), model.start(), Rk4);
    // Teeth of steel between grams vibrate at 55 kHz, and rods along their axis.
    let is_stiff =
        ["FlexibleSliderCrank", "PlanetaryStage", "PlanetaryStageHeld", "PrincetonBeam", "Stiffened"];
    let h = if is_stiff.contains(&model.name()) { 1e-2 * H } else { H };
    for _ in 0..STEPS {
        plant.step(&inputs, h).unwrap_or_else(|error| panic!("{error}"));
        alone.step(&inputs, h).unwrap_or_else(|error| panic!("{error}"));
    }
    let size = 1.0 + plant.state().q.max_abs();
    let residual = plant.constraint_residual();
    assert!(residual.position < 1e-11 * size * size, "{residual:?}");
    assert!(residual.velocity < 1e-9 * size * (1.0 + plant.state().v.max_abs()), "{residual:?}");
    let residual = alone.constraint_residual();
    assert!(residual.position < 1e-7 * size * size, "{residual:?}");
}

for_each!(in sample, it_goes_on_from_what_was_saved);

fn it_goes_on_from_what_was_saved<M: Model>() {
    let model = M::standard();
    if !model.takes_whole_steps() {
        return;
    }
    let inputs = no_inputs(&model);
    let mut plant = Stepper::new(M::standard(), model.start(), Rk4);
    plant.step(&inputs, H).unwrap();
    let saved = plant.save();
    for _ in 0..3 {
        plant.step(&inputs, H).unwrap();
    }
    let mut other = Stepper::new(M::standard(), model.start(), Rk4);
    other.restore(&saved).unwrap();
    for _ in 0..3 {
        other.step(&inputs, H).unwrap();
    }
    assert_eq!(plant.time(), other.time());
    assert!(plant.state().q == other.state().q && plant.state().v == other.state().v);

    // What is damaged or foreign is refused, and nothing has changed.
    let before = other.save();
    let foreign = linkwright::Saved { fingerprint: saved.fingerprint ^ 1, ..saved };
    assert_eq!(other.restore(&foreign), Err(StepError::OtherModel));
    let newer = linkwright::Saved { version: 99, ..saved };
    assert_eq!(other.restore(&newer), Err(StepError::OtherModel));
    let mut damaged = saved;
    damaged.q.as_mut_slice()[0] = f64::NAN;
    assert_eq!(other.restore(&damaged), Err(StepError::State));
    let undated = linkwright::Saved { time: [1.0, 1.0, 0.0], ..saved };
    assert_eq!(other.restore(&undated), Err(StepError::State));
    assert_eq!(other.save(), before);
}

for_each!(in sample, nothing_that_makes_no_sense_is_taken);

fn nothing_that_makes_no_sense_is_taken<M: Model>() {
    let model = M::standard();
    if !model.takes_whole_steps() {
        return;
    }
    let inputs = no_inputs(&model);
    let mut plant = Stepper::new(M::standard(), model.start(), Rk4);
    plant.step(&inputs, H).unwrap();
    let before = plant.save();
    for h in [0.0, -1e-3, f64::NAN, f64::INFINITY, -f64::INFINITY, 1e-300] {
        assert_eq!(plant.step(&inputs, h).map(|tick| tick.time), Err(StepError::StepSize), "{h}");
    }
    assert_eq!(plant.substeps(&inputs, H, 0), Err(StepError::StepSize));
    for index in 0..model.input_names().len() {
        for wrong in [f64::NAN, f64::INFINITY] {
            let mut values = inputs.to_array();
            values.as_mut_slice()[index] = wrong;
            assert_eq!(plant.step(&M::Inputs::from_array(values), H), Err(StepError::Input));
        }
    }
    for index in 0..model.position_names().len() {
        let mut state = model.start();
        state.q.as_mut_slice()[index] = f64::NAN;
        assert_eq!(plant.set_state(0.0, state), Err(StepError::State));
    }
    let mut state = model.start();
    state.v.as_mut_slice()[0] = f64::INFINITY;
    assert_eq!(plant.set_state(0.0, state), Err(StepError::State));
    assert_eq!(plant.set_state(f64::NAN, model.start()), Err(StepError::State));
    assert_eq!(plant.save(), before);
    // A step that may end nowhere.
    let far = plant.step(&inputs, 1e30);
    assert!(far.is_ok() || plant.save() == before);
    plant.restore(&before).unwrap();
    assert!(plant.step(&inputs, H).is_ok());
}

/// Plain data: it can stand in a `static`, and be sent.
static PLANT: Mutex<Option<Stepper<FourBar, (Rk4, NullSpace)>>> = Mutex::new(None);

#[test]
fn it_stands_in_a_static() {
    fn plain<T: Send + Sync + Clone + 'static>(_: &T) {}
    let model = FourBar::default();
    let plant = model.stepper(model.start(), (Rk4, NullSpace));
    plain(&plant);
    *PLANT.lock().unwrap() = Some(plant);
    let moved = std::thread::spawn(|| {
        let mut plant = PLANT.lock().unwrap();
        let plant = plant.as_mut().expect("it was put there");
        for _ in 0..100 {
            plant.step(&(), 1e-3).unwrap();
        }
        plant.time()
    });
    assert!((moved.join().unwrap() - 0.1).abs() < 1e-15);
}

#[test]
fn parameters_change_while_it_runs() {
    let model = ParametricFourBar::default();
    let mut plant = model.stepper(model.start(), Rk4);
    plant.step(&(), 1e-3).unwrap();
    let kept = *plant.model().parameters();
    let mut wrong = kept;
    wrong.crank_length = 20.0;
    let error = plant.set_parameters(wrong).unwrap_err();
    assert_eq!(error.what, "crank_length");
    assert_eq!(*plant.model().parameters(), kept);

    let mut longer = kept;
    longer.crank_length *= 1.001;
    plant.set_parameters(longer).unwrap();
    let off = plant.constraint_residual().position;
    assert!(off > 1e-4, "{off}");
    // The correction brings it back without a word.
    let mut steps = plant.clone();
    for _ in 0..300 {
        steps.step(&(), 1e-3).unwrap();
    }
    let left = steps.constraint_residual().position;
    assert!(left < 1e-4 * off, "{left} of {off}");
    // Or at once.
    plant.assemble().unwrap();
    assert!(plant.constraint_residual().position < 1e-12);
}

#[test]
fn a_step_off_the_constraints_is_named() {
    let model = ParametricFourBar::default();
    let mut plant = model.stepper(model.start(), Rk4);
    let mut other = *plant.model().parameters();
    other.coupler_length *= 1.5;
    plant.set_parameters(other).unwrap();
    let before = plant.save();
    assert_eq!(plant.step(&(), 1e-3), Err(StepError::Diverged));
    assert_eq!(plant.save(), before);
    // Too coarse for the motion.
    let model = FourBar::default();
    let mut plant = model.stepper(model.start(), (Rk4, LagrangeIndex1));
    let failed = (0..200).find_map(|_| plant.step(&(), 0.4).err());
    assert_eq!(failed, Some(StepError::Diverged));
}

#[test]
fn substeps_are_steps() {
    let model = FourBar::default();
    let mut one = model.stepper(model.start(), Rk4);
    let mut many = one.clone();
    let tick = many.substeps(&(), 4e-3, 4).unwrap();
    let mut least = f64::INFINITY;
    for _ in 0..4 {
        least = least.min(one.step(&(), 1e-3).unwrap().pivot);
    }
    assert_eq!(one.state(), many.state());
    assert_eq!((tick.time, tick.pivot), (one.time(), least));
}

#[test]
fn outputs_continue_and_energy_stays() {
    let model = SliderCrank::<f64>::default();
    let mut plant = model.stepper(model.start(), (Rk4, Corrected::after(LagrangeIndex1)));
    let inputs = SliderCrankInputs::from_array(Vector::zeros(model.input_names().len()));
    let (energy, mut last) = (plant.energy(), plant.outputs(&inputs).to_array());
    for _ in 0..2000 {
        plant.step(&inputs, 1e-3).unwrap();
        let now = plant.outputs(&inputs).to_array();
        for (now, last) in now.iter().zip(&last) {
            assert!((now - last).abs() < 1.0, "{now} {last}");
        }
        last = now;
    }
    assert!((plant.energy() - energy).abs() < 1e-4 * (1.0 + energy.abs()), "{energy} {}", plant.energy());
}

mechanism! {
    /// Two rods of one length that can fold into each other: at the folded position the constraints lose rank.
    planar Folding {
        rod crank { mass [kg] = 1; length [m] = 1; }
        rod coupler { mass [kg] = 1; length [m] = 1; }
        rod rocker { mass [kg] = 1; length [m] = 1; }
        joint a: revolute(ground(0, 0) [m], crank.start);
        joint b: revolute(ground(1, 0) [m], rocker.start);
        joint c: revolute(crank.end, coupler.start);
        joint d: revolute(coupler.end, rocker.end);
        start { a.angle [deg] = 20; a.rate [rad/s] = -1; b.angle [deg] ~ 20; coupler.angle [deg] ~ 0; }
    }
}

/// A parallelogram that passes the line, where it could become an antiparallelogram.
#[test]
fn a_singular_position_is_passed_and_named() {
    let model = Folding::<f64>::default();
    let mut plant = model.stepper(model.start(), (Rk4, Projected::after(LagrangeIndex1)));
    assert_eq!(plant.near_singular(), None);
    // Stops exactly on it.
    let mut flat = model.start();
    flat.q = [1.0, 0.0, 1.0, 0.0, 1.0, 0.0];
    flat.v = [-1.0, -1.0, 0.0];
    plant.set_state(0.0, flat).unwrap();
    let near = plant.near_singular().expect("the rods are in line");
    assert_eq!(near.row.of, "d");
    assert_eq!(plant.accelerations(&(), 1e-3), Err(StepError::Breakdown));
    let tick = plant.step(&(), 1e-3).unwrap();
    assert!(tick.stepped_over > 0 && tick.pivot == 0.0, "{tick:?}");
    for _ in 0..200 {
        plant.step(&(), 1e-3).unwrap();
    }
    assert_eq!(plant.near_singular(), None);
    // The parallelogram stays one.
    let State { q, .. } = plant.state();
    assert!((q[0] - q[2]).abs() < 1e-6 && (q[4] - 1.0).abs() < 1e-6, "{q:?}");
}

#[test]
fn errors_have_codes_and_texts() {
    let all = [
        StepError::StepSize,
        StepError::Input,
        StepError::State,
        StepError::NotFinite,
        StepError::Breakdown,
        StepError::Diverged,
        StepError::OtherModel,
        StepError::HeldGates,
    ];
    for (index, error) in all.into_iter().enumerate() {
        assert_eq!(usize::from(error.code()), index + 1);
        assert_eq!(error.to_string(), error.text());
        assert!(error.text().len() > 20);
    }
}

/// A method can be named in generic code.
#[test]
fn methods_are_types() {
    fn after<S: StepMethod<f64, FourBar>>(method: S) -> f64 {
        let model = FourBar::default();
        let mut plant = model.stepper(model.start(), method);
        for _ in 0..1000 {
            plant.step(&(), 1e-3).unwrap();
        }
        plant.energy()
    }
    let energies = [
        after(Rk4),
        after((Rk4, NullSpace)),
        after((Rk4, Corrected::after(LagrangeIndex1))),
        after((Rk4, Baumgarte::time_constant(0.05))),
    ];
    for energy in energies {
        assert!((energy - energies[0]).abs() < 1e-7, "{energies:?}");
    }
    assert!((after(ExplicitTrapezoidal) - energies[0]).abs() < 1e-3);
    assert!((after(SemiImplicitEuler) - energies[0]).abs() < 0.1);
}
