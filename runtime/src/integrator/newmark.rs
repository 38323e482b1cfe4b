//! One implicit step of Newmark's family on the group: what generalised-α, the trapezoidal rule and ALI3-P share.

use super::{Dynamics, Rejections, StepFailure, Stepped, SteppedOf};
use crate::linearisation::lu::Lu;
use crate::real::Real;
use crate::state::{Derivative, StateOf, Variables};
use crate::vector::Vector;
use core::fmt::Debug;

/// Velocities of the dynamics `D`.
type VelocityOf<D, R> = <<D as Dynamics<R>>::Variables as Variables<R>>::V;
/// Internal states of the dynamics `D`, or their rates.
type InternalOf<D, R> = <<D as Dynamics<R>>::Variables as Variables<R>>::Z;
/// Multipliers of the dynamics `D`.
type MultipliersOf<D, R> = <<D as Dynamics<R>>::Variables as Variables<R>>::Lambda;

/// Dynamics whose residual and exact tangent an implicit method can ask for.
///
/// Implemented for every mechanism that emits its [`Tangent`](crate::Tangent).
#[diagnostic::on_unimplemented(
    message = "implicit methods need the tangent of the mechanism",
    label = "it is not emitted",
    note = "add `options {{ emit = (tangent); }}` to the definition of the mechanism"
)]
pub trait ImplicitDynamics<R: Real>: Dynamics<R> {
    /// One entry for each velocity, then for each row, then for each internal state.
    type Unknowns: Vector<R>;
    /// A square matrix of that size, row by row.
    type Bordered: Vector<R>;
    /// A whole number for each unknown.
    type Order: Clone + Debug + AsRef<[u16]> + AsMut<[u16]>;

    /// An order to be written.
    fn order(&self) -> Self::Order;
    /// (M a + Dᵀ λ − Q, Φ or D v − ν, `rates` − ż) at a state, with the inputs there.
    #[allow(clippy::too_many_arguments)]
    fn residual(
        &mut self,
        time: R,
        state: &StateOf<Self::Variables, R>,
        a: &VelocityOf<Self, R>,
        lambda: &MultipliersOf<Self, R>,
        rates: &InternalOf<Self, R>,
        level: Level,
    ) -> Self::Unknowns;
    /// \[m M + d C + K, Dᵀ, ∂r/∂z; D′, −c, 0; −(m ∂ż/∂v̇ + d ∂ż/∂v + ∂ż/∂q), −∂ż/∂λ, s − ∂ż/∂z\] at a state, K = ∂(M a + Dᵀ λ − Q)/∂q and C = ∂(…)/∂v, by increments along which v̇ changes by
    /// `weights.mass`, v by `weights.damping` times the increment, with D′ = D or, of rows at the level of velocities,
    /// d D + ∂(D v − ν)/∂q. K and the derivatives of rows by positions are taken along `u`: of a quaternion turned by u the
    /// increment δu turns it by dexp₋ᵤ δu.
    #[allow(clippy::too_many_arguments)]
    fn matrix(
        &mut self,
        time: R,
        state: &StateOf<Self::Variables, R>,
        a: &VelocityOf<Self, R>,
        lambda: &MultipliersOf<Self, R>,
        u: &VelocityOf<Self, R>,
        weights: &Weights<R>,
        entries: &mut Self::Bordered,
    );
    /// ν and γ at a state.
    fn rates(
        &mut self,
        time: R,
        state: &StateOf<Self::Variables, R>,
    ) -> (MultipliersOf<Self, R>, MultipliersOf<Self, R>);
    /// Looks how near a singular position the state is.
    fn observe(&mut self, time: R, state: &StateOf<Self::Variables, R>);
}

/// At which level a method holds the constraints.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    /// Φ = 0.
    Position,
    /// D v = ν.
    Velocity,
}

/// The factors of the parts of [`ImplicitDynamics::matrix`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Weights<R> {
    /// m, 1/s².
    pub mass: R,
    /// d, 1/s.
    pub damping: R,
    /// 1 for K, 0 to leave it out.
    pub stiffness: R,
    /// c, the compliance of the rows.
    pub compliance: R,
    /// s, 1/s: what the rates of internal states change by; nothing where these are held.
    pub internal: Option<R>,
    /// The level of the rows.
    pub level: Level,
}

