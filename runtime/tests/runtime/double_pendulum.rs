//! A planar double pendulum in the orientations of its bodies, without constraint rows, with a torque as input.
//!
//! Angles from the x axis, gravity along −y, Δ = θ₁ − θ₂:
//! M₁₁ θ̈₁ + k cos Δ θ̈₂ = −k sin Δ ω₂² − (m₁a₁ + m₂l₁) g cos θ₁ + τ,
//! k cos Δ θ̈₁ + M₂₂ θ̈₂ = k sin Δ ω₁² − m₂a₂ g cos θ₂, with k = m₂ l₁ a₂.

use linkwright_runtime::{
    Assemble, Condition, ConditionKind, Elimination, Fields, Flips, Layout, Mechanism, MultiTurn, Row, State,
    Variables, tabled,
};
use linkwright_runtime::{Real, unwrap_angle};

#[derive(Clone, Copy, Debug)]
pub struct DoublePendulum<R = f64> {
    pub upper_inertia: R,
    pub lower_inertia: R,
    pub upper_mass: R,
    pub lower_mass: R,
    pub length: R,
    pub upper_center: R,
    pub lower_center: R,
    pub gravity: R,
}

impl<R: Real> DoublePendulum<R> {
    pub fn new() -> Self {
        let k = R::from_f64;
        DoublePendulum {
            upper_inertia: k(0.02),
            lower_inertia: k(0.03),
            upper_mass: k(1.2),
            lower_mass: k(0.8),
            length: k(0.5),
            upper_center: k(0.25),
            lower_center: k(0.3),
            gravity: k(9.81),
        }
    }

    /// The lower body hung at its centre, no gravity: both turn uniformly.
    pub fn balanced() -> Self {
        DoublePendulum { lower_center: R::ZERO, gravity: R::ZERO, ..Self::new() }
    }

    fn coupling(&self) -> R {
        self.lower_mass * self.length * self.lower_center
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Torque<R = f64> {
    pub shoulder: R,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outputs<R = f64> {
    pub upper: R,
    pub torque: R,
}

impl<R: Real> Fields<R> for Outputs<R> {
    const NAMES: &'static [&'static str] = &["upper", "torque"];
    type Array = [R; 2];

    fn from_array([upper, torque]: [R; 2]) -> Self {
        Outputs { upper, torque }
    }
    fn to_array(&self) -> [R; 2] {
        [self.upper, self.torque]
    }
}

impl<R: Real> Variables<R> for DoublePendulum<R> {
    fn layout(&self) -> &Layout<'_> {
        &Layout {
            linear: 0,
            rotations: 2,
            quaternions: 0,
            angles: &[MultiTurn { rate: &[(0, 1.0)] }, MultiTurn { rate: &[(1, 1.0), (0, -1.0)] }],
        }
    }
    type Q = [R; 8];
    type V = [R; 2];
    type Z = ();
    type Gates = ();
    type Lambda = [R; 0];
}

impl<R: Real> Mechanism<R> for DoublePendulum<R> {
    fn name(&self) -> &'static str {
        "DoublePendulum"
    }
    fn rows(&self) -> &[Row] {
        &[]
    }
    fn position_names(&self) -> &[&'static str] {
        &[
            "upper.cos",
            "upper.sin",
            "lower.cos",
            "lower.sin",
            "shoulder.turns",
            "shoulder.remainder",
            "elbow.turns",
            "elbow.remainder",
        ]
    }
    fn velocity_names(&self) -> &[&'static str] {
        &["upper.rate", "lower.rate"]
    }
    fn mass_pattern(&self) -> &[(u16, u16)] {
        &[(0, 0), (1, 0), (1, 1)]
    }
    fn jacobian_pattern(&self) -> &[(u16, u16)] {
        &[]
    }
    type Mass = [R; 3];
    type Jacobian = [R; 0];
    type Inputs = Torque<R>;
    type Outputs = Outputs<R>;

