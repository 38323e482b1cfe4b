//! The mechanism as `diffsol` sees it: ẏ = F(t, y), y(t₀), and their derivatives.

use crate::coordinates;
use crate::derivatives::{Derivatives, Exact};
use crate::settings::first_not_finite;
use crate::{Sensitivity, Settings, StateOf};
use core::cell::{Cell, RefCell};
use core::marker::PhantomData;
use diffsol::op::OpStatistics;
use diffsol::{
    ConstantOp, ConstantOpSens, Matrix, NalgebraContext, NalgebraMat, NalgebraVec, NonLinearOp,
    NonLinearOpJacobian, NonLinearOpSens, OdeEquations, OdeEquationsRef, Op, ParameterisedOp, UnitCallable,
    Vector as _,
};
use linkwright::{
    Assemble, Derivative, DerivativeOf, Mechanism, Real, Row, SimulationError, State, Tangent, Vector,
    smallest_pivot,
};

/// The equations of motion of a mechanism in y, with inputs `S` and derivatives `D`; made by
/// [`problem`](crate::problem) and [`exact_problem`](crate::exact_problem).
pub struct Equations<'m, M: Mechanism<f64>, S, D> {
    model: &'m M,
    pub(crate) inputs: S,
    start_time: f64,
    start: StateOf<M>,
    two_alpha: f64,
    beta_squared: f64,
    length_rate: f64,
    pub(crate) most_steps: usize,
    context: NalgebraContext,
    statistics: RefCell<OpStatistics>,
    failure: Cell<Option<SimulationError>>,
    sign: Cell<f64>,
    derivatives: PhantomData<D>,
}

/// The parts of y, or of its rate, that hold q, v and z.
fn parts<'y, M: Mechanism<f64>>(model: &M, y: &'y [f64]) -> [&'y [f64]; 3] {
    let (q, rest) = y.split_at(coordinates::positions(model.layout()));
    let (v, z) = rest.split_at(model.velocity_count());
    [q, v, z]
}

fn parts_mut<'y, M: Mechanism<f64>>(model: &M, y: &'y mut [f64]) -> [&'y mut [f64]; 3] {
    let (q, rest) = y.split_at_mut(coordinates::positions(model.layout()));
    let (v, z) = rest.split_at_mut(model.velocity_count());
    [q, v, z]
}

fn vector<T: Vector<f64>>(entries: &[f64]) -> T {
    let mut vector = T::zeros(entries.len());
    vector.as_mut_slice().copy_from_slice(entries);
    vector
}

/// What a solver gets in place of numbers that there are not. Its error estimates take NaN for no error at all, and a constant
/// for a motion they follow exactly; a large number whose sign changes from call to call makes it reject the step.
const UNSOLVABLE: f64 = 1e30;

/// What is not there.
type Nothing<'a> = ParameterisedOp<'a, UnitCallable<NalgebraMat<f64>>>;

impl<'m, M: Assemble<f64>, S, D> Equations<'m, M, S, D> {
    pub(crate) fn new(model: &'m M, time: f64, start: StateOf<M>, inputs: S, settings: &Settings) -> Self {
        Equations {
            model,
            inputs,
            start_time: time,
            start,
            two_alpha: 2.0 * settings.baumgarte.alpha,
            beta_squared: settings.baumgarte.beta * settings.baumgarte.beta,
            length_rate: settings.length_rate,
            most_steps: settings.most_steps,
            context: NalgebraContext::default(),
            statistics: RefCell::new(OpStatistics::default()),
            failure: Cell::new(None),
            sign: Cell::new(1.0),
            derivatives: PhantomData,
        }
    }

