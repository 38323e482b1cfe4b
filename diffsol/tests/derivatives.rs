//! Exact Jacobians against differences, and derivatives of the motion by parameters against differences of motions.

use diffsol::{
    MatrixCommon, NalgebraLU, NalgebraVec, NonLinearOp, NonLinearOpJacobian, OdeSolverMethod, Vector,
};
use linkwright::{Assemble, Baumgarte, Residual, State, StateOf, Variables as _, Vector as _, retract};
use linkwright_diffsol::{Method, Settings, diffsol, exact_problem, problem, sensitivities, solve};

linkwright::mechanism! {
    /// A four-bar with a torsion spring that counts turns, a damper and a motor.
    pub planar Loop {
        param heavy [kg] = 1 in 0.1..10;
        param reach [m] = 2 in 1.5..3;
        param stiff [N*m/rad] = 3 in 0..100;
        input drive [N*m];
        gravity [m/s^2] = (0, -9.81);
        rod crank   { mass [kg] = 1; length [m] = 1; }
        rod coupler { mass [kg] = heavy; length [m] = reach; }
        rod rocker  { mass [kg] = 1; length [m] = 1.5; }
        joint crank_pin:  revolute(ground(0, 0) [m], crank.start);
        joint rocker_pin: revolute(ground(2, 0) [m], rocker.start);
        joint left:  revolute(crank.end, coupler.start);
        joint right: revolute(coupler.end, rocker.end);
        force coil:  torsion_spring(crank_pin, stiffness [N*m/rad] = stiff, angle [rad] = 1);
        force motor: torque(crank_pin) = drive;
        start   { crank_pin.angle [deg] = 90; crank_pin.rate [rad/s] = 2; rocker_pin.angle [deg] ~ 90; }
        expect  { degrees_of_freedom = 1; }
        options { emit = (tangent); }
        output x [m] = coupler.center.x;
    }
}

linkwright::mechanism! {
    /// A body on a ball, and a second one hanging from it.
    pub spatial Balls {
        param arm [m] = 0.6 in 0.1..2;
        param load [kg] = 2 in 0.1..10;
        gravity [m/s^2] = (0, 0, -9.81);
        body upper { mass [kg] = 1; inertia [kg*m^2] = (0.1, 0.2, 0.25); center [m] = (arm/2, 0, 0);
                     point tip [m] = (arm, 0, 0); }
        body lower { mass [kg] = load; inertia [kg*m^2] = (0.3, 0.2, 0.4); center [m] = (0, 0.3, 0); }
        joint hook:  spherical(ground(0, 0, 0) [m], upper.origin);
        joint elbow: spherical(upper.tip, lower.origin);
        start   { upper.orientation = (1, 0, 0, 0); lower.orientation = (1, 0, 0, 0);
                  upper.rate.x [rad/s] = 1; upper.rate.y [rad/s] = 0; upper.rate.z [rad/s] = 2;
                  lower.rate.x [rad/s] = 0; lower.rate.y [rad/s] = -1; lower.rate.z [rad/s] = 0.5; }
        expect  { degrees_of_freedom = 6; }
        options { emit = (tangent); coordinates = absolute; }
        output z [m] = lower.center.z;
    }
}

/// A motor that brakes.
fn drive(time: f64, state: &State<[f64; Loop::START.q.len()], [f64; Loop::START.v.len()]>) -> LoopInputs {
    LoopInputs { drive: (3.0 * time).sin() - 0.4 * state.v[0] }
}

const STIFF: Settings = Settings {
    relative: 1e-10,
    absolute: 1e-10,
    baumgarte: Baumgarte { alpha: 5.0, beta: 7.0 },
    length_rate: 3.0,
    most_steps: 100_000,
    accept_inconsistent_start: false,
};

