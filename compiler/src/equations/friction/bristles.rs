//! What frictions share that remember: deflections z of bristles between two surfaces, one for each component of their sliding v.

use super::{deflections, slips};
use crate::equations::laws::Laws;
use crate::forms::Value;
use crate::model::Load;
use crate::symbolic::Scalar;

/// What resists a deflection of one, by N: 1/m, or 1/rad about a pin.
pub(super) const STIFFNESS: Value = Value::Along { effort: false, way: -1, time: 0 };
/// What resists the rate of a deflection, by N: s/m, or s/rad.
pub(super) const DAMPING: Value = Value::Along { effort: false, way: -1, time: 1 };

/// s: surfaces that are apart forget in this time, so that a new touch begins with straight bristles.
const FORGETTING: f64 = 1e-3;

/// ż of the components of one sliding v with their deflections z.
pub(super) type Bending = for<'g> fn(&Laws<'g>, &Load, v: &[Scalar<'g>], z: &[Scalar<'g>]) -> Vec<Scalar<'g>>;

/// ż of all deflections: of contacts that are open −z/τ.
pub(super) fn rates<'g>(laws: &Laws<'g>, load: &Load, bending: Bending) -> Vec<Scalar<'g>> {
    let slips = slips(laws, load).into_iter().zip(deflections(laws, load));
    let of_slip = slips.flat_map(|(slip, z)| {
        let rates = bending(laws, load, &slip.sliding(), &z).into_iter().zip(z);
        let rate = move |(rate, z): (Scalar<'g>, Scalar<'g>)| match slip.closed {
            Some(closed) => closed.select(rate, -(z / FORGETTING)),
            None => rate,
        };
        rates.map(rate)
    });
    of_slip.collect()
}

/// The length of a vector, |x| of one component; others never have less than a least length, so that it has a slope everywhere.
pub(super) fn length<'g>(x: &[Scalar<'g>], least: Scalar<'g>) -> Scalar<'g> {
    match x {
        [only] => only.abs(),
        several => super::size(several, least),
    }
}
