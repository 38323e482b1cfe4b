//! A mechanism with an internal state: an arm on a direct-current motor, whose current is the state z.
//!
//! J θ̈ = k i − m g l sin θ, L i̇ = U − R i − k θ̇, θ from where the arm hangs; 3 V from rest. The expected numbers are those of an
//! integration by an explicit method of order 8 to 3e-14.

use core::f64::consts::TAU;
use linkwright_runtime::{
    Assemble, AssembleExt, Condition, DormandPrince, Elimination, ExplicitTrapezoidal, Fields, Flips,
    Integrator, LagrangeIndex1, Layout, Mechanism, MechanismDynamics, MultiTurn, NoInputs, Rk4, Row,
    SemiImplicitEuler, Simulation, SimulationError, State, StateOf, Variables, tabled,
};

struct Motor {
    inductance: f64,
    resistance: f64,
    constant: f64,
    inertia: f64,
    weight: f64,
    voltage: f64,
}

const MOTOR: Motor =
    Motor { inductance: 2e-3, resistance: 0.5, constant: 0.08, inertia: 0.02, weight: 0.0981, voltage: 3.0 };

impl Variables<f64> for Motor {
    fn layout(&self) -> &Layout<'_> {
        &Layout { linear: 0, rotations: 1, quaternions: 0, angles: &[MultiTurn { rate: &[(0, 1.0)] }] }
    }
    type Q = [f64; 4];
    type V = [f64; 1];
    type Z = [f64; 1];
    type Gates = ();
    type Lambda = [f64; 0];
}

type Running = StateOf<Motor>;

#[derive(Clone, Copy, Debug, PartialEq)]
struct Current {
    current: f64,
}

impl Fields<f64> for Current {
    const NAMES: &'static [&'static str] = &["current"];
    type Array = [f64; 1];

    fn from_array([current]: [f64; 1]) -> Self {
        Current { current }
    }
    fn to_array(&self) -> [f64; 1] {
        [self.current]
    }
}

impl Mechanism<f64> for Motor {
    fn name(&self) -> &'static str {
        "Motor"
    }
    fn rows(&self) -> &[Row] {
        &[]
    }
    fn position_names(&self) -> &[&'static str] {
        &["arm.cos", "arm.sin", "shaft.turns", "shaft.remainder"]
    }
    fn velocity_names(&self) -> &[&'static str] {
        &["arm.rate"]
    }
    fn internal_names(&self) -> &[&'static str] {
        &["current"]
    }
    fn mass_pattern(&self) -> &[(u16, u16)] {
        &[(0, 0)]
    }
    fn jacobian_pattern(&self) -> &[(u16, u16)] {
        &[]
    }
    type Mass = [f64; 1];
    type Jacobian = [f64; 0];
    type Inputs = ();
    type Outputs = Current;

    fn mass_matrix(&self, _time: f64, _q: &[f64; 4], mass: &mut [f64; 1]) {
        *mass = [self.inertia];
    }
    fn constraints(&self, _time: f64, _q: &[f64; 4], _phi: &mut [f64; 0]) {}
    fn constraint_jacobian(&self, _time: f64, _q: &[f64; 4], _d: &mut [f64; 0]) {}
    fn nu(&self, _time: f64, _q: &[f64; 4], _nu: &mut [f64; 0]) {}
    fn gamma(&self, _time: f64, _q: &[f64; 4], _v: &[f64; 1], _gamma: &mut [f64; 0]) {}
    fn forces(&self, _time: f64, state: &Running, _u: &(), forces: &mut [f64; 1]) {
        *forces = [self.constant * state.z[0] - self.weight * state.q[1]];
    }
    fn kinetic_energy(&self, _time: f64, _q: &[f64; 4], v: &[f64; 1]) -> f64 {
        0.5 * self.inertia * v[0] * v[0]
    }
    fn potential_energy(&self, _time: f64, state: &Running) -> f64 {
        -self.weight * state.q[0]
    }
    fn acceleration(
        &self,
        time: f64,
        state: &Running,
        u: &(),
        a: &mut [f64; 1],
        _lambda: &mut [f64; 0],
    ) -> f64 {
        self.forces(time, state, u, a);
        a[0] /= self.inertia;
        1.0
    }
    fn acceleration_baumgarte(
        &self,
        time: f64,
        state: &Running,
        u: &(),
        _two_alpha: f64,
        _beta_squared: f64,
        a: &mut [f64; 1],
        lambda: &mut [f64; 0],
    ) -> f64 {
        self.acceleration(time, state, u, a, lambda)
    }
    fn internal_rates(
        &self,
        _time: f64,
        state: &Running,
        _u: &(),
        _a: &[f64; 1],
        _lambda: &[f64; 0],
        rates: &mut [f64; 1],
    ) {
        let left = self.voltage - self.resistance * state.z[0] - self.constant * state.v[0];
        *rates = [left / self.inductance];
    }
    fn input_names(&self) -> &'static [&'static str] {
        &[]
    }
    fn output_names(&self) -> &'static [&'static str] {
        Current::NAMES
    }
    fn outputs(&self, _time: f64, state: &Running, _u: &()) -> Current {
        Current { current: state.z[0] }
    }
    fn unwrap(&self, _outputs: &mut Current, _previous: &Current) {}
}

