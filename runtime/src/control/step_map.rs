//! The discrete step and its exact derivatives: x_{k+1} = F(x_k, u_k) as a stepper computes it, A_d = ∂F/∂x, B_d = ∂F/∂u.
//!
//! The integrator runs over stages that record their derivatives; small motions are then carried through the same stages by `follow.rs`.

use super::follow::{Motion, StepTangent, Tape};
use crate::error::LinearisationError;
use crate::formulation::{Baumgarte, Stabilisation};
use crate::integrator::{Dynamics, FixedStep};
use crate::linearisation::{Coordinates, Linearisation, check_finite, unit};
use crate::real::Real;
use crate::state::{Derivative, DerivativeOf, StateOf};
use crate::stepper::StepMethod;
use crate::tangent::Tangent;
use crate::vector::{Vector, at, put};

/// A step and its derivatives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepMap<S, A, B> {
    /// The state after the step, that of the stepper to the bit.
    pub state: S,
    /// A_d, `[R; n_x·n_x]`, row by row.
    pub a: A,
    /// B_d, `[R; n_x·n_u]`.
    pub b: B,
}

/// [`StepMap`] of a mechanism.
pub type StepMapOf<R, M> =
    StepMap<StateOf<M, R>, <M as Tangent<R>>::StateMatrix, <M as Tangent<R>>::InputMatrix>;

/// The state a step of `h` (s) later, as a [`Stepper`](crate::Stepper) with this method computes it with the inputs held, and the exact derivatives
/// of that step in x = (δs, δṡ, δz), the coordinates of [`Tangent::states`] as in [`StateSpace`](crate::StateSpace):
///
/// ```text
/// δx(t + h) = A_d δx(t) + B_d δu       of the step as computed, not of the motion that it approximates
/// ```
/// Each column is a motion that the constraints admit at the beginning (δs = e: D δq = 0, B δq = e, and δv with ṡ as before), carried through the
/// stages by the chain rule, on the group where orientations turn, with the derivatives of Baumgarte's terms; at the end it is seen by the coordinates
/// there, δs = B δq and δṡ = δ(B v). The state must satisfy the constraints. One factor and n_x + n_u solutions a stage. Methods are those of a stepper
/// with [`Baumgarte`] or [`LagrangeIndex1`](crate::LagrangeIndex1): `Rk4`, `ExplicitTrapezoidal`, `SemiImplicitEuler`, and pairs of these.
///
/// Source: Hairer, Nørsett, Wanner, *Solving Ordinary Differential Equations I*, II.6 (derivatives of a step's stages, internal
/// differentiation after Bock 1981); on the group as in Brüls, Eberhard, *Sensitivity analysis for dynamic mechanical systems with finite rotations*
/// (2008).
///
/// # Errors
/// [`Breakdown`](LinearisationError::Breakdown), [`SingularMass`](LinearisationError::SingularMass) and
/// [`NonFinite`](LinearisationError::NonFinite) of a stage: a stepper steps over what a derivative cannot;
/// [`Assembly`](LinearisationError::Assembly) and [`Incomplete`](LinearisationError::Incomplete) of the coordinates,
/// [`CountedOrientation`](LinearisationError::CountedOrientation).
pub fn step_map<R: Real, M: Tangent<R>, S>(
    model: &M,
    method: &S,
    (time, state): (R, &StateOf<M, R>),
    inputs: &M::Inputs,
    h: R,
) -> Result<StepMapOf<R, M>, LinearisationError>
where
    S: StepMethod<R, M, Integrator: StepTangent<R>, Formulation: Stabilisation<R>>,
{
    check_finite(time, &[h], |_| Some("the step"))?;
    check_counted(model)?;
    let terms = method.formulation(h).terms();
    let mut stages = Stages { model, inputs, terms, tape: Tape::new(h), error: None };
    let stepped = method.integrator().take(&mut stages, time, h, state);
    let Stages { tape, error, .. } = stages;
    if let Some(error) = error {
        return Err(error);
    }
    let what = LinearisationError::NonFinite { time: time.to_f64(), what: model.name() };
    let next = stepped.map_err(|_| what)?;
    let begin = Coordinates::at(model, time, state, tape.acceleration().ok_or(what)?)?;
    let end = Coordinates::at(model, time + h, &next, &model.zero_v())?;
    let (f, internal, count) = (model.states().len(), model.internal_count(), model.input_names().len());
    let size = 2 * f + internal;
    let mut a = M::StateMatrix::zeros(size * size);
    let mut b = M::InputMatrix::zeros(size * count);
    let column =
        |motion: &Motion<M::V, M::Z>, input: Option<usize>, to: &mut [R], width: usize, place: usize| {
            let motion = method.integrator().follow(&tape, motion, input);
            let (positions, rates) = end.seen(&motion.q, &motion.v);
            for row in 0..f {
                put(to, row * width + place, at(positions.as_slice(), row));
                put(to, (f + row) * width + place, at(rates.as_slice(), row));
            }
            for (row, &entry) in motion.z.as_slice().iter().enumerate() {
                put(to, (2 * f + row) * width + place, entry);
            }
        };
    let still = Motion { q: model.zero_v(), v: model.zero_v(), z: model.zero_z() };
    for state in 0..f {
        let q = begin.position(state);
        let moved = Motion { v: begin.velocity(&q), q: q.clone(), ..still.clone() };
        column(&moved, None, a.as_mut_slice(), size, state);
        column(&Motion { v: q, ..still.clone() }, None, a.as_mut_slice(), size, f + state);
    }
    for state in 0..internal {
        let moved = Motion { z: unit(model.zero_z(), state), ..still.clone() };
        column(&moved, None, a.as_mut_slice(), size, 2 * f + state);
    }
    for input in 0..count {
        column(&still, Some(input), b.as_mut_slice(), count, input);
    }
    check_finite(time, a.as_slice(), |_| Some("A_d"))?;
    check_finite(time, b.as_slice(), |_| Some("B_d"))?;
    Ok(StepMap { state: next, a, b })
}

