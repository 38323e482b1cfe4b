//! Past a stage at which a factorisation breaks down: the accelerations of a position a little further along.

use super::{Evaluation, Formulation};
use crate::layout::retract;
use crate::mechanism::Mechanism;
use crate::real::Real;
use crate::state::StateOf;
use crate::vector::Vector;

/// How far the stage is moved along its velocities at first, as a part of the step, and how much further where that breaks down as
/// well.
const FURTHER: [f64; 2] = [1e-4, 10.0];

/// The accelerations and multipliers of the first of so many positions that has some, in a step of size `h`; none if none has.
#[cold]
#[allow(clippy::too_many_arguments)]
pub(crate) fn past_breakdown<R: Real, M: Mechanism<R>, F: Formulation<R, M>>(
    formulation: &F,
    memory: &mut F::Memory,
    model: &M,
    (time, h, positions): (R, R, u32),
    state: &StateOf<M, R>,
    inputs: &M::Inputs,
    a: &mut M::V,
    lambda: &mut M::Lambda,
) -> Option<Evaluation<R>> {
    let mut duration = R::from_f64(FURTHER[0]) * h;
    (0..positions).find_map(|_| {
        let mut further = state.clone();
        retract(model.layout(), &state.q, &state.v.scaled(duration), &mut further.q);
        duration = duration * R::from_f64(FURTHER[1]);
        let evaluation = formulation.acceleration(memory, model, time, &mut further, inputs, a, lambda);
        // Written so that a NaN fails.
        let is_sound = R::any(evaluation.pivot.greater_equal(R::BREAKDOWN)) && a.first_not_finite().is_none();
        is_sound.then_some(evaluation)
    })
}
