//! The coordinates of a mechanism: what the entries of q and v are, their names and their symbols. Where they put the
//! bodies is left to `plane` and `space`.
//!
//! q = [linear coordinates | (cos, sin) per rotation | (w, x, y, z) per quaternion | (turns, remainder) per multi-turn
//! angle], v = [linear rates | ω per rotation | ω along x, y, z of the turned axes per quaternion].

use crate::model::{BodyId, JointId, Mechanism, Rotor, identifier};
use crate::symbolic::{Class, Node, Sheet};

/// A coordinate that is a length.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Linear {
    /// World x (0), y (1) or z (2) of the centre of mass of a free body.
    Center(BodyId, usize),
    /// Travel of a joint that carries a body; which of its travels.
    Travel(JointId, usize),
    /// A mode of a body that deforms.
    Mode(BodyId, usize),
}

/// A pair (cos, sin).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rotation {
    /// Of a body in the plane.
    Body(BodyId),
    /// Of a joint in space that carries a body; which of its angles.
    Joint(JointId, usize),
}

/// What a unit quaternion turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ball {
    /// A free body, relative to the ground.
    Body(BodyId),
    /// The body that a joint carries, relative to the one that carries it.
    Joint(JointId),
}

/// A multi-turn angle: its rate is `Σ weight · v[index]`.
#[derive(Clone, Debug, PartialEq)]
pub struct MultiTurn {
    pub rotor: Rotor,
    pub rate: Vec<(usize, f64)>,
}

/// What each entry of q and v is.
#[derive(Clone, Debug, Default)]
pub struct Layout {
    pub linear: Vec<Linear>,
    pub rotations: Vec<Rotation>,
    pub quaternions: Vec<Ball>,
    pub angles: Vec<MultiTurn>,
}

impl Layout {
    pub fn velocities(&self) -> usize {
        self.linear.len() + self.rotations.len() + 3 * self.quaternions.len()
    }
    pub fn positions(&self) -> usize {
        self.turns(self.angles.len())
    }
    /// Index in q of the cosine of rotation `r`; the sine follows.
    pub fn pair(&self, r: usize) -> usize {
        self.linear.len() + 2 * r
    }
    /// Index in q of the scalar part of quaternion `b`; the vector part follows.
    pub fn quaternion(&self, b: usize) -> usize {
        self.linear.len() + 2 * self.rotations.len() + 4 * b
    }
    /// Index in v of the first rate of quaternion `b`; two more follow.
    pub fn omega(&self, b: usize) -> usize {
        self.linear.len() + self.rotations.len() + 3 * b
    }
    /// Index in q of the turns of multi-turn angle `a`; the remainder follows.
    pub fn turns(&self, a: usize) -> usize {
        self.linear.len() + 2 * self.rotations.len() + 4 * self.quaternions.len() + 2 * a
    }
    /// Names of the entries of q, `crank.cos`.
    pub fn position_names(&self, mechanism: &Mechanism) -> Vec<String> {
        let mut names: Vec<String> = self.linear.iter().map(|linear| linear.name(mechanism)).collect();
        for rotation in &self.rotations {
            let of = rotation.name(mechanism);
            names.extend([format!("{of}.cos"), format!("{of}.sin")]);
        }
        for ball in &self.quaternions {
            let of = ball.name(mechanism);
            names.extend(["w", "x", "y", "z"].map(|part| format!("{of}.orientation.{part}")));
        }
        for angle in &self.angles {
            let rotor = rotor_name(mechanism, angle.rotor);
            names.extend([format!("{rotor}.turns"), format!("{rotor}.remainder")]);
        }
        names
    }
    /// Names of the entries of v, `crank.rate`.
    pub fn velocity_names(&self, mechanism: &Mechanism) -> Vec<String> {
        let mut names: Vec<String> = self.linear.iter().map(|linear| linear.rate_name(mechanism)).collect();
        names.extend(self.rotations.iter().map(|rotation| rotation.rate_name(mechanism)));
        for ball in &self.quaternions {
            let of = ball.name(mechanism);
            names.extend(["x", "y", "z"].map(|axis| format!("{of}.rate.{axis}")));
        }
        names
    }
    /// Of each velocity the joint or body to which it belongs.
    pub fn owners(&self, mechanism: &Mechanism) -> Vec<Owner> {
        let mut owners: Vec<Owner> = self
            .linear
            .iter()
            .map(|linear| match linear {
                Linear::Center(body, _) | Linear::Mode(body, _) => Owner::Body(*body),
                Linear::Travel(joint, _) => Owner::Joint(*joint),
            })
            .collect();
        owners.extend(self.rotations.iter().map(|rotation| match rotation {
            Rotation::Body(body) => Owner::Body(*body),
            Rotation::Joint(joint, _) => Owner::Joint(*joint),
        }));
        for ball in &self.quaternions {
            let owner = match ball {
                Ball::Body(body) => Owner::Body(*body),
                Ball::Joint(joint) => Owner::Joint(*joint),
            };
            owners.extend([owner; 3]);
        }
        debug_assert_eq!(owners.len(), self.velocity_names(mechanism).len());
        owners
    }
}

