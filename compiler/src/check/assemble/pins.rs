//! The pins of a planar mechanism in the world, and what their places say: which links lie in one line, and the links of
//! a four-bar.

use super::point::Point;
use super::world::World;
use crate::model::{Frame, Joint, JointId, Mechanism, Space};

/// A revolute joint in the plane.
#[derive(Clone, Copy, Debug)]
pub struct Pin {
    pub joint: JointId,
    pub links: [Frame; 2],
    /// World, m.
    pub at: [f64; 2],
}

/// Sine of an angle at a pin below which its links lie in one line.
const IN_LINE: f64 = 1e-5;

/// All pins at `q`.
pub fn pins(mechanism: &Mechanism, point: &mut Point, q: &[f64]) -> Vec<Pin> {
    if mechanism.space != Space::Planar {
        return Vec::new();
    }
    let world = World::at(mechanism, point, q);
    let revolute = mechanism.joints.iter().enumerate();
    let revolute = revolute
        .filter(|(_, joint)| joint.holds() && joint.form.keeps_place && !joint.form.keeps_orientation);
    let pin = |(index, joint): (usize, &Joint)| {
        let [x, y, _] = world.place(&joint.first)?;
        Some(Pin { joint: JointId(index), links: [joint.first.frame, joint.second.frame], at: [x, y] })
    };
    revolute.filter_map(pin).collect()
}

/// Names of the links that lie in one line with a neighbour: links with two pins, joined at another pin than `but`.
pub fn in_line(mechanism: &Mechanism, pins: &[Pin], but: Option<JointId>) -> Vec<String> {
    let mut found: Vec<Frame> = Vec::new();
    for pin in pins.iter().filter(|pin| Some(pin.joint) != but) {
        let far = pin.links.map(|link| far_end(pins, link, pin.joint));
        let [Some(a), Some(b)] = far else { continue };
        let [u, v] = [a, b].map(|far| [far.at[0] - pin.at[0], far.at[1] - pin.at[1]]);
        let sine = (u[0] * v[1] - u[1] * v[0]).abs();
        if sine < IN_LINE * length(u) * length(v) {
            found.extend(pin.links);
        }
    }
    found.sort_unstable();
    found.dedup();
    // The ground is a link like others, but says nothing where two others are named.
    if found.len() > 2 {
        found.retain(|link| *link != Frame::Ground);
    }
    found.iter().map(|link| mechanism.frame_name(*link).to_string()).collect()
}

/// The other pin of a link that has two.
fn far_end(pins: &[Pin], link: Frame, own: JointId) -> Option<&Pin> {
    let mut others = pins.iter().filter(|pin| pin.links.contains(&link) && pin.joint != own);
    let far = others.next()?;
    others.next().is_none().then_some(far)
}

/// Lengths of the four links of the loop of pins that a joint belongs to, if there is one.
pub fn four_bar(pins: &[Pin], joint: JointId) -> Option<[(Frame, f64); 4]> {
    let first = pins.iter().find(|pin| pin.joint == joint)?;
    let [ground, crank] = first.links;
    let beyond = |pin: &Pin, link: Frame| if pin.links[0] == link { pin.links[1] } else { pin.links[0] };
    let on = |link: Frame, but: JointId| {
        pins.iter().filter(move |pin| pin.links.contains(&link) && pin.joint != but)
    };
    for second in on(crank, joint) {
        let coupler = beyond(second, crank);
        for third in on(coupler, second.joint) {
            let rocker = beyond(third, coupler);
            let mut fourth = on(rocker, third.joint).filter(|pin| beyond(pin, rocker) == ground);
            if let (Some(fourth), true) = (fourth.next(), coupler != ground && rocker != crank) {
                let between = |a: &Pin, b: &Pin| length([a.at[0] - b.at[0], a.at[1] - b.at[1]]);
                return Some([
                    (ground, between(fourth, first)),
                    (crank, between(first, second)),
                    (coupler, between(second, third)),
                    (rocker, between(third, fourth)),
                ]);
            }
        }
    }
    None
}

/// The longest way between two pins of one link; 1 where there are none.
pub fn longest_link(pins: &[Pin]) -> f64 {
    let mut longest = 0.0_f64;
    for (index, a) in pins.iter().enumerate() {
        for b in &pins[index + 1..] {
            if a.links.iter().any(|link| b.links.contains(link)) {
                longest = longest.max(length([a.at[0] - b.at[0], a.at[1] - b.at[1]]));
            }
        }
    }
    if longest > 0.0 { longest } else { 1.0 }
}

fn length([x, y]: [f64; 2]) -> f64 {
    libm::hypot(x, y)
}
