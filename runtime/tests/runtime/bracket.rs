//! A body in space welded to the ground: a quaternion with the rows of `fixed`, two of which have a second root.

use crate::solve::{baumgarte, equations_of_motion, full_columns, full_row_start, natural};
use linkwright_runtime::quaternion::rotation_matrix;
use linkwright_runtime::{
    Assemble, Condition, Elimination, Flips, Layout, Mechanism, Row, State, Variables, tabled,
};

#[derive(Clone, Copy, Debug)]
pub struct Bracket {
    pub mass: f64,
    /// Principal moments about the centre of mass, body axes.
    pub inertia: [f64; 3],
    /// The orientation of the place on the ground.
    pub place: [f64; 4],
    /// What the row z is multiplied by.
    pub weight: f64,
}

impl Bracket {
    /// The axes of the ground's place in the body's axes: Aᵀ x₁, Aᵀ y₁, Aᵀ z₁.
    fn axes(&self, q: &[f64; 7]) -> [[f64; 3]; 3] {
        let (ground, body) = (rotation_matrix(self.place), rotation_matrix([q[3], q[4], q[5], q[6]]));
        let entry = |i: usize, axis: usize| (0..3).map(|k| body[k][i] * ground[k][axis]).sum();
        [0, 1, 2].map(|axis| [0, 1, 2].map(|i| entry(i, axis)))
    }
}

pub fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

const Y: [f64; 3] = [0.0, 1.0, 0.0];
const Z: [f64; 3] = [0.0, 0.0, 1.0];

impl Variables<f64> for Bracket {
    fn layout(&self) -> &Layout<'_> {
        &Layout { linear: 3, rotations: 0, quaternions: 1, angles: &[] }
    }
    type Q = [f64; 7];
    type V = [f64; 6];
    type Z = ();
    type Gates = ();
    type Lambda = [f64; 6];
}

impl Mechanism<f64> for Bracket {
    fn name(&self) -> &'static str {
        "Bracket"
    }
    fn rows(&self) -> &[Row] {
        &[
            Row { of: "weld", what: "x" },
            Row { of: "weld", what: "y" },
            Row { of: "weld", what: "z" },
            Row { of: "weld", what: "axis_1" },
            Row { of: "weld", what: "axis_2" },
            Row { of: "weld", what: "angle" },
        ]
    }
    fn position_names(&self) -> &[&'static str] {
        &[
            "body.x",
            "body.y",
            "body.z",
            "body.orientation.w",
            "body.orientation.x",
            "body.orientation.y",
            "body.orientation.z",
        ]
    }
    fn velocity_names(&self) -> &[&'static str] {
        &["body.vx", "body.vy", "body.vz", "body.rate.x", "body.rate.y", "body.rate.z"]
    }
    fn mass_pattern(&self) -> &[(u16, u16)] {
        &[(0, 0), (1, 1), (2, 2), (3, 3), (4, 4), (5, 5)]
    }
    fn jacobian_pattern(&self) -> &[(u16, u16)] {
        &[(0, 0), (1, 1), (2, 2), (3, 3), (3, 4), (3, 5), (4, 3), (4, 4), (4, 5), (5, 3), (5, 4), (5, 5)]
    }
    type Mass = [f64; 6];
    type Jacobian = [f64; 12];
    type Inputs = ();
    type Outputs = ();

    fn mass_matrix(&self, _time: f64, _q: &[f64; 7], mass: &mut [f64; 6]) {
        let [a, b, c] = self.inertia;
        *mass = [self.mass, self.mass, self.mass, a, b, c];
    }
    fn constraints(&self, _time: f64, q: &[f64; 7], phi: &mut [f64; 6]) {
        let [x1, y1, _] = self.axes(q);
        *phi = [q[0], q[1], self.weight * q[2], dot(x1, Z), dot(y1, Z), dot(x1, Y)];
    }
    fn constraint_jacobian(&self, _time: f64, q: &[f64; 7], d: &mut [f64; 12]) {
        // d/dt (x₁·A z) = x₁·A (ω × z) = ω·(z × Aᵀ x₁)
        let [x1, y1, _] = self.axes(q);
        let rows = [cross(Z, x1), cross(Z, y1), cross(Y, x1)];
        [d[0], d[1], d[2]] = [1.0, 1.0, self.weight];
        d[3..].copy_from_slice(rows.as_flattened());
    }
    fn nu(&self, _time: f64, _q: &[f64; 7], nu: &mut [f64; 6]) {
        *nu = [0.0; 6];
    }
    fn gamma(&self, _time: f64, q: &[f64; 7], v: &[f64; 6], gamma: &mut [f64; 6]) {
        let ([x1, y1, _], omega) = (self.axes(q), [v[3], v[4], v[5]]);
        let bend = |axis| cross(omega, cross(omega, axis));
        *gamma = [0.0, 0.0, 0.0, -dot(x1, bend(Z)), -dot(y1, bend(Z)), -dot(x1, bend(Y))];
    }
    fn forces(&self, _time: f64, state: &State<[f64; 7], [f64; 6]>, _u: &(), forces: &mut [f64; 6]) {
        let State { v, .. } = state;
        let omega = [v[3], v[4], v[5]];
        let spin = [0, 1, 2].map(|i| self.inertia[i] * omega[i]);
        let [x, y, z] = cross(spin, omega);
        *forces = [0.0, 0.0, -9.81 * self.mass, x, y, z];
    }
    fn kinetic_energy(&self, time: f64, q: &[f64; 7], v: &[f64; 6]) -> f64 {
        let mut mass = [0.0; 6];
        self.mass_matrix(time, q, &mut mass);
        (0..6).map(|i| 0.5 * mass[i] * v[i] * v[i]).sum()
    }
    fn potential_energy(&self, _time: f64, state: &State<[f64; 7], [f64; 6]>) -> f64 {
        let State { q, .. } = state;
        9.81 * self.mass * q[2]
    }
    fn acceleration(
        &self,
        time: f64,
        state: &State<[f64; 7], [f64; 6]>,
        u: &(),
        a: &mut [f64; 6],
        lambda: &mut [f64; 6],
    ) -> f64 {
        self.acceleration_baumgarte(time, state, u, 0.0, 0.0, a, lambda)
    }
    fn acceleration_baumgarte(
        &self,
        time: f64,
        state: &State<[f64; 7], [f64; 6]>,
        u: &(),
        two_alpha: f64,
        beta_squared: f64,
        a: &mut [f64; 6],
        lambda: &mut [f64; 6],
    ) -> f64 {
        let State { q, v, .. } = state;
        let gamma = baumgarte(self, time, q, v, two_alpha, beta_squared);
        let mut forces = [0.0; 6];
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
        _state: &State<[f64; 7], [f64; 6]>,
        _u: &(),
        _a: &[f64; 6],
        _lambda: &[f64; 6],
        _rates: &mut (),
    ) {
    }
    fn outputs(&self, _time: f64, _state: &State<[f64; 7], [f64; 6]>, _u: &()) {}
    fn unwrap(&self, _outputs: &mut (), _previous: &()) {}
}

