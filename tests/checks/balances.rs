//! What must hold of any model at consistent states: the equations of motion are solved, power is balanced, a driver's
//! power is its effort's, momentum is kept where nothing acts from outside.

use crate::identities::{derivative_over, row_rates};
use crate::registry::{At, Model, Random, compiled, fields, for_each, vector};
use crate::walking::walk;
use crate::zoo::{Floating, FloatingState, Shaken};
use linkwright::{AssembleExt, Mechanism, Simulation, State, StateOf, Vector, retract};
use linkwright_compiler::equations::Linear;
use linkwright_compiler::equations::VOCABULARY;
use linkwright_compiler::equations::space::constant_axis;
use linkwright_compiler::forms::Law;
use linkwright_compiler::functions::{MOTION, REACTION};
use linkwright_compiler::model::{
    Coordinates, Deforms, Expr, Frame, Joint, Load, Mechanism as Mechanism_, Space, value_at,
};
use linkwright_compiler::schedule::{self, Function, Inputs};
use linkwright_compiler::{Compiled, compile_model};

const STATES: usize = 10;

for_each!(equations_are_solved);
for_each!(power_is_balanced);
for_each!(springs_store_what_they_take);
for_each!(joints_exert_nothing_along_their_freedom);

/// ‖r‖ ≤ 10⁻¹³ (‖K‖ ‖z‖ + ‖b‖) for K z = b, z = (v̇, λ), b = (Q, γ − 2α (D v − ν) − β² Φ), off the constraints too.
fn equations_are_solved<M: Model>() {
    let (_, _, model, states) = walk::<M>(20, STATES);
    let mut random = Random::new(21);
    for at in &states {
        let At { time, q, v, u, .. } = at;
        let mut a = model.zero_v();
        let mut lambda = model.zero_lambda();
        let pivot = model.acceleration(*time, &at.state(), u, &mut a, &mut lambda);
        assert!(pivot > 0.0 && pivot <= 1.0, "{}: pivot {pivot}", model.name());
        assert_solved(&model, *time, (&at.state(), u), (0.0, 0.0), (&a, &lambda));

        let (off, faster) = (random.vector(a.as_slice().len()), random.vector(a.as_slice().len()));
        let mut away = *q;
        retract(model.layout(), q, &vector::<M::V>(&off).scaled(1e-2), &mut away);
        let off = at.at(away, v.plus(0.1, &vector(&faster)));
        model.acceleration_baumgarte(*time, &off, u, 7.0, 50.0, &mut a, &mut lambda);
        assert_solved(&model, *time, (&off, u), (7.0, 50.0), (&a, &lambda));
    }
}

fn assert_solved<M: Model>(
    model: &M,
    time: f64,
    (state, u): (&StateOf<M>, &M::Inputs),
    (two_alpha, beta_squared): (f64, f64),
    (a, lambda): (&M::V, &M::Lambda),
) {
    let State { q, v, .. } = state;
    let (mut mass, mut jacobian) = (model.zero_mass(), model.zero_jacobian());
    let (mut forces, mut gamma, mut phi) = (model.zero_v(), model.zero_lambda(), model.zero_lambda());
    model.mass_matrix(time, q, &mut mass);
    model.constraint_jacobian(time, q, &mut jacobian);
    model.forces(time, state, u, &mut forces);
    let mut friction = model.zero_v();
    model.friction_forces(time, state, u, a, lambda, &mut friction);
    forces = forces.plus(1.0, &friction);
    model.gamma(time, q, v, &mut gamma);
    model.constraints(time, q, &mut phi);
    let (rates, _) = row_rates(model, time, q, v);
    let n = model.velocity_names().len();

    let mut residual: Vec<f64> = forces.as_slice().to_vec();
    residual.extend(
        gamma
            .as_slice()
            .iter()
            .zip(rates)
            .zip(phi.as_slice())
            .map(|((gamma, rate), phi)| gamma - two_alpha * rate - beta_squared * phi),
    );
    let size = |values: &[f64]| values.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
    let right = size(&residual);
    let unknowns: Vec<f64> = a.as_slice().iter().chain(lambda.as_slice()).copied().collect();
    let mut sums = vec![0.0; unknowns.len()];
    let mut subtract = |row: usize, column: usize, entry: f64| {
        residual[row] -= entry * unknowns[column];
        sums[row] += entry.abs();
    };
    for (&(row, column), entry) in model.mass_pattern().iter().zip(mass.as_slice()) {
        let (row, column) = (row as usize, column as usize);
        subtract(row, column, *entry);
        if row != column {
            subtract(column, row, *entry);
        }
    }
    for (&(row, column), entry) in model.jacobian_pattern().iter().zip(jacobian.as_slice()) {
        let (row, column) = (n + row as usize, column as usize);
        subtract(row, column, *entry);
        subtract(column, row, *entry);
    }
    let (residual, scale) = (size(&residual), size(&sums) * size(&unknowns) + right);
    assert!(residual <= 1e-13 * scale, "{}: residual {residual:e} of {scale:e}", model.name());
}

