//! What follows from the derivatives, of mechanisms that emit them: against differences of the motion itself, against closed
//! forms, and there and back.

use crate::identities::derivative_over;
use crate::registry::{At, Model, Random, fields, vector};
use crate::walking::walk;
use crate::zoo_laws::Servo;
use crate::zoo_tangent::for_each_with_tangent;
use crate::zoo_tangent::{
    Bar, Buoy, Flail, Gripper, GripperInputs, Rocker, Spring, SpringInputs, Swing, Winch,
};
use linkwright::{
    AssembleExt, ConditionKind, Fields, Linearisation, LinearisationError, Mechanism, Motion, State, StateOf,
    Tangent, Variables, Vector, actuation, equilibrium, project_position, project_velocity, retract,
};

const STATES: usize = 4;

for_each_with_tangent!(responses_are_the_derivatives);
for_each_with_tangent!(equilibria_balance);
for_each_with_tangent!(actuation_undoes_the_motion);

fn linearised<'m, M: Model + Tangent<f64>>(model: &'m M, at: &At<M>) -> Linearisation<'m, f64, M> {
    Linearisation::at(model, at.time, &at.state(), &at.u)
        .unwrap_or_else(|error| panic!("{}: {error}", model.name()))
}

/// A unit vector times h.
fn along<V: Vector<f64>>(zeros: V, k: usize, h: f64) -> V {
    let mut unit = zeros;
    unit.as_mut_slice()[k] = h;
    unit
}

fn moved<M: Model>(model: &M, q: &M::Q, delta: &M::V) -> M::Q {
    let mut moved = *q;
    retract(model.layout(), q, delta, &mut moved);
    moved
}

/// v̇, then λ.
fn solved<M: Model>(model: &M, time: f64, state: &StateOf<M>, u: &M::Inputs) -> Vec<f64> {
    let (mut a, mut lambda) = (model.zero_v(), model.zero_lambda());
    model.acceleration(time, state, u, &mut a, &mut lambda);
    [a.as_slice(), lambda.as_slice()].concat()
}

/// ż of the internal states.
fn internal<M: Model>(model: &M, time: f64, state: &StateOf<M>, u: &M::Inputs) -> Vec<f64> {
    let (mut a, mut lambda, mut rates) = (model.zero_v(), model.zero_lambda(), model.zero_z());
    model.acceleration(time, state, u, &mut a, &mut lambda);
    model.internal_rates(time, state, u, &a, &lambda, &mut rates);
    rates.as_slice().to_vec()
}

fn input<M: Model>(u: &M::Inputs, k: usize, h: f64) -> M::Inputs {
    let mut values = u.to_array();
    values.as_mut_slice()[k] += h;
    M::Inputs::from_array(values)
}

fn assert_close(name: &str, found: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(found.len(), expected.len(), "{name}");
    let largest = expected.iter().fold(1.0, |largest, entry| f64::max(largest, entry.abs()));
    for (index, (found, expected)) in found.iter().zip(expected).enumerate() {
        let off = (found - expected).abs();
        assert!(off <= tolerance * largest, "{name}[{index}]: {found} {expected}, off by {off:e}");
    }
}