impl Assemble<f64> for Bracket {
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
        &[Flips { axes: Some([3, 4]), turns: &[5] }]
    }
    fn row_sizes(&self) -> Self::Lambda {
        [1.0; 6]
    }
    fn elimination(&self) -> Elimination<'_> {
        Elimination {
            order: const { &natural::<12>() },
            position: const { &natural::<12>() },
            row_start: const { &full_row_start::<13>() },
            columns: const { &full_columns::<12, 66>() },
        }
    }
    type Conditions = [f64; 0];
    type ConditionJacobian = [f64; 0];
    type Factor = [f64; 66];
    type System = [f64; 12];
    type Dense = [f64; 36];
    type Basis = [f64; 0];
    type Reduced = [f64; 0];
    type Choice = [u16; 6];
    type Store = tabled::Store<f64, Self>;
    type Lu = ();

    fn choice(&self) -> [u16; 6] {
        [0; 6]
    }
    fn lu(&self) {}
    fn store(&self) -> Self::Store {
        tabled::store(self)
    }
    fn row_scales(&self, scales: &mut [f64; 6]) {
        let turned: f64 = self.inertia.iter().map(|inertia| 1.0 / inertia).sum();
        let moved = 1.0 / self.mass;
        *scales = [moved, moved, self.weight * self.weight * moved, turned, turned, turned];
    }
    fn factor(&self, time: f64, q: &Self::Q, compliance: f64, store: &mut Self::Store) -> f64 {
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

    fn condition_residual(&self, _time: f64, _q: &[f64; 7], _target: &[f64; 0], _residual: &mut [f64; 0]) {}
    fn condition_cosines(&self, _time: f64, _q: &[f64; 7], _target: &[f64; 0], _flipped: &mut [f64; 0]) {}
    fn condition_jacobian(&self, _time: f64, _q: &[f64; 7], _jacobian: &mut [f64; 0]) {}
    fn condition_bias(&self, _time: f64, _q: &[f64; 7], _v: &[f64; 6], _bias: &mut [f64; 0]) {}
    fn condition_drift(&self, _time: f64, _q: &[f64; 7], _drift: &mut [f64; 0]) {}
    fn row_cosines(&self, _time: f64, q: &[f64; 7], cosines: &mut [f64; 6]) {
        let [_, y1, z1] = self.axes(q);
        *cosines = [1.0, 1.0, 1.0, dot(z1, Z), dot(z1, Z), dot(y1, Y)];
    }
    fn start_targets(&self, _positions: &mut [f64; 0], _rates: &mut [f64; 0]) {}
    fn start_q(&self) -> [f64; 7] {
        [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]
    }
    fn start_v(&self) -> [f64; 6] {
        [0.0; 6]
    }
    fn start_internal(&self) {}
    fn start_gates(&self) {}
}
