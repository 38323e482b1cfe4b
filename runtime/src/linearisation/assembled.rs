//! What a parameter changes in a mechanism that stays assembled: the coordinates s of [`Tangent::states`] and their rates are held,
//! and the rest moves as the constraints say.

use super::state_space::Columns;
use super::{ByParameters, Response};
use crate::error::LinearisationError;
use crate::fields::Fields;
use crate::real::Real;
use crate::tangent::Tangent;
use crate::vector::Vector;

/// Derivatives by one parameter of a mechanism that stays assembled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moved<V, L> {
    /// δq along the increments of the positions, shape n_v.
    pub position: V,
    /// δv.
    pub velocity: V,
    /// δv̇ and δλ, by the equations of motion at the state that has moved.
    pub response: Response<V, L>,
}

/// [`Moved`] of a mechanism.
pub type MovedOf<R, M> =
    Moved<<M as crate::state::Variables<R>>::V, <M as crate::state::Variables<R>>::Lambda>;

/// Derivatives by the parameters of a mechanism that stays assembled, at one state.
pub struct Assembled<'b, 'l, 'm, R: Real, M: Tangent<R>> {
    by: &'b ByParameters<'l, 'm, R, M>,
    columns: Columns<'l, 'm, R, M>,
}

impl<'l, 'm, R: Real, M: Tangent<R>> ByParameters<'l, 'm, R, M> {
    /// The same for a mechanism that stays assembled as its parameters change, with s and ṡ as they are: what another crank length does
    /// to the point of a coupler at this angle of the crank. Internal states, gates, inputs and the phases of couplings are held.
    ///
    /// # Errors
    /// [`Assembly`](LinearisationError::Assembly) where the coordinates do not move the whole at this position (a dead centre of
    /// theirs), [`Incomplete`](LinearisationError::Incomplete).
    pub fn assembled(&self) -> Result<Assembled<'_, 'l, 'm, R, M>, LinearisationError> {
        Ok(Assembled { by: self, columns: Columns::at(self.at)? })
    }
}

impl<R: Real, M: Tangent<R>> Assembled<'_, '_, '_, R, M> {
    /// Column `index`, with the derivatives of s and ṡ by that parameter where q and v are held: zero for coordinates that are
    /// entries of q, as those of a tree, and not for a travel between places that the parameter moves.
    ///
    /// ```text
    /// D δq = −∂Φ/∂p,                              B δq = −∂s/∂p
    /// D δv = −∂(D v − ν)/∂q δq − ∂(D v − ν)/∂p,   B δv = −∂ṡ/∂q δq − ∂ṡ/∂p
    /// K (δv̇, δλ) = −(∂r, ∂(D a − γ)) along δq, δv and p
    /// ```
    pub fn column(&self, index: usize, coordinates: [&[R]; 2]) -> MovedOf<R, M> {
        let (by, motions) = (self.by, &self.columns.coordinates);
        let none = by.at.model.zero_v();
        let [positions, rates] = coordinates;
        let position = motions.moved(&none, &by.constraints(index), positions);
        let velocity = motions.moved(&position, &by.rates(index), rates);
        let along = by.at.along(&position, &velocity);
        let direct = by.column(index);
        let response = Response {
            acceleration: along.acceleration.plus(R::ONE, &direct.acceleration),
            multipliers: along.multipliers.plus(R::ONE, &direct.multipliers),
        };
        Moved { position, velocity, response }
    }

    /// What it makes of the outputs, SI, in their order:
    /// δy = ∂y/∂q δq + ∂y/∂v δv + ∂y/∂v̇ δv̇ + ∂y/∂λ δλ + ∂y/∂p.
    pub fn outputs(&self, index: usize, moved: &MovedOf<R, M>) -> <M::Outputs as Fields<R>>::Array {
        let model = self.by.at.model;
        let mut outputs = <M::Outputs as Fields<R>>::Array::zeros(model.output_names().len());
        let to = outputs.as_mut_slice();
        self.columns.add_outputs(0, moved.position.as_slice(), to);
        self.columns.add_outputs(model.velocity_count(), moved.velocity.as_slice(), to);
        self.columns.add_response(&moved.response, to);
        self.by.add(index, model.velocity_count() + 3 * model.row_count(), to);
        outputs
    }
}
