//! Derivatives of v̇ and ż along increments of the state: by differences, or exact.

use crate::{Equations, StateOf};
use linkwright::{Assemble, Derivative, DerivativeOf, Fields, Tangent, Vector};

/// Where the derivatives of v̇ and ż come from: [`Differences`] or [`Exact`].
pub trait Derivatives<M: Assemble<f64>>: Sized + sealed::Sealed {
    /// The number of parameters by which there are derivatives.
    #[doc(hidden)]
    fn parameters(model: &M) -> usize;
    /// What is evaluated once at a state.
    #[doc(hidden)]
    type At;

    /// The state, made ready; nothing where the equations cannot be solved.
    #[doc(hidden)]
    fn at<S>(equations: &Equations<'_, M, S, Self>, time: f64, state: &StateOf<M>) -> Option<Self::At>
    where
        S: Fn(f64, &StateOf<M>) -> M::Inputs;

    /// The change of v̇ and ż along an increment of the state, including what the inputs do.
    #[doc(hidden)]
    fn along<S>(
        equations: &Equations<'_, M, S, Self>,
        at: &Self::At,
        increment: &DerivativeOf<M>,
    ) -> (M::V, M::Z)
    where
        S: Fn(f64, &StateOf<M>) -> M::Inputs;
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for super::Differences {}
    impl Sealed for super::Exact {}
}

/// Central differences of v̇ and ż, for any mechanism.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Differences;

/// The emitted derivatives, of a mechanism that says `options { emit = (tangent); }`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Exact;

/// Two states, a little back and a little ahead along an increment, and the inverse of what lies between.
fn around<M: Assemble<f64>>(
    model: &M,
    state: &StateOf<M>,
    increment: &DerivativeOf<M>,
) -> Option<(StateOf<M>, StateOf<M>, f64)> {
    let Derivative { v: dq, a: dv, z: dz } = increment;
    let moving = dq.max_abs().max(dv.max_abs() / (1.0 + state.v.max_abs()));
    let size = moving.max(dz.max_abs() / (1.0 + state.z.max_abs()));
    // The error of central differences is least about the third root of rounding.
    let step = f64::EPSILON.cbrt() / size;
    if !step.is_finite() {
        return None;
    }
    let moved = |step: f64| state.advance(model.layout(), step, increment);
    Some((moved(-step), moved(step), 0.5 / step))
}

impl<M: Assemble<f64>> Derivatives<M> for Differences {
    fn parameters(_: &M) -> usize {
        0
    }
    type At = (f64, StateOf<M>);

    fn at<S>(_: &Equations<'_, M, S, Self>, time: f64, state: &StateOf<M>) -> Option<Self::At>
    where
        S: Fn(f64, &StateOf<M>) -> M::Inputs,
    {
        Some((time, state.clone()))
    }

    fn along<S>(
        equations: &Equations<'_, M, S, Self>,
        (time, state): &Self::At,
        increment: &DerivativeOf<M>,
    ) -> (M::V, M::Z)
    where
        S: Fn(f64, &StateOf<M>) -> M::Inputs,
    {
        let model = equations.model();
        let Some((before, after, scale)) = around(model, state, increment) else {
            return (model.zero_v(), M::Z::zeros(state.z.as_slice().len()));
        };
        let [before, after] = [before, after].map(|state| equations.derivative(*time, &state));
        let Derivative { a, z, .. } = after.plus(-1.0, &before).scaled(scale);
        (a, z)
    }
}

/// The equations of motion with Baumgarte's terms at one state, factored, and their derivatives:
///
/// ```text
/// ⎡ M  Dᵀ ⎤ ⎡ ∂v̇ ⎤     ⎡ ∂r                                  ⎤
/// ⎣ D  0  ⎦ ⎣ ∂λ ⎦ = − ⎣ ∂(D a − γ) + 2α ∂(D v − ν) + β² ∂Φ ⎦    r = M a + Dᵀ λ − Q
/// ```
/// with ∂Φ/∂q = ∂(D v − ν)/∂v = D; as `linkwright::Linearisation`, which is of index 1.
#[doc(hidden)]
pub struct Linearised<M: Tangent<f64>> {
    time: f64,
    state: StateOf<M>,
    a: M::V,
    lambda: M::Lambda,
    store: M::Store,
    stiffness: M::Stiffness,
    damping: M::Damping,
    row_stiffness: M::RowStiffness,
    row_damping: M::RowDamping,
    rate: M::RateTangent,
    jacobian: M::Jacobian,
    input: M::InputTangent,
    internal: M::InternalTangent,
    friction: M::FrictionTangent,
    internal_rates: M::InternalRateTangent,
}

impl<M: Tangent<f64>> Derivatives<M> for Exact {
    fn parameters(model: &M) -> usize {
        model.parameter_names().len()
    }
    type At = Linearised<M>;