/// ∂(v̇, λ) by q, v, z, u and p, and ∂ż, against differences of `acceleration`.
fn responses_are_the_derivatives<M: Model + Tangent<f64>>() {
    let (_, parameters, model, states) = walk::<M>(50, STATES);
    for at in &states {
        let here = linearised(&model, at);
        let (time, q, v, u) = (at.time, &at.q, &at.v, &at.u);
        let flat = [here.acceleration().as_slice(), here.multipliers().as_slice()].concat();
        // By independent velocities, maybe.
        assert_close(model.name(), &flat, &solved(&model, time, &at.state(), u), 1e-11);
        let check = |what: &str,
                     k: usize,
                     found: linkwright::Response<M::V, M::Lambda>,
                     f: &dyn Fn(f64) -> Vec<f64>| {
            let found = [found.acceleration.as_slice(), found.multipliers.as_slice()].concat();
            assert_close(
                &format!("{}: by {what} {k}", model.name()),
                &found,
                &derivative_over(2e-4, f),
                1e-6,
            );
        };
        for k in 0..model.velocity_count() {
            let further = |h: f64| at.at(moved(&model, q, &along(model.zero_v(), k, h)), *v);
            let faster = |h: f64| at.at(*q, v.plus(1.0, &along(model.zero_v(), k, h)));
            check("position", k, here.by_position(k), &|h| solved(&model, time, &further(h), u));
            check("velocity", k, here.by_velocity(k), &|h| solved(&model, time, &faster(h), u));
            let (unit, none, still) = (along(model.zero_v(), k, 1.0), model.zero_v(), model.zero_z());
            let rates = here.internal_rates(&unit, &none, &still, &here.by_position(k));
            let expected = derivative_over(2e-4, |h| internal(&model, time, &further(h), u));
            assert_close(&format!("{}: ż by position {k}", model.name()), rates.as_slice(), &expected, 1e-6);
            let rates = here.internal_rates(&none, &unit, &still, &here.by_velocity(k));
            let expected = derivative_over(2e-4, |h| internal(&model, time, &faster(h), u));
            assert_close(&format!("{}: ż by velocity {k}", model.name()), rates.as_slice(), &expected, 1e-6);
        }
        for k in 0..model.internal_count() {
            let more = |h: f64| State { z: at.z.plus(1.0, &along(model.zero_z(), k, h)), ..at.state() };
            check("state", k, here.by_internal(k), &|h| solved(&model, time, &more(h), u));
            let (unit, none) = (along(model.zero_z(), k, 1.0), model.zero_v());
            let rates = here.internal_rates(&none, &none, &unit, &here.by_internal(k));
            let expected = derivative_over(2e-4, |h| internal(&model, time, &more(h), u));
            assert_close(&format!("{}: ż by state {k}", model.name()), rates.as_slice(), &expected, 1e-6);
        }
        for k in 0..M::Inputs::NAMES.len() {
            check("input", k, here.by_input(k), &|h| solved(&model, time, &at.state(), &input::<M>(u, k, h)));
        }
        let by_parameters = here.by_parameters();
        for k in 0..parameters.len() {
            // Relative: there are inertias of grams and stiffnesses of kilonewtons.
            let size = parameters[k].abs().max(1e-3);
            let with = |h: f64, of: fn(&M, f64, &StateOf<M>, &M::Inputs) -> Vec<f64>| {
                let mut parameters = parameters.clone();
                parameters[k] += size * h;
                let model = M::prepared(&parameters).expect("parameters near their defaults");
                of(&model, time, &at.state(), u).iter().map(|entry| entry / size).collect::<Vec<_>>()
            };
            check("parameter", k, by_parameters.column(k), &|h| with(h, solved));
            let (rates, expected) =
                (by_parameters.internal_rates(k), derivative_over(2e-4, |h| with(h, internal)));
            assert_close(&format!("{}: ż by parameter {k}", model.name()), rates.as_slice(), &expected, 1e-6);
        }
    }
}

/// Coordinates s of the independent conditions.
fn coordinates<M: Model + Tangent<f64>>(model: &M, time: f64, q: &M::Q) -> Vec<f64> {
    let (mut residual, mut upright, none) =
        (model.zero_conditions(), model.zero_conditions(), model.zero_conditions());
    model.condition_residual(time, q, &none, &mut residual);
    model.condition_cosines(time, q, &none, &mut upright);
    let value = |at: &u16| {
        let (residual, upright) = (residual.as_slice()[*at as usize], upright.as_slice()[*at as usize]);
        match model.conditions()[*at as usize].kind {
            ConditionKind::Angle => residual.atan2(upright),
            _ => residual,
        }
    };
    model.states().iter().map(value).collect()
}

