//! Angles of wheels in space: of the joints about whose parallel axes they turn against what holds them.
//!
//! Bodies have no angle of their own there. A wheel turns against the carrier by a joint between both, or both turn about one axis against a
//! third thing, by a joint each. At the angle zero the axes of both bodies coincide, so that directions may be compared.

use super::super::{Axes, Expr, Frame, JointId, Mechanism, Rotor, Vector, fold};
use super::holding::Orientations;
use super::vector::{self, V3};

/// A sum of angles of joints, about one axis.
pub struct Turn {
    pub terms: Vec<(f64, Rotor)>,
    /// A unit vector, in the axes of the carrier at the angle zero; none where nothing turns.
    pub axis: Option<V3>,
}

/// By how much a wheel turns against a carrier.
pub fn turn(
    mechanism: &Mechanism,
    orientations: &Orientations,
    wheel: Frame,
    carrier: Frame,
) -> Option<Turn> {
    let frames = std::iter::once(Frame::Ground)
        .chain((0..mechanism.bodies.len()).map(|index| Frame::Body(super::super::BodyId(index))));
    let direct = std::iter::once(carrier).chain(frames);
    direct.into_iter().find_map(|third| {
        let of_wheel = against(mechanism, orientations, wheel, third)?;
        let of_carrier = against(mechanism, orientations, carrier, third)?;
        let sense = match (of_wheel.1, of_carrier.1) {
            (Some(a), Some(b)) => parallel(a, b)?,
            _ => 1.0,
        };
        let axis = of_wheel.1.or(of_carrier.1);
        let carried = of_carrier.0.into_iter().map(|(factor, rotor)| (-sense * factor, rotor));
        Some(Turn { terms: of_wheel.0.into_iter().chain(carried).collect(), axis })
    })
}

type Sum = (Vec<(f64, Rotor)>, Option<V3>);

/// By one joint, or not at all.
fn against(mechanism: &Mechanism, orientations: &Orientations, frame: Frame, other: Frame) -> Option<Sum> {
    if orientations.class(frame).0 == orientations.class(other).0 {
        return Some((Vec::new(), None));
    }
    let holding = mechanism.joints.iter().enumerate().filter(|(_, joint)| joint.holds());
    holding.into_iter().find_map(|(index, joint)| {
        let ends = [joint.first.frame, joint.second.frame];
        let sign = match ends {
            [a, b] if a == other && b == frame => 1.0,
            [a, b] if a == frame && b == other => -1.0,
            _ => return None,
        };
        let plain = [&joint.first, &joint.second].iter().all(|place| matches!(place.axes, Axes::Parallel));
        let axis = joint.common_axis().filter(|_| plain && joint.form.angles.len() == 1)?;
        Some((vec![(sign, Rotor::Joint(JointId(index), 0))], Some(direction(mechanism, axis)?)))
    })
}

/// A direction as numbers, of length one.
pub fn direction(mechanism: &Mechanism, axis: &Vector) -> Option<V3> {
    let value = |expr: &Expr| fold::evaluate(expr, &mechanism.defaults());
    let [x, y, z] = axis.each_ref().map(value);
    let axis = [x?, y?, z?];
    (vector::length(axis) > 0.0).then(|| vector::unit(axis))
}

/// +1 or −1 of parallel directions.
pub fn parallel(a: V3, b: V3) -> Option<f64> {
    let cosine = vector::dot(a, b);
    (cosine.abs() > 1.0 - 1e-9).then(|| cosine.signum())
}

/// The components of a vector across an axis: along x and y of J(axis), by which angles about it are counted (see NOTATION.md).
pub fn across(axis: V3, of: V3) -> [f64; 2] {
    let [x, y, _] = axes(axis);
    [x, y].map(|along| vector::dot(along, of))
}

/// J(axis), its columns.
pub fn axes(axis: V3) -> [V3; 3] {
    let largest = (0..3).fold(0, |best, k| if axis[k].abs() > axis[best].abs() { k } else { best });
    let mut x = [0.0; 3];
    x[(largest + 1) % 3] = 1.0;
    let x = vector::unit(vector::across(x, axis));
    [x, vector::cross(axis, x), axis]
}

/// Axes of a place as columns, in the axes of what it belongs to, at the defaults of parameters.
pub fn columns(mechanism: &Mechanism, of: &Axes) -> Option<[V3; 3]> {
    match of {
        Axes::Parallel => Some([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]),
        Axes::Directed { axis, reference: None } => Some(axes(direction(mechanism, axis)?)),
        Axes::Directed { axis, reference: Some(reference) } => {
            let z = direction(mechanism, axis)?;
            let x = vector::unit(vector::across(direction(mechanism, reference)?, z));
            Some([x, vector::cross(z, x), z])
        }
        Axes::Turned(turns) => {
            let mut columns = columns(mechanism, &Axes::Parallel)?;
            for (about, angle) in turns {
                let angle = fold::evaluate(angle, &mechanism.defaults())?;
                let (cosine, sine) = (libm::cos(angle), libm::sin(angle));
                let (i, j) = ((about + 1) % 3, (about + 2) % 3);
                let (one, other) = (columns[i], columns[j]);
                columns[i] = vector::along(vector::scaled(cosine, one), sine, other);
                columns[j] = vector::along(vector::scaled(cosine, other), -sine, one);
            }
            Some(columns)
        }
    }
}
