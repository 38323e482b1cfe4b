//! Orders of the integrators on emitted models, with and without constraints, and angles over many turns.

use crate::registry::{Model, for_each};
use crate::walking::walk;
use crate::zoo::Gears;
use linkwright::{
    AssembleExt, Baumgarte, DormandPrince, ExplicitTrapezoidal, Fields, Integrator, LagrangeIndex1, Layout,
    Mechanism, MechanismDynamics, NoInputs, Rk4, SemiImplicitEuler, Simulation, SimulationError, State,
    StateOf, Vector,
};
use linkwright_models::{double_pendulum::DoublePendulum, n_four_bar::NFourBar2};
use std::f64::consts::{PI, TAU};

/// An integrator of a model without inputs, by Lagrange's equations.
trait Steps<M: Model<Inputs = ()>>:
    for<'m> Integrator<f64, MechanismDynamics<'m, M, f64, LagrangeIndex1, NoInputs>>
{
}

impl<M: Model<Inputs = ()>, I> Steps<M> for I where
    I: for<'m> Integrator<f64, MechanismDynamics<'m, M, f64, LagrangeIndex1, NoInputs>>
{
}

/// The state after `steps` steps to `end` from the start of the model.
fn reached<M: Model<Inputs = ()>, I: Steps<M>>(integrator: I, end: f64, steps: u32) -> StateOf<M> {
    let model = M::standard();
    let start = model.start();
    let simulation = Simulation::new(&model, start).formulation(LagrangeIndex1).integrator(integrator);
    let reached = simulation.step(end / f64::from(steps)).advance_until(end);
    reached.unwrap_or_else(|error| panic!("{}: {error}", model.name()))
}

/// log₂ of the ratio of the errors with `steps` and with twice as many.
fn order<M: Model<Inputs = ()>, I: Steps<M> + Copy>(integrator: I, end: f64, steps: u32) -> f64 {
    let exact = reached::<M, Rk4>(Rk4, end, 4000);
    // Velocities too: where the motion starts without acceleration, as the windows do, symplectic Euler has positions of
    // second order, because half a kick makes it Verlet's method.
    let error = |steps: u32| {
        let State { q, v, .. } = reached::<M, I>(integrator, end, steps);
        q.plus(-1.0, &exact.q).max_abs().max(v.plus(-1.0, &exact.v).max_abs())
    };
    (error(steps) / error(2 * steps)).log2()
}

/// Fifth order, fourth, second and first, on an open chain and on a closed one.
#[test]
fn orders_of_convergence() {
    let orders = [
        ("double pendulum, RK4", order::<DoublePendulum, _>(Rk4, 0.5, 60), 4.0),
        ("two windows, RK4", order::<NFourBar2, _>(Rk4, 0.5, 60), 4.0),
        ("double pendulum, Dormand–Prince", order::<DoublePendulum, _>(DormandPrince::fixed(), 0.5, 16), 5.0),
        ("two windows, Dormand–Prince", order::<NFourBar2, _>(DormandPrince::fixed(), 0.5, 20), 5.0),
        ("double pendulum, trapezoidal", order::<DoublePendulum, _>(ExplicitTrapezoidal, 0.5, 200), 2.0),
        ("two windows, trapezoidal", order::<NFourBar2, _>(ExplicitTrapezoidal, 0.5, 200), 2.0),
        ("double pendulum, Euler", order::<DoublePendulum, _>(SemiImplicitEuler, 0.5, 400), 1.0),
        ("two windows, Euler", order::<NFourBar2, _>(SemiImplicitEuler, 0.5, 400), 1.0),
    ];
    for (name, order, expected) in orders {
        println!("{name}: order {order:.3}");
        assert!((order - expected).abs() < 0.2, "{name}: order {order}");
    }
}

