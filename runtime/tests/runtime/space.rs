//! Motion in space: uniform rotation, the free rigid body, the heavy top; consistent states with quaternions.

use crate::bracket::{Bracket, cross};
use core::f64::consts::TAU;
use linkwright_runtime::integrator::Dynamics;
use linkwright_runtime::quaternion::{exponential, norm, product, rotation_matrix};
use linkwright_runtime::{
    AssembleExt, AssemblyError, Derivative, Integrator, Layout, Method, MultiTurn, Real, Residual, Rk4,
    SemiImplicitEuler, Simulation, SimulationError, SpatialMotion, State, StateOf, StepFailure, Stepped,
    SteppedOf, Variables, Vector, retract, smallest_pivot,
};

const ONE_BODY: Layout = Layout { linear: 0, rotations: 0, quaternions: 1, angles: &[] };

pub type Turning = State<[f64; 4], [f64; 3]>;

/// A body about a fixed point: J ω̇ = Jω × ω + r × Aᵀ F.
pub struct Top {
    /// Principal moments about the fixed point.
    pub inertia: [f64; 3],
    /// m g r, which turns where gravity points along −z.
    pub moment: [f64; 3],
}

impl Top {
    pub fn free() -> Self {
        Top { inertia: [1.0, 2.0, 3.0], moment: [0.0; 3] }
    }

    fn spin(&self, omega: [f64; 3]) -> [f64; 3] {
        [0, 1, 2].map(|i| self.inertia[i] * omega[i])
    }

    /// A J ω, world axes.
    fn momentum(&self, state: &Turning) -> [f64; 3] {
        rotation_matrix(state.q).map(|row| row.iter().zip(self.spin(state.v)).map(|(a, l)| a * l).sum())
    }

    pub fn energy(&self, state: &Turning) -> f64 {
        let [_, _, up] = rotation_matrix(state.q);
        let kinetic: f64 = self.spin(state.v).iter().zip(state.v).map(|(l, omega)| 0.5 * l * omega).sum();
        kinetic + up.iter().zip(self.moment).map(|(a, m)| a * m).sum::<f64>()
    }
}

impl Variables<f64> for Top {
    fn layout(&self) -> &Layout<'_> {
        &ONE_BODY
    }
    type Q = [f64; 4];
    type V = [f64; 3];
    type Z = ();
    type Gates = ();
    type Lambda = [f64; 0];
}

impl Dynamics<f64> for Top {
    type Variables = Self;

    fn variables(&self) -> &Self {
        self
    }

    fn derivative(&mut self, _time: f64, state: &mut Turning) -> Derivative<[f64; 3]> {
        let gyroscopic = cross(self.spin(state.v), state.v);
        let [_, _, up] = rotation_matrix(state.q);
        let weight = cross(up, self.moment);
        let a = [0, 1, 2].map(|i| (gyroscopic[i] + weight[i]) / self.inertia[i]);
        Derivative { v: state.v, a, z: () }
    }
}

pub fn run<D: Dynamics<f64>, I: Integrator<f64, D>>(
    mut dynamics: D,
    integrator: I,
    start: StateOf<D::Variables>,
    end: f64,
    steps: u32,
) -> StateOf<D::Variables> {
    let h = end / f64::from(steps);
    let mut memory = integrator.memory();
    (0..steps).fold(start, |state, k| {
        let step = integrator.step(&mut memory, &mut dynamics, f64::from(k) * h, h, &state);
        step.expect("a fixed step").state
    })
}

/// The angle between two orientations, rad.
pub fn apart(p: [f64; 4], [w, x, y, z]: [f64; 4]) -> f64 {
    let [_, x, y, z] = product([w, -x, -y, -z], p);
    2.0 * (x * x + y * y + z * z).sqrt().asin()
}

