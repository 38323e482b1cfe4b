//! A body welded to a support that slides with x = t²/10: time in the constraints, an angle row with a second root.

use crate::solve::{baumgarte, equations_of_motion, full_columns, full_row_start, natural};
use linkwright_runtime::{Assemble, Condition, Elimination, Flips, Layout, Mechanism, Row, State, Variables};

#[derive(Clone, Copy, Debug)]
pub struct Support {
    pub mass: f64,
    pub angle: f64,
}

impl Variables<f64> for Support {
    fn layout(&self) -> &Layout<'_> {
        &Layout { linear: 2, rotations: 1, quaternions: 0, angles: &[] }
    }
    type Q = [f64; 4];
    type V = [f64; 3];
    type Z = ();
    type Gates = ();
    type Lambda = [f64; 3];
}

impl Mechanism<f64> for Support {
    fn name(&self) -> &'static str {
        "Support"
    }
    fn rows(&self) -> &[Row] {
        &[Row { of: "weld", what: "x" }, Row { of: "weld", what: "y" }, Row { of: "weld", what: "angle" }]
    }
    fn position_names(&self) -> &[&'static str] {
        &["body.x", "body.y", "body.cos", "body.sin"]
    }
    fn velocity_names(&self) -> &[&'static str] {
        &["body.vx", "body.vy", "body.rate"]
    }
    fn mass_pattern(&self) -> &[(u16, u16)] {
        &[(0, 0), (1, 1), (2, 2)]
    }
    fn jacobian_pattern(&self) -> &[(u16, u16)] {
        &[(0, 0), (1, 1), (2, 2)]
    }
    type Mass = [f64; 3];
    type Jacobian = [f64; 3];
    type Inputs = ();
    type Outputs = ();

    fn mass_matrix(&self, _time: f64, _q: &[f64; 4], mass: &mut [f64; 3]) {
        *mass = [self.mass, self.mass, 0.0];
    }
    fn constraints(&self, time: f64, q: &[f64; 4], phi: &mut [f64; 3]) {
        let sine = q[3] * self.angle.cos() - q[2] * self.angle.sin();
        *phi = [q[0] - 0.1 * time * time, q[1], sine];
    }
    fn constraint_jacobian(&self, _time: f64, q: &[f64; 4], d: &mut [f64; 3]) {
        *d = [1.0, 1.0, q[2] * self.angle.cos() + q[3] * self.angle.sin()];
    }
    fn nu(&self, time: f64, _q: &[f64; 4], nu: &mut [f64; 3]) {
        *nu = [0.2 * time, 0.0, 0.0];
    }
    fn gamma(&self, _time: f64, q: &[f64; 4], v: &[f64; 3], gamma: &mut [f64; 3]) {
        let sine = q[3] * self.angle.cos() - q[2] * self.angle.sin();
        *gamma = [0.2, 0.0, sine * v[2] * v[2]];
    }
    fn forces(&self, _time: f64, _state: &State<[f64; 4], [f64; 3]>, _u: &(), forces: &mut [f64; 3]) {
        *forces = [0.0, -9.81 * self.mass, 0.0];
    }
    fn kinetic_energy(&self, _time: f64, _q: &[f64; 4], v: &[f64; 3]) -> f64 {
        0.5 * self.mass * (v[0] * v[0] + v[1] * v[1])
    }
    fn potential_energy(&self, _time: f64, state: &State<[f64; 4], [f64; 3]>) -> f64 {
        let State { q, .. } = state;
        9.81 * self.mass * q[1]
    }
    fn acceleration(
        &self,
        time: f64,
        state: &State<[f64; 4], [f64; 3]>,
        u: &(),
        a: &mut [f64; 3],
        lambda: &mut [f64; 3],
    ) -> f64 {
        self.acceleration_baumgarte(time, state, u, 0.0, 0.0, a, lambda)
    }
    fn acceleration_baumgarte(
        &self,
        time: f64,
        state: &State<[f64; 4], [f64; 3]>,
        u: &(),
        two_alpha: f64,
        beta_squared: f64,
        a: &mut [f64; 3],
        lambda: &mut [f64; 3],
    ) -> f64 {
        let State { q, v, .. } = state;
        let gamma = baumgarte(self, time, q, v, two_alpha, beta_squared);
        let mut forces = [0.0; 3];
        self.forces(time, state, u, &mut forces);
        equations_of_motion(self, time, q, &forces, &gamma, a, lambda)
    }
    fn input_names(&self) -> &'static [&'static str] {
        &[]
    }
    fn output_names(&self) -> &'static [&'static str] {
        &[]
    }
    fn internal_rates(
        &self,
        _time: f64,
        _state: &State<[f64; 4], [f64; 3]>,
        _u: &(),
        _a: &[f64; 3],
        _lambda: &[f64; 3],
        _rates: &mut (),
    ) {
    }
    fn outputs(&self, _time: f64, _state: &State<[f64; 4], [f64; 3]>, _u: &()) {}
    fn unwrap(&self, _outputs: &mut (), _previous: &()) {}
}