    fn mass_matrix(&self, _time: R, q: &[R; 8], mass: &mut [R; 3]) {
        let cos = q[0] * q[2] + q[1] * q[3];
        let (m1, m2, a1, a2, l) =
            (self.upper_mass, self.lower_mass, self.upper_center, self.lower_center, self.length);
        mass[0] = self.upper_inertia + m1 * a1 * a1 + m2 * l * l;
        mass[1] = self.coupling() * cos;
        mass[2] = self.lower_inertia + m2 * a2 * a2;
    }
    fn constraints(&self, _time: R, _q: &[R; 8], _phi: &mut [R; 0]) {}
    fn constraint_jacobian(&self, _time: R, _q: &[R; 8], _d: &mut [R; 0]) {}
    fn nu(&self, _time: R, _q: &[R; 8], _nu: &mut [R; 0]) {}
    fn gamma(&self, _time: R, _q: &[R; 8], _v: &[R; 2], _gamma: &mut [R; 0]) {}
    fn forces(&self, _time: R, state: &State<[R; 8], [R; 2]>, u: &Torque<R>, forces: &mut [R; 2]) {
        let State { q, v, .. } = state;
        let sin = q[1] * q[2] - q[0] * q[3];
        let (m1, m2, g) = (self.upper_mass, self.lower_mass, self.gravity);
        let first_moment = m1 * self.upper_center + m2 * self.length;
        forces[0] = u.shoulder - self.coupling() * sin * v[1] * v[1] - first_moment * g * q[0];
        forces[1] = self.coupling() * sin * v[0] * v[0] - m2 * self.lower_center * g * q[2];
    }
    fn kinetic_energy(&self, time: R, q: &[R; 8], v: &[R; 2]) -> R {
        let mut m = [R::ZERO; 3];
        self.mass_matrix(time, q, &mut m);
        (m[0] * v[0] * v[0] + m[2] * v[1] * v[1]) * R::from_f64(0.5) + m[1] * v[0] * v[1]
    }
    fn potential_energy(&self, _time: R, state: &State<[R; 8], [R; 2]>) -> R {
        let State { q, .. } = state;
        let (m1, m2) = (self.upper_mass, self.lower_mass);
        self.gravity * (m1 * self.upper_center * q[1] + m2 * (self.length * q[1] + self.lower_center * q[3]))
    }
    fn acceleration(
        &self,
        time: R,
        state: &State<[R; 8], [R; 2]>,
        u: &Torque<R>,
        a: &mut [R; 2],
        _lambda: &mut [R; 0],
    ) -> R {
        let State { q, .. } = state;
        let (mut m, mut f) = ([R::ZERO; 3], [R::ZERO; 2]);
        self.mass_matrix(time, q, &mut m);
        self.forces(time, state, u, &mut f);
        let l = m[1] / m[0];
        let d = m[2] - l * m[1];
        a[1] = (f[1] - l * f[0]) / d;
        a[0] = f[0] / m[0] - l * a[1];
        d / (m[2] + l * m[1])
    }
    fn acceleration_baumgarte(
        &self,
        time: R,
        state: &State<[R; 8], [R; 2]>,
        u: &Torque<R>,
        _two_alpha: R,
        _beta_squared: R,
        a: &mut [R; 2],
        lambda: &mut [R; 0],
    ) -> R {
        self.acceleration(time, state, u, a, lambda)
    }
    fn input_names(&self) -> &'static [&'static str] {
        &["shoulder"]
    }
    fn output_names(&self) -> &'static [&'static str] {
        Outputs::<R>::NAMES
    }
    fn internal_rates(
        &self,
        _time: R,
        _state: &State<[R; 8], [R; 2]>,
        _u: &Torque<R>,
        _a: &[R; 2],
        _lambda: &[R; 0],
        _rates: &mut (),
    ) {
    }
    fn outputs(&self, _time: R, state: &State<[R; 8], [R; 2]>, u: &Torque<R>) -> Outputs<R> {
        let State { q, .. } = state;
        Outputs { upper: q[1].atan2(q[0]), torque: u.shoulder }
    }
    fn unwrap(&self, outputs: &mut Outputs<R>, previous: &Outputs<R>) {
        outputs.upper = unwrap_angle(outputs.upper, previous.upper);
    }
}