pub fn largest(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

#[test]
fn a_quaternion_stays_on_the_sphere_for_a_million_steps() {
    let mut q = exponential([0.3, -0.2, 0.9]);
    for step in 0..1_000_000 {
        let from = q;
        let delta = 0.05 + 0.04 * f64::from(step % 101) / 101.0;
        retract(&ONE_BODY, &from, &[delta, 0.3 * delta - 0.02, -delta], &mut q);
    }
    assert!((norm(q) - 1.0).abs() < 1e-15, "{q:?}");
}

#[test]
fn a_uniform_rotation_in_space_is_exact() {
    for (axis, rate) in [([0.0, 0.0, 1.0], 314.0), ([0.48, -0.6, 0.64], 314.0), ([0.6, 0.8, 0.0], 3140.0)] {
        let begin = exponential([0.5, -1.0, 0.2]);
        let round = Top { inertia: [2.0; 3], moment: [0.0; 3] };
        let start = State::new(begin, axis.map(|entry: f64| entry * rate));
        let end = run(round, Rk4, start, 10.0, 10_000);
        let angle: f64 = 10.0 * rate;
        let (s, c) = (0.5 * angle).sin_cos();
        let expected = product(begin, [c, s * axis[0], s * axis[1], s * axis[2]]);
        assert!(apart(end.q, expected) < 2e-9, "{axis:?}: {}", apart(end.q, expected));
    }
}

/// What Runge and Kutta's method does without the inverse differential.
#[derive(Clone, Copy)]
struct Uncorrected;

impl Method<f64> for Uncorrected {
    type Memory<X: Variables<f64>> = ();

    fn memory<X: Variables<f64>>(&self) {}
}

impl<X: Variables<f64>, D: Dynamics<f64, Variables = X>> Integrator<f64, D> for Uncorrected {
    fn step(
        &self,
        _memory: &mut (),
        dynamics: &mut D,
        time: f64,
        h: f64,
        state: &StateOf<X>,
    ) -> Result<SteppedOf<X>, StepFailure> {
        let after = |dynamics: &D, h: f64, slope: &_| state.advance(dynamics.variables().layout(), h, slope);
        let k1 = dynamics.derivative(time, &mut state.clone());
        let k2 = dynamics.derivative(time + 0.5 * h, &mut after(dynamics, 0.5 * h, &k1));
        let k3 = dynamics.derivative(time + 0.5 * h, &mut after(dynamics, 0.5 * h, &k2));
        let k4 = dynamics.derivative(time + h, &mut after(dynamics, h, &k3));
        let mean = k1.plus(2.0, &k2).plus(2.0, &k3).plus(1.0, &k4).scaled(1.0 / 6.0);
        Ok(Stepped::explicit(h, after(dynamics, h, &mean)))
    }
}

pub const TUMBLING: Turning = State::new([1.0, 0.0, 0.0, 0.0], [0.4, 3.0, -0.7]);

/// Observed orders of the final orientation with 100, 200 and 400 steps for 2 s of a tumbling body.
fn orders<I: Integrator<f64, Top> + Copy>(integrator: I) -> [f64; 2] {
    let exact = run(Top::free(), Rk4, TUMBLING, 2.0, 12_800).q;
    let errors = [100, 200, 400].map(|n| apart(run(Top::free(), integrator, TUMBLING, 2.0, n).q, exact));
    [(errors[0] / errors[1]).log2(), (errors[1] / errors[2]).log2()]
}

#[test]
fn orders_of_convergence_of_a_tumbling_body() {
    for order in orders(Rk4) {
        assert!((3.85..4.15).contains(&order), "{order}");
    }
    for order in orders(SemiImplicitEuler) {
        assert!((0.9..1.1).contains(&order), "{order}");
    }
    for order in orders(Uncorrected) {
        assert!((1.9..2.1).contains(&order), "without the correction: {order}");
    }
}

#[test]
fn a_free_body_keeps_momentum_and_energy_to_the_order() {
    let drift = |steps| {
        let top = Top::free();
        let end = run(Top::free(), Rk4, TUMBLING, 10.0, steps);
        let momentum = largest(&top.momentum(&end), &top.momentum(&TUMBLING));
        [momentum, (top.energy(&end) - top.energy(&TUMBLING)).abs()]
    };
    let (coarse, fine) = (drift(1000), drift(2000));
    for (coarse, fine) in coarse.into_iter().zip(fine) {
        assert!(coarse < 1e-5 && (coarse / fine).log2() > 3.8, "{coarse} {fine}");
    }
}

/// The heavy top of Géradin and Cardona, *Flexible Multibody Dynamics* (2001), with the start of Brüls and Cardona, *On the
/// Use of Lie Group Time Integrators in Multibody Dynamics*, J. Comput. Nonlinear Dynam. 5 (2010): m = 15 kg, J = (0.234375,
/// 0.46875, 0.234375) kg m² at the centre, which is at (0, 1, 0) m; Ω = (0, 150, −4.61538) rad/s. Orientations computed
/// with Dormand and Prince's method of order 8 at a relative tolerance of 3e-14.
#[test]
fn the_heavy_top() {
    let computed = [
        (0.5, [0.58456062406948, -0.70066289541215, 0.38432575302288, 0.14019307880051]),
        (2.0, [0.12294713504155, -0.49107989255038, 0.35043003034356, -0.78798688755028]),
    ];
    let inertia = [0.234375 + 15.0, 0.46875, 0.234375 + 15.0];
    let top = || Top { inertia, moment: [0.0, 15.0 * 9.81, 0.0] };
    let start = State::new([1.0, 0.0, 0.0, 0.0], [0.0, 150.0, -4.61538]);
    for (time, expected) in computed {
        let end = run(top(), Rk4, start, time, (time * 40_000.0) as u32);
        let error = largest(&end.q, &expected).min(largest(&end.q, &expected.map(|entry| -entry)));
        assert!(error < 1e-9, "{time} s: {error:e}");
        let energy = top().energy(&start);
        assert!((energy - 5435.6967908656).abs() < 1e-9 && (top().energy(&end) - energy).abs() < 1e-6);
    }
}

/// A body whose rate about an axis is also kept as the speed of a linear coordinate and as a counted angle.
pub struct Counted(pub Top);

const COUNTED: [(u32, f64); 2] = [(2, 0.8), (3, -0.6)];

impl Variables<f64> for Counted {
    fn layout(&self) -> &Layout<'_> {
        &Layout { linear: 1, quaternions: 1, angles: &[MultiTurn { rate: &COUNTED }], ..ONE_BODY }
    }
    type Q = [f64; 7];
    type V = [f64; 4];
    type Z = ();
    type Gates = ();
    type Lambda = [f64; 0];
}

