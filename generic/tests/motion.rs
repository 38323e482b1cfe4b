//! Motions of the generic solver: closed forms, energy, drift, and the emitted code's own runs.

use linkwright::{
    Assemble, AssembleExt, Baumgarte, Fields, Mechanism as _, Report, Simulation, StateOf, Vector,
};
use linkwright_generic::{Algebra, BodyMotion, Error, Formulation, Mechanism, State};
use linkwright_models::bricard::Bricard;
use linkwright_models::double_pendulum::DoublePendulum;
use linkwright_models::free_rigid_body::FreeRigidBody;
use linkwright_models::general_four_bar::{GeneralFourBar, ParametricFourBar};
use linkwright_models::planetary_gear_train::PlanetaryGearTrain;
use linkwright_models::simple_pendulum::SimplePendulum;
use linkwright_models::spatial_pendulums::ScrewPendulum;

mod mapping;

/// The start of an emitted model.
fn start<M: Assemble<f64> + Report<f64>>(model: &M, mechanism: &Mechanism) -> State {
    let motions = mapping::bodies(model, 0.0, &model.start(), &model.zero_v(), &mut Vec::new());
    mapping::state(mechanism, &motions, model.start().z.as_slice())
}

fn rebuilt(definition: &str) -> Mechanism {
    Mechanism::from_definition(definition).expect("a definition that is there")
}

/// The largest difference of velocities and positions of all bodies, after both have run for `steps` steps.
fn apart<M>(model: &M, definition: &str, step: f64, steps: usize) -> f64
where
    M: Assemble<f64> + Report<f64>,
    M::Inputs: Fields<f64>,
{
    let mut mechanism = rebuilt(definition);
    let mut state = start(model, &mechanism);
    mechanism.keep_phases(0.0, &state.q).expect("a position");
    let none = vec![0.0; M::Inputs::NAMES.len()];
    let end = mechanism
        .simulate(0.0, &mut state, |_, _| none.clone(), Formulation::Projected, step, steps)
        .expect("a regular motion");
    let given = |_: f64, _: &StateOf<M>| M::Inputs::from_array(Vector::zeros(M::Inputs::NAMES.len()));
    let mut simulation = Simulation::new(model, model.start())
        .formulation(Baumgarte { alpha: 20.0, beta: 20.0 })
        .sampled(given)
        .step(0.5 * step);
    let emitted = simulation.advance_until(end).expect("a regular motion");
    let motions = mapping::bodies(model, end, &emitted, &model.zero_v(), &mut Vec::new());
    let rest = vec![0.0; state.v.len()];
    let names: Vec<String> = mechanism.bodies().map(str::to_string).collect();
    let mut worst = 0.0_f64;
    for (body, motion) in names.iter().zip(&motions) {
        let found = mechanism.body(body, &state, &rest).expect("a body");
        let pairs =
            [(found.position, motion.position), (found.velocity, motion.velocity), (found.rate, motion.rate)];
        for (found, expected) in pairs.into_iter().flat_map(|(a, b)| a.into_iter().zip(b)) {
            worst = worst.max((found - expected).abs() / (1.0 + expected.abs()));
        }
    }
    worst
}

#[test]
fn motions_are_those_of_the_emitted_code() {
    let worst = [
        apart(&DoublePendulum::default(), DoublePendulum::<f64>::DEFINITION, 2e-3, 60),
        apart(&GeneralFourBar::default(), GeneralFourBar::<f64>::DEFINITION, 2e-3, 60),
        apart(&PlanetaryGearTrain::default(), PlanetaryGearTrain::<f64>::DEFINITION, 2e-3, 60),
        apart(&ScrewPendulum::default(), ScrewPendulum::<f64>::DEFINITION, 2e-3, 60),
        apart(&Bricard::default(), Bricard::<f64>::DEFINITION, 2e-3, 15),
    ];
    assert!(worst.iter().all(|worst| *worst < 1e-7), "{worst:?}");
}

