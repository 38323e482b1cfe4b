//! What the modes of beams resist with, by themselves: K p + C ṗ, in the plane and in space.

use super::Laws;
use crate::model::{Beam, BodyId};
use crate::symbolic::Scalar;

/// K of a mode, N/m: ∫ EI (N″)² or ∫ EA (N′)².
pub fn stiffness<'g>(laws: &Laws<'g>, beam: &Beam, mode: usize) -> Scalar<'g> {
    let mode = &beam.slender.modes[mode];
    mode.stiffness * laws.value(beam.rigidity(mode.way))
}

/// C of a mode, N s/m: 2 ζ √(K M).
pub fn damping<'g>(laws: &Laws<'g>, body: BodyId, beam: &Beam, mode: usize) -> Scalar<'g> {
    let ratio = laws.value(&beam.damping_ratio);
    if ratio.is_zero() {
        return ratio;
    }
    let mass = beam.slender.second[mode + 1][mode + 1] * laws.value(&laws.mechanism.bodies[body.0].mass);
    2.0 * (ratio * (stiffness(laws, beam, mode) * mass).sqrt())
}
