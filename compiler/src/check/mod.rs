//! Checks: static rules on the model, numeric rules by assembling the mechanism.

mod admitted;
pub mod assemble;
mod beams;
mod beyond;
mod braking;
mod contacts;
mod cords;
mod curves;
mod elimination;
mod friction;
mod gears;
mod held;
mod locks;
mod messages;
mod mobility;
pub mod motion;
mod penalty;
mod proportion;
pub mod rules;
mod size;
mod steady;
mod warnings;

pub use beams::deflections;
pub use beams::{Strain, strains, unstiffened};
pub use beyond::beyond_tables;
pub use braking::{Braking, braking};
pub use contacts::{Blow, contact_times, contacts};
pub use cords::cords;
pub use curves::{curves, standing};
pub use held::held;
pub use locks::locks;
pub use penalty::{Vibration, vibration};
pub use steady::{steady, unstable};
pub use warnings::{unstable_states, warnings};

pub use size::{size, ways};

use crate::diagnostics::Diagnostics;
use crate::equations::{SpanningTree, couplings, space};
use crate::model::{Joint, JointId, Mechanism, Rotor, Space};

/// The static rules.
pub fn check(mechanism: &Mechanism) -> Result<(), Diagnostics> {
    let mut errors = Diagnostics::new();
    rules::check(mechanism, &mut errors);
    errors.finish(())
}

/// In space the turns of an angle are counted along one velocity, so its joint has to carry a body.
pub fn counted_angles(mechanism: &Mechanism, tree: &SpanningTree) -> Result<(), Diagnostics> {
    let mut errors = Diagnostics::new();
    if mechanism.space == Space::Spatial {
        let carrying = tree.carrying(mechanism);
        for rotor in couplings::multi_turn_rotors(mechanism) {
            let Rotor::Joint(joint, _) = rotor else { continue };
            let Joint { name, .. } = &mechanism.joints[joint.0];
            if !mechanism.joints[joint.0].holds() {
                errors.error(name.span, messages::counted_and_yielding(&name.text));
            } else if !carrying[joint.0] {
                errors.error(name.span, messages::counted_and_cut(&name.text));
            }
        }
    }
    errors.finish(())
}

/// Whether absolute coordinates have all that the dynamics use. They can count angles: their axes have to be known here, and a
/// universal joint has two that move. They do not have the parameter of a curve that is no graph.
pub fn absolute_is_possible(mechanism: &Mechanism) -> Result<(), (JointId, String)> {
    if let Some(joint) = mechanism.bound_to_a_tree() {
        return Err((joint, messages::curve_in_absolute(&mechanism.joints[joint.0].name.text)));
    }
    for rotor in couplings::multi_turn_rotors(mechanism) {
        let Rotor::Joint(id, _) = rotor else { continue };
        let joint = &mechanism.joints[id.0];
        let known = |place| space::constant_axis(mechanism, joint, place).is_some();
        if mechanism.space == Space::Spatial && !(known(&joint.first) && known(&joint.second)) {
            return Err((id, messages::not_counted_in_absolute(&joint.name.text)));
        }
    }
    Ok(())
}
