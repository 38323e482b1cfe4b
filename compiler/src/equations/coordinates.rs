//! The coordinates of a mechanism and where they put its bodies.
//!
//! q = [linear coordinates | (cos, sin) per rotation | (turns, remainder) per multi-turn angle],
//! v = [linear rates | ω per rotation].

use super::joints;
use super::kinematics::{FrameId, GROUND, Kinematics, Placement, Position, TurningFrame};
use super::laws::Laws;
use super::spanning_tree::{Attachment, SpanningTree};
use crate::model::{BodyId, BodyKind, Frame, JointId, Mechanism, Rotor};
use crate::symbolic::{Class, Graph, Node};
use std::collections::BTreeMap;

/// A coordinate that is a length.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Linear {
    /// World x (0) or y (1) of the centre of mass of a free body.
    Center(BodyId, usize),
    /// Travel of a joint that carries a body.
    Travel(JointId),
}

/// A multi-turn angle: its rate is `v[plus] − v[minus]`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MultiTurn {
    pub rotor: Rotor,
    pub plus: Option<usize>,
    pub minus: Option<usize>,
}

/// What each entry of q and v is.
#[derive(Clone, Debug, Default)]
pub struct Layout {
    pub linear: Vec<Linear>,
    /// The body whose orientation each pair is.
    pub rotations: Vec<BodyId>,
    pub angles: Vec<MultiTurn>,
}

impl Layout {
    pub fn velocities(&self) -> usize {
        self.linear.len() + self.rotations.len()
    }
    pub fn positions(&self) -> usize {
        self.linear.len() + 2 * self.rotations.len() + 2 * self.angles.len()
    }
    /// Index in q of the cosine of rotation `r`; the sine follows.
    pub fn pair(&self, r: usize) -> usize {
        self.linear.len() + 2 * r
    }
    /// Index in q of the turns of multi-turn angle `a`; the remainder follows.
    pub fn turns(&self, a: usize) -> usize {
        self.linear.len() + 2 * self.rotations.len() + 2 * a
    }
    /// Names of the entries of q, `crank.cos`.
    pub fn position_names(&self, mechanism: &Mechanism) -> Vec<String> {
        let mut names: Vec<String> = self.linear.iter().map(|linear| linear.name(mechanism)).collect();
        for body in &self.rotations {
            let body = &mechanism.bodies[body.0].name.text;
            names.extend([format!("{body}.cos"), format!("{body}.sin")]);
        }
        for angle in &self.angles {
            let rotor = rotor_name(mechanism, angle.rotor);
            names.extend([format!("{rotor}.turns"), format!("{rotor}.remainder")]);
        }
        names
    }
    /// Names of the entries of v, `crank.rate`.
    pub fn velocity_names(&self, mechanism: &Mechanism) -> Vec<String> {
        let linear = self.linear.iter().map(|linear| match linear {
            Linear::Center(body, axis) => {
                format!("{}.center.velocity.{}", mechanism.bodies[body.0].name.text, ["x", "y"][*axis])
            }
            Linear::Travel(joint) => format!("{}.speed", mechanism.joints[joint.0].name.text),
        });
        let rotations =
            self.rotations.iter().map(|body| format!("{}.rate", mechanism.bodies[body.0].name.text));
        linear.chain(rotations).collect()
    }
}

impl Linear {
    fn name(&self, mechanism: &Mechanism) -> String {
        match self {
            Linear::Center(body, axis) => {
                format!("{}.center.{}", mechanism.bodies[body.0].name.text, ["x", "y"][*axis])
            }
            Linear::Travel(joint) => format!("{}.travel", mechanism.joints[joint.0].name.text),
        }
    }
}

pub fn rotor_name(mechanism: &Mechanism, rotor: Rotor) -> &str {
    match rotor {
        Rotor::Joint(joint) => &mechanism.joints[joint.0].name.text,
        Rotor::Body(body) => &mechanism.bodies[body.0].name.text,
    }
}

/// The unknowns of the graph, in the order of their creation.
#[derive(Clone, Debug)]
pub struct Symbols {
    pub parameters: Vec<Node>,
    /// One per coupling whose phase comes from the assembled start.
    pub phases: Vec<Node>,
    pub time: Node,
    pub q: Vec<Node>,
    pub v: Vec<Node>,
    pub inputs: Vec<Node>,
    pub two_alpha: Node,
    pub beta_squared: Node,
    /// v̇ and λ, for functions that take them as given.
    pub acceleration: Vec<Node>,
    pub lambda: Vec<Node>,
    /// Values asked of conditions.
    pub targets: Vec<Node>,
}

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
                let kind = &mechanism.joints[joint.0].kind;
                if joints::slides(kind) {
                    found.travels.insert(*joint, linear.len());
                    linear.push(Linear::Travel(*joint));
                }
                if rigid && !joints::turns(kind) {
                    found.frames[body.0] = match parent {
                        Frame::Ground => GROUND,
                        Frame::Body(parent) => found.frames[parent.0],
                    };
                }
                rigid && joints::turns(kind)
            }
        };
        if turns {
            found.layout.rotations.push(*body);
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
                Rotor::Joint(joint) => {
                    let joint = &mechanism.joints[joint.0];
                    (rate(joint.second.frame), rate(joint.first.frame))
                }
            };
            MultiTurn { rotor: *rotor, plus, minus }
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
    let at = laws.vector(g, &mechanism.bodies[body.0].center);
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

fn symbols(g: &mut Graph, mechanism: &Mechanism, layout: &Layout) -> Symbols {
    let named = |g: &mut Graph, names: Vec<String>, class: Class| -> Vec<Node> {
        names.into_iter().map(|name| g.symbol(name, class)).collect()
    };
    let parameters = mechanism.parameters.iter().map(|parameter| parameter.name.identifier()).collect();
    let inputs = mechanism.inputs.iter().map(|input| input.name.identifier()).collect();
    let phases = super::couplings::open_phases(mechanism).map(|name| format!("{name}_phase")).collect();
    let dots = |names: Vec<String>| {
        names.into_iter().map(|name| name.replace(['.', '['], "_").replace(']', "")).collect::<Vec<_>>()
    };
    let velocity_names = dots(layout.velocity_names(mechanism));
    let acceleration_names = velocity_names.iter().map(|name| format!("{name}_dot")).collect();
    Symbols {
        parameters: named(g, parameters, Class::Parameter),
        phases: named(g, phases, Class::Parameter),
        time: g.symbol("time", Class::Position),
        q: named(g, dots(layout.position_names(mechanism)), Class::Position),
        v: named(g, velocity_names, Class::Velocity),
        inputs: named(g, inputs, Class::Input),
        two_alpha: g.symbol("two_alpha", Class::Input),
        beta_squared: g.symbol("beta_squared", Class::Input),
        acceleration: named(g, acceleration_names, Class::Input),
        lambda: Vec::new(),
        targets: Vec::new(),
    }
}
