//! What modes resist with, by themselves: K p + C ṗ, in the plane and in space.

use super::Laws;
use crate::beams::Way;
use crate::model::{Beam, BodyId, Deforms};
use crate::symbolic::Scalar;

/// K p + C ṗ of each mode, by the coordinates and their rates. Of a finite element model C is the damping ratio times that of the ratio 1.
pub fn resistance<'g>(
    laws: &Laws<'g>,
    body: BodyId,
    deforms: &Deforms,
    modes: &[(Scalar<'g>, Scalar<'g>)],
) -> Vec<Scalar<'g>> {
    match deforms {
        Deforms::Beam(beam) => {
            let own = |(mode, (value, rate)): (usize, &(Scalar<'g>, Scalar<'g>))| {
                let damping = damping(laws, body, beam, mode);
                stiffness(laws, beam, mode) * *value + damping * *rate
            };
            modes.iter().enumerate().map(own).collect()
        }
        Deforms::Modal(modal) => {
            let ratio = laws.value(&modal.damping_ratio);
            let critical = if ratio.is_zero() { Vec::new() } else { modal.reduced.critical_damping() };
            let row = |mode: usize| {
                let stiff = modal.reduced.stiffness[mode].iter().zip(modes);
                let sum = laws.g.sum(stiff.map(|(entry, (value, _))| *entry * *value));
                let damped = critical.get(mode).into_iter().flatten().zip(modes);
                sum + ratio * laws.g.sum(damped.map(|(entry, (_, rate))| *entry * *rate))
            };
            (0..modes.len()).map(row).collect()
        }
    }
}

/// ½ pᵀ K p, mode by mode.
pub fn energies<'g>(laws: &Laws<'g>, deforms: &Deforms, values: &[Scalar<'g>]) -> Vec<Scalar<'g>> {
    let energy = |(mode, value): (usize, &Scalar<'g>)| match deforms {
        Deforms::Beam(beam) => 0.5 * (stiffness(laws, beam, mode) * value.square()),
        Deforms::Modal(modal) => {
            let stiff = modal.reduced.stiffness[mode].iter().zip(values);
            0.5 * (*value * laws.g.sum(stiff.map(|(entry, other)| *entry * *other)))
        }
    };
    values.iter().enumerate().map(energy).collect()
}

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
    let mass = beam.slender.moved(mode) * moved;
    2.0 * (ratio * (stiffness(laws, beam, mode) * mass).sqrt())
}