/// The model's motion as functions of h, to the second order: t + h, q ⊕ (h v + ½ h² v̇), v + h v̇.
struct Ahead<M: Model> {
    at: At<M>,
    a: M::V,
    lambda: M::Lambda,
}

impl<M: Model> Ahead<M> {
    fn new(model: &M, at: At<M>) -> Self {
        let (mut a, mut lambda) = (model.zero_v(), model.zero_lambda());
        model.acceleration(at.time, &at.state(), &at.u, &mut a, &mut lambda);
        Ahead { at, a, lambda }
    }

    fn state(&self, h: f64) -> (f64, M::Q, M::V) {
        let model = M::standard();
        let mut q = self.at.q;
        retract(model.layout(), &self.at.q, &self.at.v.scaled(h).plus(h * h / 2.0, &self.a), &mut q);
        (self.at.time + h, q, self.at.v.plus(h, &self.a))
    }

    /// d(f)/dt along the motion.
    fn rate(&self, f: impl Fn(f64, &M::Q, &M::V) -> f64) -> f64 {
        // Short enough that nothing turns or speeds up by more than a thousandth.
        let step = 1e-3 / (1.0 + self.at.v.max_abs() + self.a.max_abs().sqrt());
        derivative_over(step, |h| {
            let (time, q, v) = self.state(h);
            vec![f(time, &q, &v)]
        })[0]
    }
}

/// The same mechanism without gravity, for what springs alone store.
fn weightless(compiled: &Compiled) -> Compiled {
    let mut mechanism = compiled.mechanism.clone();
    mechanism.gravity = None;
    mechanism.expect.budgets.clear();
    mechanism.expect.deflections.clear();
    // Without a weight on them cords may push.
    let rods = (VOCABULARY.joints)(mechanism.space);
    let rod = rods.into_iter().find(|form| form.call.word == "distance").expect("there are rods");
    mechanism.joints.iter_mut().filter(|joint| joint.form.only_pulls).for_each(|cord| cord.form = rod);
    let coordinates = compiled.choice.coordinates;
    compile_model(mechanism, compiled.definition.clone(), Some(coordinates)).expect("gravity moves no joint")
}

/// V of springs.
fn stored<M: Model>(weightless: &Compiled, parameters: &[f64], time: f64, q: &M::Q) -> f64 {
    let mut inputs = Inputs {
        parameters: parameters.to_vec(),
        phases: weightless.assembly.phases.clone(),
        time,
        q: q.as_slice().to_vec(),
        ..Inputs::default()
    };
    inputs.prepared = schedule::run(weightless.programs.get(Function::Prepare), &inputs);
    schedule::run(weightless.programs.get(Function::PotentialEnergy), &inputs)[0]
}

/// −Σ (K p + C ṗ) ṗ of modes.
fn of_modes(compiled: &Compiled, parameters: &[f64], q: &[f64], v: &[f64]) -> f64 {
    let mut power = 0.0;
    for (index, linear) in compiled.complete.equations.layout.linear.iter().enumerate() {
        let Linear::Mode(body, mode) = linear else { continue };
        let body = &compiled.mechanism.bodies[body.0];
        let number = |expr: &Expr| value_at(expr, parameters).expect("a number");
        let beam = match body.deforms.as_ref().expect("what has modes deforms") {
            Deforms::Beam(beam) => beam,
            Deforms::Modal(modal) => {
                // Modes of a body stand side by side.
                let first = index - mode;
                let damping = modal.reduced.critical_damping();
                let stiffness = modal.reduced.stiffness[*mode].iter().zip(&damping[*mode]).enumerate();
                let force = stiffness.map(|(k, (stiffness, damping))| {
                    stiffness * q[first + k] + number(&modal.damping_ratio) * damping * v[first + k]
                });
                power -= force.sum::<f64>() * v[index];
                continue;
            }
        };
        let stiffness =
            beam.slender.modes[*mode].stiffness * number(beam.rigidity(beam.slender.modes[*mode].way));
        let rate = stiffness / beam.rates(&body.mass, parameters)[*mode];
        power -= (stiffness * q[index] + 2.0 * number(&beam.damping_ratio) * rate * v[index]) * v[index];
    }
    power
}

