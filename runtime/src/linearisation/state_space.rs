//! ẋ = A x + B u, y = C x + D u: small motions about a state, in as many coordinates as there are degrees of freedom.

use super::coordinates::Coordinates;
use super::{ColumnsOf, Linearisation, ResponseOf, add_block, add_column, check_finite, unit};
use crate::error::LinearisationError;
use crate::fields::Fields;
use crate::mechanism::{Assemble, ConditionKind};
use crate::real::Real;
use crate::state::State;
use crate::tangent::Tangent;
use crate::vector::{Vector, put};

/// Matrices of a linearised mechanism, dense and row by row.
///
/// x = (δs, δṡ, δz): the coordinates of [`Tangent::states`] and their rates, f numbers each, m, rad, m/s, rad/s, then the n_z internal
/// states in their units; n_x = 2f + n_z. u and y in the order of inputs and outputs, SI. About a motion they hold at one time; about an equilibrium they are constant and the eigenvalues of A tell
/// stability.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StateSpace<A, B, C, D> {
    /// `[R; n_x·n_x]`.
    pub a: A,
    /// `[R; n_x·n_u]`.
    pub b: B,
    /// `[R; n_y·n_x]`.
    pub c: C,
    /// `[R; n_y·n_u]`.
    pub d: D,
}

/// [`StateSpace`] of a mechanism.
pub type StateSpaceOf<R, M> = StateSpace<
    <M as Tangent<R>>::StateMatrix,
    <M as Tangent<R>>::InputMatrix,
    <M as Tangent<R>>::OutputMatrix,
    <M as Tangent<R>>::Feedthrough,
>;

impl<'m, R: Real, M: Tangent<R>> Linearisation<'m, R, M> {
    /// A, B, C and D at the state, which must satisfy the constraints.
    ///
    /// Column by column, from a motion that the constraints admit:
    ///
    /// ```text
    /// s:  D δq = 0, B δq = e;   D δv = −∂(D v − ν)/∂q δq, B δv = −∂(B v)/∂q δq
    /// ṡ:  δq = 0;               D δv = 0, B δv = e
    /// z:  δq = 0, δv = 0, δz = e
    /// then δv̇, δλ by K(0);      δs̈ = ∂(B a + b)/∂q δq + ∂(B a + b)/∂v δv + B δv̇
    ///                           δż, δy = ∂/∂q δq + ∂/∂v δv + ∂/∂z δz + ∂/∂v̇ δv̇ + ∂/∂λ δλ
    /// ```
    /// with ṡ = B v (and more where places move with time), s̈ = B a + b. Where a coordinate is a component of ω, its δs is the
    /// turn about that axis of the body, and δṡ is not the rate of δs but that rate and ω × δs (turned axes) apart.
    ///
    /// # Errors
    /// [`Assembly`](LinearisationError::Assembly) where the coordinates do not move the whole at this position (a dead centre of
    /// theirs), [`Incomplete`](LinearisationError::Incomplete), [`NonFinite`](LinearisationError::NonFinite).
    pub fn state_space(&self) -> Result<StateSpaceOf<R, M>, LinearisationError> {
        let model = self.model;
        let columns = Columns::at(self)?;
        let (f, inputs, outputs) =
            (model.states().len(), model.input_names().len(), model.output_names().len());
        let internal = model.internal_count();
        let size = 2 * f + internal;
        let mut found = StateSpace {
            a: M::StateMatrix::zeros(size * size),
            b: M::InputMatrix::zeros(size * inputs),
            c: M::OutputMatrix::zeros(outputs * size),
            d: M::Feedthrough::zeros(outputs * inputs),
        };
        let (none, still) = (model.zero_v(), model.zero_z());
        for state in 0..f {
            let moved = columns.coordinates.position(state);
            let dv = columns.coordinates.velocity(&moved);
            columns.fill(state, &moved, &dv, &still, &mut found);
            columns.fill(f + state, &none, &moved, &still, &mut found);
        }
        for state in 0..internal {
            columns.fill(2 * f + state, &none, &none, &unit(model.zero_z(), state), &mut found);
        }
        for input in 0..inputs {
            columns.fill_input(input, &mut found);
        }
        let (state, output) = (
            |index: usize| match index.checked_sub(2 * f) {
                Some(internal) => model.internal_names().get(internal).copied(),
                None => {
                    let condition = model.states().get(index % f.max(1));
                    condition.and_then(|&at| model.conditions().get(at as usize)).map(|at| at.of)
                }
            },
            |row: usize| model.output_names().get(row).copied(),
        );
        let by_state = |width: usize| move |index: usize| state(index / width.max(1));
        check_finite(self.time, found.a.as_slice(), by_state(size))?;
        check_finite(self.time, found.b.as_slice(), by_state(inputs))?;
        check_finite(self.time, found.c.as_slice(), |index| output(index / size.max(1)))?;
        check_finite(self.time, found.d.as_slice(), |index| output(index / inputs.max(1)))?;
        Ok(found)
    }
    /// C and D of [`state_space`](Linearisation::state_space) alone: how the outputs answer to x = (δs, δṡ, δz) and to the inputs, what an
    /// estimator asks of a measurement y = h(x, u). Outputs may name accelerations and reactions; these move as the equations of motion say.
    ///
    /// # Errors
    /// As [`state_space`](Linearisation::state_space).
    pub fn output_matrices(&self) -> Result<(M::OutputMatrix, M::Feedthrough), LinearisationError> {
        let (model, columns) = (self.model, Columns::at(self)?);
        let (f, internal) = (model.states().len(), model.internal_count());
        let (inputs, outputs) = (model.input_names().len(), model.output_names().len());
        let mut c = M::OutputMatrix::zeros(outputs * (2 * f + internal));
        let mut d = M::Feedthrough::zeros(outputs * inputs);
        let (none, still) = (model.zero_v(), model.zero_z());
        let mut fill = |column: usize, moved: (&M::V, &M::V, &M::Z)| {
            columns.fill_outputs(column, moved, &self.along_state(moved.0, moved.1, moved.2), &mut c);
        };
        for state in 0..f {
            let moved = columns.coordinates.position(state);
            fill(state, (&moved, &columns.coordinates.velocity(&moved), &still));
            fill(f + state, (&none, &moved, &still));
        }
        for state in 0..internal {
            fill(2 * f + state, (&none, &none, &unit(model.zero_z(), state)));
        }
        for input in 0..inputs {
            columns.fill_feedthrough(input, &self.by_input(input), &mut d);
        }
        let output = |row: usize| model.output_names().get(row).copied();
        check_finite(self.time, c.as_slice(), |index| output(index / (2 * f + internal).max(1)))?;
        check_finite(self.time, d.as_slice(), |index| output(index / inputs.max(1)))?;
        Ok((c, d))
    }
}