/// From level and at rest a pendulum of reduced length l is at the bottom after K(1/√2) √(l/g), K(1/√2) = 1.8540746773013719.
#[test]
fn a_pendulum_takes_a_quarter_of_its_period() {
    let mut pendulum = rebuilt(SimplePendulum::<f64>::DEFINITION);
    let model = SimplePendulum::<f64>::default();
    let mut state = start(&model, &pendulum);
    let body = pendulum.bodies().next().expect("a body").to_string();
    let first = pendulum.body(&body, &state, &vec![0.0; state.v.len()]).expect("a body");
    // ω̇ at the level gives g/l.
    let level = BodyMotion { velocity: [0.0; 3], rate: [0.0; 3], ..first };
    pendulum.set_body(&mut state, &body, &level).expect("a body");
    let (mut a, mut lambda) = (vec![0.0; pendulum.velocity_count()], vec![0.0; pendulum.row_count()]);
    let solve = Formulation::Lagrange;
    pendulum.acceleration(0.0, &state.q, &state.v, &[], solve, &mut a, &mut lambda).expect("regular");
    let motion = pendulum.body(&body, &state, &a).expect("a body");
    let [x, y] = [motion.position[0], motion.position[1]];
    let radius = x.hypot(y);
    let [ax, ay] = [motion.acceleration[0], motion.acceleration[1]];
    let turning = (x * ay - y * ax) / (radius * radius);
    // From any angle θ above the lowest position at rest: T/4 = √(l/g) K(sin θ/2), θ̈ = −(g/l) sin θ.
    let angle = x.atan2(-y).abs();
    let ratio = turning.abs() / angle.sin();
    let quarter = complete_elliptic((angle / 2.0).sin()) / ratio.sqrt();
    let steps = 2000;
    let step = quarter / steps as f64;
    pendulum
        .simulate(0.0, &mut state, |_, _| Vec::new(), Formulation::Projected, step, steps)
        .expect("a regular motion");
    let end = pendulum.body(&body, &state, &a).expect("a body");
    assert!(end.position[0].abs() < 1e-9 && end.position[1] < 0.0, "{:?}", end.position);
}

/// K(k) by the arithmetic-geometric mean.
fn complete_elliptic(k: f64) -> f64 {
    let (mut a, mut b) = (1.0_f64, (1.0 - k * k).sqrt());
    for _ in 0..8 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    std::f64::consts::PI / (2.0 * a)
}

#[test]
fn a_four_bar_keeps_its_energy() {
    let mut mechanism = rebuilt(GeneralFourBar::<f64>::DEFINITION);
    let mut state = start(&GeneralFourBar::default(), &mechanism);
    let [kinetic, potential] = mechanism.energy(0.0, &state).expect("a state");
    let mut time = 0.0;
    for _ in 0..20 {
        time = mechanism
            .simulate(time, &mut state, |_, _| Vec::new(), Formulation::Projected, 1e-3, 100)
            .expect("a regular motion");
        let [t, v] = mechanism.energy(time, &state).expect("a state");
        let change = t + v - kinetic - potential;
        assert!(change.abs() < 1e-8 * (kinetic + potential.abs()), "{change:e} J at {time} s");
    }
}

/// At the bottom of its swing the tension of a string is λ L = m (g + v²/L), and it pulls the bob up.
#[test]
fn multipliers_are_forces() {
    let number = |text: &str| format!(r#"{{"unit": null, "value": {{"number": "{text}"}}}}"#);
    let definition = format!(
        r#"{{"linkwright": 1, "kind": "spatial", "name": "Bob",
             "gravity": {{"unit": null, "value": [{{"number": "0"}}, {{"number": "0"}}, {{"number": "-9.81"}}]}},
             "bodies": [{{"name": "bob", "kind": "particle", "properties": {{"mass": {}}}}}],
             "joints": [{{"name": "string", "kind": "cord", "second": {{"place": "bob.center"}}, "length": {},
                          "first": {{"ground": [{{"number": "0"}}, {{"number": "0"}}, {{"number": "0"}}], "unit": null}}}}]}}"#,
        number("3"),
        number("0.5")
    );
    let mut mechanism = rebuilt(&definition);
    let (q, v, mut a, mut lambda) = ([0.0, 0.0, -0.5], [2.0, 0.0, 0.0], [0.0; 3], [0.0; 1]);
    mechanism.acceleration(0.0, &q, &v, &[], Formulation::Lagrange, &mut a, &mut lambda).expect("regular");
    assert!((lambda[0] * 0.5 - 3.0 * (9.81 + 8.0)).abs() < 1e-12, "{lambda:?}");
    assert!((a[2] - 8.0).abs() < 1e-12, "{a:?}");
}

/// In space: energy and angular momentum of a body without loads.
#[test]
fn a_free_body_keeps_its_momentum() {
    let mut mechanism = rebuilt(FreeRigidBody::<f64>::DEFINITION);
    let mut state = start(&FreeRigidBody::default(), &mechanism);
    let [before, _] = mechanism.energy(0.0, &state).expect("a state");
    mechanism
        .simulate(0.0, &mut state, |_, _| Vec::new(), Formulation::Lagrange, 1e-3, 2000)
        .expect("a regular motion");
    let [after, _] = mechanism.energy(2.0, &state).expect("a state");
    assert!((after - before).abs() < 1e-9 * before, "{before} {after}");
}

/// The index-1 equations drift, Baumgarte's terms hold the drift, the projection takes it away.
#[test]
fn constraints_hold_as_the_formulation_says() {
    let residual = |formulation: Formulation| {
        let mut mechanism = rebuilt(GeneralFourBar::<f64>::DEFINITION);
        let mut state = start(&GeneralFourBar::default(), &mechanism);
        mechanism
            .simulate(0.0, &mut state, |_, _| Vec::new(), formulation, 1e-2, 300)
            .expect("a regular motion");
        mechanism.residual(3.0, &state).expect("a state")
    };
    let [plain, plain_rate] = residual(Formulation::Lagrange);
    let [held, _] = residual(Formulation::Baumgarte { alpha: 10.0, beta: 10.0 });
    let [none, none_rate] = residual(Formulation::Projected);
    println!("{plain:.1e} {plain_rate:.1e}, {held:.1e}, {none:.1e} {none_rate:.1e}");
    assert!(plain > 3.0 * held && held > 1e-10, "{plain:e} {held:e}");
    assert!(none < 1e-12 && none_rate < 1e-12, "{none:e} {none_rate:e}");
}

