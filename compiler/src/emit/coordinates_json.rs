//! What the entries of q and v and the constraint rows are, for tools that rebuild the mechanism from its definition.

use crate::equations::coordinates::rotor_name;
use crate::equations::{Ball, Equations, Linear, Rotation};
use crate::model::{Frame, Mechanism, Space};

/// `{"coordinates":"tree","tree":[…],"linear":[…],"rotations":[…],"angles":[…],"rows":[…]}`.
pub fn coordinates_json(mechanism: &Mechanism, equations: &Equations) -> String {
    let body = |index: usize| quoted(&mechanism.bodies[index].name.text);
    let joint = |index: usize| quoted(&mechanism.joints[index].name.text);
    let tree = equations.tree.attachments.iter().map(|attachment| {
        let (joint, parent) = match attachment.joint {
            None => ("null".to_string(), quoted("ground")),
            Some((id, Frame::Ground)) => (joint(id.0), quoted("ground")),
            Some((id, Frame::Body(parent))) => (joint(id.0), body(parent.0)),
        };
        format!("{{\"body\":{},\"joint\":{joint},\"parent\":{parent}}}", body(attachment.body.0))
    });
    let linear = equations.layout.linear.iter().map(|linear| match linear {
        Linear::Center(id, axis) => {
            format!("{{\"kind\":\"{}\",\"of\":{}}}", ["x", "y", "z"][*axis], body(id.0))
        }
        Linear::Mode(id, mode) => {
            let name = mechanism.bodies[id.0].deforms.as_ref().map(|deforms| deforms.mode_name(*mode));
            format!("{{\"kind\":{},\"of\":{}}}", quoted(&name.unwrap_or_default()), body(id.0))
        }
        Linear::Travel(id, which) => {
            let names = mechanism.joints[id.0].form.travels;
            format!("{{\"kind\":{},\"of\":{}}}", quoted(names[*which][0]), joint(id.0))
        }
    });
    let rotations = equations.layout.rotations.iter().map(|rotation| match rotation {
        Rotation::Body(id) => format!("{{\"body\":{}}}", body(id.0)),
        Rotation::Joint(id, which) => {
            let names = mechanism.joints[id.0].form.angles;
            format!("{{\"joint\":{},\"angle\":{}}}", joint(id.0), quoted(names[*which][0]))
        }
    });
    let quaternions = equations.layout.quaternions.iter().map(|ball| match ball {
        Ball::Body(id) => format!("{{\"body\":{}}}", body(id.0)),
        Ball::Joint(id) => format!("{{\"joint\":{}}}", joint(id.0)),
    });
    let angles = equations.layout.angles.iter().map(|angle| {
        let of = quoted(rotor_name(mechanism, angle.rotor));
        let rate: Vec<String> =
            angle.rate.iter().map(|(index, weight)| format!("[{index},{weight:?}]")).collect();
        format!("{{\"of\":{of},\"rate\":[{}]}}", rate.join(","))
    });
    let rows = equations.rows.iter().map(|row| {
        let axes = match row.axes {
            None => String::new(),
            Some(Frame::Ground) => ",\"in\":\"ground\"".to_string(),
            Some(Frame::Body(id)) => format!(",\"in\":{}", body(id.0)),
        };
        format!("{{\"of\":{},\"what\":{}{axes}}}", quoted(&row.of), quoted(row.form.name))
    });
    let kind = if equations.tree.attachments.iter().all(|attachment| attachment.joint.is_none()) {
        "absolute"
    } else {
        "tree"
    };
    let list = |items: Vec<String>| items.join(",");
    let quaternions = match mechanism.space {
        Space::Planar => String::new(),
        Space::Spatial => format!("\"quaternions\":[{}],", list(quaternions.collect())),
    };
    format!(
        "{{\"coordinates\":\"{kind}\",\"tree\":[{}],\"linear\":[{}],\"rotations\":[{}],{quaternions}\"angles\":[{}],\"rows\":[{}]}}",
        list(tree.collect()),
        list(linear.collect()),
        list(rotations.collect()),
        list(angles.collect()),
        list(rows.collect())
    )
}

/// Names hold no character that JSON would want escaped.
fn quoted(text: &str) -> String {
    format!("\"{text}\"")
}
