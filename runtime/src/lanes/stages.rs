//! The mechanisms in lanes as an integrator sees them: the stages of one step, without a way past breakdowns.

use crate::formulation::Formulation;
use crate::integrator::Dynamics;
use crate::mechanism::Mechanism;
use crate::real::Real;
use crate::state::{Derivative, DerivativeOf, StateOf};
use crate::vector::Vector;

pub(super) struct LaneStages<'s, M: Mechanism<R>, R: Real, F: Formulation<R, M>> {
    pub model: &'s M,
    pub formulation: F,
    pub memory: F::Memory,
    pub inputs: &'s M::Inputs,
    /// The smallest pivot so far.
    pub pivot: R,
    /// The lanes in which no stage broke down.
    pub sound: R::Mask,
}

impl<M: Mechanism<R>, R: Real, F: Formulation<R, M>> Dynamics<R> for LaneStages<'_, M, R, F> {
    type Variables = M;

    #[inline(always)]
    fn variables(&self) -> &M {
        self.model
    }

    #[inline(always)]
    fn derivative(&mut self, time: R, state: &mut StateOf<M, R>) -> DerivativeOf<M, R> {
        let Self { model, formulation, memory, inputs, .. } = self;
        let (mut a, mut lambda) = (model.zero_v(), model.zero_lambda());
        let found = formulation.acceleration(memory, model, time, state, inputs, &mut a, &mut lambda);
        let mut z = M::Z::zeros(state.z.as_slice().len());
        model.internal_rates(time, state, inputs, &a, &lambda, &mut z);
        // Written so that a NaN is not sound.
        self.sound = self.sound & found.pivot.greater_equal(R::BREAKDOWN);
        self.pivot = found.pivot.min(self.pivot);
        Derivative { v: state.v.clone(), a, z }
    }
}
