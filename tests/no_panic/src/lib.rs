//! Everything that a machine's firmware can ask of a mechanism, for an image in which nothing may panic.
//!
//! Errors are told by a number and never written, because the standard library's formatting has panics of its own. The models are
//! small: loops of the plane and of space, with inputs and without, a tree without constraints.
#![no_std]

use linkwright::{
    Actuators, Ali3p, Assemble, AssembleExt, AugmentedLagrangian, Baumgarte, Corrected, DormandPrince, Event,
    ExplicitTrapezoidal, Fields, Formulation, GeneralisedAlpha, ImplicitTrapezoidal, InputSource, Integrator,
    LagrangeIndex1, Linearisation, Mechanism, MechanismDynamics, Motion, NullSpace, Parametric, Partitioned,
    Penalty, Projected, Reading, Reduced, Rk4, SemiImplicitEuler, Simulation, StateOf, StepMethod, Tangent,
    Vector, actuation, coordinate, coordinate_rates, coordinate_values, equilibrium, measured, mechanism,
    step_map, zero_order_hold,
};

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}

mechanism! {
    planar SliderCrank {
        const R [mm] = 40;
        const L [mm] = 140;
        input torque [N*m];
        input gas [N];
        body crank  { mass [kg] = 1.2; inertia [kg*m^2] = 2.5e-3; point pin [m] = (R, 0); }
        body rod    { mass [kg] = 0.55; inertia [kg*m^2] = 1.6e-3; center [mm] = (40, 0); point eye [m] = (L, 0); }
        body piston { mass [kg] = 0.4; inertia [kg*m^2] = 2e-4; }
        joint main:   revolute(ground(0, 0) [m], crank.origin);
        joint big:    revolute(crank.pin, rod.origin);
        joint wrist:  revolute(rod.eye, piston.center);
        joint bore:   prismatic(ground(0, 0) [m], piston.center, axis = (1, 0));
        table friction(rate [rpm]) [N*m] = [(-2000, 0.8), (-100, 0.3), (0, 0), (100, -0.3), (2000, -0.8)];
        table pressure(angle [deg]) [N] = [(0, 900), (20, 1200), (90, 300), (300, 10), (360, 900)], periodic;
        table share(rate [rpm], load [N]) = grid((0, 1000), (-10, 0, 500), [(1, 1), (1, 0.9), (0.8, 0.7)]);
        #[allow(outside_table)]
        force drive: torque(main) = torque + friction(main.rate)*share(main.rate, gas);
        force load:  force(piston.center, direction = (-1, 0)) = gas + pressure(main.angle);
        start  { main.angle [deg] = 30; main.rate [rpm] = 1200; bore.travel [mm] ~ 170; }
        options { emit = (tangent, penalty, projection, null_space); }
        output angle [rad] = main.angle;
    }
}

mechanism! {
    spatial Rods {
        gravity [m/s^2] = (0, 0, -9.81);
        body crank  { mass [kg] = 0.12; inertia [kg*m^2] = (1e-4, 1e-4, 1e-5); point pin [m] = (0, 0, 0.08); }
        body slider { mass [kg] = 2; inertia [kg*m^2] = (1e-4, 1e-4, 1e-4); }
        joint bearing: revolute(ground(0, 0.1, 0.12) [m], crank.origin, axis = (1, 0, 0));
        joint rod:     distance(crank.pin, slider.center, length = 0.3 [m]);
        joint rail:    prismatic(ground(0, 0, 0) [m], slider.center, axis = (1, 0, 0));
        start  { bearing.angle [rad] = 0; bearing.rate [rad/s] = 6; rail.travel [m] ~ 0.2; }
        options { emit = (tangent); }
        output stroke [m] = rail.travel;
    }
}

mechanism! {
    spatial Top {
        gravity [m/s^2] = (0, 0, -9.81);
        body top { mass [kg] = 1; inertia [kg*m^2] = (2e-3, 2e-3, 1e-3); center [m] = (0, 0, 0.1); }
        joint tip: spherical(ground(0, 0, 0) [m], top.origin);
        options { emit = (tangent); }
        output height [m] = top.center.z;
    }
}

/// Zeros, whatever the inputs.
struct Still;

impl<M: Mechanism<f64, Inputs: Fields<f64>>> InputSource<f64, M> for Still {
    const HELD: bool = false;

    fn sample(&mut self, _: f64, _: &StateOf<M>) -> M::Inputs {
        M::Inputs::from_array(Vector::zeros(M::Inputs::NAMES.len()))
    }
}