#[test]
fn a_state_is_put_back_on_the_constraints() {
    for definition in [GeneralFourBar::<f64>::DEFINITION, Bricard::<f64>::DEFINITION] {
        let mut mechanism = rebuilt(definition);
        let mut state = if mechanism.is_spatial() {
            start(&Bricard::default(), &mechanism)
        } else {
            start(&GeneralFourBar::default(), &mechanism)
        };
        for (k, q) in state.q.iter_mut().enumerate() {
            *q += 1e-3 * (k as f64).sin();
        }
        state.v.iter_mut().enumerate().for_each(|(k, v)| *v += (k as f64).cos());
        mechanism.project(0.0, &mut state).expect("near the constraints");
        let [phi, rate] = mechanism.residual(0.0, &state).expect("a state");
        assert!(phi < 1e-12 && rate < 1e-12, "{phi:e} {rate:e}");
    }
}

/// Drift lets rows contradict one another that repeat each other: accelerations and multipliers hardly change.
#[test]
fn redundant_rows_bear_drift() {
    for algebra in [Algebra::Dense, Algebra::Sparse] {
        let mut mechanism =
            Mechanism::with_algebra(Bricard::<f64>::DEFINITION, algebra).expect("it is there");
        let mut state = start(&Bricard::default(), &mechanism);
        let formulation = Formulation::Baumgarte { alpha: 10.0, beta: 10.0 };
        let mut solve = |state: &State| {
            let [mut a, mut lambda] = [vec![0.0; 30], vec![0.0; 30]];
            mechanism
                .acceleration(0.0, &state.q, &state.v, &[], formulation, &mut a, &mut lambda)
                .expect("a regular state");
            (a, lambda)
        };
        let (a, lambda) = solve(&state);
        state.q.iter_mut().enumerate().for_each(|(k, q)| *q += 1e-6 * (k as f64).sin());
        let (near, near_lambda) = solve(&state);
        let apart =
            |a: &[f64], b: &[f64]| a.iter().zip(b).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
        assert!(apart(&a, &near) < 1e-2, "{:e}", apart(&a, &near));
        assert!(apart(&lambda, &near_lambda) < 1e-2, "{:e}", apart(&lambda, &near_lambda));
    }
}

#[test]
fn parameters_change_the_mechanism() {
    let mut mechanism = rebuilt(ParametricFourBar::<f64>::DEFINITION);
    let model = ParametricFourBar::<f64>::default();
    let state = start(&model, &mechanism);
    let solve = |mechanism: &mut Mechanism| {
        let (mut a, mut lambda) = (vec![0.0; mechanism.velocity_count()], vec![0.0; mechanism.row_count()]);
        let formulation = Formulation::Lagrange;
        mechanism
            .acceleration(0.0, &state.q, &state.v, &[], formulation, &mut a, &mut lambda)
            .expect("regular");
        a
    };
    let before = solve(&mut mechanism);
    mechanism.set_parameter("coupler_mass", 3.0).expect("a parameter");
    let changed = solve(&mut mechanism);
    assert_ne!(before, changed);
    let mut parameters = *model.parameters();
    parameters.coupler_mass = 3.0;
    let model = ParametricFourBar::prepare(parameters).expect("a mass");
    let (mut a, mut lambda, at) = (model.zero_v(), model.zero_lambda(), model.start());
    model.acceleration(0.0, &at, &(), &mut a, &mut lambda);
    let motions = mapping::bodies(&model, 0.0, &at, &a, &mut Vec::new());
    for (k, motion) in motions.iter().enumerate() {
        assert!((changed[3 * k] - motion.acceleration[0]).abs() < 1e-10 * (1.0 + changed[3 * k].abs()));
    }
    mechanism.set_parameter("coupler_mass", 1.93).expect("a parameter");
    assert_eq!(solve(&mut mechanism), before);
}

#[test]
fn phases_are_those_of_the_start() {
    let mut mechanism = rebuilt(PlanetaryGearTrain::<f64>::DEFINITION);
    let mut state = start(&PlanetaryGearTrain::default(), &mechanism);
    let phase = mechanism.project(0.0, &mut state);
    assert!(matches!(phase, Err(Error::Phase { .. })), "{phase:?}");
    mechanism.keep_phases(0.0, &state.q).expect("a position");
    assert!(mechanism.residual(0.0, &state).expect("a state")[0] < 1e-14);
}
