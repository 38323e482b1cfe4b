//! A pinion and its rack.
//!
//! t is the direction of the rack's line and d that from the pinion's centre to it, x the way along t from the middle of a tooth to the centre, s = (a × d)·t with the axis a of
//! the pinion. A tooth of the pinion faces a space where z (θ − ψ) + 2 s x/m = π + 2πk, ψ the direction d; x falls or grows by the travel of the rail.

use super::super::{Axes, Frame, Joint, JointId, Mechanism, Place, Space};
use super::pair::Touch;
use super::vector::{V3, across, along, cross, difference, dot, length, scaled, unit};
use super::{Coupled, Toothing, Wheels, about_axes, collected, cylinders, holding, times};
use crate::messages;
use std::f64::consts::PI;

/// Of directions.
const ALONG: f64 = 1e-9;

/// `pinion` says which of both is it.
pub fn couple(wheels: &Wheels, pinion: usize) -> Result<Coupled, String> {
    let (wheel, rack) = (wheels.toothings[pinion], wheels.toothings[1 - pinion]);
    let texts = [wheel.text.as_str(), rack.text.as_str()];
    let mechanism = wheels.mechanism;
    let Some(stand) = rail(wheels, pinion) else { return Err(messages::rack_without_rail(texts)) };
    let Stand { carrier, center, start, line, travel } = stand;
    if length(cross(travel.1, line)) > ALONG {
        let angle = libm::acos(dot(travel.1, line).abs().min(1.0)).to_degrees();
        return Err(messages::rack_across_rail(texts, &mechanism.joints[travel.0.0].name.text, angle));
    }
    let (axis, terms, fixed) = match mechanism.space {
        Space::Planar => {
            let frames = [wheels.own[pinion], carrier, Frame::Ground];
            let (terms, fixed) = cylinders::in_the_plane(wheels.orientations, [1.0, -1.0, 0.0], frames);
            ([0.0, 0.0, 1.0], terms, fixed)
        }
        Space::Spatial => {
            let turn = about_axes::turn(mechanism, wheels.orientations, wheels.own[pinion], carrier);
            let turn = turn.and_then(|turn| Some((turn.terms, turn.axis?)));
            let Some((terms, axis)) = turn else { return Err(messages::no_axle(texts[0], texts[1])) };
            (axis, terms, 0.0)
        }
    };
    if dot(axis, line).abs() > ALONG {
        return Err(messages::rack_along_axle(texts));
    }
    if terms.is_empty() {
        return Err(messages::teeth_on_one_shaft(texts[0], texts[1]));
    }
    let way = difference(center, start);
    // Across the line and the axle, from the centre to the line.
    let towards = scaled(-1.0, across(across(way, line), axis));
    let (distance, direction) = (length(towards), unit(towards));
    let side = dot(cross(axis, direction), line);
    let psi = match mechanism.space {
        Space::Planar => libm::atan2(direction[1], direction[0]),
        Space::Spatial => {
            let [x, y] = about_axes::across(axis, direction);
            libm::atan2(y, x)
        }
    };
    // The factor of the pinion is positive.
    let in_modules = 2.0 * side.signum() / rack.module;
    let constant = PI + wheel.teeth * (psi - wheel.first - fixed) - in_modules * dot(way, line);
    let travels = vec![(-in_modules * dot(travel.1, line).signum(), travel.0)];
    let between = [distance, 0.0];
    // Where the pinion is ahead, it pushes the rack the way that its teeth go there.
    let (sine, cosine) = (libm::sin(wheel.pressure_angle), libm::cos(wheel.pressure_angle));
    let touch = Touch {
        from: 0,
        at: scaled(wheel.pitch_radius(), direction),
        push: scaled(cosine, cross(axis, direction)),
        part: scaled(sine, direction),
        radius: 0.5 * rack.module * cosine,
    };
    Ok(Coupled {
        carrier,
        between,
        travels,
        constant,
        axes: None,
        beside: 0.0,
        axles: (mechanism.space == Space::Spatial).then_some([axis; 2]),
        turns: [terms.clone(), terms.clone()],
        terms: collected(times(wheel.teeth, terms)),
        first: [wheel.first; 2],
        psi: [psi; 2],
        side: [1.0; 2],
        touch: Some(if pinion == 0 { touch } else { touch.reversed() }),
    })
}

