//! A mechanism whose sizes and tables are found while the program runs and whose entries are in lists: every method moves it as
//! it moves the same one in arrays, to the bit.
//!
//! N masses on parallel rails, coupled by springs from neighbour to neighbour and led by one constraint that has them all,
//! Σ xᵢ² = L². M is diagonal, D = 2 xᵀ, γ = −2 Σ vᵢ²; Q has springs, dampers and a force on the first mass.

use linkwright_runtime::{
    Ali3p, Assemble, AssembleExt, AugmentedLagrangian, Baumgarte, Condition, ConditionKind, DormandPrince,
    Elimination, Event, ExplicitTrapezoidal, Fields, Flips, Formulation, GeneralisedAlpha,
    ImplicitTrapezoidal, Integrator, LagrangeIndex1, Layout, Linearisation, Mechanism, MechanismDynamics,
    Motion, NullSpace, Partitioned, Penalty, Projected, Rk4, Row, SemiImplicitEuler, Simulation, StateOf,
    Tangent, Variables, Vector, actuation, equilibrium, tabled,
};
use std::fmt::Debug;

/// Numbers in a list, as many as asked for.
#[derive(Clone, Debug, PartialEq)]
struct List(Vec<f64>);

impl Vector<f64> for List {
    fn zeros(len: usize) -> Self {
        List(vec![0.0; len])
    }
    fn as_slice(&self) -> &[f64] {
        &self.0
    }
    fn as_mut_slice(&mut self) -> &mut [f64] {
        &mut self.0
    }
}

/// Where entries are kept, named after their number with n velocities.
trait Storage: 'static {
    type None: Vector<f64>;
    type One: Vector<f64>;
    type N: Vector<f64>;
    /// n + 1.
    type Unknowns: Vector<f64>;
    /// (n + 1)².
    type Bordered: Vector<f64>;
    /// 3n − 2.
    type Tridiagonal: Vector<f64>;
    /// n (n − 1).
    type Basis: Vector<f64>;
    /// (n − 1)².
    type Reduced: Vector<f64>;
    /// 2n + 1.
    type System: Vector<f64>;
    /// The triangle below its diagonal.
    type Factor: Vector<f64>;
    /// n − 1, the freedoms.
    type Freedoms: Vector<f64>;
    /// Those of positions and velocities.
    type States: Vector<f64>;
    /// A square matrix of these.
    type StateMatrix: Vector<f64>;
    type Choice: Clone + Debug + AsRef<[u16]> + AsMut<[u16]>;
    type Order: Clone + Debug + AsRef<[u16]> + AsMut<[u16]>;

    fn choice(len: usize) -> Self::Choice;
    fn order(len: usize) -> Self::Order;
}

/// Whatever the number of masses.
struct Lists;

impl Storage for Lists {
    type None = List;
    type One = List;
    type N = List;
    type Unknowns = List;
    type Bordered = List;
    type Tridiagonal = List;
    type Basis = List;
    type Reduced = List;
    type System = List;
    type Factor = List;
    type Freedoms = List;
    type States = List;
    type StateMatrix = List;
    type Choice = Vec<u16>;
    type Order = Vec<u16>;

    fn choice(len: usize) -> Vec<u16> {
        vec![0; len]
    }
    fn order(len: usize) -> Vec<u16> {
        vec![0; len]
    }
}

/// Four masses.
struct Arrays;

impl Storage for Arrays {
    type None = [f64; 0];
    type One = [f64; 1];
    type N = [f64; 4];
    type Unknowns = [f64; 5];
    type Bordered = [f64; 25];
    type Tridiagonal = [f64; 10];
    type Basis = [f64; 12];
    type Reduced = [f64; 9];
    type System = [f64; 9];
    type Factor = [f64; 36];
    type Freedoms = [f64; 3];
    type States = [f64; 6];
    type StateMatrix = [f64; 36];
    type Choice = [u16; 4];
    type Order = [u16; 5];

    fn choice(_: usize) -> [u16; 4] {
        [0; 4]
    }
    fn order(_: usize) -> [u16; 5] {
        [0; 5]
    }
}