impl Dynamics<f64> for Counted {
    type Variables = Self;

    fn variables(&self) -> &Self {
        self
    }

    fn derivative(&mut self, time: f64, state: &mut State<[f64; 7], [f64; 4]>) -> Derivative<[f64; 4]> {
        let ([_, q @ .., _, _], [_, v @ ..]) = (state.q, state.v);
        let [x, y, z] = self.0.derivative(time, &mut State::new(q, v)).a;
        Derivative { v: state.v, a: [0.8 * y - 0.6 * z, x, y, z], z: () }
    }
}

#[test]
fn a_counted_angle_follows_the_integral_of_its_rate() {
    let v = [0.8 * 3.0 + 0.6 * 0.7, 0.4, 3.0, -0.7];
    let start = State::new([0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0], v);
    for end in [
        run(Counted(Top::free()), Rk4, start, 20.0, 400),
        run(Counted(Top::free()), SemiImplicitEuler, start, 20.0, 400),
    ] {
        let counted = TAU * end.q[5] + end.q[6];
        assert!(end.q[0].abs() > 7.0 && (counted - end.q[0]).abs() < 1e-12, "{counted} {}", end.q[0]);
    }
}

#[test]
fn single_precision_turns() {
    let mut q = [1.0_f32, 0.0, 0.0, 0.0];
    for _ in 0..10_000 {
        let from = q;
        retract(&ONE_BODY, &from, &[0.01, -0.02, 0.03], &mut q);
    }
    assert!((norm(q) - 1.0).abs() < 1e-6 && Real::is_finite(q[0]), "{q:?}");
}

#[test]
fn a_motion_in_space_has_points_and_a_quaternion() {
    let q = exponential([0.0, 0.0, 0.5 * core::f64::consts::PI]);
    let motion = SpatialMotion {
        position: [1.0, 2.0, 3.0],
        orientation: rotation_matrix(q),
        velocity: [0.0; 3],
        rate: [0.0; 3],
        acceleration: [0.0; 3],
        angular_acceleration: [0.0; 3],
    };
    assert!(largest(&motion.point([1.0, 0.0, 0.5]), &[1.0, 3.0, 3.5]) < 1e-15);
    assert!(largest(&motion.quaternion(), &q) < 1e-15);
}

