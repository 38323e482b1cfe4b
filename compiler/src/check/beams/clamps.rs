//! What holds the direction of a beam at its start: a joint that lets nothing turn there, one that turns about the beam's own axis alone, or one
//! about whose angles a moment passes, from a motor, a spring or a coupling. Shapes that are clamped at the start have a moment there, and without
//! one many of them are needed.

use crate::beams::{Shapes, Way};
use crate::forms::JointAxes;
use crate::model::{
    Beam, BodyId, ConstraintKind, Coordinate, Frame, JointId, Mechanism, Place, Quantity, Rotor, Space,
    Subject, Vector, value_at,
};

/// Sines of angles that are none.
const STRAIGHT: f64 = 1e-9;

/// The axis of the beam about which a joint at its start lets it turn freely, where its modes bend it, in words.
pub fn loose(
    mechanism: &Mechanism,
    body: BodyId,
    beam: &Beam,
    id: JointId,
    place: &Place,
) -> Option<&'static str> {
    let joint = &mechanism.joints[id.0];
    if joint.form.keeps_orientation || passes(mechanism, Rotor::Body(body)) {
        return None;
    }
    let angles = joint.form.angles.len();
    let is_free = |angle: &usize| !passes(mechanism, Rotor::Joint(id, *angle));
    let free: Vec<usize> = (0..angles).filter(is_free).collect();
    if angles > 0 && free.is_empty() {
        return None;
    }
    if mechanism.space == Space::Planar {
        return Some("z");
    }
    // A common axis is the same in the axes of both places; any other turn may be about any axis.
    let across = match joint.form.axes {
        JointAxes::Common if angles == 1 => direction(mechanism, &joint.directions[0]),
        // The axis that the other place has stands across this one, and turns about it.
        JointAxes::OfEach if free.len() == 1 => {
            let own = usize::from(std::ptr::eq(place, &joint.second));
            (free[0] == own).then(|| direction(mechanism, &joint.directions[own])).flatten()
        }
        _ => None,
    };
    // A cross passes what twists the beam on.
    let turns = |about: usize| match joint.form.axes {
        JointAxes::OfEach if about == 0 => false,
        _ => across.is_none_or(|axis| axis[about].abs() > STRAIGHT),
    };
    // What moves along y turns about z, what moves along z about y; twist is held at the start by the shapes of two hinges, too.
    let held = |way: Way| beam.has(way) && (way == Way::Torsion || beam.slender.shapes != Shapes::Pinned);
    [("z", 2, Way::Bending), ("y", 1, Way::BendingZ), ("x", 0, Way::Torsion)]
        .into_iter()
        .find(|(_, about, way)| turns(*about) && held(*way))
        .map(|it| it.0)
}

/// Whether a beam is a column whose foot is held with its direction and whose head is free to sway: no way to the ground leads from its other
/// joints but through it.
pub fn sways(mechanism: &Mechanism, body: BodyId, beam: &Beam, at_start: &[(JointId, &Place)]) -> bool {
    let held = |(id, place): &(JointId, &Place)| loose(mechanism, body, beam, *id, place).is_none();
    let [only] = at_start else { return false };
    if !held(only) {
        return false;
    }
    let other = |id: JointId| {
        let joint = &mechanism.joints[id.0];
        if joint.first.frame == Frame::Body(body) { joint.second.frame } else { joint.first.frame }
    };
    let on_it = |id: &usize| {
        let joint = &mechanism.joints[*id];
        [joint.first.frame, joint.second.frame].contains(&Frame::Body(body))
    };
    // What is reached from the foot without the beam.
    let mut reached = vec![other(only.0), Frame::Ground];
    let apart: Vec<usize> = (0..mechanism.joints.len()).filter(|id| !on_it(id)).collect();
    loop {
        let next = apart.iter().find_map(|id| {
            let ends = [mechanism.joints[*id].first.frame, mechanism.joints[*id].second.frame];
            match ends.map(|end| reached.contains(&end)) {
                [true, false] => Some(ends[1]),
                [false, true] => Some(ends[0]),
                _ => None,
            }
        });
        match next {
            Some(frame) => reached.push(frame),
            None => break,
        }
    }
    let heads = (0..mechanism.joints.len()).filter(on_it).filter(|id| JointId(*id) != only.0);
    heads.into_iter().all(|id| !reached.contains(&other(JointId(id))))
}

/// Whether a moment passes about an angle: a driver has it, a load acts on it, or a coupling or a constraint ties it to something.
fn passes(mechanism: &Mechanism, rotor: Rotor) -> bool {
    let of = |coordinate: &Coordinate| matches!(coordinate, Coordinate::Angle(it) if *it == rotor);
    let driven = mechanism.drivers.iter().any(|driver| of(&driver.coordinate));
    let loaded = mechanism.loads.iter().flat_map(|load| &load.on).any(|subject| match subject {
        Subject::Rotor(it) => *it == rotor,
        Subject::Body(body) => Rotor::Body(*body) == rotor,
        _ => false,
    });
    let tied = mechanism.constraints.iter().any(|constraint| match &constraint.kind {
        ConstraintKind::Coupling(coupling) => coupling.rotors().any(|it| it == rotor),
        ConstraintKind::Equation { residual } => {
            let mut named = false;
            residual
                .quantities(&mut |quantity| named |= matches!(quantity, Quantity::Coordinate(it) if of(it)));
            named
        }
        ConstraintKind::Teeth { .. } => false,
    });
    driven || loaded || tied
}

/// As a unit vector at the defaults of parameters.
fn direction(mechanism: &Mechanism, written: &Vector) -> Option<[f64; 3]> {
    let defaults = mechanism.defaults();
    let [x, y, z] = written.each_ref().map(|it| value_at(it, &defaults));
    let (x, y, z) = (x?, y?, z?);
    let length = libm::hypot(libm::hypot(x, y), z);
    Some([x / length, y / length, z / length])
}