impl Assemble<f64> for Motor {
    fn conditions(&self) -> &[Condition] {
        &[]
    }
    fn start_conditions(&self) -> &[u16] {
        &[]
    }
    fn start_rates(&self) -> &[u16] {
        &[]
    }
    fn independent(&self) -> &[u16] {
        &[]
    }
    fn condition_pattern(&self) -> &[(u16, u16)] {
        &[]
    }
    fn flips(&self) -> &[Flips<'_>] {
        &[]
    }
    fn row_sizes(&self) -> Self::Lambda {
        []
    }
    fn elimination(&self) -> Elimination<'_> {
        Elimination { order: &[0], position: &[0], row_start: &[0, 0], columns: &[] }
    }
    type Conditions = [f64; 0];
    type ConditionJacobian = [f64; 0];
    type Factor = [f64; 0];
    type System = [f64; 1];
    type Dense = [f64; 0];
    type Basis = [f64; 1];
    type Reduced = [f64; 1];
    type Choice = [u16; 1];
    type Store = tabled::Store<f64, Self>;
    type Lu = ();

    fn choice(&self) -> [u16; 1] {
        [0]
    }
    fn lu(&self) {}
    fn store(&self) -> Self::Store {
        tabled::store(self)
    }
    fn row_scales(&self, scales: &mut [f64; 0]) {
        *scales = [];
    }
    fn factor(&self, time: f64, q: &[f64; 4], compliance: f64, store: &mut Self::Store) -> f64 {
        tabled::factor(self, time, q, compliance, store)
    }
    fn solve(
        &self,
        store: &Self::Store,
        forces: &[f64; 1],
        rows: &[f64; 0],
        a: &mut [f64; 1],
        lambda: &mut [f64; 0],
    ) {
        tabled::solve(self, store, forces, rows, a, lambda);
    }
    fn condition_residual(&self, _time: f64, _q: &[f64; 4], _target: &[f64; 0], _residual: &mut [f64; 0]) {}
    fn condition_cosines(&self, _time: f64, _q: &[f64; 4], _target: &[f64; 0], _cosines: &mut [f64; 0]) {}
    fn condition_jacobian(&self, _time: f64, _q: &[f64; 4], _jacobian: &mut [f64; 0]) {}
    fn condition_bias(&self, _time: f64, _q: &[f64; 4], _v: &[f64; 1], _bias: &mut [f64; 0]) {}
    fn condition_drift(&self, _time: f64, _q: &[f64; 4], _drift: &mut [f64; 0]) {}
    fn row_cosines(&self, _time: f64, _q: &[f64; 4], _cosines: &mut [f64; 0]) {}
    fn start_targets(&self, _positions: &mut [f64; 0], _rates: &mut [f64; 0]) {}
    fn start_q(&self) -> [f64; 4] {
        [1.0, 0.0, 0.0, 0.0]
    }
    fn start_v(&self) -> [f64; 1] {
        [0.0]
    }
    fn start_internal(&self) -> [f64; 1] {
        [0.0]
    }
    fn start_gates(&self) {}
}