    /// The model that moves.
    pub fn model(&self) -> &'m M {
        self.model
    }

    /// The time of the start, s.
    pub fn start_time(&self) -> f64 {
        self.start_time
    }

    /// The state at the start.
    pub fn start(&self) -> &StateOf<M> {
        &self.start
    }

    /// The state that `y` holds, orientations of length one; nothing if `y` has not as many entries as the equations.
    pub fn state(&self, y: &NalgebraVec<f64>) -> Option<StateOf<M>> {
        let y = y.clone_as_vec();
        (y.len() == self.length()).then(|| self.state_of(self.start_time, &y))
    }

    /// The y that holds a state.
    pub fn entries(&self, state: &StateOf<M>) -> NalgebraVec<f64> {
        NalgebraVec::from_vec(self.entries_of(state), self.context)
    }

    /// Why the equations could not be solved where a solver asked last, if so.
    pub fn failure(&self) -> Option<SimulationError> {
        self.failure.get()
    }

    pub(crate) fn forget_failure(&self) {
        self.failure.set(None);
    }

    /// 2α and β².
    pub(crate) fn baumgarte(&self) -> (f64, f64) {
        (self.two_alpha, self.beta_squared)
    }

    pub(crate) fn length(&self) -> usize {
        let model = self.model;
        coordinates::positions(model.layout()) + model.velocity_count() + self.start.z.as_slice().len()
    }

    pub(crate) fn state_of(&self, time: f64, y: &[f64]) -> StateOf<M> {
        let model = self.model;
        let [q, v, z] = parts(model, y);
        let q = coordinates::from_entries(model.layout(), &self.start.q, q);
        let mut state = State { q, v: vector(v), z: vector(z), gates: self.start.gates.clone() };
        // y has no gates: they are those of the state.
        state.gates = model.live_gates(time, &state);
        state
    }

    fn entries_of(&self, state: &StateOf<M>) -> Vec<f64> {
        let model = self.model;
        let mut q = vec![0.0; coordinates::positions(model.layout())];
        coordinates::to_entries(model.layout(), &self.start.q, &state.q, &mut q);
        [&q, state.v.as_slice(), state.z.as_slice()].concat()
    }

    /// The entries' motion that belongs to an increment of the state.
    fn motion(&self, y: &[f64], increment: &DerivativeOf<M>) -> Vec<f64> {
        let model = self.model;
        let mut q = vec![0.0; coordinates::positions(model.layout())];
        coordinates::entries_along(model.layout(), parts(model, y)[0], increment.v.as_slice(), &mut q);
        [&q, increment.a.as_slice(), increment.z.as_slice()].concat()
    }

    /// The increment of the state in a motion of the entries: δq, δv and δz where a derivative has v, v̇ and ż.
    pub(crate) fn increment(&self, y: &[f64], motion: &[f64]) -> DerivativeOf<M> {
        let model = self.model;
        let [dq, dv, dz] = parts(model, motion);
        let dq = coordinates::increment(model.layout(), parts(model, y)[0], dq);
        Derivative { v: dq, a: vector(dv), z: vector(dz) }
    }

    /// Whether a pivot is none; remembered if so.
    pub(crate) fn breaks_down(&self, time: f64, state: &StateOf<M>, pivot: f64) -> bool {
        let model = self.model;
        let broken = pivot.is_nan() || pivot < <f64 as Real>::BREAKDOWN;
        if broken && state.q.first_not_finite().is_none() {
            let (_, row) = smallest_pivot(self.model, time, &state.q);
            let row = row.map_or(Row { of: model.name(), what: "constraints" }, |row| model.rows()[row]);
            let pivot = if pivot.is_nan() { 0.0 } else { pivot };
            self.failure.set(Some(SimulationError::Breakdown { time, pivot, row }));
        }
        broken
    }
}

impl<M, S, D> Equations<'_, M, S, D>
where
    M: Assemble<f64>,
    S: Fn(f64, &StateOf<M>) -> M::Inputs,
{
    /// v̇ and λ; NaN where they are not to be had, with the reason remembered.
    pub(crate) fn acceleration(&self, time: f64, state: &StateOf<M>) -> (M::V, M::Lambda) {
        let model = self.model;
        let (mut a, mut lambda) = (model.zero_v(), model.zero_lambda());
        let inputs = (self.inputs)(time, state);
        let (two_alpha, beta_squared) = self.baumgarte();
        let pivot = self.model.acceleration_baumgarte(
            time,
            state,
            &inputs,
            two_alpha,
            beta_squared,
            &mut a,
            &mut lambda,
        );
        if self.breaks_down(time, state, pivot) {
            a.as_mut_slice().fill(f64::NAN);
        } else if let Some(entry) = a.first_not_finite()
            && first_not_finite(model, state).is_none()
        {
            self.failure.set(Some(SimulationError::NonFinite { time, what: model.velocity_names()[entry] }));
        }
        (a, lambda)
    }

    /// v, v̇ and ż; NaN where they are not to be had, with the reason remembered.
    pub(crate) fn derivative(&self, time: f64, state: &StateOf<M>) -> DerivativeOf<M> {
        let (a, lambda) = self.acceleration(time, state);
        let mut z = M::Z::zeros(state.z.as_slice().len());
        self.model.internal_rates(time, state, &(self.inputs)(time, state), &a, &lambda, &mut z);
        Derivative { v: state.v.clone(), a, z }
    }

    /// F(t, y).
    fn rates(&self, time: f64, y: &[f64], to: &mut [f64]) {
        let model = self.model;
        let [q, v, _] = parts(model, y);
        let [to_q, to_v, to_z] = parts_mut(model, to);
        coordinates::entries_along(model.layout(), q, v, to_q);
        coordinates::add_pull(model.layout(), self.length_rate, q, to_q);
        let derivative = self.derivative(time, &self.state_of(time, y));
        to_v.copy_from_slice(derivative.a.as_slice());
        to_z.copy_from_slice(derivative.z.as_slice());
        if to.iter().any(|rate| !rate.is_finite()) {
            self.sign.set(-self.sign.get());
            to.fill(self.sign.get() * UNSOLVABLE);
        }
    }
}