/// B x and more: of ṡ = B v + drift or s̈ = B a + bias.
fn rates<M: Model + Tangent<f64>>(
    model: &M,
    time: f64,
    q: &M::Q,
    x: &M::V,
    constant: &M::Conditions,
) -> Vec<f64> {
    let mut jacobian = model.zero_condition_jacobian();
    model.condition_jacobian(time, q, &mut jacobian);
    let mut all = *constant;
    for (entry, (row, column)) in jacobian.as_slice().iter().zip(model.condition_pattern()) {
        all.as_mut_slice()[*row as usize] += entry * x.as_slice()[*column as usize];
    }
    model.states().iter().map(|at| all.as_slice()[*at as usize]).collect()
}

fn velocities<M: Model + Tangent<f64>>(model: &M, time: f64, q: &M::Q, v: &M::V) -> Vec<f64> {
    let mut drift = model.zero_conditions();
    model.condition_drift(time, q, &mut drift);
    rates(model, time, q, v, &drift)
}

/// s̈, then ż, then the outputs.
fn motion<M: Model + Tangent<f64>>(model: &M, time: f64, state: &StateOf<M>, u: &M::Inputs) -> Vec<f64> {
    let State { q, v, .. } = state;
    let (mut a, mut lambda, mut bias) = (model.zero_v(), model.zero_lambda(), model.zero_conditions());
    model.acceleration(time, state, u, &mut a, &mut lambda);
    model.condition_bias(time, q, v, &mut bias);
    let outputs = model.outputs(time, state, u).to_array();
    let internal = internal(model, time, state, u);
    [rates(model, time, q, &a, &bias).as_slice(), &internal, outputs.as_slice()].concat()
}

/// A, B, C and D against differences of the constrained motion in its independent coordinates.
fn state_matrices_are_the_derivatives<M: Model + Tangent<f64>>() {
    let (_, _, model, states) = walk::<M>(51, STATES);
    let f = model.states().len();
    for at in &states {
        let (time, q, v, u) = (at.time, &at.q, &at.v, &at.u);
        let found =
            linearised(&model, at).state_space().unwrap_or_else(|error| panic!("{}: {error}", model.name()));
        let (z, rate) = (coordinates(&model, time, q), velocities(&model, time, q, v));
        let by_state = |k: usize, h: f64| {
            let mut given: Vec<Motion> = z
                .iter()
                .zip(&rate)
                .map(|(position, rate)| Motion { position: *position, rate: *rate, acceleration: 0.0 })
                .collect();
            let mut internal = at.z;
            if k < f {
                given[k].position += h
            } else if k < 2 * f {
                given[k - f].rate += h
            } else {
                internal.as_mut_slice()[k - 2 * f] += h
            }
            let moved =
                model.kinematics(time, q, &given).unwrap_or_else(|error| panic!("{}: {error}", model.name()));
            motion(&model, time, &State { z: internal, ..at.at(moved.q, moved.v) }, u)
        };
        let outputs = M::Outputs::NAMES.len();
        let column = |matrix: &[f64], rows: std::ops::Range<usize>, width: usize, k: usize| -> Vec<f64> {
            rows.map(|row| matrix[row * width + k]).collect()
        };
        let size = 2 * f + model.internal_count();
        for k in 0..size {
            let mut entries = column(found.a.as_slice(), f..size, size, k);
            entries.extend(column(found.c.as_slice(), 0..outputs, size, k));
            let expected = derivative_over(2e-4, |h| by_state(k, h));
            assert_close(&format!("{}: A and C, column {k}", model.name()), &entries, &expected, 2e-6);
            let upper: Vec<f64> = (0..f).map(|row| if k == f + row { 1.0 } else { 0.0 }).collect();
            assert_eq!(column(found.a.as_slice(), 0..f, size, k), upper);
        }
        let inputs = M::Inputs::NAMES.len();
        for k in 0..inputs {
            let mut entries = column(found.b.as_slice(), f..size, inputs, k);
            entries.extend(column(found.d.as_slice(), 0..outputs, inputs, k));
            let expected = derivative_over(2e-4, |h| motion(&model, time, &at.state(), &input::<M>(u, k, h)));
            assert_close(&format!("{}: B and D, column {k}", model.name()), &entries, &expected, 2e-6);
            assert!(column(found.b.as_slice(), 0..f, inputs, k).iter().all(|entry| *entry == 0.0));
        }
    }
}

