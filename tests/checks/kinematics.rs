//! Assembly at run time: changed parameters, given motions of the independent coordinates, and the typed errors of
//! both and of `prepare`.

use crate::identities::{derivative_over, row_rates, slopes_of};
use crate::registry::{Model, for_each};
use crate::walking::walk;
use linkwright::{
    Assemble, AssembleExt, AssemblyError, Condition, ConditionKind, Kinematics, Mechanism, Motion, Residual,
    State, Variables, Vector, retract,
};
use linkwright_compiler::model::Space;
use linkwright_models::change_point_four_bar::ChangePointFourBar;
use linkwright_models::four_bar::FourBar;
use linkwright_models::general_four_bar::{ParametricFourBar, ParametricFourBarParameters};

type Parameters = ParametricFourBarParameters;

fn near() -> State<<ParametricFourBar as Variables<f64>>::Q, <ParametricFourBar as Variables<f64>>::V> {
    ParametricFourBar::START
}

/// With other lengths and another start the loop is closed anew, at the angle and rate that `start` states.
#[test]
fn changed_parameters_are_assembled() {
    for (length, degrees) in [(0.4, 40.0), (0.35, 55.0), (0.5, 20.0), (0.42, 170.0), (0.3, -100.0)] {
        let start_angle = f64::to_radians(degrees);
        let parameters =
            Parameters { crank_length: length, start_angle, start_rate: -2.0, ..Parameters::default() };
        let model = ParametricFourBar::prepare(parameters).expect("possible parameters");
        let state = model.assemble(&near()).unwrap_or_else(|error| panic!("{length} m, {degrees}°: {error}"));
        let residual = Residual::of(&model, 0.0, &state);
        assert!(residual.position < 1e-13 && residual.velocity < 1e-13, "{residual:?}");
        let [crank, coupler, rocker] = model.motions(0.0, &state.q, &state.v, &model.zero_v());
        let off = (crank.orientation[1].atan2(crank.orientation[0]) - start_angle).sin();
        assert!(off.abs() < 1e-13 && (crank.rate + 2.0).abs() < 1e-12, "{off} {}", crank.rate);
        // The tip of the crank, where the coupler begins, by the lengths that were asked for.
        let tip = crank.point([length - 0.17, -0.033]);
        let begin = coupler.point([-0.43, 0.12]);
        let (end, far) = (coupler.point([0.57, 0.12]), rocker.point([0.38, -0.071]));
        for (a, b) in [(tip, begin), (end, far)] {
            assert!((a[0] - b[0]).hypot(a[1] - b[1]) < 1e-13, "{a:?} {b:?}");
        }
    }
}

/// Defaults assemble to the state that was computed at expansion.
#[test]
fn the_start_is_found_again() {
    // From beside it: every body turned by a twentieth of a radian or more, at rest.
    let mut beside = near();
    retract(<ParametricFourBar>::default().layout(), &near().q, &[0.05, -0.08, 0.11], &mut beside.q);
    beside.v = [0.0; 3];
    let state = ParametricFourBar::<f64>::default().assemble(&beside).expect("the defaults fit");
    let (off, rates_off) = (state.q.plus(-1.0, &near().q).max_abs(), state.v.plus(-1.0, &near().v).max_abs());
    assert!(off < 1e-12 && rates_off < 1e-11, "{off:e} {rates_off:e}");
}

for_each!(kinematics_follow_the_given_motion);

