//! Past a stage at which a factorisation breaks down: the accelerations of a position a little further along.

use super::{Evaluation, Formulation};
use crate::layout::retract;
use crate::mechanism::Mechanism;
use crate::real::Real;
use crate::state::StateOf;
use crate::vector::Vector;

/// How far the stage is moved along its velocities, as parts of the step; the next is tried where the one before breaks down as
/// well.
const FURTHER: [f64; 3] = [1e-4, 1e-3, 1e-2];

/// The accelerations and multipliers of the first of these positions that has some, in a step of size `h`; none if none has.
#[cold]
#[allow(clippy::too_many_arguments)]
pub(crate) fn past_breakdown<R: Real, M: Mechanism<R>, F: Formulation<R, M>>(
    formulation: &F,
    memory: &mut F::Memory,
    model: &M,
    (time, h): (R, R),
    state: &StateOf<M, R>,
    inputs: &M::Inputs,
    a: &mut M::V,
    lambda: &mut M::Lambda,
) -> Option<Evaluation<R>> {
    FURTHER.iter().find_map(|&part| {
        let mut further = state.clone();
        retract(model.layout(), &state.q, &state.v.scaled(R::from_f64(part) * h), &mut further.q);
        let evaluation = formulation.acceleration(memory, model, time, &mut further, inputs, a, lambda);
        // Written so that a NaN fails.
        let is_sound = R::any(evaluation.pivot.greater_equal(R::BREAKDOWN)) && a.first_not_finite().is_none();
        is_sound.then_some(evaluation)
    })
}