/// Many turns of a pinion, a wheel and a flap: the counted angle of each joint is that of the bodies' orientations up
/// to whole turns, and the gear's ratio holds of the counted ones.
/// A method that chooses its steps needs none: a run without a step size is one with a step size that is never reached. One that does not
/// choose says what is missing.
#[test]
fn a_method_that_chooses_its_steps_needs_no_size() {
    let model = DoublePendulum::<f64>::default();
    let method = DormandPrince::tolerance(1e-9);
    let mut free = model.simulation(model.start()).integrator(method);
    let mut bounded = model.simulation(model.start()).integrator(method).step(1e3);
    let (found, expected) = (free.advance_until(2.0).unwrap(), bounded.advance_until(2.0).unwrap());
    assert!(free.time() == 2.0 && found.v.plus(-1.0, &expected.v).max_abs() < 1e-6, "{found:?} {expected:?}");
    let mut single = model.simulation(model.start()).integrator(method);
    let step = single.advance().unwrap();
    assert!(step.time > 0.0 && step.time < 1.0, "{step:?}");
    for error in [
        model.simulation(model.start()).advance().unwrap_err(),
        model.simulation(model.start()).integrator(DormandPrince::fixed()).advance().unwrap_err(),
    ] {
        assert!(matches!(error, SimulationError::StepMissing), "{error}");
    }
}

#[test]
fn counted_angles_are_those_of_the_pairs() {
    let model = Gears::default();
    let start = model.assemble(&Gears::START).expect("it is consistent");
    let drive = |_: f64, _: &State<_, _>| crate::zoo::GearsInputs { drive: 0.5 };
    let baumgarte = Baumgarte { alpha: 10.0, beta: 10.0 };
    let mut simulation = Simulation::new(&model, start).formulation(baumgarte).sampled(drive).step(1e-3);
    let begun = simulation.sample().outputs;
    let mut largest = 0.0_f64;
    for sample in simulation.samples(5.0) {
        let sample = sample.expect("it runs");
        let o = sample.outputs;
        let motions = model.motions(sample.time, &sample.state.q, &sample.state.v, &model.zero_v());
        let angle = |name: &str| {
            let body = Gears::BODIES.iter().position(|body| *body == name).expect("a body of the mechanism");
            let [c, s] = motions[body].orientation;
            s.atan2(c)
        };
        let relative = [
            (o.turned, angle("pinion")),
            (o.wheel_turned, angle("wheel") - angle("arm")),
            (o.flapped, angle("flap") - angle("arm")),
        ];
        for (counted, pair) in relative {
            let off = (counted - pair + PI).rem_euclid(TAU) - PI;
            assert!(off.abs() < 1e-9, "at {}: {counted} {pair}", sample.time);
        }
        let ratio = (o.wheel_turned - begun.wheel_turned) + 5.0 / 7.0 * (o.turned - begun.turned);
        assert!(ratio.abs() < 1e-5, "at {}: the gear slipped by {ratio} rad", sample.time);
        largest = largest.max((o.turned - begun.turned).abs());
    }
    assert!(largest > TAU, "it turned by {largest} rad only");
}

for_each!(walking_keeps_angles_and_pairs_together);

/// Projections and retractions move a counted angle and its pair alike: outputs do not jump along a walk.
fn walking_keeps_angles_and_pairs_together<M: Model>() {
    let (compiled, _, model, states) = walk::<M>(30, 10);
    for at in &states {
        let outputs = model.outputs(at.time, &at.state(), &at.u).to_array();
        assert!(outputs.as_slice().iter().all(|output| output.is_finite()), "{}", model.name());
        let Layout { linear, rotations, quaternions, angles } = *model.layout();
        let counts = linear + 2 * rotations + 4 * quaternions;
        let q = at.q.as_slice();
        for (angle, known) in compiled.complete.equations.layout.angles.iter().zip(0..angles.len()) {
            // In space a free body's ω is the rate of no angle.
            if angle.rate.iter().any(|(rate, _)| !(linear..linear + rotations).contains(rate)) {
                continue;
            }
            let angle_of = |q: &[f64]| -> f64 {
                let pair = |rate: usize| q[2 * rate - linear + 1].atan2(q[2 * rate - linear]);
                angle.rate.iter().map(|(rate, weight)| weight * pair(*rate)).sum()
            };
            let counted = |q: &[f64]| TAU * q[counts + 2 * known] + q[counts + 2 * known + 1];
            // A constant lies between them: the frames' fixed angles, the same as at the start.
            let start = model.start_q();
            let start = start.as_slice();
            let moved = angle_of(q) - angle_of(start);
            let off = (counted(q) - counted(start) - moved + PI).rem_euclid(TAU) - PI;
            assert!(off.abs() < 1e-9, "{}: {} against {moved}", model.name(), counted(q));
        }
    }
}