impl<R: Real> Assemble<R> for DoublePendulum<R> {
    fn conditions(&self) -> &[Condition] {
        &[
            Condition { of: "shoulder.angle", kind: ConditionKind::Angle },
            Condition { of: "lower.angle", kind: ConditionKind::Angle },
        ]
    }
    fn start_conditions(&self) -> &[u16] {
        &[0, 1]
    }
    fn start_rates(&self) -> &[u16] {
        &[0, 1]
    }
    fn independent(&self) -> &[u16] {
        &[0, 1]
    }
    fn condition_pattern(&self) -> &[(u16, u16)] {
        &[(0, 0), (1, 1)]
    }
    fn flips(&self) -> &[Flips<'_>] {
        &[]
    }
    fn row_sizes(&self) -> Self::Lambda {
        []
    }
    fn elimination(&self) -> Elimination<'_> {
        Elimination {
            order: &[0, 2, 1, 3],
            position: &[0, 2, 1, 3],
            row_start: &[0, 0, 1, 3, 4],
            columns: &[0, 0, 1, 2],
        }
    }
    type Conditions = [R; 2];
    type ConditionJacobian = [R; 2];
    type Factor = [R; 4];
    type System = [R; 4];
    type Dense = [R; 0];
    type Basis = [R; 4];
    type Reduced = [R; 4];
    type Choice = [u16; 2];
    type Store = tabled::Store<R, Self>;
    type Lu = ();

    fn choice(&self) -> [u16; 2] {
        [0; 2]
    }
    fn lu(&self) {}
    fn store(&self) -> Self::Store {
        tabled::store(self)
    }
    fn row_scales(&self, scales: &mut [R; 0]) {
        *scales = [];
    }
    fn factor(&self, time: R, q: &Self::Q, compliance: R, store: &mut Self::Store) -> R {
        tabled::factor(self, time, q, compliance, store)
    }
    fn solve(
        &self,
        store: &Self::Store,
        forces: &Self::V,
        rows: &Self::Lambda,
        a: &mut Self::V,
        lambda: &mut Self::Lambda,
    ) {
        tabled::solve(self, store, forces, rows, a, lambda);
    }

    fn condition_residual(&self, _time: R, q: &[R; 8], target: &[R; 2], residual: &mut [R; 2]) {
        for i in 0..2 {
            residual[i] = q[2 * i + 1] * target[i].cos() - q[2 * i] * target[i].sin();
        }
    }
    fn condition_cosines(&self, _time: R, q: &[R; 8], target: &[R; 2], flipped: &mut [R; 2]) {
        for i in 0..2 {
            flipped[i] = q[2 * i] * target[i].cos() + q[2 * i + 1] * target[i].sin();
        }
    }
    fn condition_jacobian(&self, _time: R, _q: &[R; 8], jacobian: &mut [R; 2]) {
        *jacobian = [R::ONE; 2];
    }
    fn condition_bias(&self, _time: R, _q: &[R; 8], _v: &[R; 2], bias: &mut [R; 2]) {
        *bias = [R::ZERO; 2];
    }
    fn condition_drift(&self, _time: R, _q: &[R; 8], drift: &mut [R; 2]) {
        *drift = [R::ZERO; 2];
    }
    fn row_cosines(&self, _time: R, _q: &[R; 8], _cosines: &mut [R; 0]) {}
    fn start_targets(&self, positions: &mut [R; 2], rates: &mut [R; 2]) {
        *positions = [R::from_f64(0.3), R::from_f64(-2.0)];
        *rates = [R::ONE, R::from_f64(-3.0)];
    }
    fn start_q(&self) -> [R; 8] {
        let mut q = [R::ZERO; 8];
        (q[0], q[2]) = (R::ONE, R::ONE);
        q
    }
    fn start_v(&self) -> [R; 2] {
        [R::ZERO; 2]
    }
    fn start_internal(&self) {}
    fn start_gates(&self) {}
}