/// The values carried from step to step: the accelerations at its end, v̇ and the method's own a, λ, and likewise ż and the method's own.
#[derive(Clone, Copy, Debug)]
pub struct Carried<V, Lambda, Z = ()> {
    pub(super) known: Option<Known<V, Lambda, Z>>,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Known<V, Lambda, Z> {
    /// v̇ of the equations of motion.
    pub v_dot: V,
    /// a of the method.
    pub a: V,
    pub lambda: Lambda,
    /// ż of the internal states, and that of the method.
    pub z_dot: Z,
    pub w: Z,
}

/// What a method carries between steps of what has the variables `X`.
pub type CarriedOf<X, R> =
    Carried<<X as Variables<R>>::V, <X as Variables<R>>::Lambda, <X as Variables<R>>::Z>;
type KnownOf<X, R> = Known<<X as Variables<R>>::V, <X as Variables<R>>::Lambda, <X as Variables<R>>::Z>;

/// The coefficients of a method:
///
/// ```text
/// (1 − α_m) a₁ + α_m a₀ = (1 − α_f) v̇₁ + α_f v̇₀
/// u = h v₀ + h² (½ − β) a₀ + h² β a₁,   q₁ = q₀ ⊕ u
/// v₁ = v₀ + h (1 − γ) a₀ + h γ a₁
/// (1 − α_m) w₁ + α_m w₀ = (1 − α_f) ż₁ + α_f ż₀,   z₁ = z₀ + h (1 − γ) w₀ + h γ w₁
/// ```
/// Internal states move as velocities do: Brüls, Arnold, *The generalized-α scheme as a linear multistep integrator: toward a
/// general mechatronic simulator*, J. Comput. Nonlinear Dynam. 3 (2008) 041007.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scheme<R> {
    pub alpha_m: R,
    pub alpha_f: R,
    pub beta: R,
    pub gamma: R,
    pub level: Level,
    /// 1/α of a penalty, whose multipliers are iterated; 0 where the constraints are held as they are.
    pub compliance: R,
    /// The change of a coordinate at which the iteration ends, relative to 1 + the largest coordinate.
    pub tolerance: R,
    /// The most iterations made.
    pub iterations: u32,
}

/// The end of a step under iteration.
struct Trial<X: Variables<R>, R: Real> {
    u: X::V,
    state: StateOf<X, R>,
    v_dot: X::V,
    a: X::V,
    lambda: X::Lambda,
    z_dot: X::Z,
    w: X::Z,
}

/// The matrix of the last iterations, factored.
pub(super) struct Factored<R: Real, D: ImplicitDynamics<R>> {
    pub entries: D::Bordered,
    rows: D::Unknowns,
    columns: D::Unknowns,
    order: D::Order,
}

impl<R: Real, D: ImplicitDynamics<R>> Factored<R, D> {
    pub fn new(dynamics: &D) -> Self {
        let order = dynamics.order();
        let size = order.as_ref().len();
        let (rows, columns) = (D::Unknowns::zeros(size), D::Unknowns::zeros(size));
        Factored { entries: D::Bordered::zeros(size * size), rows, columns, order }
    }

    /// The number of unknowns.
    pub fn size(&self) -> usize {
        self.order.as_ref().len()
    }

    pub fn lu(&mut self) -> Lu<'_, R> {
        Lu {
            entries: self.entries.as_mut_slice(),
            rows: self.rows.as_mut_slice(),
            columns: self.columns.as_mut_slice(),
            order: self.order.as_mut(),
        }
    }
}