/// Whether a load's end is moved by its support, which then takes part in its power.
fn is_moved(mechanism: &Mechanism_, load: &Load) -> bool {
    let joint = load.in_place_of().map(|joint| &mechanism.joints[joint.0]);
    let held = joint.into_iter().flat_map(|joint| [&joint.first, &joint.second]);
    load.moves_by_itself()
        || load.places().chain(held).any(|place| format!("{:?}", place.at).contains("Time"))
}

/// dT/dt = Σ powers of loads − dV_gravity/dt − λᵀν, and −λᵀν of the drivers' rows is their power.
fn power_is_balanced<M: Model>() {
    let (compiled, parameters, model, states) = walk::<M>(22, STATES);
    if compiled.mechanism.loads.iter().any(|load| is_moved(&compiled.mechanism, load)) {
        assert!(
            [
                "CarAxis",
                "Table",
                "Mounted",
                "Yielding",
                "Cabin",
                "Steered",
                "Worn",
                "Hoisted",
                "RearWheel",
                "RubbingPairs",
                "Dropping",
                "Gripping",
                "GrippingInSpace",
                "VehicleOnPans"
            ]
            .contains(&model.name()),
            "{}: left to the reference",
            model.name()
        );
        return;
    }
    let weightless = weightless(&compiled);
    for at in states {
        if model.kinetic_energy(at.time, &at.q, &model.zero_v()) != 0.0 {
            // A support carries bodies: its power is a reaction's, see `a_moving_support_works`.
            assert_eq!(model.name(), "Shaken");
            return;
        }
        let ahead = Ahead::new(&model, at);
        let Ahead { at, lambda, .. } = &ahead;
        let kinetic = ahead.rate(|time, q, v| model.kinetic_energy(time, q, v));
        let gravity = ahead.rate(|time, q, v| {
            stored::<M>(&weightless, &parameters, time, q) - model.potential_energy(time, &at.at(*q, *v))
        });
        let mut nu = model.zero_lambda();
        model.nu(at.time, &at.q, &mut nu);
        let forced: Vec<f64> =
            lambda.as_slice().iter().zip(nu.as_slice()).map(|(lambda, nu)| -lambda * nu).collect();
        let loads = model.flat_powers(at);
        let bending = of_modes(&compiled, &parameters, at.q.as_slice(), at.v.as_slice());
        let powers: Vec<f64> = loads.iter().chain(&forced).copied().chain([gravity, bending]).collect();
        let sum: f64 = powers.iter().sum();
        let scale = kinetic.abs() + powers.iter().map(|power| power.abs()).sum::<f64>();
        assert!(
            (kinetic - sum).abs() <= 1e-6 * scale,
            "{}: dT/dt {kinetic}, powers {powers:?}",
            model.name()
        );

        let drivers = model.flat_driver_efforts(at, lambda);
        let (_, driving) = drivers.split_at(drivers.len() / 2);
        let rows = &forced[forced.len() - driving.len()..];
        for (power, row) in driving.iter().zip(rows) {
            assert!((power - row).abs() <= 1e-12 * (1e-12 + row.abs()), "{}: {power} {row}", model.name());
        }
    }
}

/// The power of springs without damping is −dV/dt.
fn springs_store_what_they_take<M: Model>() {
    let (compiled, parameters, model, states) = walk::<M>(23, STATES);
    let elastic = undamped_springs(&compiled.mechanism);
    if elastic.is_empty() {
        return;
    }
    let weightless = weightless(&compiled);
    for at in states {
        let powers = model.flat_powers(&at);
        let taken: f64 = elastic.iter().map(|index| powers[*index]).sum();
        let scale: f64 = elastic.iter().map(|index| powers[*index].abs()).sum();
        let ahead = Ahead::new(&model, at);
        let rate = ahead.rate(|time, q, _| stored::<M>(&weightless, &parameters, time, q));
        assert!((taken + rate).abs() <= 1e-6 * (scale + rate.abs()), "{}: {taken} {rate}", model.name());
    }
}