/// The parts that columns are made of.
pub(super) struct Columns<'l, 'm, R: Real, M: Tangent<R>> {
    at: &'l Linearisation<'m, R, M>,
    pub(super) coordinates: Coordinates<'m, R, M>,
    output: M::OutputTangent,
    columns: ColumnsOf,
}

impl<'l, 'm, R: Real, M: Tangent<R>> Columns<'l, 'm, R, M> {
    pub(super) fn at(at: &'l Linearisation<'m, R, M>) -> Result<Self, LinearisationError> {
        let Linearisation { model, time, state, u, a, lambda, .. } = at;
        let coordinates = Coordinates::at(*model, *time, state, a)?;
        let mut output = model.zero_output_tangent();
        model.output_tangent(*time, state, u, a, lambda, &mut output);
        Ok(Columns { at, coordinates, output, columns: ColumnsOf::of(*model) })
    }

    /// One column of A and of C.
    fn fill(&self, column: usize, dq: &M::V, dv: &M::V, dz: &M::Z, found: &mut StateSpaceOf<R, M>) {
        let model = self.at.model;
        let (f, n) = (model.states().len(), model.velocity_count());
        let size = 2 * f + model.internal_count();
        let response = self.at.along_state(dq, dv, dz);
        let mut states = model.zero_conditions();
        let lower = &mut states.as_mut_slice()[..f];
        self.coordinates.add((f, 0), dq, lower);
        self.coordinates.add((f, n), dv, lower);
        self.coordinates.add((0, n), &response.acceleration, lower);
        let internal = self.at.internal_rates(dq, dv, dz, &response);
        for (state, &entry) in lower.iter().chain(internal.as_slice()).enumerate() {
            put(found.a.as_mut_slice(), (f + state) * size + column, entry);
        }
        if column < f {
            self.fill_rates(column, dq, found);
        } else if column < 2 * f {
            put(found.a.as_mut_slice(), (column - f) * size + column, R::ONE);
        }
        self.fill_outputs(column, (dq, dv, dz), &response, &mut found.c);
    }

    /// One column of C.
    fn fill_outputs(
        &self,
        column: usize,
        (dq, dv, dz): (&M::V, &M::V, &M::Z),
        response: &ResponseOf<R, M>,
        c: &mut M::OutputMatrix,
    ) {
        let model = self.at.model;
        let (n, size) = (model.velocity_count(), 2 * model.states().len() + model.internal_count());
        let mut outputs = <M::Outputs as Fields<R>>::Array::zeros(model.output_names().len());
        self.add_outputs(0, dq.as_slice(), outputs.as_mut_slice());
        self.add_outputs(n, dv.as_slice(), outputs.as_mut_slice());
        self.add_outputs(self.columns.internal, dz.as_slice(), outputs.as_mut_slice());
        self.add_response(response, outputs.as_mut_slice());
        for (output, &entry) in outputs.as_slice().iter().enumerate() {
            put(c.as_mut_slice(), output * size + column, entry);
        }
    }