    fn at<S>(equations: &Equations<'_, M, S, Self>, time: f64, state: &StateOf<M>) -> Option<Linearised<M>>
    where
        S: Fn(f64, &StateOf<M>) -> M::Inputs,
    {
        let model = equations.model();
        let (q, v, u) = (&state.q, &state.v, (equations.inputs)(time, state));
        let (a, lambda) = equations.acceleration(time, state);
        let mut store = model.store();
        let pivot = model.factor(time, q, 0.0, &mut store);
        if a.first_not_finite().is_some() || equations.breaks_down(time, state, pivot) {
            return None;
        }
        let mut at = Linearised {
            time,
            state: state.clone(),
            a,
            lambda,
            store,
            stiffness: model.zero_stiffness(),
            damping: model.zero_damping(),
            row_stiffness: model.zero_row_stiffness(),
            row_damping: model.zero_row_damping(),
            rate: model.zero_rate_tangent(),
            jacobian: model.zero_jacobian(),
            input: model.zero_input_tangent(),
            internal: model.zero_internal_tangent(),
            friction: model.zero_friction_tangent(),
            internal_rates: model.zero_internal_rate_tangent(),
        };
        model.tangent(time, state, &u, &at.a, &at.lambda, &mut at.stiffness, &mut at.damping);
        model.row_tangent(time, q, v, &at.a, &mut at.row_stiffness, &mut at.row_damping);
        model.rate_tangent(time, q, v, &mut at.rate);
        model.constraint_jacobian(time, q, &mut at.jacobian);
        model.input_tangent(time, state, &u, &mut at.input);
        model.internal_tangent(time, state, &u, &mut at.internal);
        model.friction_tangent(time, state, &u, &at.a, &at.lambda, &mut at.friction);
        model.internal_rate_tangent(time, state, &u, &at.a, &at.lambda, &mut at.internal_rates);
        Some(at)
    }

    fn along<S>(
        equations: &Equations<'_, M, S, Self>,
        at: &Linearised<M>,
        increment: &DerivativeOf<M>,
    ) -> (M::V, M::Z)
    where
        S: Fn(f64, &StateOf<M>) -> M::Inputs,
    {
        let model = equations.model();
        let Derivative { v: dq, a: dv, z: dz } = increment;
        let (mut forces, mut rows) = (model.zero_v(), model.zero_lambda());
        add_product(model.stiffness_pattern(), &at.stiffness, 1.0, dq, &mut forces);
        add_product(model.damping_pattern(), &at.damping, 1.0, dv, &mut forces);
        add_product(model.internal_pattern(), &at.internal, 1.0, dz, &mut forces);
        add_product(model.row_stiffness_pattern(), &at.row_stiffness, 1.0, dq, &mut rows);
        add_product(model.row_damping_pattern(), &at.row_damping, 1.0, dv, &mut rows);
        let (two_alpha, beta_squared) = equations.baumgarte();
        add_product(model.rate_pattern(), &at.rate, two_alpha, dq, &mut rows);
        add_product(model.jacobian_pattern(), &at.jacobian, two_alpha, dv, &mut rows);
        add_product(model.jacobian_pattern(), &at.jacobian, beta_squared, dq, &mut rows);
        let mut du = <M::Inputs as Fields<f64>>::Array::zeros(model.input_names().len());
        if let Some((before, after, scale)) = around(model, &at.state, increment) {
            let [before, after] = [before, after].map(|state| (equations.inputs)(at.time, &state).to_array());
            du = after.plus(-1.0, &before).scaled(scale);
            add_product(model.input_pattern(), &at.input, 1.0, &du, &mut forces);
        }
        let (inputs, first) = (model.input_names().len(), model.input_names().len() + model.row_count());
        for (&(row, column), entry) in model.friction_pattern().iter().zip(at.friction.as_slice()) {
            let column = usize::from(column);
            let by = if column < inputs {
                du.as_slice()[column]
            } else if (first..first + model.internal_count()).contains(&column) {
                dz.as_slice()[column - first]
            } else {
                continue;
            };
            forces.as_mut_slice()[usize::from(row)] += entry * by;
        }
        let (a, lambda) = at.response(equations.model(), &forces, &rows);
        let increments =
            [dq.as_slice(), dv.as_slice(), du.as_slice(), lambda.as_slice(), dz.as_slice(), a.as_slice()];
        let z = at.internal_along(model, increments);
        (a, z)
    }
}

impl<M: Tangent<f64>> Linearised<M> {
    /// −K⁻¹ (∂r, ∂(rows)).
    fn response(&self, model: &M, forces: &M::V, rows: &M::Lambda) -> (M::V, M::Lambda) {
        let (mut a, mut lambda) = (model.zero_v(), model.zero_lambda());
        let (forces, rows) = (forces.scaled(-1.0), rows.scaled(-1.0));
        model.solve_rubbing(&self.store, &self.friction, &forces, &rows, &mut a, &mut lambda);
        (a, lambda)
    }

    /// δż of the internal states along increments of q, v, u, λ, z and v̇.
    fn internal_along(&self, model: &M, increments: [&[f64]; 6]) -> M::Z {
        let mut rates = model.zero_z();
        let to = rates.as_mut_slice();
        for (&(row, column), entry) in
            model.internal_rate_pattern().iter().zip(self.internal_rates.as_slice())
        {
            let mut column = usize::from(column);
            for increment in increments {
                if let Some(by) = increment.get(column) {
                    to[usize::from(row)] += entry * by;
                    break;
                }
                column -= increment.len();
            }
        }
        rates
    }