/// Steps, runs, samples, events, under one pair of methods.
fn moves<M, F, I>(model: &M, start: &StateOf<M>, formulation: F, integrator: I, h: f64) -> u32
where
    M: Assemble<f64, Inputs: Fields<f64>, Outputs: Fields<f64>>,
    F: Formulation<f64, M>,
    I: for<'m> Integrator<f64, MechanismDynamics<'m, M, f64, F, Still>>,
{
    let simulation = Simulation::new(model, start.clone()).input_source(Still).formulation(formulation);
    let mut simulation = simulation.integrator(integrator).step(h).step_over_breakdowns();
    let mut good = u32::from(simulation.advance().is_ok());
    good += u32::from(simulation.advance_until(10.0 * h).is_ok());
    good += u32::from(simulation.run_until(20.0 * h, |_| ()).is_ok());
    good += simulation.samples(30.0 * h).filter(Result::is_ok).count() as u32;
    let level = Event::of(M::Outputs::NAMES.first().copied().unwrap_or_default()).level(h);
    good += u32::from(simulation.run_until_event(40.0 * h, &[level, level.rising()], |_| ()).is_ok());
    good += u32::from(simulation.acceleration().is_ok());
    good + u32::from(simulation.multipliers().is_ok())
}

/// What a control loop calls.
fn steps<M, S>(model: &M, start: &StateOf<M>, method: S, h: f64) -> u32
where
    M: Assemble<f64, Inputs: Fields<f64>, Outputs: Fields<f64>> + Parametric<f64> + Clone,
    S: StepMethod<f64, M>,
{
    let mut plant = model.stepper(start.clone(), method);
    let inputs = M::Inputs::from_array(Vector::zeros(M::Inputs::NAMES.len()));
    let mut good =
        u32::from(plant.step(&inputs, h).is_ok()) + u32::from(plant.substeps(&inputs, h, 3).is_ok());
    let saved = plant.save();
    good += u32::from(plant.set_parameters(model.parameters().clone()).is_ok());
    good += u32::from(plant.set_state(h, start.clone()).is_ok()) + u32::from(plant.assemble().is_ok());
    good += u32::from(plant.restore(&saved).is_ok()) + u32::from(plant.near_singular().is_some());
    good += u32::from(plant.outputs(&inputs).to_array().max_abs() > h);
    good + u32::from(plant.accelerations(&inputs, h).is_ok())
}

fn every_way<M>(model: &M, start: &StateOf<M>, h: f64) -> u32
where
    M: Tangent<f64> + Assemble<f64, Inputs: Fields<f64>, Outputs: Fields<f64>> + Parametric<f64> + Clone,
{
    let penalty = Penalty::for_model(model, 0.0, &start.q, h);
    let mut good = moves(model, start, LagrangeIndex1, Rk4, h);
    good += steps(model, start, Rk4, h);
    good += steps(model, start, (SemiImplicitEuler, NullSpace), h);
    good += steps(model, start, (ExplicitTrapezoidal, Corrected::after(LagrangeIndex1)), h);
    good += steps(model, start, (Rk4, Projected::after(LagrangeIndex1)), h);
    good += moves(model, start, Baumgarte { alpha: 10.0, beta: 10.0 }, SemiImplicitEuler, h);
    good += moves(model, start, penalty, ExplicitTrapezoidal, h);
    good += moves(model, start, AugmentedLagrangian::new(penalty), Rk4, h);
    good += moves(model, start, NullSpace, Rk4, h);
    good += moves(model, start, Partitioned::default(), Rk4, h);
    good += moves(model, start, Projected::after(NullSpace), Rk4, h);
    good += moves(model, start, Projected::after(LagrangeIndex1), DormandPrince::tolerance(1e-8), h);
    good += moves(model, start, LagrangeIndex1, GeneralisedAlpha::new(0.8), h);
    good += moves(model, start, LagrangeIndex1, ImplicitTrapezoidal::default(), h);
    good += moves(model, start, LagrangeIndex1, Ali3p::new(1e5), h);
    let simulation = Simulation::new(model, start.clone()).input_source(Still);
    let mut simulation = simulation.integrator(DormandPrince::tolerance(1e-8)).step(h);
    good += u32::from(simulation.run_every(0.3 * h, 10.0 * h, |_| ()).is_ok());
    good += u32::from(simulation.interpolate(9.9 * h).is_ok());

    // Positions, derivatives.
    good += u32::from(model.assemble(start).is_ok()) + u32::from(model.project(h, start).is_ok());
    let motions = [Motion { position: h, rate: 1.0, acceleration: 0.0 }; 3];
    let given = motions.get(..model.independent().len()).unwrap_or_default();
    if let Ok(found) = model.kinematics(0.0, &start.q, given) {
        let inputs = M::Inputs::from_array(Vector::zeros(M::Inputs::NAMES.len()));
        good += u32::from(actuation(model, 0.0, start, &found.a, &inputs, M::Inputs::NAMES).is_ok());
    }
    let inputs = M::Inputs::from_array(Vector::zeros(M::Inputs::NAMES.len()));
    good += u32::from(equilibrium(model, 0.0, &start.q, &inputs).is_ok());
    if let Ok(here) = Linearisation::at(model, 0.0, start, &inputs) {
        good += u32::from(here.by_position(0).acceleration.max_abs() > 0.0);
        good += u32::from(here.by_input(0).acceleration.max_abs() > 0.0);
        good += u32::from(here.by_parameters().column(0).acceleration.max_abs() > 0.0);
        good += u32::from(here.state_space().is_ok());
        good += u32::from(here.output_matrices().is_ok());
        if let Ok(space) = here.state_space() {
            good += u32::from(zero_order_hold(&space.a, &space.b, h).is_ok());
        }
    }
    good + controls(model, start, h)
}

