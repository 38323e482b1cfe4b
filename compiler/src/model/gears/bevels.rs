//! Bevel gears: two cones that roll on each other about axes that cross.
//!
//! The axes leave the point where they cross towards the wheels as u₁ and u₂, at the angle Σ. Cones that roll have tan δ₁ = sin Σ/(z₂/z₁ + cos Σ)
//! and the other way about, and their outer ends are r/sin δ from that point. Where they touch, z₁(θ₁ − ψ₁) + z₂(θ₂ − ψ₂) = π + 2πk with the angles about
//! u₁ and u₂ and ψ those of the direction to the other axis (Litvin & Fuentes, Gear Geometry and Applied Theory, 2004, sections 3.6 and 21.2).

use super::pair::{Touch, middle};
use super::vector::{across, along, cross, difference, dot, length, scaled, unit};
use super::{Coupled, Wheels, about_axes, collected, times};
use crate::messages;

/// Of angles, and of places as part of the cone's length.
const SAME: f64 = 1e-6;

/// Σ, and what is coupled.
pub fn couple(wheels: &Wheels) -> Result<(f64, Coupled), String> {
    let [first, second] = wheels.toothings;
    wheels.in_space()?;
    let (carrier, centers) = wheels.held()?;
    let [(one, a), (other, b)] = wheels.axles(carrier)?;
    let normal = cross(a, b);
    let square = dot(normal, normal);
    if square < 1e-12 {
        return Err(messages::bevels_in_parallel(wheels.texts()));
    }
    // The point of the first axis that is nearest to the second one.
    let way = difference(centers[1], centers[0]);
    let apex = along(centers[0], dot(cross(way, b), normal) / square, a);
    let apart = (dot(way, normal) / libm::sqrt(square)).abs();
    let size = first.pitch_radius() + second.pitch_radius();
    if apart > SAME * size {
        return Err(messages::bevels_pass(wheels.texts(), apart));
    }
    let out = centers.map(|center| difference(center, apex));
    let reach = out.map(length);
    if reach.iter().any(|reach| *reach < SAME * size) {
        return Err(messages::bevel_at_the_apex(
            wheels.texts(),
            [first, second].map(|it| it.pitch_radius() / libm::tan(it.cone)),
        ));
    }
    let out = out.map(unit);
    let between = libm::acos(dot(out[0], out[1]).clamp(-1.0, 1.0));
    let teeth = [first.teeth, second.teeth];
    let cones = [0, 1].map(|k| libm::atan2(libm::sin(between), teeth[1 - k] / teeth[k] + libm::cos(between)));
    if [first, second].iter().zip(cones).any(|(toothing, cone)| (toothing.cone - cone).abs() > SAME) {
        let written = [first, second].map(|toothing| toothing.cone.to_degrees());
        return Err(messages::cones_do_not_roll(
            wheels.texts(),
            written,
            cones.map(f64::to_degrees),
            between.to_degrees(),
        ));
    }
    for (toothing, found) in [first, second].into_iter().zip(reach) {
        let right = toothing.pitch_radius() / libm::tan(toothing.cone);
        if (found - right).abs() > SAME * size {
            return Err(messages::bevel_misplaced(&toothing.text, found, right));
        }
    }
    // Angles are counted about the axes of the joints, which may point inwards; the factor of the first is positive.
    let signs = [1.0, dot(out[0], a).signum() * dot(out[1], b).signum()];
    let facing = [about_axes::across(a, out[1]), about_axes::across(b, out[0])];
    let mut constant = std::f64::consts::PI;
    for ((toothing, sign), [x, y]) in [first, second].into_iter().zip(signs).zip(facing) {
        constant += sign * toothing.teeth * (libm::atan2(y, x) - toothing.first);
    }
    let terms = times(first.teeth, one.clone()).chain(times(signs[1] * second.teeth, other.clone()));
    let cone = first.pitch_radius() / libm::sin(first.cone);
    // In the middle of the face, on the line along which the cones touch.
    let (sine, cosine) = (libm::sin(first.cone), libm::cos(first.cone));
    let toward = unit(across(out[1], out[0]));
    let reach = cone * middle([first, second]);
    let touching = along(along(apex, reach * cosine, out[0]), reach * sine, toward);
    let angle = first.pressure_angle;
    let touch = Touch {
        from: 0,
        at: difference(touching, centers[0]),
        push: scaled(libm::cos(angle), cross(a, toward)),
        part: scaled(libm::sin(angle), along(scaled(-sine, out[0]), cosine, toward)),
        radius: reach * sine * libm::cos(angle) / first.teeth,
    };
    let coupled = Coupled {
        carrier,
        between: [cone, 0.0],
        terms: collected(terms),
        travels: Vec::new(),
        constant,
        axes: None,
        beside: 0.0,
        axles: Some([a, b]),
        turns: [one, other],
        first: [first.first, second.first],
        psi: facing.map(|[x, y]| libm::atan2(y, x)),
        side: signs,
        touch: Some(touch),
    };
    Ok((between, coupled))
}