/// What a velocity belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Owner {
    Body(BodyId),
    Joint(JointId),
}

impl Linear {
    /// Whether it is a length: all but modes in torsion, which are angles.
    pub fn is_length(&self, mechanism: &Mechanism) -> bool {
        let Linear::Mode(body, mode) = self else { return true };
        let deforms = mechanism.bodies[body.0].deforms.as_ref();
        deforms.is_none_or(|deforms| !deforms.is_angle(*mode))
    }

    fn name(&self, mechanism: &Mechanism) -> String {
        match self {
            Linear::Center(body, axis) => {
                let place = reference(mechanism, *body);
                format!("{place}.{}", ["x", "y", "z"][*axis])
            }
            Linear::Travel(joint, which) => travel_name(mechanism, *joint, *which, 0),
            Linear::Mode(body, mode) => mode_name(mechanism, *body, *mode),
        }
    }

    fn rate_name(&self, mechanism: &Mechanism) -> String {
        match self {
            Linear::Center(body, axis) => {
                let place = reference(mechanism, *body);
                format!("{place}.velocity.{}", ["x", "y", "z"][*axis])
            }
            Linear::Travel(joint, which) => travel_name(mechanism, *joint, *which, 1),
            Linear::Mode(body, mode) => format!("{}.rate", mode_name(mechanism, *body, *mode)),
        }
    }
}

impl Rotation {
    fn name(&self, mechanism: &Mechanism) -> String {
        match self {
            Rotation::Body(body) => mechanism.bodies[body.0].name.text.clone(),
            Rotation::Joint(joint, which) => match joint_angles(mechanism, *joint).len() {
                1 => mechanism.joints[joint.0].name.text.clone(),
                _ => angle_name(mechanism, *joint, *which, 0),
            },
        }
    }

    fn rate_name(&self, mechanism: &Mechanism) -> String {
        match self {
            Rotation::Body(body) => format!("{}.rate", mechanism.bodies[body.0].name.text),
            Rotation::Joint(joint, which) => angle_name(mechanism, *joint, *which, 1),
        }
    }
}

impl Ball {
    pub fn name<'m>(&self, mechanism: &'m Mechanism) -> &'m str {
        match self {
            Ball::Body(body) => &mechanism.bodies[body.0].name.text,
            Ball::Joint(joint) => &mechanism.joints[joint.0].name.text,
        }
    }
}

fn joint_angles(mechanism: &Mechanism, joint: JointId) -> &'static [[&'static str; 2]] {
    mechanism.joints[joint.0].form.angles
}

/// `knee.angle`, or with `rate` 1 `knee.rate`.
pub fn angle_name(mechanism: &Mechanism, joint: JointId, which: usize, rate: usize) -> String {
    format!("{}.{}", mechanism.joints[joint.0].name.text, joint_angles(mechanism, joint)[which][rate])
}