impl<M, S, D> Equations<'_, M, S, D>
where
    M: Assemble<f64>,
    S: Fn(f64, &StateOf<M>) -> M::Inputs,
    D: Derivatives<M>,
{
    /// (∂F/∂y) w with what was evaluated at y; zero where F has no value, for the step will be rejected.
    fn rates_along(&self, at: Option<&D::At>, y: &[f64], along: &[f64], to: &mut [f64]) {
        let model = self.model;
        let Some(at) = at else { return to.fill(0.0) };
        let ([q, v, _], [dq, dv, _]) = (parts(model, y), parts(model, along));
        let [to_q, to_v, to_z] = parts_mut(model, to);
        coordinates::entries_along(model.layout(), q, dv, to_q);
        coordinates::add_turned(model.layout(), dq, v, to_q);
        coordinates::add_pull_along(model.layout(), self.length_rate, q, dq, to_q);
        let (a, z) = D::along(self, at, &self.increment(y, along));
        to_v.copy_from_slice(a.as_slice());
        to_z.copy_from_slice(z.as_slice());
        if to.iter().any(|rate| !rate.is_finite()) {
            to.fill(0.0);
        }
    }

    fn at(&self, time: f64, y: &[f64]) -> Option<D::At> {
        D::at(self, time, &self.state_of(time, y))
    }
}

impl<M, S> Equations<'_, M, S, Exact>
where
    M: Tangent<f64>,
    S: Fn(f64, &StateOf<M>) -> M::Inputs,
{
    /// The derivatives of the start by the parameters; none where they are not to be had.
    pub(crate) fn start_sensitivities(&self) -> Vec<Sensitivity<M::V, M::Z>> {
        let at = Exact::at(self, self.start_time, &self.start);
        let by_parameters = at.map_or(Vec::new(), |at| at.starts_by_parameters(self));
        by_parameters.into_iter().map(|Derivative { v: q, a: v, z }| Sensitivity { q, v, z }).collect()
    }
}

impl<M, S, D> Op for Equations<'_, M, S, D>
where
    M: Assemble<f64>,
    D: Derivatives<M>,
{
    type T = f64;
    type V = NalgebraVec<f64>;
    type M = NalgebraMat<f64>;
    type C = NalgebraContext;

    fn context(&self) -> &NalgebraContext {
        &self.context
    }
    fn nstates(&self) -> usize {
        self.length()
    }
    fn nout(&self) -> usize {
        self.length()
    }
    fn nparams(&self) -> usize {
        let model = self.model;
        D::parameters(model)
    }
    fn statistics(&self) -> OpStatistics {
        self.statistics.borrow().clone()
    }
}

impl<M, S, D> NonLinearOp for Equations<'_, M, S, D>
where
    M: Assemble<f64>,
    S: Fn(f64, &StateOf<M>) -> M::Inputs,
    D: Derivatives<M>,
{
    fn call_inplace(&self, y: &NalgebraVec<f64>, time: f64, to: &mut NalgebraVec<f64>) {
        self.statistics.borrow_mut().increment_call();
        to.for_each_batch_host([y], |to, [y], _| self.rates(time, y, to));
    }
}

impl<M, S, D> NonLinearOpJacobian for Equations<'_, M, S, D>
where
    M: Assemble<f64>,
    S: Fn(f64, &StateOf<M>) -> M::Inputs,
    D: Derivatives<M>,
{
    // `along` and `to` hold one lane for each parameter when sensitivities are solved, all at the same y.
    fn jac_mul_inplace(
        &self,
        y: &NalgebraVec<f64>,
        time: f64,
        along: &NalgebraVec<f64>,
        to: &mut NalgebraVec<f64>,
    ) {
        self.statistics.borrow_mut().increment_jac_mul();
        let y = y.clone_as_vec();
        let at = self.at(time, &y);
        to.for_each_batch_host([along], |to, [along], _| self.rates_along(at.as_ref(), &y, along, to));
    }

    fn jacobian_inplace(&self, y: &NalgebraVec<f64>, time: f64, to: &mut NalgebraMat<f64>) {
        self.statistics.borrow_mut().increment_matrix();
        let y = y.clone_as_vec();
        let at = self.at(time, &y);
        let mut unit = vec![0.0; y.len()];
        for column in 0..y.len() {
            let mut entries = vec![0.0; y.len()];
            unit[column] = 1.0;
            self.rates_along(at.as_ref(), &y, &unit, &mut entries);
            unit[column] = 0.0;
            to.set_column(column, &NalgebraVec::from_vec(entries, self.context));
        }
    }
}