/// Which loads are springs, where none is damped and no body deforms.
fn undamped_springs(mechanism: &Mechanism_) -> Vec<usize> {
    // What deforms stores too, and no load tells of that.
    if mechanism.bodies.iter().any(|body| body.deforms.is_some()) {
        return Vec::new();
    }
    let none = |damping: &Expr| matches!(damping, Expr::Number(0.0));
    // A damper is a spring that stores nothing, and so does what has a memory or a winch.
    let loads = mechanism.loads.iter().enumerate();
    let springs =
        loads.filter(|(_, load)| load.form.law == Law::None && load.form.effort.is_none() && !load.form.rubs);
    let mut springs = springs.map(|(index, load)| {
        let is_damping = |name: &str| name.ends_with("damping");
        let dampings = load.arguments().filter(|(argument, _)| is_damping(argument.name));
        (index, dampings.flat_map(|(_, values)| values).all(none))
    });
    let elastic = springs.clone().map(|(index, _)| index).collect();
    if springs.any(|(_, undamped)| !undamped) { Vec::new() } else { elastic }
}

/// A revolute exerts no torque at its places, a slide no force along its line, by the solved v̇ and λ.
fn joints_exert_nothing_along_their_freedom<M: Model>() {
    let (compiled, _, model, states) = walk::<M>(26, STATES);
    for at in states {
        let (mut a, mut lambda) = (model.zero_v(), model.zero_lambda());
        model.acceleration(at.time, &at.state(), &at.u, &mut a, &mut lambda);
        let reactions = model.flat_reactions(&at, &a, &lambda);
        let largest = reactions.iter().fold(0.0_f64, |largest, reaction| largest.max(reaction.abs()));
        let kind = REACTION.of(compiled.mechanism.space);
        let reactions = reactions.chunks(kind.length()).map(|reaction| kind.split(reaction));
        if compiled.mechanism.space == Space::Spatial {
            let motions = model.flat_motions(at.time, &at.q, &at.v, &a);
            let all = compiled.mechanism.joints.iter().zip(reactions);
            // What yields is open here, and its axes are two.
            for (joint, reaction) in all.filter(|(joint, _)| joint.holds()) {
                for work in along_the_freedom(&compiled.mechanism, joint, reaction, &motions) {
                    let name = &joint.name.text;
                    assert!(work.abs() <= 1e-10 * largest, "{} {name}: {work} of {largest}", model.name());
                }
            }
            continue;
        }
        for (joint, [force, torque]) in compiled.mechanism.joints.iter().zip(reactions) {
            let wrench = [force[0], force[1], torque[0]];
            let free: &[usize] = match joint.word() {
                "revolute" | "point_on_line" | "point_on_curve" | "distance" | "cord" | "cam" => &[2],
                "parallel" => &[0, 1],
                // The force along the axis of a slide is left to the reference.
                "fixed" | "prismatic" => &[],
                other => panic!("say what {other} lets move"),
            };
            for work in free.iter().map(|component| wrench[*component]) {
                let name = &joint.name.text;
                assert!(work.abs() <= 1e-11 * largest, "{} {name}: {work} of {largest}", model.name());
            }
        }
    }
}

/// Components of a reaction in space along what its joint lets move: all of the torque of a ball, what lies along the axis
/// of a revolute, prismatic, cylindrical or planar joint. Axes that depend on parameters are left to the reference.
fn along_the_freedom(
    mechanism: &Mechanism_,
    joint: &Joint,
    [force, torque]: [&[f64]; 2],
    motions: &[f64],
) -> Vec<f64> {
    let along = |direction: [f64; 3], vector: &[f64]| -> f64 {
        direction.iter().zip(vector).map(|(a, b)| a * b).sum()
    };
    let axis = || -> Option<[f64; 3]> {
        let axis = constant_axis(mechanism, joint, &joint.second)?;
        let Frame::Body(body) = joint.second.frame else { return Some(axis) };
        let kind = MOTION.of(mechanism.space);
        let [_, turned, ..]: [&[f64]; 6] = kind.split(motions.chunks(kind.length()).nth(body.0)?);
        Some([0, 1, 2].map(|row| along(axis, &turned[3 * row..])))
    };
    match joint.word() {
        "spherical" | "point_on_line" | "point_on_plane" | "distance" | "cord" => torque.to_vec(),
        "revolute" | "planar" => axis().map(|axis| along(axis, torque)).into_iter().collect(),
        "prismatic" => axis().map(|axis| along(axis, force)).into_iter().collect(),
        "cylindrical" => {
            axis().map(|axis| [along(axis, force), along(axis, torque)]).into_iter().flatten().collect()
        }
        "parallel" => force.to_vec(),
        "fixed" | "screw" | "universal" | "constant_velocity" => Vec::new(),
        other => panic!("say what {other} lets move"),
    }
}