/// An angle that counts the turns of a quaternion is moved by the integral of ω, which is no motion of the quaternion.
fn check_counted<R: Real, M: Tangent<R>>(model: &M) -> Result<(), LinearisationError> {
    let layout = model.layout();
    let turned = layout.linear + layout.rotations;
    let mut angles = layout.angles.iter();
    let counted = angles.position(|angle| angle.rate.iter().any(|&(index, _)| index as usize >= turned));
    counted.map_or(Ok(()), |index| {
        let place = layout.positions() - 2 * layout.angles.len() + 2 * index;
        let angle = model.position_names().get(place).copied().unwrap_or(model.name());
        Err(LinearisationError::CountedOrientation { angle })
    })
}

/// The mechanism as the integrator sees it, which keeps the derivatives of each stage.
struct Stages<'m, R: Real, M: Tangent<R>> {
    model: &'m M,
    inputs: &'m M::Inputs,
    terms: Option<Baumgarte<R>>,
    tape: Tape<'m, R, M>,
    /// The first.
    error: Option<LinearisationError>,
}

impl<R: Real, M: Tangent<R>> Dynamics<R> for Stages<'_, R, M> {
    type Variables = M;

    fn variables(&self) -> &M {
        self.model
    }

    fn derivative(&mut self, time: R, state: &mut StateOf<M, R>) -> DerivativeOf<M, R> {
        let (model, mut z) = (self.model, self.model.zero_z());
        let here = match self.terms {
            Some(terms) => Linearisation::stabilised(model, time, state, self.inputs, terms),
            None => Linearisation::at(model, time, state, self.inputs),
        };
        match here {
            Ok(here) => {
                let a = here.acceleration().clone();
                model.internal_rates(time, state, self.inputs, &a, here.multipliers(), &mut z);
                self.tape.record(here);
                Derivative { v: state.v.clone(), a, z }
            }
            Err(error) => {
                self.error.get_or_insert(error);
                Derivative { v: state.v.clone(), a: model.zero_v(), z }
            }
        }
    }

    fn broke_down(&self) -> bool {
        self.error.is_some()
    }
}