#[test]
fn state_matrices_belong_to_the_independent_coordinates() {
    state_matrices_are_the_derivatives::<Gripper>();
    state_matrices_are_the_derivatives::<Winch>();
    state_matrices_are_the_derivatives::<Rocker>();
    state_matrices_are_the_derivatives::<Swing>();
    state_matrices_are_the_derivatives::<Spring>();
    state_matrices_are_the_derivatives::<Servo>();
}

/// What the two positions q and q ⊕ δ differ by, to first order.
fn difference<M: Model>(q: &M::Q, other: &M::Q) -> M::V {
    let model = M::standard();
    let layout = model.layout();
    assert!(layout.rotations == 0 && layout.angles.is_empty());
    let (mut delta, q, other) = (model.zero_v(), q.as_slice(), other.as_slice());
    for k in 0..layout.linear {
        delta.as_mut_slice()[k] = other[k] - q[k];
    }
    for b in 0..layout.quaternions {
        let part = |q: &[f64]| <[f64; 4]>::try_from(&q[layout.linear + 4 * b..][..4]).expect("four entries");
        let [w, x, y, z] = part(q);
        let [_, turned @ ..] = linkwright::quaternion::product([w, -x, -y, -z], part(other));
        for (k, half) in turned.iter().enumerate() {
            delta.as_mut_slice()[layout.linear + 3 * b + k] = 2.0 * half;
        }
    }
    delta
}

/// Where states are components of ω: (B δq, δ(B v)) of neighbouring motions moves as A says.
fn state_matrices_move_neighbouring_motions<M: Model + Tangent<f64>>(rates_among_states: usize) {
    let (_, _, model, states) = walk::<M>(52, STATES);
    let (f, n) = (model.states().len(), model.velocity_count());
    let kind = |state: &&u16| model.conditions()[**state as usize].kind == ConditionKind::Rate;
    assert_eq!(model.states().iter().filter(kind).count(), rates_among_states);
    for at in &states {
        let found = linearised(&model, at).state_space().expect("a regular position");
        // The motion through a state, to second order.
        let ahead = |q: &M::Q, v: &M::V, h: f64| {
            let a: M::V = vector(&solved(&model, at.time, &at.at(*q, *v), &at.u)[..n]);
            (moved(&model, q, &v.scaled(h).plus(h * h / 2.0, &a)), v.plus(h, &a))
        };
        for k in 0..2 * n {
            let epsilon = 1e-5;
            let near = |sign: f64| {
                let wish =
                    at.v.plus(1.0, &along(model.zero_v(), k % n, if k < n { 0.0 } else { sign * epsilon }));
                let q = moved(
                    &model,
                    &at.q,
                    &along(model.zero_v(), k % n, if k < n { sign * epsilon } else { 0.0 }),
                );
                let q = project_position(&model, at.time, &q).expect("near");
                (q, project_velocity(&model, at.time, &q, &wish).expect("near"))
            };
            let (more, less) = (near(1.0), near(-1.0));
            let x = |h: f64| -> Vec<f64> {
                let (q, _) = ahead(&at.q, &at.v, h);
                let (more, less) = (ahead(&more.0, &more.1, h), ahead(&less.0, &less.1, h));
                let apart = difference::<M>(&q, &more.0).plus(-1.0, &difference::<M>(&q, &less.0));
                let first = rates(&model, at.time, &q, &apart, &model.zero_conditions());
                let second = velocities(&model, at.time, &more.0, &more.1);
                let third = velocities(&model, at.time, &less.0, &less.1);
                let second = second.iter().zip(&third).map(|(more, less)| more - less);
                first.into_iter().chain(second).map(|entry| entry / (2.0 * epsilon)).collect()
            };
            let (here, expected) = (x(0.0), derivative_over(1e-3, x));
            let row = |row: usize| (0..2 * f).map(|j| found.a.as_slice()[row * 2 * f + j] * here[j]).sum();
            let product: Vec<f64> = (0..2 * f).map(row).collect();
            assert_close(&format!("{}: direction {k}", model.name()), &product, &expected, 1e-5);
        }
    }
}