/// What a controller or an estimator calls.
fn controls<M: Tangent<f64>>(model: &M, start: &StateOf<M>, h: f64) -> u32 {
    let inputs = M::Inputs::from_array(Vector::zeros(M::Inputs::NAMES.len()));
    let mut good = u32::from(step_map(model, &Rk4, (0.0, start), &inputs, h).is_ok());
    good +=
        u32::from(step_map(model, &(SemiImplicitEuler, LagrangeIndex1), (0.0, start), &inputs, h).is_ok());
    good += u32::from(step_map(model, &ExplicitTrapezoidal, (0.0, start), &inputs, h).is_ok());
    good += u32::from(coordinate(model, "main.angle").is_ok());
    good += u32::from(coordinate_values(model, 0.0, &start.q).max_abs() > h);
    good += u32::from(coordinate_rates(model, 0.0, &start.q, &start.v).max_abs() > h);
    let reading =
        Reading { coordinate: model.independent().first().copied().unwrap_or(9), position: h, rate: h };
    good += u32::from(measured(model, 0.0, start, &[reading]).is_ok());
    if let Ok(reduced) = Reduced::along(model, 0.0, start, &inputs, model.states()) {
        good += u32::from(reduced.mass_matrix().max_abs() > h);
        good += reduced.bias().len() as u32 + reduced.gravity().len() as u32;
        let a = reduced.acceleration(&[h]).plus(h, &reduced.velocity(&[h])).plus(h, &reduced.motion(1));
        good += u32::from(reduced.component(0, &a) > h);
        if let Ok(actuators) = Actuators::named(model, ["torque", "gas"]) {
            good += u32::from(
                actuators.inputs_for(model, (0.0, start), &reduced.acceleration(&[h]), &inputs).is_ok(),
            );
        }
    }
    good
}

/// What is asked of by a loader: it keeps everything above in the image.
#[unsafe(no_mangle)]
pub extern "C" fn slider_crank(h: f64, rate: f64) -> u32 {
    let model = SliderCrank::<f64>::default();
    let mut start = model.start();
    start.v = start.v.scaled(rate);
    every_way(&model, &start, h)
}

#[unsafe(no_mangle)]
pub extern "C" fn rods(h: f64, rate: f64) -> u32 {
    let model = Rods::<f64>::default();
    let mut start = model.start();
    start.v = start.v.scaled(rate);
    every_way(&model, &start, h)
}

#[unsafe(no_mangle)]
pub extern "C" fn top(h: f64, rate: f64) -> u32 {
    let model = Top::<f64>::default();
    let mut start = model.start();
    start.v = start.v.scaled(rate);
    every_way(&model, &start, h)
}

#[unsafe(no_mangle)]
pub extern "C" fn control(index: usize) -> f64 {
    // With the feature `control` an index that may be out of range: the search must find it.
    const TABLE: [f64; 3] = [1.0, 2.0, 3.0];
    if cfg!(feature = "control") { TABLE[index] } else { TABLE.get(index).copied().unwrap_or(0.0) }
}
