//! A planar four-bar in absolute coordinates: three rods, four revolute joints, nothing given from outside.
//!
//! A joint place is (u, 0) on a rod, u from its centre, or a point of the ground. Its position is (x + u c, y + u s),
//! its velocity (ẋ − u s ω, ẏ + u c ω), its acceleration at v̇ = 0 −u ω² (c, s).

use crate::solve::{baumgarte, equations_of_motion, full_columns, full_row_start, natural};
use linkwright_runtime::unwrap_angle;
use linkwright_runtime::{
    Assemble, Condition, ConditionKind, Elimination, Flips, Layout, Mechanism, MultiTurn, Row, State,
    Variables, tabled,
};

#[derive(Clone, Copy, Debug)]
pub struct FourBar {
    /// Lengths of crank, coupler and rocker, m.
    pub lengths: [f64; 3],
    pub masses: [f64; 3],
    pub ground: f64,
    pub gravity: f64,
    pub start_angle: f64,
    pub start_rate: f64,
}

pub type Q = [f64; 14];
pub type V = [f64; 9];

impl FourBar {
    pub fn new() -> Self {
        FourBar {
            lengths: [0.1, 0.35, 0.25],
            masses: [0.2, 0.7, 0.5],
            ground: 0.4,
            gravity: 9.81,
            start_angle: 1.0,
            start_rate: 12.0,
        }
    }

    /// (body, u) of the two places of each joint; body 3 is the ground at x = u.
    fn joints(&self) -> [[(usize, f64); 2]; 4] {
        let [crank, coupler, rocker] = self.lengths.map(|length| length / 2.0);
        [
            [(3, 0.0), (0, -crank)],
            [(0, crank), (1, -coupler)],
            [(1, coupler), (2, rocker)],
            [(2, -rocker), (3, self.ground)],
        ]
    }

    fn pair(q: &Q, body: usize) -> (f64, f64) {
        (q[6 + 2 * body], q[7 + 2 * body])
    }

    /// A rough position with the crank, coupler and rocker at these angles.
    pub fn rough(&self, angles: [f64; 3]) -> Q {
        let mut q = [0.0; 14];
        let [crank, coupler, rocker] = self.lengths;
        for (body, angle) in angles.into_iter().enumerate() {
            (q[6 + 2 * body], q[7 + 2 * body]) = (angle.cos(), angle.sin());
        }
        (q[0], q[1]) = (crank / 2.0 * q[6], crank / 2.0 * q[7]);
        (q[2], q[3]) = (crank * q[6] + coupler / 2.0 * q[8], crank * q[7] + coupler / 2.0 * q[9]);
        (q[4], q[5]) = (self.ground + rocker / 2.0 * q[10], rocker / 2.0 * q[11]);
        q[13] = angles[0];
        q
    }

    pub fn rough_start(&self) -> State<Q, V> {
        State::new(self.rough([0.9, 0.5, 1.6]), [0.0; 9])
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outputs {
    pub crank: f64,
}

/// The velocity columns of the two rows of a joint's place.
const fn columns(body: u16) -> [u16; 3] {
    [2 * body, 2 * body + 1, 6 + body]
}

const JACOBIAN_PATTERN: [(u16, u16); 24] = {
    let bodies: [[u16; 2]; 4] = [[3, 0], [0, 1], [1, 2], [2, 3]];
    let mut pattern = [(0, 0); 24];
    let (mut at, mut row) = (0, 0);
    while row < 8 {
        // Positions before rotations, so that columns ascend.
        let mut part = 0;
        while part < 4 {
            let body = bodies[row / 2][part % 2];
            if body < 3 {
                let column = if part < 2 { columns(body)[row % 2] } else { columns(body)[2] };
                pattern[at] = (row as u16, column);
                at += 1;
            }
            part += 1;
        }
        row += 1;
    }
    pattern
};

impl Variables<f64> for FourBar {
    fn layout(&self) -> &Layout<'_> {
        &Layout { linear: 6, rotations: 3, quaternions: 0, angles: &[MultiTurn { rate: &[(6, 1.0)] }] }
    }
    type Q = Q;
    type V = V;
    type Z = ();
    type Gates = ();
    type Lambda = [f64; 8];
}

impl Mechanism<f64> for FourBar {
    fn name(&self) -> &'static str {
        "FourBar"
    }
    fn rows(&self) -> &[Row] {
        &[
            Row { of: "crank_pin", what: "x" },
            Row { of: "crank_pin", what: "y" },
            Row { of: "coupler_pin", what: "x" },
            Row { of: "coupler_pin", what: "y" },
            Row { of: "rocker_pin", what: "x" },
            Row { of: "rocker_pin", what: "y" },
            Row { of: "bearing", what: "x" },
            Row { of: "bearing", what: "y" },
        ]
    }
    fn position_names(&self) -> &[&'static str] {
        &[
            "crank.x",
            "crank.y",
            "coupler.x",
            "coupler.y",
            "rocker.x",
            "rocker.y",
            "crank.cos",
            "crank.sin",
            "coupler.cos",
            "coupler.sin",
            "rocker.cos",
            "rocker.sin",
            "crank.turns",
            "crank.remainder",
        ]
    }
    fn velocity_names(&self) -> &[&'static str] {
        &[
            "crank.vx",
            "crank.vy",
            "coupler.vx",
            "coupler.vy",
            "rocker.vx",
            "rocker.vy",
            "crank.rate",
            "coupler.rate",
            "rocker.rate",
        ]
    }
    fn mass_pattern(&self) -> &[(u16, u16)] {
        &[(0, 0), (1, 1), (2, 2), (3, 3), (4, 4), (5, 5), (6, 6), (7, 7), (8, 8)]
    }
    fn jacobian_pattern(&self) -> &[(u16, u16)] {
        &JACOBIAN_PATTERN
    }
    type Mass = [f64; 9];
    type Jacobian = [f64; 24];
    type Inputs = ();
    type Outputs = Outputs;