impl Assemble<f64> for Support {
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
        &[Flips { axes: None, turns: &[2] }]
    }
    fn row_sizes(&self) -> Self::Lambda {
        [1.0; 3]
    }
    fn elimination(&self) -> Elimination<'_> {
        Elimination {
            order: const { &natural::<6>() },
            position: const { &natural::<6>() },
            row_start: const { &full_row_start::<7>() },
            columns: const { &full_columns::<6, 15>() },
        }
    }
    type Conditions = [f64; 0];
    type ConditionJacobian = [f64; 0];
    type Factor = [f64; 15];
    type System = [f64; 6];
    type Dense = [f64; 9];
    type Basis = [f64; 0];
    type Reduced = [f64; 0];
    type Choice = [u16; 3];
    type Store = linkwright_runtime::tabled::Store<f64, Self>;
    type Lu = ();
    fn choice(&self) -> [u16; 3] {
        [0; 3]
    }
    fn lu(&self) {}
    fn store(&self) -> Self::Store {
        linkwright_runtime::tabled::store(self)
    }
    fn row_scales(&self, scales: &mut [f64; 3]) {
        *scales = [1.0; 3];
    }
    fn factor(&self, time: f64, q: &Self::Q, compliance: f64, store: &mut Self::Store) -> f64 {
        linkwright_runtime::tabled::factor(self, time, q, compliance, store)
    }
    fn solve(
        &self,
        store: &Self::Store,
        forces: &Self::V,
        rows: &Self::Lambda,
        a: &mut Self::V,
        lambda: &mut Self::Lambda,
    ) {
        linkwright_runtime::tabled::solve(self, store, forces, rows, a, lambda);
    }

    fn condition_residual(&self, _time: f64, _q: &[f64; 4], _target: &[f64; 0], _residual: &mut [f64; 0]) {}
    fn condition_cosines(&self, _time: f64, _q: &[f64; 4], _target: &[f64; 0], _flipped: &mut [f64; 0]) {}
    fn condition_jacobian(&self, _time: f64, _q: &[f64; 4], _jacobian: &mut [f64; 0]) {}
    fn condition_bias(&self, _time: f64, _q: &[f64; 4], _v: &[f64; 3], _bias: &mut [f64; 0]) {}
    fn condition_drift(&self, _time: f64, _q: &[f64; 4], _drift: &mut [f64; 0]) {}
    fn row_cosines(&self, _time: f64, q: &[f64; 4], cosines: &mut [f64; 3]) {
        *cosines = [1.0, 1.0, q[2] * self.angle.cos() + q[3] * self.angle.sin()];
    }
    fn start_targets(&self, _positions: &mut [f64; 0], _rates: &mut [f64; 0]) {}
    fn start_q(&self) -> [f64; 4] {
        [0.0, 0.0, 1.0, 0.0]
    }
    fn start_v(&self) -> [f64; 3] {
        [0.0; 3]
    }
    fn start_internal(&self) {}
    fn start_gates(&self) {}
}