/// From given motions of the independent coordinates: the state they came from is found again, its position, velocities and
/// accelerations satisfy the rows, and the coordinates move as given. Where these say everything, velocities and
/// accelerations are the derivatives of the positions.
fn kinematics_follow_the_given_motion<M: Model>() {
    let (compiled, _, model, states) = walk::<M>(40, 5);
    let freedoms = compiled.assembly.mobility.generic - compiled.mechanism.drivers.len();
    let complete = model.independent().len() == freedoms;
    // An orientation in space is no coordinate that could be given.
    let balls = compiled.mechanism.space == Space::Spatial && model.independent().len() < freedoms;
    assert!(complete || balls, "{}: {freedoms} freedoms, {:?}", model.name(), model.independent());
    for at in &states {
        let values = value(&model, at.time, &at.q);
        // v̇ of no particular motion, made consistent by what `kinematics` itself asks.
        let motion = |index: usize, h: f64| {
            let (rate, acceleration) = (0.3 + 0.1 * index as f64, 0.2 - 0.1 * index as f64);
            Motion {
                position: values[index] + h * rate + h * h / 2.0 * acceleration,
                rate: rate + h * acceleration,
                acceleration,
            }
        };
        let given = |h: f64| (0..values.len()).map(|index| motion(index, h)).collect::<Vec<Motion<f64>>>();
        let solved = |h: f64| model.kinematics(at.time + h, &at.q, &given(h));
        let here = solved(0.0).unwrap_or_else(|error| panic!("{}: {error}", model.name()));
        let moved = here.q.plus(-1.0, &at.q).max_abs();
        assert!(moved < 1e-9, "{}: the state it came from is {moved} away", model.name());
        assert_followed(&model, at.time, &here, &given(0.0));

        let speed = here.v.max_abs() + here.a.max_abs().sqrt();
        let step = 2e-4 / (1.0 + speed);
        // Elsewhere, too: what is not given is then whatever is nearest.
        let there = solved(step).unwrap_or_else(|error| panic!("{} at h = {step}: {error}", model.name()));
        assert_followed(&model, at.time + step, &there, &given(step));
        if !complete {
            // Of the balls' motion nothing is said; what is taken at one time is not the derivative of what is taken before.
            continue;
        }
        // Bodies' positions and velocities as functions of time; by bodies, because q is no vector.
        let bodies = |h: f64| {
            let there = solved(h).unwrap_or_else(|error| panic!("{} at h = {h}: {error}", model.name()));
            model.flat_motions(at.time + h, &there.q, &there.v, &there.a)
        };
        let (slopes, bodies) = (derivative_over(step, bodies), bodies(0.0));
        let size = bodies.len() / model.bodies().len();
        for (body, slope) in bodies.chunks(size).zip(slopes.chunks(size)) {
            for (index, value) in slopes_of(body) {
                let (slope, tolerance) = (slope[index], 1e-5 * (1.0 + speed + value.abs()));
                assert!((slope - value).abs() < tolerance, "{} [{index}]: {slope} {value}", model.name());
            }
        }
    }
}

/// Φ = 0, D v = ν, D v̇ = γ, and the independent coordinates, their rates and second derivatives are those given.
fn assert_followed<M: Model>(model: &M, time: f64, found: &Kinematics<M::Q, M::V>, given: &[Motion<f64>]) {
    let Kinematics { q, v, a } = found;
    let residual = Residual::of(model, time, &State { q: *q, v: *v, ..model.start() });
    assert!(residual.position <= 1e-11, "{}: {residual:?}", model.name());
    assert!(residual.velocity <= 1e-10 * (1.0 + v.max_abs()), "{}: {residual:?}", model.name());
    let mut gamma = model.zero_lambda();
    model.gamma(time, q, v, &mut gamma);
    // D v̇ − ν, of which ν is taken back.
    let (asked, magnitudes) = row_rates(model, time, q, a);
    let mut nu = model.zero_lambda();
    model.nu(time, q, &mut nu);
    for (row, name) in model.rows().iter().enumerate() {
        let (found, gamma) = (asked[row] + nu.as_slice()[row], gamma.as_slice()[row]);
        let tolerance = 1e-10 * (1.0 + magnitudes[row] + gamma.abs());
        assert!((found - gamma).abs() <= tolerance, "{} {name}: D v̇ {found}, γ {gamma}", model.name());
    }

    let positions = value(model, time, q);
    let (mut jacobian, mut drift) = (model.zero_condition_jacobian(), model.zero_conditions());
    let mut bias = model.zero_conditions();
    model.condition_jacobian(time, q, &mut jacobian);
    model.condition_drift(time, q, &mut drift);
    model.condition_bias(time, q, v, &mut bias);
    for ((&index, position), given) in model.independent().iter().zip(positions).zip(given) {
        let along = |of: &M::V| -> f64 {
            let entries = model.condition_pattern().iter().zip(jacobian.as_slice());
            let own = entries.filter(|((row, _), _)| *row == index);
            own.map(|((_, column), j)| j * of.as_slice()[*column as usize]).sum()
        };
        let condition = model.conditions()[index as usize];
        let off = match condition.kind {
            ConditionKind::Angle => (position - given.position).sin(),
            ConditionKind::Linear => position - given.position,
            ConditionKind::Rate => panic!("{}: {} has no position", model.name(), condition.of),
        };
        let rate = along(v) + drift.as_slice()[index as usize] - given.rate;
        let acceleration = along(a) + bias.as_slice()[index as usize] - given.acceleration;
        let size = 1.0 + v.max_abs() + a.max_abs();
        assert!(off.abs() <= 1e-11 * (1.0 + position.abs()), "{} {}: {off:e}", model.name(), condition.of);
        assert!(rate.abs() <= 1e-10 * size, "{} {}: rate off by {rate:e}", model.name(), condition.of);
        assert!(
            acceleration.abs() <= 1e-10 * size * size,
            "{} {}: {acceleration:e}",
            model.name(),
            condition.of
        );
    }
}