/// Inputs and outputs, whose names the mechanism tells.
#[derive(Clone, Debug, PartialEq)]
struct Numbers<V>(V);

impl<V: Vector<f64>> Fields<f64> for Numbers<V> {
    const NAMES: &'static [&'static str] = &[];
    type Array = V;

    fn from_array(values: V) -> Self {
        Numbers(values)
    }
    fn to_array(&self) -> V {
        self.0.clone()
    }
}

type Pattern = Vec<(u16, u16)>;

struct Masses<S> {
    masses: Vec<f64>,
    stiffness: f64,
    damping: f64,
    radius: f64,
    layout: Layout<'static>,
    names: Vec<&'static str>,
    rows: Vec<Row>,
    conditions: Vec<Condition>,
    diagonal: Pattern,
    row: Pattern,
    tridiagonal: Pattern,
    coordinates: Pattern,
    independent: Vec<u16>,
    dependent: Pattern,
    order: Vec<u16>,
    row_start: Vec<u32>,
    columns: Vec<u16>,
    storage: std::marker::PhantomData<S>,
}

impl<S: Storage> Masses<S> {
    /// So many masses.
    fn new(count: usize) -> Self {
        let n = count as u16;
        let names: Vec<&'static str> = (0..n).map(|i| &*format!("mass_{i}.travel").leak()).collect();
        let conditions = names.iter().map(|&of| Condition { of, kind: ConditionKind::Linear }).collect();
        let tridiagonal = |i: u16| (i.saturating_sub(1)..=(i + 1).min(n - 1)).map(move |j| (i, j));
        let unknowns = 2 * n + 1;
        Masses {
            masses: (0..n).map(|i| 1.0 + 0.3 * f64::from(i)).collect(),
            stiffness: 7.0,
            damping: 0.02,
            radius: 1.5,
            layout: Layout { linear: count, rotations: 0, quaternions: 0, angles: &[] },
            names,
            rows: vec![Row { of: "sphere", what: "equation" }],
            conditions,
            diagonal: (0..n).map(|i| (i, i)).collect(),
            row: (0..n).map(|i| (0, i)).collect(),
            tridiagonal: (0..n).flat_map(tridiagonal).collect(),
            coordinates: (0..n - 1).map(|i| (i, n + i)).collect(),
            independent: (0..n - 1).collect(),
            dependent: vec![(0, n - 1)],
            order: (0..unknowns).collect(),
            row_start: (0..=u32::from(unknowns)).map(|k| k * k.saturating_sub(1) / 2).collect(),
            columns: (0..unknowns).flat_map(|k| 0..k).collect(),
            storage: std::marker::PhantomData,
        }
    }
}

impl<S: Storage> Variables<f64> for Masses<S> {
    fn layout(&self) -> &Layout<'_> {
        &self.layout
    }
    type Q = S::N;
    type V = S::N;
    type Z = ();
    type Gates = ();
    type Lambda = S::One;
}

/// Σ xᵢ yᵢ.
fn dot(x: &[f64], y: &[f64]) -> f64 {
    x.iter().zip(y).map(|(x, y)| x * y).sum()
}

