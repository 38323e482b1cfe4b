//! What the modes of beams resist with, by themselves: K p + C ṗ, in the plane and in space.

use super::Laws;
use crate::beams::Way;
use crate::model::{Beam, BodyId};
use crate::symbolic::Scalar;

/// K of a mode, N/m: ∫ EI (N″)² or ∫ EA (N′)²; of torsion ∫ G J_t (N′)², N m.
pub fn stiffness<'g>(laws: &Laws<'g>, beam: &Beam, mode: usize) -> Scalar<'g> {
    let mode = &beam.slender.modes[mode];
    mode.stiffness * laws.value(beam.rigidity(mode.way))
}

/// C of a mode, N s/m, of torsion N m s: 2 ζ √(K M), M the mass that it moves, or the moment of inertia about the axis that it turns.
pub fn damping<'g>(laws: &Laws<'g>, body: BodyId, beam: &Beam, mode: usize) -> Scalar<'g> {
    let ratio = laws.value(&beam.damping_ratio);
    if ratio.is_zero() {
        return ratio;
    }
    let mass = laws.value(&laws.mechanism.bodies[body.0].mass);
    let moved = match beam.slender.modes[mode].way {
        Way::Torsion => mass * laws.value(&beam.spin),
        Way::Axial | Way::Bending | Way::BendingZ => mass,
    };
    let mass = beam.slender.second[mode + 1][mode + 1] * moved;
    2.0 * (ratio * (stiffness(laws, beam, mode) * mass).sqrt())
}
