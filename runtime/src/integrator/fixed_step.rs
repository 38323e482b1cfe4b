//! Methods that take every step as they are asked to and carry nothing from one to the next.

use super::{Dynamics, ExplicitTrapezoidal, Integrator, Method, Rk4, SemiImplicitEuler, StepFailure};
use crate::real::Real;
use crate::state::StateOf;

/// A method of fixed steps: the state at the end of a step follows from that at its beginning, in a number of evaluations that is always
/// the same.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no method of fixed steps",
    label = "a stepper takes `SemiImplicitEuler`, `ExplicitTrapezoidal` or `Rk4`",
    note = "methods that choose their steps or iterate belong to a `Simulation`: `.integrator({Self} …)`"
)]
pub trait FixedStep<R: Real>: Method<R> {
    /// The state at `time + h` (s) from the one at `time`.
    ///
    /// # Errors
    /// A stage broke down.
    fn take<D: Dynamics<R>>(
        &self,
        dynamics: &mut D,
        time: R,
        h: R,
        state: &StateOf<D::Variables, R>,
    ) -> Result<StateOf<D::Variables, R>, StepFailure<R>>;
}

macro_rules! fixed_step {
    ($($method:ident),*) => {$(
        impl<R: Real> FixedStep<R> for $method {
            #[inline(always)]
            fn take<D: Dynamics<R>>(
                &self,
                dynamics: &mut D,
                time: R,
                h: R,
                state: &StateOf<D::Variables, R>,
            ) -> Result<StateOf<D::Variables, R>, StepFailure<R>> {
                self.step(&mut (), dynamics, time, h, state).map(|stepped| stepped.state)
            }
        }
    )*};
}

fixed_step!(SemiImplicitEuler, ExplicitTrapezoidal, Rk4);