/// The matrices of both kinds agree, and each with products; off unit lengths and off the constraints too.
macro_rules! jacobians_agree {
    ($model:expr, $start:expr, $inputs:expr) => {{
        let (model, start) = ($model, $start);
        let exact = exact_problem(&model, 0.2, &start, $inputs, &STIFF).expect("a problem");
        let plain = problem(&model, 0.2, &start, $inputs, &STIFF).expect("a problem");
        let mut y = exact.eqn().entries(&start).clone_as_vec();
        for (index, entry) in y.iter_mut().enumerate() {
            *entry += 0.03 * (1.7 * index as f64).sin();
        }
        let y = NalgebraVec::from_vec(y, Default::default());
        let (a, b) = (exact.eqn().jacobian(&y, 0.2), plain.eqn().jacobian(&y, 0.2));
        let n = y.len();
        let along = NalgebraVec::from_vec((0..n).map(|i| (i as f64).cos()).collect(), Default::default());
        let product = exact.eqn().jac_mul(&y, 0.2, &along).clone_as_vec();
        for row in 0..n {
            let sum: f64 = (0..n).map(|column| a[(row, column)] * (column as f64).cos()).sum();
            assert!((sum - product[row]).abs() < 1e-8 * (1.0 + sum.abs()), "{row}: {sum} {}", product[row]);
            for column in 0..n {
                let (x, z) = (a[(row, column)], b[(row, column)]);
                assert!((x - z).abs() < 1e-6 * (1.0 + x.abs()), "({row}, {column}): {x} {z}");
            }
        }
        // Without angles that are counted, also the plain partial derivatives of F.
        if y.len() == start.q.len() + start.v.len() {
            for column in 0..n {
                let at = |h: f64| {
                    let mut moved = y.clone_as_vec();
                    moved[column] += h;
                    let moved = NalgebraVec::from_vec(moved, Default::default());
                    exact.eqn().call(&moved, 0.2).clone_as_vec()
                };
                let (before, after) = (at(-1e-6), at(1e-6));
                for row in 0..n {
                    let z = (after[row] - before[row]) / 2e-6;
                    let x = a[(row, column)];
                    assert!((x - z).abs() < 1e-6 * (1.0 + x.abs()), "({row}, {column}): {x} {z}");
                }
            }
        }
    }};
}

#[test]
fn jacobians_of_a_loop() {
    assert_eq!(<Loop>::default().layout().angles.len(), 1);
    jacobians_agree!(Loop::default(), Loop::START, drive);
}

#[test]
fn jacobians_of_balls() {
    jacobians_agree!(Balls::default(), Balls::START, |_, _| ());
}

/// The state on the constraints of `model` that is nearest to `state` in the norm of M.
fn nearest<M: Assemble<f64>>(model: &M, state: StateOf<M>) -> StateOf<M> {
    let State { mut q, mut v, .. } = state;
    for _ in 0..20 {
        let (mut store, mut phi) = (model.store(), model.zero_lambda());
        model.factor(0.0, &q, 0.0, &mut store);
        model.constraints(0.0, &q, &mut phi);
        let (mut delta, mut lambda, from) = (model.zero_v(), model.zero_lambda(), q.clone());
        model.solve(&store, &model.zero_v(), &phi.scaled(-1.0), &mut delta, &mut lambda);
        retract(model.layout(), &from, &delta, &mut q);
        let mut rest = model.zero_lambda();
        let mut jacobian = model.zero_jacobian();
        model.constraint_jacobian(0.0, &q, &mut jacobian);
        model.nu(0.0, &q, &mut rest);
        for (&(row, column), entry) in model.jacobian_pattern().iter().zip(jacobian.as_slice()) {
            rest.as_mut_slice()[row as usize] -= entry * v.as_slice()[column as usize];
        }
        model.factor(0.0, &q, 0.0, &mut store);
        model.solve(&store, &model.zero_v(), &rest, &mut delta, &mut lambda);
        v.axpy(1.0, &delta);
    }
    let state = State { q, v, z: state.z, gates: state.gates };
    let residual = Residual::of(model, 0.0, &state);
    assert!(residual.position < 1e-13 && residual.velocity < 1e-12);
    state
}

const H: f64 = 1e-4;
const METHODS: [Method; 2] = [Method::Bdf, Method::Tsit45];