/// `rail.travel`, or with `rate` 1 `rail.speed`.
pub fn travel_name(mechanism: &Mechanism, joint: JointId, which: usize, rate: usize) -> String {
    let joint = &mechanism.joints[joint.0];
    let travels = joint.form.travels;
    format!("{}.{}", joint.name.text, travels[which][rate])
}

/// `coupler.bending[0]`.
pub fn mode_name(mechanism: &Mechanism, body: BodyId, mode: usize) -> String {
    let body = &mechanism.bodies[body.0];
    let mode = body.deforms.as_ref().map_or_else(String::new, |deforms| deforms.mode_name(mode));
    format!("{}.{mode}", body.name.text)
}

/// What the coordinates of a free body are of: its centre of mass, or the origin of the frame of one that deforms.
fn reference(mechanism: &Mechanism, body: BodyId) -> String {
    let body = &mechanism.bodies[body.0];
    let place = if body.form.bends() { "origin" } else { "center" };
    format!("{}.{place}", body.name.text)
}

pub fn rotor_name(mechanism: &Mechanism, rotor: Rotor) -> &str {
    match rotor {
        Rotor::Joint(joint, _) => &mechanism.joints[joint.0].name.text,
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
    /// Those with rates of their own.
    pub internal: Vec<Node>,
    /// Held over a step: 1 where a contact acts, else 0; then of events and memories.
    pub gates: Vec<Node>,
    pub two_alpha: Node,
    pub beta_squared: Node,
    /// c of K(c).
    pub compliance: Node,
    /// v̇ and λ, for functions that take them as given.
    pub acceleration: Vec<Node>,
    pub lambda: Vec<Node>,
    /// The forces that press surfaces together by reactions; what is emitted has none of them.
    pub normals: Vec<Node>,
}

/// New symbols for everything the equations depend on.
pub fn symbols(g: Sheet, mechanism: &Mechanism, layout: &Layout) -> Symbols {
    let symbol = |name: &str, class: Class| g.symbol(name, class).bare;
    let named = |names: Vec<String>, class: Class| -> Vec<Node> {
        names.iter().map(|name| symbol(name, class)).collect()
    };
    let parameters = mechanism.parameters.iter().map(|parameter| parameter.name.identifier()).collect();
    let inputs = mechanism.inputs.iter().map(|input| input.name.identifier()).collect();
    let internal = mechanism.states.iter().map(|state| state.name.identifier()).collect();
    let gates = mechanism.gates().map(|(load, which)| {
        let name = mechanism.loads[load.0].name.identifier();
        if which == 0 { format!("{name}_gate") } else { format!("{name}_gate_{}", which + 1) }
    });
    let events = mechanism.events_in_places();
    let events = events.into_iter().map(|(_, event)| format!("{}_event", event.name.identifier()));
    let memories = mechanism.memories.iter().map(|memory| memory.name.identifier());
    let gates = gates.chain(events).chain(memories).collect();
    let phases = super::couplings::open_phases(mechanism).map(|name| format!("{name}_phase")).collect();
    let dots = |names: Vec<String>| names.into_iter().map(|name| identifier(&name)).collect::<Vec<_>>();
    let velocity_names = dots(layout.velocity_names(mechanism));
    let acceleration_names = velocity_names.iter().map(|name| format!("{name}_dot")).collect();
    Symbols {
        parameters: named(parameters, Class::Parameter),
        phases: named(phases, Class::Parameter),
        time: symbol("time", Class::Position),
        q: named(dots(layout.position_names(mechanism)), Class::Position),
        v: named(velocity_names, Class::Velocity),
        inputs: named(inputs, Class::Input),
        internal: named(internal, Class::Input),
        gates: named(gates, Class::Input),
        two_alpha: symbol("two_alpha", Class::Input),
        beta_squared: symbol("beta_squared", Class::Input),
        compliance: symbol("compliance", Class::Input),
        acceleration: named(acceleration_names, Class::Input),
        lambda: Vec::new(),
        normals: Vec::new(),
    }
}