/// The values of the independent coordinates at a position.
fn value<M: Model>(model: &M, time: f64, q: &M::Q) -> Vec<f64> {
    let (mut residual, mut upright) = (model.zero_conditions(), model.zero_conditions());
    model.condition_residual(time, q, &model.zero_conditions(), &mut residual);
    model.condition_cosines(time, q, &model.zero_conditions(), &mut upright);
    let value = |&index: &u16| {
        let (residual, upright) = (residual.as_slice()[index as usize], upright.as_slice()[index as usize]);
        match model.conditions()[index as usize].kind {
            ConditionKind::Angle => residual.atan2(upright),
            ConditionKind::Linear => residual,
            ConditionKind::Rate => panic!("{}: ω is no independent coordinate", model.name()),
        }
    };
    model.independent().iter().map(value).collect()
}

/// The four-bar of unit rods is a parallelogram: its rocker follows the crank, its coupler keeps level.
#[test]
fn the_parallelogram_has_a_closed_form() {
    let model = FourBar::<f64>::default();
    let Condition { of, .. } = <FourBar>::default().conditions()[0];
    assert_eq!(of, "crank_pin.angle");
    let mut near = FourBar::START.q;
    for step in 0..100 {
        let angle = 1.5 - 0.01 * f64::from(step);
        let given = [Motion { position: angle, rate: 2.0, acceleration: -3.0 }];
        let kinematics = model.kinematics(0.0, &near, &given).expect("it turns freely there");
        near = kinematics.q;
        let [crank, coupler, rocker] = model.motions(0.0, &near, &kinematics.v, &kinematics.a);
        for body in [crank, rocker] {
            let [c, s] = body.orientation;
            assert!((c - angle.cos()).abs() < 1e-13 && (s - angle.sin()).abs() < 1e-13);
            assert!((body.rate - 2.0).abs() < 1e-12 && (body.angular_acceleration + 3.0).abs() < 1e-11);
        }
        assert!(coupler.orientation[1].abs() < 1e-13 && coupler.rate.abs() < 1e-12);
    }
}

/// Parameters that are no parameters: out of bounds, not finite, masses that are none.
#[test]
fn impossible_parameters_are_named() {
    let refused = |parameters: Parameters| ParametricFourBar::prepare(parameters).expect_err("impossible");
    let default = Parameters::default();
    let cases = [
        (Parameters { crank_length: 0.0, ..default }, "crank_length", 0.0, "from 0.01 to 10.0"),
        (Parameters { crank_length: 11.0, ..default }, "crank_length", 11.0, "from 0.01 to 10.0"),
        (Parameters { gravity_x: f64::INFINITY, ..default }, "gravity_x", f64::INFINITY, "finite"),
        (Parameters { crank_mass: -1.0, ..default }, "mass of \"crank\"", -1.0, "positive"),
        (Parameters { coupler_inertia: 0.0, ..default }, "inertia of \"coupler\"", 0.0, "positive"),
    ];
    for (parameters, what, value, must_be) in cases {
        let error = refused(parameters);
        assert_eq!((error.what, error.value), (what, value));
        assert!(error.must_be.contains(must_be), "{error}");
        assert!(error.to_string().contains(what), "{error}");
    }
    let error = refused(Parameters { rocker_center_y: f64::NAN, ..default });
    assert!(error.what == "rocker_center_y" && error.value.is_nan() && error.must_be == "finite", "{error}");
    // Each finite, their product not.
    let error =
        refused(Parameters { coupler_mass: 1e300, crank_center_x: 1e200, crank_mass: 1e200, ..default });
    assert_eq!(error.what, "the parameters together");
}