#[test]
fn state_matrices_belong_to_rates_without_coordinates() {
    state_matrices_move_neighbouring_motions::<Buoy>(6);
    state_matrices_move_neighbouring_motions::<Flail>(2);
}

/// From a position some way off, also off the constraints: r = 0 and Φ = 0 at rest.
fn equilibria_balance<M: Model + Tangent<f64>>() {
    let (_, _, model, states) = walk::<M>(53, 1);
    let mut random = Random::new(54);
    let at = &states[0];
    let u: M::Inputs = fields(&random.vector(M::Inputs::NAMES.len()));
    let near =
        equilibrium(&model, at.time, &at.q, &u).unwrap_or_else(|error| panic!("{}: {error}", model.name()));
    for _ in 0..STATES {
        let away: M::V = vector(&random.vector(model.velocity_count()));
        let from = moved(&model, &near.q, &away.scaled(0.05));
        let found = equilibrium(&model, at.time, &from, &u)
            .unwrap_or_else(|error| panic!("{}: {error}", model.name()));
        let (rest, mut residual, mut phi) = (model.zero_v(), model.zero_v(), model.zero_lambda());
        let state = State { z: found.z, ..at.at(found.q, rest) };
        model.residual(at.time, &state, &u, &rest, &found.lambda, &mut residual);
        let mut rates = model.zero_z();
        model.internal_rates(at.time, &state, &u, &rest, &found.lambda, &mut rates);
        assert!(rates.max_abs() < 1e-9, "{}: {rates:?}", model.name());
        model.constraints(at.time, &found.q, &mut phi);
        let size = 1.0 + found.lambda.max_abs();
        assert!(residual.max_abs() < 1e-11 * size, "{}: {residual:?}", model.name());
        assert!(phi.max_abs() < 1e-12, "{}: {phi:?}", model.name());
        assert!(found.iterations < 20, "{}: {} iterations", model.name(), found.iterations);
        // v̇ is zero there, and so is the linearised motion's start.
        if !["Winch", "Servo"].contains(&model.name()) {
            let still = solved(&model, at.time, &state, &u);
            let largest = still[..model.velocity_count()]
                .iter()
                .fold(0.0, |largest, entry| f64::max(largest, entry.abs()));
            assert!(largest < 1e-9 * size, "{}: v̇ {largest:e}", model.name());
        }
    }
}

/// k (θ − θ₀) + ½ m g L cos θ = τ, by bisection.
#[test]
fn a_bar_on_a_torsion_spring_hangs_where_its_moments_balance() {
    let model = Spring::<f64>::default();
    for drive in [-3.0, 0.0, 4.0] {
        let moment = |angle: f64| 5.0 * (angle - 0.5) + 2.0 * 9.81 * 0.3 * angle.cos() - drive;
        let (mut low, mut high) = (-3.0, 3.0);
        for _ in 0..100 {
            let middle = 0.5 * (low + high);
            if moment(middle) > 0.0 { high = middle } else { low = middle }
        }
        let found =
            equilibrium(&model, 0.0, &Spring::START.q, &SpringInputs { drive }).expect("there is one");
        let angle = model.outputs(0.0, &State::new(found.q, [0.0]), &SpringInputs { drive }).angle;
        // Of several roots any.
        assert!(moment(angle).abs() < 1e-12, "{drive}: {angle}");
        assert!((angle - low).abs() < 1e-12, "{drive}: {angle} {low}");
        // The stiffness about it: ω² = (k − ½ m g L sin θ)/(m L²/3).
        let at = State::new(found.q, [0.0]);
        let here = Linearisation::at(&model, 0.0, &at, &SpringInputs { drive }).expect("a mass");
        let a = here.state_space().expect("one coordinate").a;
        let stiffness = 5.0 - 2.0 * 9.81 * 0.3 * angle.sin();
        assert_close("A", &a, &[0.0, 1.0, -stiffness / (2.0 * 0.36 / 3.0), 0.0], 1e-12);
    }
}