impl<S: Storage> Mechanism<f64> for Masses<S> {
    fn name(&self) -> &'static str {
        "Masses"
    }
    fn rows(&self) -> &[Row] {
        &self.rows
    }
    fn position_names(&self) -> &[&'static str] {
        &self.names
    }
    fn velocity_names(&self) -> &[&'static str] {
        &self.names
    }
    fn input_names(&self) -> &'static [&'static str] {
        &["push"]
    }
    fn output_names(&self) -> &'static [&'static str] {
        &["first"]
    }
    fn mass_pattern(&self) -> &[(u16, u16)] {
        &self.diagonal
    }
    fn jacobian_pattern(&self) -> &[(u16, u16)] {
        &self.row
    }
    type Mass = S::N;
    type Jacobian = S::N;
    type Inputs = Numbers<S::One>;
    type Outputs = Numbers<S::One>;

    fn mass_matrix(&self, _time: f64, _q: &S::N, mass: &mut S::N) {
        mass.as_mut_slice().copy_from_slice(&self.masses);
    }
    fn constraints(&self, _time: f64, q: &S::N, phi: &mut S::One) {
        phi.as_mut_slice()[0] = dot(q.as_slice(), q.as_slice()) - self.radius * self.radius;
    }
    fn constraint_jacobian(&self, _time: f64, q: &S::N, d: &mut S::N) {
        d.clone_from(&q.scaled(2.0));
    }
    fn nu(&self, _time: f64, _q: &S::N, nu: &mut S::One) {
        nu.as_mut_slice()[0] = 0.0;
    }
    fn gamma(&self, _time: f64, _q: &S::N, v: &S::N, gamma: &mut S::One) {
        gamma.as_mut_slice()[0] = -2.0 * dot(v.as_slice(), v.as_slice());
    }
    fn forces(&self, _time: f64, state: &StateOf<Self>, u: &Numbers<S::One>, forces: &mut S::N) {
        let (q, v) = (state.q.as_slice(), state.v.as_slice());
        for (i, force) in forces.as_mut_slice().iter_mut().enumerate() {
            *force = if i == 0 { u.0.as_slice()[0] } else { 0.0 } - self.damping * v[i];
            for j in [i.wrapping_sub(1), i + 1] {
                *force -= q.get(j).map_or(0.0, |other| self.stiffness * (q[i] - other));
            }
        }
    }
    fn kinetic_energy(&self, _time: f64, _q: &S::N, v: &S::N) -> f64 {
        self.masses.iter().zip(v.as_slice()).map(|(m, v)| 0.5 * m * v * v).sum()
    }
    fn potential_energy(&self, _time: f64, state: &StateOf<Self>) -> f64 {
        state.q.as_slice().windows(2).map(|x| 0.5 * self.stiffness * (x[1] - x[0]).powi(2)).sum()
    }
    fn acceleration(
        &self,
        time: f64,
        state: &StateOf<Self>,
        u: &Numbers<S::One>,
        a: &mut S::N,
        lambda: &mut S::One,
    ) -> f64 {
        self.acceleration_baumgarte(time, state, u, 0.0, 0.0, a, lambda)
    }
    fn acceleration_baumgarte(
        &self,
        time: f64,
        state: &StateOf<Self>,
        u: &Numbers<S::One>,
        two_alpha: f64,
        beta_squared: f64,
        a: &mut S::N,
        lambda: &mut S::One,
    ) -> f64 {
        let (mut d, mut right, mut phi, mut scale) =
            (self.zero_jacobian(), self.zero_lambda(), self.zero_lambda(), self.zero_lambda());
        self.constraint_jacobian(time, &state.q, &mut d);
        self.gamma(time, &state.q, &state.v, &mut right);
        self.constraints(time, &state.q, &mut phi);
        self.forces(time, state, u, a);
        self.row_scales(&mut scale);
        let rate = dot(d.as_slice(), state.v.as_slice());
        let wanted = right.as_slice()[0] - two_alpha * rate - beta_squared * phi.as_slice()[0];
        for (a, mass) in a.as_mut_slice().iter_mut().zip(&self.masses) {
            *a /= mass;
        }
        let pivot: f64 = d.as_slice().iter().zip(&self.masses).map(|(d, mass)| d * d / mass).sum();
        let multiplier = (dot(d.as_slice(), a.as_slice()) - wanted) / pivot;
        for ((a, d), mass) in a.as_mut_slice().iter_mut().zip(d.as_slice()).zip(&self.masses) {
            *a -= d * multiplier / mass;
        }
        lambda.as_mut_slice()[0] = multiplier;
        pivot / scale.as_slice()[0]
    }
    fn internal_rates(
        &self,
        _time: f64,
        _state: &StateOf<Self>,
        _u: &Numbers<S::One>,
        _a: &S::N,
        _lambda: &S::One,
        _rates: &mut (),
    ) {
    }
    fn outputs(&self, _time: f64, state: &StateOf<Self>, _u: &Numbers<S::One>) -> Numbers<S::One> {
        let mut first = S::One::zeros(1);
        first.as_mut_slice()[0] = state.q.as_slice()[0];
        Numbers(first)
    }
    fn unwrap(&self, _outputs: &mut Numbers<S::One>, _previous: &Numbers<S::One>) {}
}