impl<R: Real> Scheme<R> {
    /// One step; leaves what the next begins with in `carried`, the multipliers among it.
    pub fn step<X: Variables<R>, D: ImplicitDynamics<R, Variables = X>>(
        &self,
        carried: &mut CarriedOf<X, R>,
        dynamics: &mut D,
        time: R,
        h: R,
        state: &StateOf<X, R>,
    ) -> Result<SteppedOf<X, R>, StepFailure<R>> {
        let mut factored = Factored::new(dynamics);
        let n = state.v.as_slice().len();
        let known = match &carried.known {
            Some(known) => known.clone(),
            None => {
                let Derivative { a: v_dot, z: z_dot, .. } = dynamics.derivative(time, &mut state.clone());
                let lambda = X::Lambda::zeros(factored.size() - n - state.z.as_slice().len());
                Known { a: v_dot.clone(), v_dot, lambda, w: z_dot.clone(), z_dot }
            }
        };
        let end = time + h;
        let Scheme { alpha_m, alpha_f, beta, gamma, .. } = *self;
        let mass = (R::ONE - alpha_m) / (h * h * beta * (R::ONE - alpha_f));
        let internal = (R::ONE - alpha_m) / (h * gamma * (R::ONE - alpha_f));
        let weights = Weights {
            mass,
            damping: gamma / (h * beta),
            stiffness: R::ONE,
            compliance: self.compliance,
            internal: Some(internal),
            level: self.level,
        };
        let mut trial = self.predicted(dynamics.variables(), h, state, &known);
        let mut multipliers = known.lambda.clone();
        let (mut iterations, mut last) = (0, R::ZERO);
        loop {
            let Trial { state: there, v_dot, lambda, z_dot, .. } = &trial;
            let mut residual = dynamics.residual(end, there, v_dot, lambda, z_dot, self.level);
            // A penalty's row is Φ − (λ − λ*)/α.
            let rows = residual.as_mut_slice()[n..].iter_mut();
            for (row, (&lambda, &before)) in
                rows.zip(trial.lambda.as_slice().iter().zip(multipliers.as_slice()))
            {
                *row = *row - self.compliance * (lambda - before);
            }
            if residual.first_not_finite().is_some() {
                return Err(StepFailure::NoConvergence { iterations, residual: residual.max_abs() });
            }
            // The matrix of the first iteration serves as long as it is good.
            if iterations < 2 || last > R::from_f64(1e-3) {
                let Trial { state, v_dot, lambda, u, .. } = &trial;
                dynamics.matrix(end, state, v_dot, lambda, u, &weights, &mut factored.entries);
                if factored.lu().factor_above(R::ZERO).is_err() {
                    return Err(StepFailure::Singular { time: end });
                }
            }
            let mut step = residual.scaled(-R::ONE);
            factored.lu().solve(step.as_mut_slice());
            let (du, dlambda) = step.as_slice().split_at(n);
            let mut increment = X::V::zeros(n);
            increment.as_mut_slice().copy_from_slice(du);
            for (entry, &delta) in trial.lambda.as_mut_slice().iter_mut().zip(dlambda) {
                *entry = *entry + delta;
            }
            trial.v_dot.axpy(mass, &increment);
            let mut dz = X::Z::zeros(state.z.as_slice().len());
            let of_rates = dlambda.iter().skip(trial.lambda.as_slice().len());
            dz.as_mut_slice().iter_mut().zip(of_rates).for_each(|(entry, &delta)| *entry = delta);
            trial.z_dot.axpy(internal, &dz);
            self.close(dynamics.variables(), h, state, &known, &mut trial);
            iterations += 1;
            let size = R::ONE + trial.state.q.max_abs();
            last = increment.max_abs() / size;
            last = last.max(relative(dynamics.variables().internal_scales(), &dz, &trial.state.z));
            if last <= self.tolerance {
                // A penalty's multipliers have to settle too.
                let change = trial.lambda.plus(-R::ONE, &multipliers).max_abs();
                let settled = change * self.compliance <= self.tolerance * size;
                multipliers.clone_from(&trial.lambda);
                if settled {
                    break;
                }
            }
            // Near singular positions multipliers without meaning are long in coming, with next to nothing to move.
            let moves_little = self.compliance > R::ZERO && last <= self.tolerance.sqrt();
            if iterations >= self.iterations && moves_little {
                break;
            }
            // Written so that a NaN fails.
            if iterations >= self.iterations || !R::any(last.less(R::from_f64(1e6))) {
                return Err(StepFailure::NoConvergence { iterations, residual: last / self.tolerance });
            }
        }
        let Trial { state, v_dot, a, lambda, z_dot, w, .. } = trial;
        carried.known = Some(Known { v_dot, a, lambda, z_dot, w });
        dynamics.observe(end, &state);
        Ok(Stepped {
            state,
            size: h,
            iterations,
            residual: last / self.tolerance,
            rejections: Rejections::default(),
        })
    }

    /// The step with the accelerations of its beginning.
    fn predicted<X: Variables<R>>(
        &self,
        of: &X,
        h: R,
        state: &StateOf<X, R>,
        known: &KnownOf<X, R>,
    ) -> Trial<X, R> {
        let Known { v_dot, a, lambda, z_dot, w } = known.clone();
        let u = X::V::zeros(a.as_slice().len());
        let mut trial = Trial { u, state: state.clone(), v_dot, a, lambda, z_dot, w };
        self.close(of, h, state, known, &mut trial);
        trial
    }

    /// a, u, q and v that belong to v̇ at the end; w and z that belong to ż.
    fn close<X: Variables<R>>(
        &self,
        of: &X,
        h: R,
        begin: &StateOf<X, R>,
        known: &KnownOf<X, R>,
        trial: &mut Trial<X, R>,
    ) {
        let Scheme { alpha_m, alpha_f, beta, gamma, .. } = *self;
        let half = R::from_f64(0.5);
        let mut a = trial.v_dot.scaled(R::ONE - alpha_f);
        a.axpy(alpha_f, &known.v_dot);
        a.axpy(-alpha_m, &known.a);
        trial.a = a.scaled(R::ONE / (R::ONE - alpha_m));
        let mut u = begin.v.scaled(h);
        u.axpy(h * h * (half - beta), &known.a);
        u.axpy(h * h * beta, &trial.a);
        let mut v = begin.v.plus(h * (R::ONE - gamma), &known.a);
        v.axpy(h * gamma, &trial.a);
        // Counted angles take ∫ v dt, which for this method is u itself.
        let mut w = trial.z_dot.scaled(R::ONE - alpha_f);
        w.axpy(alpha_f, &known.z_dot);
        w.axpy(-alpha_m, &known.w);
        trial.w = w.scaled(R::ONE / (R::ONE - alpha_m));
        let mut z = begin.z.plus(h * (R::ONE - gamma), &known.w);
        z.axpy(h * gamma, &trial.w);
        trial.state = begin.moved(of.layout(), &u, v, z);
        trial.u = u;
    }
}

/// The largest change of an internal state, relative to its scale and itself.
pub(crate) fn relative<R: Real, Z: Vector<R>>(scales: &[f64], change: &Z, z: &Z) -> R {
    let scales = scales.iter().copied().chain(core::iter::repeat(1.0));
    let entries = change.as_slice().iter().zip(z.as_slice()).zip(scales);
    entries.fold(R::ZERO, |largest, ((change, z), scale)| {
        largest.max(change.abs() / (R::from_f64(scale) + z.abs()))
    })
}
