//! Frictions that press on each other: as many as are written out.

use crate::diagnostics::Diagnostics;
use crate::messages;
use crate::model::{Frame, Mechanism};

/// The elimination for them grows with the cube of their number.
const MOST: usize = 12;

// Frictions by reactions that joints connect without the ground are found together, and are so many at most.
pub fn loops_of_friction_are_small(mechanism: &Mechanism, diagnostics: &mut Diagnostics) {
    let mut group: Vec<usize> = (0..mechanism.bodies.len()).collect();
    let find = |group: &[usize], mut body: usize| {
        while group[body] != body {
            body = group[body];
        }
        body
    };
    for joint in &mechanism.joints {
        if let (Frame::Body(one), Frame::Body(other)) = (joint.first.frame, joint.second.frame) {
            let (one, other) = (find(&group, one.0), find(&group, other.0));
            group[one.min(other)] = one.max(other);
        }
    }
    for own in 0..group.len() {
        let together = mechanism.loads.iter().filter(|load| {
            let joint = load.normal.and(load.bearing()).map(|joint| &mechanism.joints[joint.0]);
            joint.is_some_and(|joint| {
                let ends = [joint.first.frame, joint.second.frame];
                ends.iter().any(|end| matches!(end, Frame::Body(body) if find(&group, body.0) == own))
            })
        });
        let names: Vec<_> = together.map(|load| &load.name).collect();
        if let Some(first) = names.get(MOST) {
            let shown: Vec<&str> = names.iter().take(3).map(|name| name.text.as_str()).collect();
            let message =
                messages::too_many_in_a_loop(names.len(), MOST, &format!("{}, …", shown.join(", ")));
            diagnostics.error(first.span, message);
        }
    }
}