/// A loop with springs stands where its energy has no slope, and its A is the energy's curvature over the inertia.
#[test]
fn a_four_bar_stands_where_its_energy_has_no_slope() {
    let model = Gripper::<f64>::default();
    let u = GripperInputs { drive: 0.0, pull: 0.0 };
    let found = equilibrium(&model, 0.0, &Gripper::START.q, &u).expect("a spring holds it");
    let angle = coordinates(&model, 0.0, &found.q)[0];
    let given = |position: f64, rate: f64| {
        let given = [Motion { position, rate, acceleration: 0.0 }];
        model.kinematics(0.0, &found.q, &given).expect("near")
    };
    let energy = |h: f64| vec![model.potential_energy(0.0, &given(angle + h, 0.0).state())];
    let slope = derivative_over(1e-3, energy)[0];
    assert!(slope.abs() < 1e-9, "{slope}");
    let curvature = derivative_over(1e-3, |h| derivative_over(1e-3, |k| energy(h + k)))[0];
    let moving = given(angle, 1.0);
    let inertia = 2.0 * model.kinetic_energy(0.0, &moving.q, &moving.v);
    let at = State::new(found.q, moving.v.scaled(0.0));
    let a =
        Linearisation::at(&model, 0.0, &at, &u).expect("regular").state_space().expect("one coordinate").a;
    assert_close("A", &a, &[0.0, 1.0, -curvature / inertia, -0.2 / inertia], 1e-6);
}

/// What a search for an equilibrium cannot find it says, with the numbers.
#[test]
fn without_an_equilibrium_there_is_an_error() {
    let model = Bar::<f64>::default();
    let inputs = |drive: f64| crate::zoo_tangent::BarInputs { drive };
    // ½ m g L = 5.886 is the most that weight resists.
    assert!(equilibrium(&model, 0.0, &Bar::START.q, &inputs(5.8)).is_ok());
    let error = equilibrium(&model, 0.0, &Bar::START.q, &inputs(8.0)).expect_err("too much");
    let text = error.to_string();
    assert!(
        matches!(error, LinearisationError::NoEquilibrium { .. } | LinearisationError::Indifferent { .. }),
        "{text}"
    );
    assert!(text.contains("pin.rate") || text.contains("bar.rate"), "{text}");
    let nowhere = [0.0, 0.0];
    let error = equilibrium(&model, 0.0, &nowhere, &inputs(0.0)).expect_err("no orientation");
    assert!(matches!(error, LinearisationError::Assembly(_)), "{error}");
    let error = equilibrium(&model, 0.0, &Bar::START.q, &inputs(f64::NAN)).expect_err("not a number");
    assert!(matches!(error, LinearisationError::NonFinite { .. }), "{error}");
}

