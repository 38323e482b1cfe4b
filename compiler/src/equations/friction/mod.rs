//! Friction in joints: what resists the sliding of two surfaces, by the force N that presses them together, which is the reaction
//! that the joint has.
//!
//! ```text
//! F = N p(v) + o(v)    against each component of the sliding v (N or N m; N in N)
//! ```
//! N is a symbol here, one for each friction that has one, and Q is affine in these symbols. What N is in v̇ and λ stands in
//! `normal`, what it is for a state in `solve::friction`. One file for each law p, o; what slides, and what presses, is `bearing`.

mod bearing;
mod coulomb;
mod magnitudes;
mod normal;
mod stribeck;

pub use normal::{Friction, closed, friction, symbols};

use super::laws::Laws;
use super::loads::{LoadKind, LoadTerms, along};
use crate::model::Load;
use crate::symbolic::Scalar;
use bearing::Slip;

/// The laws of friction, which the plane and space have in common.
pub static LAWS: &[&LoadKind] = &[&coulomb::LOAD, &stribeck::LOAD];

/// p and o of each component of a sliding v: rad/s where the surfaces turn on each other, else m/s.
type Resistance = for<'g> fn(&Laws<'g>, &Load, &[Scalar<'g>]) -> Vec<[Scalar<'g>; 2]>;

/// −(N a p + o) along each of the coordinates that slide, a being the radius of what turns; and where a length of surface
/// turns and shifts, by the same law along both.
fn terms<'g>(laws: &Laws<'g>, load: &Load, resistance: Resistance) -> LoadTerms<'g> {
    let pressed = pressed(laws, load);
    bearing::slips(laws, load).into_iter().fold(LoadTerms::none(laws), |sum, slip| {
        let efforts = slip.efforts(laws, load, pressed, resistance);
        slip.along
            .iter()
            .zip(efforts)
            .fold(sum, |sum, ((coordinate, _), effort)| sum.and(along(coordinate, effort)))
    })
}

/// What it exerts along the first coordinate that slides.
fn effort<'g>(laws: &Laws<'g>, load: &Load, resistance: Resistance) -> Scalar<'g> {
    let first = bearing::slips(laws, load).into_iter().next();
    let efforts = first.map(|slip| slip.efforts(laws, load, pressed(laws, load), resistance));
    efforts.and_then(|efforts| efforts.first().copied()).unwrap_or_else(|| laws.g.zero())
}

/// N, the preload included.
pub fn pressed<'g>(laws: &Laws<'g>, load: &Load) -> Scalar<'g> {
    let own = load.normal.and_then(|which| laws.symbols.normals.get(which));
    let own = own.map_or_else(|| laws.g.zero(), |own| laws.g.on(*own));
    own + laws.value(load.named("preload"))
}

impl<'g> Slip<'g> {
    /// v.
    fn sliding(&self) -> Vec<Scalar<'g>> {
        self.along.iter().map(|(coordinate, lever)| *lever * coordinate.rate()).collect()
    }

    fn efforts(
        &self,
        laws: &Laws<'g>,
        load: &Load,
        pressed: Scalar<'g>,
        resistance: Resistance,
    ) -> Vec<Scalar<'g>> {
        let resisted = resistance(laws, load, &self.sliding());
        let efforts = self.along.iter().zip(resisted);
        efforts.map(|((_, lever), [p, o])| -(*lever * (pressed * (self.radius * p) + o))).collect()
    }
}

/// v/√(v·v + v_s²): of one root, smooth, and as good as the direction of v well above v_s.
fn direction<'g>(v: &[Scalar<'g>], speed: Scalar<'g>) -> Vec<Scalar<'g>> {
    let inverse = size(v, speed).reciprocal();
    v.iter().map(|v| *v * inverse).collect()
}

/// √(v·v + v_s²).
fn size<'g>(v: &[Scalar<'g>], speed: Scalar<'g>) -> Scalar<'g> {
    v.iter().fold(speed.square(), |sum, v| sum + v.square()).sqrt()
}