/// Derivatives by the parameter `index` against those of motions that begin nearby, with what an increment does to q.
macro_rules! sensitivities_agree {
    ($model:ident, $parameters:expr, $change:expr, $index:expr, $inputs:expr) => {{
        let times = [0.0, 0.2, 0.5];
        let model = $model::prepare($parameters).expect("parameters");
        let exact = exact_problem(&model, 0.0, &$model::START, $inputs, &STIFF).expect("a problem");
        let moved = |h: f64| {
            let mut parameters = $parameters;
            $change(&mut parameters, h);
            let model = $model::prepare(parameters).expect("parameters");
            let start = nearest(&model, $model::START);
            let problem = exact_problem(&model, 0.0, &start, $inputs, &STIFF).expect("a problem");
            solve(&problem, Method::Tsit45, &times).expect("it moves")
        };
        let (before, after) = (moved(-H), moved(H));
        for method in METHODS {
            let (states, derivatives) = sensitivities(&exact, method, &times).expect("it moves");
            for k in 0..times.len() {
                let by = derivatives[k][$index];
                let mut expected = [states[k].q; 2];
                for (h, q) in [-H, H].into_iter().zip(&mut expected) {
                    retract(<$model>::default().layout(), &states[k].q, &by.q.scaled(h), q);
                }
                let mut worst = 0.0_f64;
                for i in 0..states[k].q.len() {
                    let found = (expected[1][i] - expected[0][i]) / (2.0 * H);
                    let reference = (after[k].q[i] - before[k].q[i]) / (2.0 * H);
                    worst = worst.max((found - reference).abs() / (1.0 + reference.abs()));
                }
                for i in 0..states[k].v.len() {
                    let reference = (after[k].v[i] - before[k].v[i]) / (2.0 * H);
                    worst = worst.max((by.v[i] - reference).abs() / (1.0 + reference.abs()));
                }
                println!(
                    "{} by parameter {} {method:?} at {}: {worst:.1e}",
                    stringify!($model),
                    $index,
                    times[k]
                );
                assert!(worst < 1e-6, "{method:?} at {}: {worst:.1e}", times[k]);
            }
        }
    }};
}

#[test]
fn sensitivities_of_a_loop() {
    let p = LoopParameters { heavy: 1.5, reach: 2.0, stiff: 3.0 };
    sensitivities_agree!(Loop, p, |p: &mut LoopParameters, h| p.heavy += h, 0, drive);
    sensitivities_agree!(Loop, p, |p: &mut LoopParameters, h| p.reach += h, 1, drive);
    sensitivities_agree!(Loop, p, |p: &mut LoopParameters, h| p.stiff += h, 2, drive);
}

#[test]
fn sensitivities_of_balls() {
    let p = BallsParameters { arm: 0.6, load: 2.0 };
    sensitivities_agree!(Balls, p, |p: &mut BallsParameters, h| p.arm += h, 0, |_, _| ());
    sensitivities_agree!(Balls, p, |p: &mut BallsParameters, h| p.load += h, 1, |_, _| ());
}

/// All four methods carry derivatives along.
#[test]
fn all_methods_carry_sensitivities() {
    let model = Loop::default();
    let settings = Settings { relative: 1e-7, absolute: 1e-7, ..STIFF };
    let exact = exact_problem(&model, 0.0, &Loop::START, drive, &settings).expect("a problem");
    let (_, expected) = sensitivities(&exact, Method::Tsit45, &[0.5]).expect("it moves");
    for method in [Method::Bdf, Method::TrBdf2, Method::Esdirk34] {
        let (_, found) = sensitivities(&exact, method, &[0.5]).expect("it moves");
        assert_eq!(found[0].len(), 3);
        for (found, expected) in found[0].iter().zip(&expected[0]) {
            let apart =
                found.q.plus(-1.0, &expected.q).max_abs().max(found.v.plus(-1.0, &expected.v).max_abs());
            println!("{method:?}: {apart:.1e}");
            assert!(apart < 1e-3, "{method:?}: {apart:.1e}");
        }
    }
}

/// All four methods solve with exact Jacobians, and a problem serves diffsol's own interface.
#[test]
fn exact_and_plain_problems_move_alike() {
    let model = Loop::default();
    let settings = Settings { relative: 1e-7, absolute: 1e-7, ..STIFF };
    let exact = exact_problem(&model, 0.0, &Loop::START, drive, &settings).expect("a problem");
    let plain = problem(&model, 0.0, &Loop::START, drive, &settings).expect("a problem");
    for method in [Method::Bdf, Method::TrBdf2, Method::Esdirk34, Method::Tsit45] {
        let [a, b] = [
            solve(&exact, method, &[0.5]).expect("it moves")[0],
            solve(&plain, method, &[0.5]).expect("it moves")[0],
        ];
        for (x, y) in a.q.iter().chain(&a.v).zip(b.q.iter().chain(&b.v)) {
            assert!((x - y).abs() < 1e-4, "{method:?}: {x} {y}");
        }
    }
    let mut solver = exact.bdf::<NalgebraLU<f64>>().expect("a solver");
    let (y, _) = solver.solve(0.5).map(|(all, _, reason)| (all, reason)).expect("it moves");
    assert_eq!(y.nrows(), exact.eqn().entries(&Loop::START).len());
    let state = exact.eqn().state(solver.state().y).expect("as many entries");
    assert!(Residual::of(&model, 0.5, &state).position < 1e-5);
    assert!(exact.eqn().state(&NalgebraVec::zeros(3, Default::default())).is_none());
}