    fn mass_matrix(&self, _time: f64, _q: &Q, mass: &mut [f64; 9]) {
        for body in 0..3 {
            let m = self.masses[body];
            (mass[2 * body], mass[2 * body + 1]) = (m, m);
            mass[6 + body] = m * self.lengths[body].powi(2) / 12.0;
        }
    }
    fn constraints(&self, _time: f64, q: &Q, phi: &mut [f64; 8]) {
        *phi = [0.0; 8];
        for (joint, places) in self.joints().into_iter().enumerate() {
            for ((body, u), sign) in places.into_iter().zip([1.0, -1.0]) {
                let place = match body {
                    3 => [u, 0.0],
                    _ => {
                        let (c, s) = Self::pair(q, body);
                        [q[2 * body] + u * c, q[2 * body + 1] + u * s]
                    }
                };
                phi[2 * joint] += sign * place[0];
                phi[2 * joint + 1] += sign * place[1];
            }
        }
    }
    fn constraint_jacobian(&self, _time: f64, q: &Q, d: &mut [f64; 24]) {
        let joints = self.joints();
        for (entry, (row, column)) in d.iter_mut().zip(JACOBIAN_PATTERN) {
            let body = if column < 6 { column / 2 } else { column - 6 } as usize;
            let second = joints[row as usize / 2][1].0 == body;
            let (_, u) = joints[row as usize / 2][usize::from(second)];
            let sign = if second { -1.0 } else { 1.0 };
            let (c, s) = Self::pair(q, body);
            *entry = match (column < 6, row % 2) {
                (true, _) => sign,
                (false, 0) => -sign * u * s,
                (false, _) => sign * u * c,
            };
        }
    }
    fn nu(&self, _time: f64, _q: &Q, nu: &mut [f64; 8]) {
        *nu = [0.0; 8];
    }
    fn gamma(&self, _time: f64, q: &Q, v: &V, gamma: &mut [f64; 8]) {
        *gamma = [0.0; 8];
        for (joint, places) in self.joints().into_iter().enumerate() {
            for ((body, u), sign) in places.into_iter().zip([1.0, -1.0]) {
                if body < 3 {
                    let (c, s) = Self::pair(q, body);
                    gamma[2 * joint] += sign * u * v[6 + body].powi(2) * c;
                    gamma[2 * joint + 1] += sign * u * v[6 + body].powi(2) * s;
                }
            }
        }
    }
    fn forces(&self, _time: f64, _state: &State<Q, V>, _u: &(), forces: &mut V) {
        *forces = [0.0; 9];
        for body in 0..3 {
            forces[2 * body + 1] = -self.masses[body] * self.gravity;
        }
    }
    fn kinetic_energy(&self, time: f64, q: &Q, v: &V) -> f64 {
        let mut mass = [0.0; 9];
        self.mass_matrix(time, q, &mut mass);
        mass.iter().zip(v).map(|(m, v)| 0.5 * m * v * v).sum()
    }
    fn potential_energy(&self, _time: f64, state: &State<Q, V>) -> f64 {
        let State { q, .. } = state;
        (0..3).map(|body| self.masses[body] * self.gravity * q[2 * body + 1]).sum()
    }
    fn acceleration(&self, time: f64, state: &State<Q, V>, u: &(), a: &mut V, lambda: &mut [f64; 8]) -> f64 {
        self.acceleration_baumgarte(time, state, u, 0.0, 0.0, a, lambda)
    }
    fn acceleration_baumgarte(
        &self,
        time: f64,
        state: &State<Q, V>,
        u: &(),
        two_alpha: f64,
        beta_squared: f64,
        a: &mut V,
        lambda: &mut [f64; 8],
    ) -> f64 {
        let State { q, v, .. } = state;
        let gamma = baumgarte(self, time, q, v, two_alpha, beta_squared);
        let mut forces = [0.0; 9];
        self.forces(time, state, u, &mut forces);
        equations_of_motion(self, time, q, &forces, &gamma, a, lambda)
    }
    fn input_names(&self) -> &'static [&'static str] {
        &[]
    }
    fn output_names(&self) -> &'static [&'static str] {
        &["crank"]
    }
    fn internal_rates(
        &self,
        _time: f64,
        _state: &State<Q, V>,
        _u: &(),
        _a: &V,
        _lambda: &[f64; 8],
        _rates: &mut (),
    ) {
    }
    fn outputs(&self, _time: f64, state: &State<Q, V>, _u: &()) -> Outputs {
        let State { q, .. } = state;
        Outputs { crank: q[7].atan2(q[6]) }
    }
    fn unwrap(&self, outputs: &mut Outputs, previous: &Outputs) {
        outputs.crank = unwrap_angle(outputs.crank, previous.crank);
    }
}

