//! What a stepper does in a step: an integrator, and what keeps the constraints.

use crate::formulation::{Baumgarte, Formulation};
use crate::integrator::{ExplicitTrapezoidal, FixedStep, Rk4, SemiImplicitEuler};
use crate::mechanism::Mechanism;
use crate::real::Real;

/// The part of the way back to the constraints that Baumgarte's terms take in a step: a time constant of ten steps, far from where
/// explicit methods become unstable (2.8 steps of the classical one, 1 of Euler's).
const PART: f64 = 0.1;

/// A method of a [`Stepper`](super::Stepper): a pair of an integrator and a formulation, such as `(Rk4, NullSpace)`, or an
/// integrator alone, with [`Baumgarte`]'s terms for a time constant of ten steps.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no method of a stepper",
    label = "write an integrator, `Rk4`, or a pair of an integrator and a formulation, `(Rk4, NullSpace)`",
    note = "integrators are `SemiImplicitEuler`, `ExplicitTrapezoidal` and `Rk4`"
)]
pub trait StepMethod<R: Real, M: Mechanism<R>>: Clone {
    /// How time is stepped.
    type Integrator: FixedStep<R>;
    /// How accelerations follow the constraints.
    type Formulation: Formulation<R, M> + Clone;

    /// The integrator.
    fn integrator(&self) -> &Self::Integrator;
    /// The formulation in a step of size `h`, s.
    fn formulation(&self, h: R) -> Self::Formulation;
}

impl<R: Real, M: Mechanism<R>, I: FixedStep<R> + Clone, F: Formulation<R, M> + Clone> StepMethod<R, M>
    for (I, F)
{
    type Integrator = I;
    type Formulation = F;

    #[inline(always)]
    fn integrator(&self) -> &I {
        &self.0
    }

    #[inline(always)]
    fn formulation(&self, _h: R) -> F {
        self.1.clone()
    }
}

macro_rules! alone {
    ($($integrator:ident),*) => {$(
        impl<R: Real, M: Mechanism<R>> StepMethod<R, M> for $integrator {
            type Integrator = $integrator;
            type Formulation = Baumgarte<R>;

            #[inline(always)]
            fn integrator(&self) -> &$integrator {
                self
            }

            #[inline(always)]
            fn formulation(&self, h: R) -> Baumgarte<R> {
                let rate = R::from_f64(PART) / h;
                Baumgarte { alpha: rate, beta: rate }
            }
        }
    )*};
}

alone!(SemiImplicitEuler, ExplicitTrapezoidal, Rk4);