impl<S: Storage> Assemble<f64> for Masses<S> {
    fn conditions(&self) -> &[Condition] {
        &self.conditions
    }
    fn start_conditions(&self) -> &[u16] {
        &self.independent
    }
    fn start_rates(&self) -> &[u16] {
        &self.independent
    }
    fn independent(&self) -> &[u16] {
        &self.independent
    }
    fn condition_pattern(&self) -> &[(u16, u16)] {
        &self.diagonal
    }
    fn flips(&self) -> &[Flips<'_>] {
        &[]
    }
    fn dependent(&self) -> &[(u16, u16)] {
        &self.dependent
    }
    fn row_sizes(&self) -> S::One {
        let mut sizes = self.zero_lambda();
        sizes.as_mut_slice().fill(3.0);
        sizes
    }
    fn elimination(&self) -> Elimination<'_> {
        let Masses { order, row_start, columns, .. } = self;
        Elimination { order, position: order, row_start, columns }
    }
    type Conditions = S::N;
    type ConditionJacobian = S::N;
    type Factor = S::Factor;
    type System = S::System;
    type Dense = S::N;
    type Basis = S::Basis;
    type Reduced = S::Reduced;
    type Choice = S::Choice;
    type Store = tabled::Store<f64, Self>;
    type Lu = ();

    fn choice(&self) -> S::Choice {
        S::choice(self.masses.len())
    }
    fn lu(&self) {}
    fn store(&self) -> Self::Store {
        tabled::store(self)
    }
    fn row_scales(&self, scales: &mut S::One) {
        scales.as_mut_slice()[0] = 8.0 * self.radius * self.radius / self.masses[0];
    }
    fn factor(&self, time: f64, q: &S::N, compliance: f64, store: &mut Self::Store) -> f64 {
        tabled::factor(self, time, q, compliance, store)
    }
    fn solve(&self, store: &Self::Store, forces: &S::N, rows: &S::One, a: &mut S::N, lambda: &mut S::One) {
        tabled::solve(self, store, forces, rows, a, lambda);
    }
    fn condition_residual(&self, _time: f64, q: &S::N, target: &S::N, residual: &mut S::N) {
        residual.clone_from(&q.plus(-1.0, target));
    }
    fn condition_cosines(&self, _time: f64, _q: &S::N, _target: &S::N, cosines: &mut S::N) {
        cosines.as_mut_slice().fill(1.0);
    }
    fn condition_jacobian(&self, _time: f64, _q: &S::N, jacobian: &mut S::N) {
        jacobian.as_mut_slice().fill(1.0);
    }
    fn condition_bias(&self, _time: f64, _q: &S::N, _v: &S::N, bias: &mut S::N) {
        bias.as_mut_slice().fill(0.0);
    }
    fn condition_drift(&self, _time: f64, _q: &S::N, drift: &mut S::N) {
        drift.as_mut_slice().fill(0.0);
    }
    fn row_cosines(&self, _time: f64, _q: &S::N, cosines: &mut S::One) {
        cosines.as_mut_slice().fill(1.0);
    }
    fn start_targets(&self, positions: &mut S::N, rates: &mut S::N) {
        let count = self.masses.len() as f64;
        for (i, (x, v)) in positions.as_mut_slice().iter_mut().zip(rates.as_mut_slice()).enumerate() {
            (*x, *v) = ((0.5 - i as f64) * 0.9 / count, 0.4 * i as f64);
        }
    }
    fn start_q(&self) -> S::N {
        let mut q = self.zero_v();
        *q.as_mut_slice().last_mut().unwrap() = 1.0;
        q
    }
    fn start_v(&self) -> S::N {
        self.zero_v()
    }
    fn start_internal(&self) {}
    fn start_gates(&self) {}
}