    fn by_parameters<S>(&self, equations: &Equations<'_, M, S, Exact>) -> M::ParameterTangent
    where
        S: Fn(f64, &StateOf<M>) -> M::Inputs,
    {
        let model = equations.model();
        let u = (equations.inputs)(self.time, &self.state);
        let mut entries = model.zero_parameter_tangent();
        equations.model().parameter_tangent(self.time, &self.state, &u, &self.a, &self.lambda, &mut entries);
        entries
    }

    /// ∂v̇/∂p and ∂ż/∂p, one pair for each parameter.
    pub(crate) fn rates_by_parameters<S>(&self, equations: &Equations<'_, M, S, Exact>) -> Vec<(M::V, M::Z)>
    where
        S: Fn(f64, &StateOf<M>) -> M::Inputs,
    {
        let model = equations.model();
        let (two_alpha, beta_squared) = equations.baumgarte();
        let (n, m, outputs) = (model.velocity_count(), model.row_count(), model.output_names().len());
        let entries = self.by_parameters(equations);
        let column = |parameter| {
            let (mut forces, mut rows) = (model.zero_v(), model.zero_lambda());
            add_column(model, &entries, parameter, 0, 1.0, &mut forces);
            add_column(model, &entries, parameter, n, 1.0, &mut rows);
            add_column(model, &entries, parameter, n + m, two_alpha, &mut rows);
            add_column(model, &entries, parameter, n + 2 * m, beta_squared, &mut rows);
            let (a, lambda) = self.response(equations.model(), &forces, &rows);
            let (still, none) = (vec![0.0; 2 * n], vec![0.0; model.internal_count()]);
            let (inputs, [q, v]) = (vec![0.0; model.input_names().len()], [&still[..n], &still[n..]]);
            let mut z = self.internal_along(model, [q, v, &inputs, lambda.as_slice(), &none, a.as_slice()]);
            add_column(model, &entries, parameter, n + 3 * m + outputs, 1.0, &mut z);
            (a, z)
        };
        (0..Exact::parameters(model)).map(column).collect()
    }

    /// ∂q/∂p as increments, ∂v/∂p and ∂z/∂p of the start: the nearest state on the constraints, one for each parameter:
    /// D δq = −∂Φ/∂p and D δv = −∂(D v − ν)/∂p − ∂(D v − ν)/∂q δq, both least in the norm of M.
    pub(crate) fn starts_by_parameters<S>(
        &self,
        equations: &Equations<'_, M, S, Exact>,
    ) -> Vec<DerivativeOf<M>>
    where
        S: Fn(f64, &StateOf<M>) -> M::Inputs,
    {
        let model = equations.model();
        let (n, m) = (model.velocity_count(), model.row_count());
        let first_start = n + 3 * m + model.output_names().len() + model.internal_count();
        let (model, entries) = (equations.model(), self.by_parameters(equations));
        let column = |parameter| {
            let (mut phi, mut rates) = (model.zero_lambda(), model.zero_lambda());
            add_column(model, &entries, parameter, n + 2 * m, 1.0, &mut phi);
            let dq = self.response(model, &model.zero_v(), &phi).0;
            add_column(model, &entries, parameter, n + m, 1.0, &mut rates);
            add_product(model.rate_pattern(), &self.rate, 1.0, &dq, &mut rates);
            let dv = self.response(model, &model.zero_v(), &rates).0;
            let mut dz = model.zero_z();
            add_column(model, &entries, parameter, first_start, 1.0, &mut dz);
            Derivative { v: dq, a: dv, z: dz }
        };
        (0..Exact::parameters(model)).map(column).collect()
    }
}

/// y ← y + scale A x of a sparse A.
fn add_product<A, X, Y>(pattern: &[(u16, u16)], entries: &A, scale: f64, x: &X, y: &mut Y)
where
    A: Vector<f64>,
    X: Vector<f64>,
    Y: Vector<f64>,
{
    let (x, y) = (x.as_slice(), y.as_mut_slice());
    for (&(row, column), entry) in pattern.iter().zip(entries.as_slice()) {
        y[row as usize] += scale * entry * x[column as usize];
    }
}

/// y ← y + scale × a column of the derivatives by parameters, from row `first` on.
fn add_column<M: Tangent<f64>, Y: Vector<f64>>(
    model: &M,
    entries: &M::ParameterTangent,
    parameter: usize,
    first: usize,
    scale: f64,
    y: &mut Y,
) {
    for (&(row, column), entry) in model.parameter_pattern().iter().zip(entries.as_slice()) {
        let row = (row as usize).checked_sub(first).and_then(|row| y.as_mut_slice().get_mut(row));
        if let Some(to) = row
            && column as usize == parameter
        {
            *to += scale * entry;
        }
    }
}