/// Angle, rate and current at `end`.
fn run<I>(integrator: I, h: f64, end: f64) -> [f64; 3]
where
    I: for<'m> Integrator<f64, MechanismDynamics<'m, Motor, f64, LagrangeIndex1, NoInputs>>,
{
    let mut simulation = Simulation::new(&MOTOR, MOTOR.start()).integrator(integrator).step(h);
    numbers(&simulation.advance_until(end).expect("it is regular"))
}

fn numbers(State { q, v, z, .. }: &Running) -> [f64; 3] {
    [TAU * q[2] + q[3], v[0], z[0]]
}

fn off(found: [f64; 3], expected: [f64; 3]) -> f64 {
    found.iter().zip(expected).map(|(found, expected)| (found / expected - 1.0).abs()).fold(0.0, f64::max)
}

/// After 0.01 s and 1 s.
const EARLY: [f64; 3] = [5.920_812_890_90e-4, 0.151_706_724_118_73, 5.494_146_993_263_54];
const LATE: [f64; 3] = [9.149_928_836_671_469, 16.814_920_126_022_002, 3.317_073_210_020_512];

#[test]
fn the_current_is_integrated_with_the_motion() {
    assert!(off(run(Rk4, 1e-4, 0.01), EARLY) < 1e-8);
    assert!(off(run(Rk4, 1e-4, 1.0), LATE) < 1e-9);
    assert!(off(run(DormandPrince::fixed(), 2e-4, 1.0), LATE) < 1e-11);
    assert!(off(run(DormandPrince::tolerance(1e-11), 1.0, 1.0), LATE) < 1e-9);
}

#[test]
fn each_method_keeps_its_order() {
    let orders: [(&dyn Fn(f64) -> f64, f64); 4] = [
        (&|h| off(run(SemiImplicitEuler, h, 0.01), EARLY), 1.0),
        (&|h| off(run(ExplicitTrapezoidal, h, 0.01), EARLY), 2.0),
        (&|h| off(run(Rk4, h, 0.01), EARLY), 4.0),
        (&|h| off(run(DormandPrince::fixed(), h, 0.01), EARLY), 5.0),
    ];
    for (error, order) in orders {
        let found = (error(5e-4) / error(2.5e-4)).log2();
        assert!((found - order).abs() < 0.35, "order {found} in place of {order}");
    }
}

/// The current rises within milliseconds, the arm moves in seconds: steps that only looked at the motion would miss it.
#[test]
fn steps_are_chosen_by_the_current_too() {
    let mut simulation =
        Simulation::new(&MOTOR, MOTOR.start()).integrator(DormandPrince::tolerance(1e-9)).step(1.0);
    simulation.advance_until(0.01).expect("it is regular");
    assert!(off(numbers(simulation.state()), EARLY) < 1e-7, "{:?}", numbers(simulation.state()));
}

#[test]
fn dense_output_has_the_current() {
    let mut simulation = Simulation::new(&MOTOR, MOTOR.start()).integrator(DormandPrince::fixed()).step(5e-4);
    simulation.advance_until(0.0102).expect("it is regular");
    let [_, _, current] = numbers(&simulation.interpolate(0.01005).expect("it is covered"));
    let [_, _, exact] = run(DormandPrince::fixed(), 5e-5, 0.01005);
    assert!((current / exact - 1.0).abs() < 1e-8, "{current} {exact}");
}

#[test]
fn a_current_that_is_no_number_is_named() {
    let start = State { z: [f64::NAN], ..MOTOR.start() };
    let error = Simulation::new(&MOTOR, start).step(1e-3).advance().unwrap_err();
    assert_eq!(error, SimulationError::NonFinite { time: 0.0, what: "current" });
}

#[test]
fn projection_leaves_the_current_alone() {
    let given = State { z: [2.5], ..MOTOR.start() };
    assert_eq!(MOTOR.project(0.0, &given).expect("there is nothing to project"), given);
}