/// Where a pinion and its rack stand, in the axes of what holds the pinion.
struct Stand {
    carrier: Frame,
    center: V3,
    /// The first point of the line where the travel is zero, and its direction.
    start: V3,
    line: V3,
    /// The rail, and along what it moves the rack.
    travel: (JointId, V3),
}

/// A point and a direction of something.
#[derive(Clone, Copy)]
struct Ray {
    frame: Frame,
    at: V3,
    along: V3,
}

/// What the pinion is pinned to, and the rail between that and the rack.
fn rail(wheels: &Wheels, pinion: usize) -> Option<Stand> {
    let mechanism = wheels.mechanism;
    let (wheel, rack) = (wheels.toothings[pinion], wheels.toothings[1 - pinion]);
    let (frame, at) = holding::known(mechanism, &rack.center)?;
    let own = Ray { frame, at, along: rack.along };
    let rays = carried(mechanism, own);
    let pinned = holding::pinned(mechanism, &wheel.center);
    pinned.into_iter().filter(|(frame, _)| *frame != wheels.own[pinion]).find_map(|(carrier, center)| {
        mechanism.joints.iter().enumerate().find_map(|(index, joint)| {
            if !joint.holds() || !joint.form.keeps_orientation || joint.form.travels.len() != 1 {
                return None;
            }
            let ray = rays.iter().find(|ray| {
                let ends = [joint.first.frame, joint.second.frame];
                ends == [carrier, ray.frame] || ends == [ray.frame, carrier]
            })?;
            let [first, second] = [plain(mechanism, &joint.first)?, plain(mechanism, &joint.second)?];
            let axis = about_axes::direction(mechanism, joint.directions.first()?)?;
            let angle = holding::turned(mechanism, joint)?;
            let (start, line, moves) = if joint.first.frame == carrier {
                let at = difference(ray.at, second);
                (along(first, 1.0, rotated(angle, at)), rotated(angle, ray.along), axis)
            } else {
                // The axis is the rack's, and the carrier goes along it.
                let at = difference(ray.at, first);
                (
                    along(second, 1.0, rotated(-angle, at)),
                    rotated(-angle, ray.along),
                    rotated(-angle, scaled(-1.0, axis)),
                )
            };
            Some(Stand { carrier, center, start, line, travel: (JointId(index), moves) })
        })
    })
}

/// Everything that a rack is fixed to, its own body first.
pub fn fixed_to(mechanism: &Mechanism, rack: &Toothing) -> Vec<Frame> {
    let rays = holding::known(mechanism, &rack.center)
        .map(|(frame, at)| carried(mechanism, Ray { frame, at, along: rack.along }));
    rays.into_iter().flatten().map(|ray| ray.frame).collect()
}

/// The ray in everything that its body is fixed to.
fn carried(mechanism: &Mechanism, own: Ray) -> Vec<Ray> {
    let mut found = vec![own];
    let mut next = 0;
    while next < found.len() {
        let here = found[next];
        next += 1;
        let fixed = |joint: &&Joint| joint.holds() && joint.form.keeps_place && joint.form.keeps_orientation;
        for joint in mechanism.joints.iter().filter(fixed) {
            let ends = [plain(mechanism, &joint.first), plain(mechanism, &joint.second)];
            let ([Some(first), Some(second)], Some(angle)) = (ends, holding::turned(mechanism, joint)) else {
                continue;
            };
            let pairs = [
                (&joint.first, first, &joint.second, second, -angle),
                (&joint.second, second, &joint.first, first, angle),
            ];
            for (near, from, far, to, angle) in pairs {
                if near.frame == here.frame && found.iter().all(|ray| ray.frame != far.frame) {
                    let at = along(to, 1.0, rotated(angle, difference(here.at, from)));
                    found.push(Ray { frame: far.frame, at, along: rotated(angle, here.along) });
                }
            }
        }
    }
    found
}

/// A place without axes of its own, as numbers.
fn plain(mechanism: &Mechanism, place: &Place) -> Option<V3> {
    let (_, at) = holding::known(mechanism, place)?;
    matches!(place.axes, Axes::Parallel).then_some(at)
}

/// About z.
fn rotated(angle: f64, [x, y, z]: V3) -> V3 {
    let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
    [cosine * x - sine * y, sine * x + cosine * y, z]
}