/// Where a support moves a body, dT/dt has the power of the joint's reaction: F·ṗ.
#[test]
fn a_moving_support_works() {
    let (compiled, parameters, model, states) = walk::<Shaken>(24, STATES);
    assert_eq!(compiled.choice.coordinates, Coordinates::Tree);
    let (stroke, shoulder) = (parameters[0], 0);
    assert_eq!(Shaken::JOINTS[shoulder], "shoulder");
    for at in states {
        let t = at.time;
        let ahead = Ahead::new(&model, at);
        let Ahead { at, a, lambda } = &ahead;
        let energy = ahead.rate(|time, q, v| {
            model.kinetic_energy(time, q, v) + model.potential_energy(time, &at.at(*q, *v))
        });
        let force = model.reactions(t, &at.state(), &at.u, a, lambda)[shoulder].force;
        let support = force[0] * stroke * 3.0 * (3.0 * t).cos() - force[1] * 0.05 * 2.0 * (2.0 * t).sin();
        let driving: f64 = model.driver_efforts(t, &at.q, &at.v, lambda).iter().map(|[_, power]| power).sum();
        let scale = energy.abs() + support.abs() + driving.abs();
        // The driven torque turns against the resting ground; only the force meets a velocity there.
        assert!(
            (energy - support - driving).abs() <= 1e-7 * scale,
            "{energy}: support {support}, drivers {driving}"
        );
    }
}

/// Nothing acts on the floating pair from outside: linear and angular momentum stay what they are.
#[test]
fn momentum_is_kept() {
    let masses = [(3.0, 0.2), (1.0, 1.2 * 1.2 / 12.0)];
    let momentum = |bodies: &[linkwright::BodyMotion]| {
        let mut sum = [0.0; 3];
        for (body, (mass, inertia)) in bodies.iter().zip(masses) {
            let ([x, y], [vx, vy]) = (body.position, body.velocity);
            let terms = [mass * vx, mass * vy, mass * (x * vy - y * vx) + inertia * body.rate];
            sum.iter_mut().zip(terms).for_each(|(sum, term)| *sum += term);
        }
        sum
    };
    let forces = |bodies: &[linkwright::BodyMotion]| {
        let mut sum = [0.0; 3];
        for (body, (mass, inertia)) in bodies.iter().zip(masses) {
            let ([x, y], [ax, ay]) = (body.position, body.acceleration);
            let moment = mass * (x * ay - y * ax) + inertia * body.angular_acceleration;
            sum.iter_mut().zip([mass * ax, mass * ay, moment]).for_each(|(sum, term)| *sum += term);
        }
        sum
    };
    let (_, _, model, states) = walk::<Floating>(25, STATES);
    for at in &states {
        let (mut a, mut lambda) = ([0.0; 4], Default::default());
        model.acceleration(at.time, &at.state(), &at.u, &mut a, &mut lambda);
        let sum = forces(&model.motions(at.time, &at.q, &at.v, &a));
        assert!(sum.iter().all(|force| force.abs() < 1e-12), "{sum:?}");
    }

    let start = model.assemble(&Floating::START).expect("it is consistent");
    let mut simulation = Simulation::new(&model, start).sampled(|time, _| fields(&[time.sin()])).step(1e-3);
    let bodies = |state: &FloatingState| model.motions(0.0, &state.q, &state.v, &[0.0; 4]);
    let before = momentum(&bodies(&start));
    let after = momentum(&bodies(&simulation.advance_until(2.0).expect("it runs")));
    for (before, after) in before.iter().zip(after) {
        assert!((before - after).abs() < 1e-10, "{before} {after}");
    }
    assert!(compiled::<Floating>(None).complete.equations.rows.is_empty());
    assert_eq!(<Floating>::default().rows().len(), 0);
}