impl<S: Storage> Tangent<f64> for Masses<S> {
    fn states(&self) -> &[u16] {
        &self.independent
    }
    fn stiffness_pattern(&self) -> &[(u16, u16)] {
        &self.tridiagonal
    }
    fn damping_pattern(&self) -> &[(u16, u16)] {
        &self.diagonal
    }
    fn row_stiffness_pattern(&self) -> &[(u16, u16)] {
        &self.row
    }
    fn row_damping_pattern(&self) -> &[(u16, u16)] {
        &self.row
    }
    fn rate_pattern(&self) -> &[(u16, u16)] {
        &self.row
    }
    fn input_pattern(&self) -> &[(u16, u16)] {
        &[(0, 0)]
    }
    fn parameter_pattern(&self) -> &[(u16, u16)] {
        &[]
    }
    fn output_pattern(&self) -> &[(u16, u16)] {
        &[(0, 0)]
    }
    fn coordinate_pattern(&self) -> &[(u16, u16)] {
        &self.coordinates
    }
    type Stiffness = S::Tridiagonal;
    type Damping = S::N;
    type RowStiffness = S::N;
    type RowDamping = S::N;
    type RateTangent = S::N;
    type InputTangent = S::One;
    type InternalTangent = ();
    type FrictionTangent = ();
    type ParameterTangent = S::None;
    type OutputTangent = S::One;
    type InternalRateTangent = ();
    type CoordinateTangent = S::Freedoms;
    type StateMatrix = S::StateMatrix;
    type InputMatrix = S::States;
    type OutputMatrix = S::States;
    type Feedthrough = S::One;
    type Unknowns = S::Unknowns;
    type Bordered = S::Bordered;
    type Order = S::Order;
    type Parameters = ();

    fn parameter_names(&self) -> &[&'static str] {
        &[]
    }
    fn order(&self) -> S::Order {
        S::order(self.masses.len() + 1)
    }
    fn residual(
        &self,
        time: f64,
        state: &StateOf<Self>,
        u: &Numbers<S::One>,
        a: &S::N,
        lambda: &S::One,
        residual: &mut S::N,
    ) {
        let mut forces = self.zero_v();
        self.forces(time, state, u, &mut forces);
        let terms = a.as_slice().iter().zip(state.q.as_slice()).zip(forces.as_slice()).zip(&self.masses);
        for (entry, (((a, q), force), mass)) in residual.as_mut_slice().iter_mut().zip(terms) {
            *entry = mass * a + 2.0 * q * lambda.as_slice()[0] - force;
        }
    }
    fn tangent(
        &self,
        _time: f64,
        _state: &StateOf<Self>,
        _u: &Numbers<S::One>,
        _a: &S::N,
        lambda: &S::One,
        stiffness: &mut S::Tridiagonal,
        damping: &mut S::N,
    ) {
        damping.as_mut_slice().fill(self.damping);
        let last = self.masses.len() as u16 - 1;
        for (entry, (i, j)) in stiffness.as_mut_slice().iter_mut().zip(&self.tridiagonal) {
            let springs = if *i == 0 || *i == last { 1.0 } else { 2.0 };
            *entry =
                if i == j { springs * self.stiffness + 2.0 * lambda.as_slice()[0] } else { -self.stiffness };
        }
    }
    fn row_tangent(
        &self,
        _time: f64,
        _q: &S::N,
        v: &S::N,
        a: &S::N,
        stiffness: &mut S::N,
        damping: &mut S::N,
    ) {
        stiffness.clone_from(&a.scaled(2.0));
        damping.clone_from(&v.scaled(4.0));
    }
    fn rate_tangent(&self, _time: f64, _q: &S::N, v: &S::N, rate: &mut S::N) {
        rate.clone_from(&v.scaled(2.0));
    }
    fn input_tangent(&self, _time: f64, _state: &StateOf<Self>, _u: &Numbers<S::One>, input: &mut S::One) {
        input.as_mut_slice().fill(-1.0);
    }
    fn parameter_tangent(
        &self,
        _time: f64,
        _state: &StateOf<Self>,
        _u: &Numbers<S::One>,
        _a: &S::N,
        _lambda: &S::One,
        _parameter: &mut S::None,
    ) {
    }
    fn output_tangent(
        &self,
        _time: f64,
        _state: &StateOf<Self>,
        _u: &Numbers<S::One>,
        _a: &S::N,
        _lambda: &S::One,
        output: &mut S::One,
    ) {
        output.as_mut_slice().fill(1.0);
    }
    fn coordinate_tangent(&self, _time: f64, _q: &S::N, _v: &S::N, _a: &S::N, coordinate: &mut S::Freedoms) {
        coordinate.as_mut_slice().fill(1.0);
    }
}