/// The accelerations that some inputs give ask for inputs that give these accelerations: the same where each acts along a
/// freedom of its own.
fn actuation_undoes_the_motion<M: Model + Tangent<f64>>() {
    let (_, _, model, states) = walk::<M>(55, STATES);
    let f = model.states().len();
    for at in &states {
        let a: M::V = vector(&solved(&model, at.time, &at.state(), &at.u)[..model.velocity_count()]);
        let found = match actuation(&model, at.time, &at.state(), &a, &at.u, M::Inputs::NAMES) {
            Ok(found) => found,
            // A voltage moves a current, not a mass.
            Err(LinearisationError::Unactuated { .. }) if model.internal_count() > 0 => continue,
            Err(error) => panic!("{}: {error}", model.name()),
        };
        let mut residual = model.zero_v();
        model.residual(at.time, &at.state(), &found.inputs, &a, &found.lambda, &mut residual);
        let size = 1.0 + found.lambda.max_abs() + a.max_abs();
        assert!(residual.max_abs() < 1e-9 * size, "{}: {residual:?}", model.name());
        let (given, found) = (at.u.to_array(), found.inputs.to_array());
        let (given, found) = (given.as_slice(), found.as_slice());
        // Of a voltage that only moves a current the least is zero.
        if given.len() <= f && model.internal_count() == 0 {
            assert_close(model.name(), found, given, 1e-8);
        }
        // The least of all: what was given differs from it by what is orthogonal to it.
        let off: f64 = given.iter().zip(found).map(|(given, found)| (given - found) * found).sum();
        assert!(off.abs() < 1e-9, "{}: {off:e}", model.name());
    }
}

#[test]
fn what_actuators_cannot_do_they_say() {
    let (_, _, model, states) = walk::<Gripper>(56, 1);
    let at = &states[0];
    let count = <Gripper>::default().velocity_names().len();
    let a: <Gripper as Variables<f64>>::V = vector(&solved(&model, at.time, &at.state(), &at.u)[..count]);
    let with = |a, names: &[&'static str]| actuation(&model, at.time, &at.state(), a, &at.u, names);
    // One of two: the other stays as given.
    let alone = with(&a, &["drive"]).expect("it acts along the freedom").inputs;
    assert!((alone.drive - at.u.drive).abs() < 1e-9 && alone.pull == at.u.pull);
    let error = with(&a, &["drvie"]).expect_err("no such input");
    assert_eq!(error.to_string(), "there is no input `drvie`; name some of `drive` `pull`");
    let off = a.plus(1.0, &along(model.zero_v(), 0, 3.0));
    let error = with(&off, &["drive"]).expect_err("off the constraints");
    assert!(matches!(error, LinearisationError::Inconsistent { .. }), "{error}");
    // None acts.
    let none = GripperInputs { drive: 0.0, pull: 0.0 };
    let error =
        actuation(&model, at.time, &at.state(), &a, &none, &[]).expect_err("the inputs were not zero");
    let LinearisationError::Unactuated { missing, actuators: 0, coordinate } = error else {
        panic!("{error}")
    };
    assert!(missing != 0.0 && coordinate == "a.angle", "{error}");

    let (_, _, model, states) = walk::<Buoy>(57, 1);
    let at = &states[0];
    let a: [f64; 9] = vector(&solved(&model, at.time, &at.state(), &at.u)[..9]);
    let more = a.plus(1.0, &along(model.zero_v(), 4, 0.5));
    let error =
        actuation(&model, at.time, &at.state(), &more, &at.u, &["push", "twist"]).expect_err("two for nine");
    assert!(matches!(error, LinearisationError::Unactuated { actuators: 2, .. }), "{error}");
}

/// Of all links in one line the constraints lose rank, and nothing can be linearised.
#[test]
fn a_dead_centre_is_an_error() {
    let model = Swing::<f64>::default();
    let names = model.position_names();
    let value = |name: &&str| match *name {
        "one.center.x" => 0.5,
        "two.center.x" => 1.5,
        "three.center.x" => 2.5,
        "table.center.x" => 2.0,
        name if name.ends_with("cos") => 1.0,
        _ => 0.0,
    };
    let q = vector(&names.iter().map(value).collect::<Vec<_>>());
    let state = State::new(q, Swing::START.v.scaled(0.0));
    let u = fields(&[1.0, 2.0]);
    let Err(error) = Linearisation::at(&model, 0.0, &state, &u) else { panic!("rank is lost") };
    let LinearisationError::Breakdown { row, pivot, .. } = error else { panic!("{error}") };
    assert!(pivot < 1e-14 && ["x", "y"].contains(&row.what), "{error}");
}
