//! The coordinates of a planar mechanism and where they put its bodies.
//!
//! Each body keeps its own orientation (cos, sin) and rate ω, in tree coordinates too: rotations never compose.

use super::flexible::{Flexible, Modal, ModalMotion, slope_weights};
use super::joints;
use super::kinematics::{
    FrameId, GROUND, Kinematics, LocalVector, Placement, Position, Travelled, TurningFrame,
};
use super::vector;
use crate::equations::coordinates::{Layout, Linear, MultiTurn, Rotation, Symbols, symbols};
use crate::equations::laws::Laws;
use crate::equations::spanning_tree::{Attachment, SpanningTree};
use crate::model::{BodyId, Frame, JointId, Mechanism, Place, Rotor};
use crate::symbolic::Sheet;
use std::collections::BTreeMap;

/// What `layout` reads off the tree: the frame and the travel of each body.
struct Enumeration {
    layout: Layout,
    frames: Vec<FrameId>,
    travels: BTreeMap<JointId, usize>,
    centers: BTreeMap<BodyId, usize>,
    /// The first mode of each beam.
    modes: BTreeMap<BodyId, usize>,
}

fn enumerate(mechanism: &Mechanism, tree: &SpanningTree) -> Enumeration {
    let mut found = Enumeration {
        layout: Layout::default(),
        frames: vec![GROUND; mechanism.bodies.len()],
        travels: BTreeMap::new(),
        centers: BTreeMap::new(),
        modes: BTreeMap::new(),
    };
    for Attachment { body, joint } in &tree.attachments {
        let turns = mechanism.bodies[body.0].form.turns;
        let linear = &mut found.layout.linear;
        let turns = match joint {
            None => {
                found.centers.insert(*body, linear.len());
                linear.extend([Linear::Center(*body, 0), Linear::Center(*body, 1)]);
                turns
            }
            Some((joint, parent)) => {
                let form = mechanism.joints[joint.0].form;
                if !form.travels.is_empty() {
                    found.travels.insert(*joint, linear.len());
                    linear.extend((0..form.travels.len()).map(|which| Linear::Travel(*joint, which)));
                }
                if turns && form.keeps_orientation {
                    found.frames[body.0] = match parent {
                        Frame::Ground => GROUND,
                        Frame::Body(parent) => found.frames[parent.0],
                    };
                }
                turns && !form.keeps_orientation
            }
        };
        if let Some(beam) = mechanism.bodies[body.0].beam() {
            let linear = &mut found.layout.linear;
            found.modes.insert(*body, linear.len());
            linear.extend((0..beam.slender.modes.len()).map(|mode| Linear::Mode(*body, mode)));
        }
        if turns {
            found.layout.rotations.push(Rotation::Body(*body));
            found.frames[body.0] = found.layout.rotations.len();
        }
    }
    found
}

