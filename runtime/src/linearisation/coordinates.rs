//! Small motions along the coordinates of [`Tangent::states`], and what of these is seen of a small motion.

use super::add_block;
use super::admissible::Admissible;
use crate::error::LinearisationError;
use crate::real::Real;
use crate::state::StateOf;
use crate::tangent::Tangent;
use crate::vector::Vector;

/// The coordinates s at one state: N of the motions D N = 0, B N = 1, and the derivatives of ṡ and s̈.
pub(crate) struct Coordinates<'m, R: Real, M: Tangent<R>> {
    model: &'m M,
    admissible: Admissible<'m, R, M>,
    rate: M::RateTangent,
    coordinate: M::CoordinateTangent,
}

impl<'m, R: Real, M: Tangent<R>> Coordinates<'m, R, M> {
    /// At a state and the accelerations `a`, which matter for s̈ alone.
    pub(crate) fn at(
        model: &'m M,
        time: R,
        state: &StateOf<M, R>,
        a: &M::V,
    ) -> Result<Self, LinearisationError> {
        let (q, v) = (&state.q, &state.v);
        let admissible = Admissible::at(model, time, q)?;
        let (mut rate, mut coordinate) = (model.zero_rate_tangent(), model.zero_coordinate_tangent());
        model.rate_tangent(time, q, v, &mut rate);
        model.coordinate_tangent(time, q, v, a, &mut coordinate);
        Ok(Coordinates { model, admissible, rate, coordinate })
    }

    /// δq with D δq = 0, B δq = e_index.
    pub(crate) fn position(&self, index: usize) -> M::V {
        self.admissible.basis(index)
    }

    /// δv that goes with δq where ṡ is as before.
    pub(crate) fn velocity(&self, dq: &M::V) -> M::V {
        let model = self.model;
        let mut rows = model.zero_lambda();
        add_block(model.rate_pattern(), self.rate.as_slice(), (0, 0), dq.as_slice(), rows.as_mut_slice());
        let mut states = model.zero_conditions();
        let states = states.as_mut_slice().get_mut(..model.states().len()).unwrap_or_default();
        self.add((0, 0), dq, states);
        states.iter_mut().for_each(|entry| *entry = -*entry);
        self.admissible.motion(&rows.scaled(-R::ONE), states)
    }

    /// δ with D δ = −`rows` and B δ = −`states`, and of velocities what goes with δq besides: −∂(D v − ν)/∂q δq and −∂ṡ/∂q δq.
    pub(crate) fn moved(&self, dq: &M::V, rows: &M::Lambda, states: &[R]) -> M::V {
        let model = self.model;
        let (mut to_rows, mut all) = (rows.clone(), model.zero_conditions());
        let to_states = all.as_mut_slice().get_mut(..model.states().len()).unwrap_or_default();
        for (entry, &given) in to_states.iter_mut().zip(states) {
            *entry = given;
        }
        add_block(model.rate_pattern(), self.rate.as_slice(), (0, 0), dq.as_slice(), to_rows.as_mut_slice());
        self.add((0, 0), dq, to_states);
        to_states.iter_mut().for_each(|entry| *entry = -*entry);
        self.admissible.motion(&to_rows.scaled(-R::ONE), to_states)
    }

    /// `to` += the f rows of ∂(ṡ, s̈)/∂(q, v) from `from` on, times x.
    pub(crate) fn add(&self, from: (usize, usize), x: &M::V, to: &mut [R]) {
        let model = self.model;
        add_block(model.coordinate_pattern(), self.coordinate.as_slice(), from, x.as_slice(), to);
    }

    /// (δs, δṡ) of a small motion, f numbers each: B δq and ∂(B v)/∂q δq + B δv.
    pub(crate) fn seen(&self, dq: &M::V, dv: &M::V) -> (M::Conditions, M::Conditions) {
        let (mut positions, mut rates) = (self.model.zero_conditions(), self.model.zero_conditions());
        let (f, n) = (self.model.states().len(), self.model.velocity_count());
        let first = |all: &mut M::Conditions, from, x| {
            self.add(from, x, all.as_mut_slice().get_mut(..f).unwrap_or_default());
        };
        // ∂ṡ/∂v is B.
        first(&mut positions, (0, n), dq);
        first(&mut rates, (0, 0), dq);
        first(&mut rates, (0, n), dv);
        (positions, rates)
    }
}