impl<M, S> NonLinearOpSens for Equations<'_, M, S, Exact>
where
    M: Tangent<f64>,
    S: Fn(f64, &StateOf<M>) -> M::Inputs,
{
    fn sens_mul_inplace(
        &self,
        y: &NalgebraVec<f64>,
        time: f64,
        along: &NalgebraVec<f64>,
        to: &mut NalgebraVec<f64>,
    ) {
        let mut matrix = NalgebraMat::zeros(self.length(), self.nparams(), self.context);
        NonLinearOpSens::sens_inplace(self, y, time, &mut matrix);
        matrix.gemv(1.0, along, 0.0, to);
    }

    fn sens_inplace(&self, y: &NalgebraVec<f64>, time: f64, to: &mut NalgebraMat<f64>) {
        let model = self.model;
        let y = y.clone_as_vec();
        let columns = match self.at(time, &y) {
            Some(at) => at.rates_by_parameters(self),
            None => vec![(model.zero_v(), model.zero_z()); self.nparams()],
        };
        let positions = coordinates::positions(model.layout());
        for (index, (a, z)) in columns.iter().enumerate() {
            let mut entries = vec![0.0; positions];
            entries.extend_from_slice(a.as_slice());
            entries.extend_from_slice(z.as_slice());
            to.set_column(index, &NalgebraVec::from_vec(entries, self.context));
        }
    }
}

impl<M, S, D> ConstantOp for Equations<'_, M, S, D>
where
    M: Assemble<f64>,
    D: Derivatives<M>,
{
    fn call_inplace(&self, _time: f64, to: &mut NalgebraVec<f64>) {
        to.copy_from(&self.entries(&self.start));
    }
}

impl<M, S> ConstantOpSens for Equations<'_, M, S, Exact>
where
    M: Tangent<f64>,
    S: Fn(f64, &StateOf<M>) -> M::Inputs,
{
    fn sens_mul_inplace(&self, time: f64, along: &NalgebraVec<f64>, to: &mut NalgebraVec<f64>) {
        let mut matrix = NalgebraMat::zeros(self.length(), self.nparams(), self.context);
        ConstantOpSens::sens_inplace(self, time, &mut matrix);
        matrix.gemv(1.0, along, 0.0, to);
    }

    fn sens_inplace(&self, _time: f64, to: &mut NalgebraMat<f64>) {
        let y = self.entries_of(&self.start);
        let columns: Vec<Vec<f64>> = match self.at(self.start_time, &y) {
            Some(at) => {
                let moved = at.starts_by_parameters(self).into_iter();
                moved.map(|increment| self.motion(&y, &increment)).collect()
            }
            None => vec![vec![0.0; self.length()]; self.nparams()],
        };
        for (index, column) in columns.into_iter().enumerate() {
            to.set_column(index, &NalgebraVec::from_vec(column, self.context));
        }
    }
}

impl<'a, M, S, D> OdeEquationsRef<'a> for Equations<'_, M, S, D>
where
    M: Assemble<f64>,
    S: Fn(f64, &StateOf<M>) -> M::Inputs,
    D: Derivatives<M>,
{
    type Rhs = &'a Self;
    type Init = &'a Self;
    type Mass = Nothing<'a>;
    type Root = Nothing<'a>;
    type Out = Nothing<'a>;
    type Reset = Nothing<'a>;
}

impl<M, S, D> OdeEquations for Equations<'_, M, S, D>
where
    M: Assemble<f64>,
    S: Fn(f64, &StateOf<M>) -> M::Inputs,
    D: Derivatives<M>,
{
    fn rhs(&self) -> &Self {
        self
    }
    fn mass(&self) -> Option<Nothing<'_>> {
        None
    }
    fn init(&self) -> &Self {
        self
    }
    /// The parameters are in the model.
    fn set_params(&mut self, _p: &NalgebraVec<f64>) {}
    fn get_params(&self, p: &mut NalgebraVec<f64>) {
        p.fill(0.0);
    }
}