/// A crank that cannot reach, too few motions, and what is no number.
#[test]
fn impossible_positions_are_named() {
    let long = Parameters { crank_length: 3.5, ..Parameters::default() };
    let model = ParametricFourBar::prepare(long).expect("each within its bounds");
    match model.assemble(&near()) {
        Err(AssemblyError::NoConvergence { residual, .. }) => assert!(residual > 0.1, "{residual}"),
        Err(AssemblyError::RankDeficient { pivot, .. }) => assert!(pivot < 1e-10, "{pivot}"),
        other => panic!("a crank of 3.5 m reaches nothing: {other:?}"),
    }

    let model = ParametricFourBar::<f64>::default();
    let error = model.kinematics(0.0, &near().q, &[]).expect_err("one motion is needed");
    assert_eq!(error, AssemblyError::WrongLength { needed: 1, given: 0 });
    let motion = Motion { position: 0.7, rate: 0.0, acceleration: 0.0 };
    let error = model.kinematics(0.0, &near().q, &[motion; 2]).expect_err("one motion is needed");
    assert_eq!(error, AssemblyError::WrongLength { needed: 1, given: 2 });
    let nan = [Motion { position: f64::NAN, ..motion }];
    let error = model.kinematics(0.0, &near().q, &nan).expect_err("NaN is no angle");
    assert_eq!(error, AssemblyError::GivenNotFinite { what: "crank_pin.angle" });
    let mut lost = near();
    lost.q[0] = f64::INFINITY;
    assert!(matches!(model.assemble(&lost), Err(AssemblyError::GivenNotFinite { .. })));
    let mut fast = near();
    fast.v[0] = f64::NAN;
    assert!(matches!(model.project(0.0, &fast), Err(AssemblyError::GivenNotFinite { .. })));
    assert_eq!(model.project(f64::NAN, &near()), Err(AssemblyError::GivenNotFinite { what: "time" }));
}

/// Beside a change point the crank determines nothing: an error that names the row; at some distance velocities are right.
#[test]
fn beside_a_change_point_kinematics_are_right_or_an_error() {
    let model = ChangePointFourBar::<f64>::default();
    // The branch on which the rods pass the line: rates at a distance converge to those at it.
    let rates = |distance: f64| {
        let mut q = ChangePointFourBar::START.q;
        let begin = std::f64::consts::FRAC_PI_2;
        let mut found = Err(AssemblyError::WrongLength { needed: 1, given: 0 });
        for step in 0..=20 {
            let position = begin + (begin - distance) * f64::from(step) / 20.0;
            found = model.kinematics(0.0, &q, &[Motion { position, rate: 4.0, acceleration: 0.0 }]);
            match found {
                Ok(found) => q = found.q,
                Err(_) => break,
            }
        }
        found.map(|found| found.v)
    };
    let limit = rates(1e-3).expect("far enough");
    for distance in [1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-12, 0.0] {
        match rates(distance) {
            Ok(v) => {
                let off = v.iter().zip(limit).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                assert!(distance >= 1e-4 && off < 0.05 * distance.max(1e-3), "{distance:e}: {v:?}");
            }
            Err(AssemblyError::RankDeficient { row, .. }) => {
                assert!(distance < 2e-4 && row.of == "right", "{distance:e}: {row}");
            }
            Err(error) => panic!("{distance:e}: {error}"),
        }
    }
    // Nothing is asked of the others where all rests.
    let rest = Motion { position: std::f64::consts::PI - 1e-6, rate: 0.0, acceleration: 0.0 };
    assert_eq!(
        model.kinematics(0.0, &ChangePointFourBar::START.q, &[rest]).map(|found| found.v),
        Ok([0.0; 3])
    );
}

linkwright::mechanism! {
    /// A pendulum that starts in its second turn.
    planar SecondTurn {
        gravity [m/s^2] = (0, -9.81);
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
        start { pivot.angle [deg] = 400; pivot.rate [rad/s] = 20; }
        output angle [rad] = pivot.angle;
        output body_angle [rad] = arm.angle;
    }
}

/// Angles among the outputs begin at the value that `start` states and go on from there.
#[test]
fn output_angles_begin_where_start_says() {
    let model = SecondTurn::<f64>::default();
    let mut simulation = linkwright::Simulation::new(&model, SecondTurn::START).step(1e-3);
    let first = simulation.sample().outputs;
    assert!((first.angle - 400_f64.to_radians()).abs() < 1e-12, "{}", first.angle);
    // The body's angle is not stated; its principal value is as good as any.
    assert!((first.body_angle - 40_f64.to_radians()).abs() < 1e-12, "{}", first.body_angle);
    simulation.run_until(1.0, |_| {}).unwrap();
    let last = simulation.sample().outputs;
    assert!(last.angle > 720_f64.to_radians(), "{}", last.angle);
    assert!((last.angle - last.body_angle - std::f64::consts::TAU).abs() < 1e-12);
}