/// The force on the first mass at a time, N.
fn push<S: Storage>(time: f64) -> Numbers<S::One> {
    let mut force = S::One::zeros(1);
    force.as_mut_slice()[0] = (3.0 * time).sin();
    Numbers(force)
}

fn entries<S: Storage>(state: &StateOf<Masses<S>>) -> Vec<f64> {
    [state.q.as_slice(), state.v.as_slice()].concat()
}

/// Numbers of a second in motion: the end, energy and what is left of the constraint.
fn moved<S: Storage, F, I>(model: &Masses<S>, formulation: F, integrator: I) -> Vec<f64>
where
    F: Formulation<f64, Masses<S>>,
    I: for<'m> Integrator<
            f64,
            MechanismDynamics<
                'm,
                Masses<S>,
                f64,
                F,
                linkwright_runtime::input::HeldOrSampled<linkwright_runtime::input::AtStages, Law<S>>,
            >,
        >,
{
    let start = model.assemble(&model.start()).expect("it assembles");
    let force: Law<S> = |time, _| push::<S>(time);
    let simulation = Simulation::new(model, start).formulation(formulation).sampled(force);
    let mut simulation = simulation.integrator(integrator).step(0.01);
    let end = simulation.advance_until(1.0).expect("it moves");
    let mut numbers = entries::<S>(&end);
    numbers.extend([simulation.energy(), simulation.constraint_residual().position]);
    assert!(numbers[numbers.len() - 1].abs() < 1e-2, "{numbers:?}");
    numbers
}

/// The inputs, by time and state.
type Law<S> = fn(f64, &StateOf<Masses<S>>) -> Numbers<<S as Storage>::One>;