fn bracket() -> Bracket {
    Bracket { mass: 2.0, inertia: [0.1, 0.2, 0.3], place: exponential([0.4, -0.9, 0.2]), weight: 1.0 }
}

#[test]
fn a_weld_in_space_is_assembled_from_any_orientation() {
    let model = bracket();
    let mut random = 1_u64;
    let mut next = || {
        random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (random >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    };
    let mut failures = Vec::new();
    for _ in 0..1000 {
        let orientation = [next(), next(), next(), next()];
        let near = [next(), next(), next(), orientation[0], orientation[1], orientation[2], orientation[3]];
        let state = State::new(near, [next(); 6]);
        match model.project(0.0, &state) {
            Ok(State { q, v, .. }) => {
                assert!(largest(&q[..3], &[0.0; 3]) < 1e-14 && v.max_abs() < 1e-14, "{q:?} {v:?}");
                assert!(apart([q[3], q[4], q[5], q[6]], model.place) < 1e-13, "{q:?}");
            }
            Err(error) => failures.push((near, error)),
        }
    }
    assert!(failures.is_empty(), "{} {:?}", failures.len(), failures.first());
}

#[test]
fn a_weld_in_space_is_turned_from_right_angles_and_from_behind() {
    let half = core::f64::consts::FRAC_1_SQRT_2;
    for place in [
        [0.0, 1.0, 0.0, 0.0],
        [0.0, 0.0, 1.0, 0.0],
        [0.0, 0.0, 0.0, 1.0],
        [half, half, 0.0, 0.0],
        [half, 0.0, -half, 0.0],
        [half, 0.0, 0.0, half],
        [0.5, 0.5, 0.5, 0.5],
    ] {
        let model = Bracket { place, ..bracket() };
        let found = model.project(0.0, &Bracket::start(&model));
        let near = found.map(|State { q: [_, _, _, turned @ ..], .. }| apart(turned, place));
        assert!(matches!(near, Ok(angle) if angle < 1e-13), "{place:?}: {near:?}");
    }
}

#[test]
fn an_orientation_that_is_not_of_length_one_is_named() {
    let model = bracket();
    let mut start = model.project(0.0, &State::new(Bracket::start(&model).q, [0.0; 6])).unwrap();
    assert!(Residual::of(&model, 0.0, &start).position < 1e-14);
    assert!(Simulation::new(&model, start).step(1e-3).advance().is_ok());

    let unit = start;
    for entry in &mut start.q[3..] {
        *entry *= 1.5;
    }
    for simulation in
        [Simulation::new(&model, start), Simulation::new(&model, start).accept_inconsistent_start()]
    {
        let error = simulation.step(1e-3).advance().unwrap_err();
        assert!(
            matches!(error, SimulationError::NotNormalised { time: 0.0, what: "body.orientation.w", length }
                if (length - 1.5).abs() < 1e-15),
            "{error:?}"
        );
        assert!(error.to_string().contains("divide"), "{error}");
    }
    let again = model.project(0.0, &start).unwrap();
    assert!(largest(&again.q, &unit.q) < 1e-15, "{again:?}");

    start.q[3..].fill(0.0);
    let error = model.project(0.0, &start).unwrap_err();
    assert_eq!(error, AssemblyError::NoOrientation { what: "body.orientation.w", length: 0.0 });
}

#[test]
fn a_row_that_vanishes_beside_its_neighbours_is_named() {
    let start = Bracket::start(&bracket());
    let (pivot, row) = smallest_pivot(&bracket(), 0.0, &start.q);
    assert!(pivot > 1e-3, "{pivot} {row:?}");
    let flat = Bracket { weight: 1e-17, ..bracket() };
    let (pivot, row) = smallest_pivot(&flat, 0.0, &start.q);
    assert!(pivot < 1e-30 && row == Some(2), "{pivot} {row:?}");
}
