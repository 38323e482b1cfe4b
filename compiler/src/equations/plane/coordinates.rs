//! The coordinates of a planar mechanism and where they put its bodies.
//!
//! Each body keeps its own orientation (cos, sin) and rate ω, in tree coordinates too: rotations never compose.

use super::joints;
use super::kinematics::{FrameId, GROUND, Kinematics, Placement, Position, TurningFrame};
use crate::equations::coordinates::{Layout, Linear, MultiTurn, Rotation, Symbols, symbols};
use crate::equations::laws::Laws;
use crate::equations::spanning_tree::{Attachment, SpanningTree};
use crate::model::{BodyId, BodyKind, Frame, JointId, Mechanism, Rotor};
use crate::symbolic::Graph;
use std::collections::BTreeMap;

/// What `layout` reads off the tree: the frame and the travel of each body.
struct Enumeration {
    layout: Layout,
    frames: Vec<FrameId>,
    travels: BTreeMap<JointId, usize>,
    centers: BTreeMap<BodyId, usize>,
}

fn enumerate(mechanism: &Mechanism, tree: &SpanningTree) -> Enumeration {
    let mut found = Enumeration {
        layout: Layout::default(),
        frames: vec![GROUND; mechanism.bodies.len()],
        travels: BTreeMap::new(),
        centers: BTreeMap::new(),
    };
    for Attachment { body, joint } in &tree.attachments {
        let rigid = mechanism.bodies[body.0].kind == BodyKind::Rigid;
        let linear = &mut found.layout.linear;
        let turns = match joint {
            None => {
                found.centers.insert(*body, linear.len());
                linear.extend([Linear::Center(*body, 0), Linear::Center(*body, 1)]);
                rigid
            }
            Some((joint, parent)) => {
                let form = mechanism.joints[joint.0].form;
                if !form.travels.is_empty() {
                    found.travels.insert(*joint, linear.len());
                    linear.push(Linear::Travel(*joint, 0));
                }
                if rigid && form.keeps_orientation {
                    found.frames[body.0] = match parent {
                        Frame::Ground => GROUND,
                        Frame::Body(parent) => found.frames[parent.0],
                    };
                }
                rigid && !form.keeps_orientation
            }
        };
        if turns {
            found.layout.rotations.push(Rotation::Body(*body));
            found.frames[body.0] = found.layout.rotations.len();
        }
    }
    found
}

/// Coordinates for a spanning tree: their layout, symbols for them, and the bodies' placements.
pub fn coordinates(
    g: &mut Graph,
    mechanism: &Mechanism,
    tree: &SpanningTree,
    rotors: &[Rotor],
) -> (Layout, Symbols, Kinematics) {
    let Enumeration { mut layout, frames, travels, centers } = enumerate(mechanism, tree);
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
            MultiTurn { rotor: *rotor, rate: terms.collect() }
        })
        .collect();

    let symbols = symbols(g, mechanism, &layout);
    let mut kinematics = Kinematics {
        frames: vec![TurningFrame { cos: g.constant(1.0), sin: g.constant(0.0), rate: None }],
        velocities: symbols.v.clone(),
        bodies: Vec::new(),
    };
    for r in 0..layout.rotations.len() {
        let (cos, sin) = (symbols.q[layout.pair(r)], symbols.q[layout.pair(r) + 1]);
        kinematics.frames.push(TurningFrame { cos, sin, rate: Some(linear + r) });
    }

    let mut placements: Vec<Option<Placement>> = vec![None; mechanism.bodies.len()];
    for Attachment { body, joint } in &tree.attachments {
        let placement = match joint {
            None => free(g, mechanism, &symbols, *body, frames[body.0], centers[body]),
            Some((joint, parent)) => {
                let travel = travels.get(joint).map(|index| (symbols.q[*index], *index));
                let parent = ground_or(g, *parent, &placements);
                let laws = Laws::constant(mechanism, &symbols);
                joints::attach(g, &laws, *joint, *body, parent, frames[body.0], travel)
            }
        };
        placements[body.0] = Some(placement);
    }
    kinematics.bodies = placements.into_iter().flatten().collect();
    (layout, symbols, kinematics)
}

/// A free body: its coordinates are its centre of mass and its own rotation.
fn free(
    g: &mut Graph,
    mechanism: &Mechanism,
    symbols: &Symbols,
    body: BodyId,
    frame: FrameId,
    index: usize,
) -> Placement {
    let (zero, one) = (g.constant(0.0), g.constant(1.0));
    let mut center = Position::fixed(g, GROUND, [symbols.q[index], symbols.q[index + 1]]);
    if let Some(vector) = center.parts.get_mut(&GROUND) {
        vector.slides.insert(index, [one, zero]);
        vector.slides.insert(index + 1, [zero, one]);
    }
    let laws = Laws::constant(mechanism, symbols);
    let at = laws.pair_of(g, &mechanism.bodies[body.0].center);
    let arm = Position::fixed(g, frame, at);
    Placement { origin: center.sub(g, &arm), frame, offset: [one, zero] }
}

fn ground_or(g: &mut Graph, parent: Frame, placements: &[Option<Placement>]) -> Placement {
    let ground =
        Placement { origin: Position::default(), frame: GROUND, offset: [g.constant(1.0), g.constant(0.0)] };
    match parent {
        Frame::Ground => ground,
        Frame::Body(parent) => placements[parent.0].clone().unwrap_or(ground),
    }
}