    /// The rates of components of ω: d(B δq)/dt − δ(B v) = ∂(B δq)/∂q v − ∂(B v)/∂q δq + B (δq × ω), zero for coordinates.
    fn fill_rates(&self, column: usize, dq: &M::V, found: &mut StateSpaceOf<R, M>) {
        let model = self.at.model;
        let kind = |state: usize| model.conditions()[model.states()[state] as usize].kind;
        let f = model.states().len();
        if (0..f).all(|state| kind(state) != ConditionKind::Rate) {
            return;
        }
        let Linearisation { model, time, state: State { q, v, .. }, a, .. } = self.at;
        let mut turned = model.zero_coordinate_tangent();
        model.coordinate_tangent(*time, q, dq, a, &mut turned);
        let mut states = model.zero_conditions();
        let rates = &mut states.as_mut_slice()[..f];
        self.coordinates.add((0, 0), dq, rates);
        rates.iter_mut().for_each(|entry| *entry = -*entry);
        add_block(model.coordinate_pattern(), turned.as_slice(), (0, 0), v.as_slice(), rates);
        self.coordinates.add((0, model.velocity_count()), &bracket(*model, dq, v), rates);
        for (state, &entry) in rates.iter().enumerate() {
            if kind(state) == ConditionKind::Rate {
                let size = 2 * f + model.internal_count();
                put(found.a.as_mut_slice(), state * size + column, entry);
            }
        }
    }

    /// One column of B and of D.
    fn fill_input(&self, input: usize, found: &mut StateSpaceOf<R, M>) {
        let model = self.at.model;
        let (f, n, inputs) = (model.states().len(), model.velocity_count(), model.input_names().len());
        let response = self.at.by_input(input);
        let mut states = model.zero_conditions();
        let lower = &mut states.as_mut_slice()[..f];
        self.coordinates.add((0, n), &response.acceleration, lower);
        let internal = self.at.internal_rates_by_input(input, &response);
        for (state, &entry) in lower.iter().chain(internal.as_slice()).enumerate() {
            put(found.b.as_mut_slice(), (f + state) * inputs + input, entry);
        }
        self.fill_feedthrough(input, &response, &mut found.d);
    }

    /// One column of D.
    fn fill_feedthrough(&self, input: usize, response: &ResponseOf<R, M>, d: &mut M::Feedthrough) {
        let model = self.at.model;
        let mut outputs = <M::Outputs as Fields<R>>::Array::zeros(model.output_names().len());
        let (pattern, from) = (model.output_pattern(), (0, self.columns.inputs + input));
        add_column(pattern, self.output.as_slice(), from, outputs.as_mut_slice());
        self.add_response(response, outputs.as_mut_slice());
        for (output, &entry) in outputs.as_slice().iter().enumerate() {
            put(d.as_mut_slice(), output * model.input_names().len() + input, entry);
        }
    }

    pub(super) fn add_outputs(&self, column: usize, x: &[R], to: &mut [R]) {
        let model = self.at.model;
        add_block(model.output_pattern(), self.output.as_slice(), (0, column), x, to);
    }

    pub(super) fn add_response(&self, response: &ResponseOf<R, M>, to: &mut [R]) {
        self.add_outputs(self.columns.multipliers, response.multipliers.as_slice(), to);
        self.add_outputs(self.columns.accelerations, response.acceleration.as_slice(), to);
    }
}

/// δ × ω of each quaternion, zero elsewhere: along a motion, (δ of its turned axes)˙ = δω + δ × ω.
fn bracket<R: Real, M: Assemble<R>>(model: &M, dq: &M::V, v: &M::V) -> M::V {
    let mut bracket = model.zero_v();
    let first = model.layout().linear + model.layout().rotations;
    let (deltas, rates) =
        (dq.as_slice()[first..].as_chunks::<3>().0, v.as_slice()[first..].as_chunks::<3>().0);
    let triples = bracket.as_mut_slice()[first..].as_chunks_mut::<3>().0;
    for ((to, d), w) in triples.iter_mut().zip(deltas).zip(rates) {
        *to = [d[1] * w[2] - d[2] * w[1], d[2] * w[0] - d[0] * w[2], d[0] * w[1] - d[1] * w[0]];
    }
    bracket
}
