//! Integrators: one step of time on the group of positions.
//!
//! A method sees a mechanism only as [`Dynamics`]: states in, derivatives out. States move as a whole, by
//! [`State::advance`](crate::State::advance) along a derivative or by `runge_kutta.rs`, which corrects the increments of orientations for
//! all methods above order 2. Inputs, the clock and errors are `simulation`.

mod ali3p;
mod dormand_prince;
mod explicit_trapezoidal;
mod fixed_step;
mod generalised_alpha;
mod implicit_trapezoidal;
mod interpolate;
mod newmark;
mod rk4;
mod runge_kutta;
mod semi_implicit_euler;

pub use ali3p::Ali3p;
pub use dormand_prince::{DormandPrince, DormandPrinceMemory};
pub use explicit_trapezoidal::ExplicitTrapezoidal;
pub use fixed_step::FixedStep;
pub use generalised_alpha::GeneralisedAlpha;
pub use implicit_trapezoidal::ImplicitTrapezoidal;
pub use interpolate::Interpolate;
pub(crate) use newmark::relative;
pub use newmark::{Carried, CarriedOf, ImplicitDynamics, Level, Weights};
pub use rk4::Rk4;
pub use semi_implicit_euler::SemiImplicitEuler;

use crate::error::SettingError;
use crate::real::Real;
use crate::state::{DerivativeOf, StateOf, Variables};
use core::fmt::Debug;

/// The equations that are integrated: v̇ and ż as functions of (t, q, v, z), with q moving by v on the group.
pub trait Dynamics<R: Real> {
    /// What is integrated.
    type Variables: Variables<R>;

    /// What is integrated, whose layout says how states move.
    fn variables(&self) -> &Self::Variables;

    /// v, v̇ and ż at a stage, whose state may be brought to the constraints on the way: v is that of the state then. The first call
    /// of a step must be at the step's own start, so that what was evaluated there already (the inputs) is not evaluated again; where
    /// that call is left out, [`resume`](Dynamics::resume) stands for it.
    fn derivative(
        &mut self,
        time: R,
        state: &mut StateOf<Self::Variables, R>,
    ) -> DerivativeOf<Self::Variables, R>;

    /// Begins a step in place of the evaluation at its start, with the derivative found there at the end of the step
    /// before; whether they still hold. They do not where inputs are held and may have changed with the step.
    fn resume(&mut self) -> bool {
        true
    }

    /// A trial of this size (s) begins, after the evaluation at the step's start: what broke down in the trials before it is
    /// forgotten. Methods that try a step once need not say so.
    fn begin_trial(&mut self, size: R) {
        let _ = size;
    }

    /// Whether a stage of this trial, or of the step if there are no trials, was at a singular position, so that its
    /// derivative means nothing.
    fn broke_down(&self) -> bool {
        false
    }
}

/// A one-step method by itself: its parameters, and what it carries from step to step.
pub trait Method<R: Real> {
    /// The values carried from one step to the next, such as the last accelerations.
    type Memory<X: Variables<R>>: Clone + Debug;

    /// The values to carry before the first step.
    fn memory<X: Variables<R>>(&self) -> Self::Memory<X>;

    /// Whether the method's parameters make sense.
    ///
    /// # Errors
    /// The parameter that does not.
    fn check(&self) -> Result<(), SettingError> {
        Ok(())
    }

    /// The largest step, s, where a simulation is given none; nothing of methods that do not choose their steps.
    fn largest_step(&self) -> Option<R> {
        None
    }

    /// The most steps that a run may take by this method. One that takes every step as it is asked to needs no bound: the run then
    /// takes (end − time)/h of them.
    fn most_steps(&self) -> u64 {
        u64::MAX
    }
}

/// A one-step method for the dynamics `D`.
pub trait Integrator<R: Real, D: Dynamics<R>>: Method<R> {
    /// The state at `time + h` from the one at `time`, s; adaptive methods may take less, but more than nothing. `time` is the
    /// clock rounded once, and so may be the same in several steps, where these are short beside it.
    ///
    /// # Errors
    /// Why no step was taken.
    fn step(
        &self,
        memory: &mut Self::Memory<D::Variables>,
        dynamics: &mut D,
        time: R,
        h: R,
        state: &StateOf<D::Variables, R>,
    ) -> Result<SteppedOf<D::Variables, R>, StepFailure<R>>;
}

/// A step that was taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stepped<R, State> {
    /// The state at its end.
    pub state: State,
    /// Its size, s.
    pub size: R,
    /// Iterations of an implicit method.
    pub iterations: u32,
    /// The change by the last of them, relative to what may remain.
    pub residual: R,
    /// Trials that were given up before.
    pub rejections: Rejections,
}

/// A step of what has the variables `X`.
pub type SteppedOf<X, R = f64> = Stepped<R, StateOf<X, R>>;

impl<R: Real, State> Stepped<R, State> {
    /// A step of size `h` without iterations or rejections.
    #[inline]
    pub fn explicit(h: R, state: State) -> Self {
        Stepped { state, size: h, iterations: 0, residual: R::ZERO, rejections: Rejections::default() }
    }
}

/// Trials of a step that were given up, by reason.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Rejections {
    /// The estimated error was above the tolerance.
    pub error: u32,
    /// An iteration did not converge.
    pub convergence: u32,
    /// A stage was at a singular position, or not finite.
    pub breakdown: u32,
}

impl Rejections {
    /// All of them.
    pub fn total(&self) -> u32 {
        self.error + self.convergence + self.breakdown
    }
}

/// Why a method took no step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StepFailure<R = f64> {
    /// The step that the tolerances ask for is below the least one, or was not found in the trials that are allowed.
    Underflow {
        /// The last size tried, s.
        size: R,
        /// Why it was not accepted.
        rejections: Rejections,
    },
    /// The matrix of an iteration is singular.
    Singular {
        /// The time at the end of the step tried, s.
        time: R,
    },
    /// A stage was at a singular position, or not finite, and no other size of step would help or may be tried.
    Breakdown,
    /// An iteration did not converge.
    NoConvergence {
        /// Iterations made.
        iterations: u32,
        /// The change by the last of them, relative to what may remain.
        residual: R,
    },
}