/// Coordinates for a spanning tree: their layout, symbols for them, and the bodies' placements.
pub fn coordinates(
    g: Sheet,
    mechanism: &Mechanism,
    tree: &SpanningTree,
    rotors: &[Rotor],
) -> (Layout, Symbols, Kinematics) {
    let Enumeration { mut layout, frames, travels, centers, modes } = enumerate(mechanism, tree);
    let linear = layout.linear.len();
    let rate = |frame: Frame| match frame {
        Frame::Ground => None,
        Frame::Body(body) if frames[body.0] == GROUND => None,
        Frame::Body(body) => Some(linear + frames[body.0] - 1),
    };
    layout.angles = rotors
        .iter()
        .map(|rotor| {
            let (plus, minus) = match rotor {
                Rotor::Body(body) => (rate(Frame::Body(*body)), None),
                Rotor::Joint(joint, _) => {
                    let joint = &mechanism.joints[joint.0];
                    (rate(joint.second.frame), rate(joint.first.frame))
                }
            };
            let terms = plus.map(|index| (index, 1.0)).into_iter().chain(minus.map(|index| (index, -1.0)));
            let mut rate: Vec<(usize, f64)> = terms.collect();
            if let Rotor::Joint(joint, _) = rotor {
                let joint = &mechanism.joints[joint.0];
                rate.extend(sections(mechanism, &joint.second, &modes));
                let first = sections(mechanism, &joint.first, &modes);
                rate.extend(first.into_iter().map(|(index, weight)| (index, -weight)));
            }
            MultiTurn { rotor: *rotor, rate }
        })
        .collect();

    let symbols = symbols(g, mechanism, &layout);
    let mut kinematics = Kinematics {
        frames: vec![TurningFrame::still(g)],
        velocities: symbols.v.clone(),
        bodies: Vec::new(),
        travels: BTreeMap::new(),
    };
    for r in 0..layout.rotations.len() {
        let (cos, sin) = (symbols.q[layout.pair(r)], symbols.q[layout.pair(r) + 1]);
        kinematics.frames.push(TurningFrame { cos, sin, rate: Some(linear + r) });
    }

    let laws = Laws::constant(g, mechanism, &symbols);
    let mut placements: Vec<Option<Placement>> = vec![None; mechanism.bodies.len()];
    for Attachment { body, joint } in &tree.attachments {
        let flexible = modes.get(body).and_then(|first| flexible(&symbols, mechanism, *body, *first));
        let placement = match joint {
            None => free(&laws, *body, frames[body.0], centers[body], flexible),
            Some((joint, parent)) => {
                let count = mechanism.joints[joint.0].form.travels.len();
                let own = travels.get(joint).into_iter().flat_map(|first| *first..first + count);
                let own = own.map(|index| (symbols.q[index], index)).collect();
                let parent = ground_or(g, *parent, &placements);
                joints::attach(&laws, *joint, *body, parent, (frames[body.0], flexible), own)
            }
        };
        placements[body.0] = Some(placement);
    }
    kinematics.bodies = placements.into_iter().flatten().collect();
    for (joint, index) in travels.iter().filter(|(joint, _)| mechanism.joints[joint.0].must_carry()) {
        let (value, rate, index) = (symbols.q[*index], symbols.v[*index], Some(*index));
        kinematics.travels.insert(*joint, Travelled { value, rate, index });
    }
    (layout, symbols, kinematics)
}

/// A free body: its coordinates are its centre of mass and its own rotation.
fn free(laws: &Laws, body: BodyId, frame: FrameId, index: usize, flexible: Option<Flexible>) -> Placement {
    let g = laws.g;
    let mut center = LocalVector::fixed(g.on([laws.symbols.q[index], laws.symbols.q[index + 1]]));
    center.slide_freely(g, index);
    let arm = laws.pair_of(&laws.mechanism.bodies[body.0].center).fixed_in(frame);
    let origin = g.on(Position::of(GROUND, center)) - arm;
    Placement { origin: origin.bare, frame, offset: vector::unturned(g).bare, flexible }
}

/// The modes of a beam, whose coordinates stand side by side.
fn flexible(symbols: &Symbols, mechanism: &Mechanism, body: BodyId, first: usize) -> Option<Flexible> {
    let beam = mechanism.bodies[body.0].beam()?;
    let modal = |index: usize| Modal {
        value: symbols.q[index],
        rate: symbols.v[index],
        motion: ModalMotion::Free(index),
    };
    let modes = (first..first + beam.slender.modes.len()).map(modal).collect();
    Some(Flexible { slender: beam.slender.clone(), modes })
}

/// The weights of modes in the rate of the section at a place.
fn sections(mechanism: &Mechanism, place: &Place, modes: &BTreeMap<BodyId, usize>) -> BTreeMap<usize, f64> {
    let first = match place.frame {
        Frame::Ground => None,
        Frame::Body(body) => modes.get(&body).copied(),
    };
    slope_weights(mechanism.beam(place.frame), place, first)
}

fn ground_or(g: Sheet, parent: Frame, placements: &[Option<Placement>]) -> Placement {
    let offset = vector::unturned(g).bare;
    let ground = Placement { origin: Position::default(), frame: GROUND, offset, flexible: None };
    match parent {
        Frame::Ground => ground,
        Frame::Body(parent) => placements[parent.0].clone().unwrap_or(ground),
    }
}
