//! Dense output: the state between the ends of the last step.

use super::Method;
use crate::real::Real;
use crate::state::{StateOf, Variables};

/// A method whose memory holds a continuous extension of the last step.
///
/// The extension joins the state that the step began with to the one that the method itself ended it with. Where a
/// formulation then brings that state to the constraints ([`Projected`](crate::Projected)), the extension ends before the
/// projection: at the step's end it is off by what [`Step::moved`](crate::Step::moved) says, and between the ends it is off
/// the constraints by its own truncation error.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no dense output",
    label = "this integrator knows states only at the ends of its steps",
    note = "use `.integrator(DormandPrince::tolerance(1e-8))`, or take samples at the steps with `run_until`, whose last step \
            lands on the end"
)]
pub trait Interpolate<R: Real>: Method<R> {
    /// The size of the last step, s; none before the first.
    fn size<X: Variables<R>>(memory: &Self::Memory<X>) -> Option<R>;

    /// The state of `of` `elapsed` (s) after the beginning of the last step; none before the first. Outside the step the extension is
    /// extrapolated and soon of no use.
    fn at<X: Variables<R>>(memory: &Self::Memory<X>, of: &X, elapsed: R) -> Option<StateOf<X, R>>;
}
