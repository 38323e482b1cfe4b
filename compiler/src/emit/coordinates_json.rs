//! What the entries of q and v and the constraint rows are, for tools that rebuild the mechanism from its definition.

use crate::equations::coordinates::rotor_name;
use crate::equations::{Equations, Linear};
use crate::model::{Frame, Mechanism};

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
            format!("{{\"kind\":\"{}\",\"of\":{}}}", ["x", "y"][*axis], body(id.0))
        }
        Linear::Travel(id) => format!("{{\"kind\":\"travel\",\"of\":{}}}", joint(id.0)),
    });
    let rotations = equations.layout.rotations.iter().map(|id| format!("{{\"body\":{}}}", body(id.0)));
    let index = |index: Option<usize>| index.map_or("null".to_string(), |index| index.to_string());
    let angles = equations.layout.angles.iter().map(|angle| {
        let of = quoted(rotor_name(mechanism, angle.rotor));
        format!("{{\"of\":{of},\"plus\":{},\"minus\":{}}}", index(angle.plus), index(angle.minus))
    });
    let rows = equations
        .rows
        .iter()
        .map(|row| format!("{{\"of\":{},\"what\":{}}}", quoted(&row.of), quoted(row.what)));
    let kind = if equations.tree.attachments.iter().all(|attachment| attachment.joint.is_none()) {
        "absolute"
    } else {
        "tree"
    };
    let list = |items: Vec<String>| items.join(",");
    format!(
        "{{\"coordinates\":\"{kind}\",\"tree\":[{}],\"linear\":[{}],\"rotations\":[{}],\"angles\":[{}],\"rows\":[{}]}}",
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
