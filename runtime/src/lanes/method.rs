//! Methods whose steps go straight ahead, whatever the numbers: those that several mechanisms can take together.

use super::{InScalars, Lanes};
use crate::formulation::{Baumgarte, Corrected, LagrangeIndex1, WithMultipliers};
use crate::integrator::{ExplicitTrapezoidal, Rk4, SemiImplicitEuler};
use crate::stepper::StepMethod;

/// A method of a [`Stepper`](crate::Stepper), or a part of one, that can be taken in lanes: it does not iterate until something
/// has vanished, and carries nothing from step to step.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no method of steps in lanes",
    label = "write `Rk4`, `(Rk4, LagrangeIndex1)`, `(Rk4, Corrected::after(LagrangeIndex1))` or the like",
    note = "formulations in lanes are `Baumgarte`, `LagrangeIndex1`, `WithMultipliers` of these, and `Corrected` after any of them"
)]
pub trait InLanes<L: Lanes>: Clone + Send + Sync {
    /// The same in lanes.
    type In: Clone + Send + Sync;

    /// The same settings in every lane.
    fn in_lanes(&self) -> Self::In;
}

macro_rules! as_it_is {
    ($($method:ident),*) => {$(
        impl<L: Lanes> InLanes<L> for $method {
            type In = $method;

            fn in_lanes(&self) -> $method {
                *self
            }
        }
    )*};
}

as_it_is!(SemiImplicitEuler, ExplicitTrapezoidal, Rk4, LagrangeIndex1);

impl<L: Lanes> InLanes<L> for Baumgarte<L::Scalar> {
    type In = Baumgarte<L>;

    fn in_lanes(&self) -> Baumgarte<L> {
        Baumgarte { alpha: L::splat(self.alpha), beta: L::splat(self.beta) }
    }
}

impl<L: Lanes, F: InLanes<L>> InLanes<L> for WithMultipliers<F> {
    type In = WithMultipliers<F::In>;

    fn in_lanes(&self) -> Self::In {
        WithMultipliers(self.0.in_lanes())
    }
}

impl<L: Lanes, F: InLanes<L>> InLanes<L> for Corrected<F> {
    type In = Corrected<F::In>;

    fn in_lanes(&self) -> Self::In {
        Corrected { formulation: self.formulation.in_lanes() }
    }
}

impl<L: Lanes, I: InLanes<L>, F: InLanes<L>> InLanes<L> for (I, F) {
    type In = (I::In, F::In);

    fn in_lanes(&self) -> Self::In {
        (self.0.in_lanes(), self.1.in_lanes())
    }
}

/// A method that steps mechanisms of the definition `M` in lanes, and one that has to leave them alone; implemented by all that can.
pub trait LaneMethod<M: InScalars, L: Lanes>:
    InLanes<L, In: StepMethod<L, M::In<L>>> + StepMethod<L::Scalar, M::In<L::Scalar>>
{
}

impl<M: InScalars, L: Lanes, S> LaneMethod<M, L> for S where
    S: InLanes<L, In: StepMethod<L, M::In<L>>> + StepMethod<L::Scalar, M::In<L::Scalar>>
{
}