/// Everything that can be asked, as numbers.
fn numbers<S: Storage>(model: &Masses<S>) -> Vec<(&'static str, Vec<f64>)> {
    let start = model.assemble(&model.start()).expect("it assembles");
    let penalty = Penalty::for_model(model, 0.0, &start.q, 0.01);
    let baumgarte = Baumgarte { alpha: 10.0, beta: 10.0 };
    let mut found = vec![
        ("start", entries::<S>(&start)),
        ("Runge and Kutta", moved(model, LagrangeIndex1, Rk4)),
        ("Baumgarte", moved(model, baumgarte, Rk4)),
        ("Dormand and Prince", moved(model, LagrangeIndex1, DormandPrince::tolerance(1e-8))),
        ("projected", moved(model, Projected::after(LagrangeIndex1), Rk4)),
        ("projected, adaptive", moved(model, Projected::after(baumgarte), DormandPrince::tolerance(1e-6))),
        ("penalty", moved(model, penalty, Rk4)),
        ("augmented Lagrangian", moved(model, AugmentedLagrangian::new(penalty), ExplicitTrapezoidal)),
        ("null space", moved(model, NullSpace, Rk4)),
        ("partitioned", moved(model, Partitioned::default(), SemiImplicitEuler)),
        ("generalised alpha", moved(model, LagrangeIndex1, GeneralisedAlpha::new(0.8))),
        ("implicit trapezoidal", moved(model, LagrangeIndex1, ImplicitTrapezoidal::default())),
        ("index 3", moved(model, LagrangeIndex1, Ali3p::new(1e7))),
    ];

    let motions: Vec<Motion> = (0..model.independent().len())
        .map(|i| Motion { position: 0.1 + 0.1 * i as f64, rate: 1.0, acceleration: -0.5 })
        .collect();
    let led = model.kinematics(0.0, &start.q, &motions).expect("it is led");
    found.push(("kinematics", [led.q.as_slice(), led.v.as_slice(), led.a.as_slice()].concat()));

    let mut simulation = Simulation::new(model, start.clone()).sampled(|time, _| push::<S>(time)).step(0.02);
    let happened = simulation.run_until_event(5.0, &[Event::of("first").falling()], |_| ());
    let happened = happened.expect("it moves").expect("the first mass passes zero");
    found.push(("event", vec![happened.time, simulation.state().q.as_slice()[0]]));
    assert!(simulation.state().q.as_slice()[0].abs() < 1e-8);

    let mut simulation = Simulation::new(model, start.clone()).sampled(|time, _| push::<S>(time)).step(0.1);
    let (mut samples, mut adaptive) = (Vec::new(), Vec::new());
    simulation.run_until(0.5, |sample| samples.extend(entries::<S>(&sample.state))).expect("it moves");
    let mut simulation = simulation.integrator(DormandPrince::tolerance(1e-7));
    simulation.run_every(0.03, 1.0, |sample| adaptive.extend(entries::<S>(&sample.state))).expect("it moves");
    found.extend([("samples", samples), ("samples at even times", adaptive)]);

    let at = Linearisation::at(model, 0.2, &start, &push::<S>(0.2)).expect("it is regular");
    let space = at.state_space().expect("it has coordinates");
    found.push(("state matrix", [space.a.as_slice(), space.b.as_slice(), space.c.as_slice()].concat()));
    let a = at.acceleration();
    let acting = actuation(model, 0.2, &start, a, &push::<S>(0.2), &["push"]);
    // One force is enough for one freedom only.
    found.push(("actuation", vec![acting.map_or(-1.0, |found| found.inputs.0.as_slice()[0])]));
    let rest = equilibrium(model, 0.0, &start.q, &push::<S>(0.0)).expect("there is one");
    found.push(("equilibrium", [rest.q.as_slice(), rest.lambda.as_slice()].concat()));
    found
}

#[test]
fn lists_move_as_arrays_do() {
    let lists = numbers(&Masses::<Lists>::new(4));
    for ((name, list), (_, array)) in lists.iter().zip(numbers(&Masses::<Arrays>::new(4))) {
        let bits = |numbers: &[f64]| numbers.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
        assert!(list.iter().all(|number| number.is_finite()), "{name}: {list:?}");
        assert_eq!(bits(list), bits(&array), "{name}: {list:?} {array:?}");
    }
}

#[test]
fn the_number_of_masses_is_chosen_while_the_program_runs() {
    for count in [2, 3, 7] {
        let model = Masses::<Lists>::new(count);
        let found = numbers(&model);
        let end = |name: &str| &found.iter().find(|(known, _)| *known == name).unwrap().1;
        // Methods of order 4 at a step that resolves the motion agree.
        let (first, second) = (end("Runge and Kutta"), end("Dormand and Prince"));
        for (a, b) in first.iter().zip(second) {
            assert!((a - b).abs() < 1e-5, "{count}: {first:?} {second:?}");
        }
        assert_eq!(end("start").len(), 2 * count);
    }
}

#[test]
fn errors_name_rows_and_coordinates() {
    let model = Masses::<Lists>::new(3);
    let mut start = model.assemble(&model.start()).unwrap();
    start.q.as_mut_slice()[1] += 0.5;
    let mut simulation = Simulation::new(&model, start.clone()).sampled(|_, _| push::<Lists>(0.0)).step(0.01);
    assert!(simulation.advance().unwrap_err().to_string().contains("sphere"));
    start.v.as_mut_slice()[2] = f64::NAN;
    let mut simulation = Simulation::new(&model, start).sampled(|_, _| push::<Lists>(0.0)).step(0.01);
    assert!(simulation.advance().unwrap_err().to_string().contains("mass_2.travel"));
}