impl Assemble<f64> for FourBar {
    fn conditions(&self) -> &[Condition] {
        &[
            Condition { of: "crank_pin.angle", kind: ConditionKind::Angle },
            Condition { of: "coupler.center.y", kind: ConditionKind::Linear },
        ]
    }
    fn start_conditions(&self) -> &[u16] {
        &[0]
    }
    fn start_rates(&self) -> &[u16] {
        &[0]
    }
    fn independent(&self) -> &[u16] {
        &[0]
    }
    fn condition_pattern(&self) -> &[(u16, u16)] {
        &[(0, 6), (1, 3)]
    }
    fn flips(&self) -> &[Flips<'_>] {
        &[]
    }
    fn row_sizes(&self) -> Self::Lambda {
        [1.0; 8]
    }
    fn elimination(&self) -> Elimination<'_> {
        Elimination {
            order: const { &natural::<19>() },
            position: const { &natural::<19>() },
            row_start: const { &full_row_start::<20>() },
            columns: const { &full_columns::<19, 171>() },
        }
    }
    type Conditions = [f64; 2];
    type ConditionJacobian = [f64; 2];
    type Factor = [f64; 171];
    type System = [f64; 19];
    type Dense = [f64; 72];
    type Basis = [f64; 9];
    type Reduced = [f64; 1];
    type Choice = [u16; 9];
    type Store = tabled::Store<f64, Self>;
    type Lu = ();

    fn choice(&self) -> [u16; 9] {
        [0; 9]
    }
    fn lu(&self) {}
    fn store(&self) -> Self::Store {
        tabled::store(self)
    }
    fn row_scales(&self, scales: &mut [f64; 8]) {
        // A pin moves with the centre of its rod, 1/m, and with the turn about it, (l/2)²/(m l²/12) = 3/m.
        let lightest = self.masses.iter().fold(f64::INFINITY, |least, mass| least.min(*mass));
        *scales = [4.0 / lightest; 8];
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

    fn condition_residual(&self, _time: f64, q: &Q, target: &[f64; 2], residual: &mut [f64; 2]) {
        *residual = [q[7] * target[0].cos() - q[6] * target[0].sin(), q[3] - target[1]];
    }
    fn condition_cosines(&self, _time: f64, q: &Q, target: &[f64; 2], flipped: &mut [f64; 2]) {
        *flipped = [q[6] * target[0].cos() + q[7] * target[0].sin(), 1.0];
    }
    fn condition_jacobian(&self, _time: f64, _q: &Q, jacobian: &mut [f64; 2]) {
        *jacobian = [1.0; 2];
    }
    fn condition_bias(&self, _time: f64, _q: &Q, _v: &V, bias: &mut [f64; 2]) {
        *bias = [0.0; 2];
    }
    fn condition_drift(&self, _time: f64, _q: &Q, drift: &mut [f64; 2]) {
        *drift = [0.0; 2];
    }
    fn row_cosines(&self, _time: f64, _q: &Q, cosines: &mut [f64; 8]) {
        *cosines = [1.0; 8];
    }
    fn start_targets(&self, positions: &mut [f64; 2], rates: &mut [f64; 2]) {
        *positions = [self.start_angle, 0.0];
        *rates = [self.start_rate, 0.0];
    }
    fn start_q(&self) -> Q {
        FourBar::new().rough([0.9, 0.5, 1.6])
    }
    fn start_v(&self) -> V {
        [0.0; 9]
    }
    fn start_internal(&self) {}
    fn start_gates(&self) {}
}
