//! A worm and its wheel: the wheel's teeth are pushed along the axis of the worm.
//!
//! In the plane that contains the worm's axis and is the middle one of the wheel, threads are a rack of the axial module m. n points from the worm's axis to
//! the wheel's, a₁ and a₂ are the axes, h = ±1 is the hand. Where a thread stands in a space of the wheel,
//! h z₁ (θ₁ − ψ₁) + s z₂ (θ₂ − ψ₂) = π − 2 ζ/m + 2πk, s = (a₂ × −n)·a₁, ψ the directions n and −n, ζ the way along a₁ from the worm's centre to the wheel's
//! (Litvin & Fuentes, Gear Geometry and Applied Theory, 2004, chapter 19).

use super::pair::Touch;
use super::vector::{along, cross, difference, dot, length, scaled};
use super::{Coupled, Wheels, about_axes, collected, times};
use crate::messages;
use std::f64::consts::PI;

const SAME: f64 = 1e-6;

/// `worm` says which of both is it.
pub fn couple(wheels: &Wheels, worm: usize) -> Result<Coupled, String> {
    let (screw, wheel) = (wheels.toothings[worm], wheels.toothings[1 - worm]);
    let texts = [screw.text.as_str(), wheel.text.as_str()];
    let lead = screw.lead_angle();
    if (wheel.helix.abs() - lead).abs() > SAME {
        return Err(messages::worm_and_helix(texts, wheel.helix.to_degrees(), lead.to_degrees()));
    }
    // m of the wheel's normal section is that along the worm times cos γ.
    let module = screw.module * libm::cos(lead);
    if (wheel.module - module).abs() > SAME * module {
        return Err(messages::worm_and_module(texts, [screw.module, wheel.module], module));
    }
    wheels.in_space()?;
    let (carrier, centers) = wheels.held()?;
    let mut axles = wheels.axles(carrier)?;
    axles.rotate_left(worm);
    let [(of_screw, a), (of_wheel, b)] = axles;
    if dot(a, b).abs() > SAME {
        let angle = libm::acos(dot(a, b).abs().min(1.0));
        return Err(messages::worm_axes(texts, angle.to_degrees()));
    }
    let way = difference(centers[1 - worm], centers[worm]);
    let normal = cross(a, b);
    let across = dot(way, normal);
    let distance = across.abs();
    let normal = scaled(across.signum() / length(normal), normal);
    let size = 0.5 * screw.diameter + wheel.pitch_radius();
    if dot(way, b).abs() > SAME * size {
        return Err(messages::worm_beside_wheel(texts, dot(way, b).abs()));
    }
    let hand = wheel.helix.signum();
    let back = scaled(-1.0, normal);
    let side = dot(cross(b, back), a).signum();
    let angle = |axis, direction| {
        let [x, y] = about_axes::across(axis, direction);
        libm::atan2(y, x)
    };
    let (turned, opposite) = (angle(a, normal) - screw.first, angle(b, back) - wheel.first);
    // The factor of the first is positive.
    let first = if worm == 0 { hand } else { side };
    let factors = [first * hand * screw.teeth, first * side * wheel.teeth];
    let shifted = PI - 2.0 * dot(way, a) / screw.module;
    let constant = first * shifted + factors[0] * turned + factors[1] * opposite;
    let terms = times(factors[0], of_screw.clone()).chain(times(factors[1], of_wheel.clone()));
    // In the wheel's middle plane threads are a rack, at its pitch circle as steep as a screw is there: their normal goes back along the axis, around it and outwards.
    let radius = distance - wheel.pitch_radius();
    let steep = 0.5 * screw.teeth * screw.module / radius;
    let slope = libm::tan(wheel.transverse_angle());
    let axial = 1.0 / libm::sqrt(1.0 + steep * steep + slope * slope);
    let around = along(scaled(-1.0, a), hand * steep, cross(a, normal));
    let touch = Touch {
        from: 1,
        at: scaled(wheel.pitch_radius(), back),
        push: scaled(first * axial, around),
        part: scaled(axial * slope, normal),
        radius: 0.5 * screw.module * axial,
    };
    Ok(Coupled {
        carrier,
        between: [distance, 0.0],
        terms: collected(terms),
        travels: Vec::new(),
        constant,
        axes: None,
        beside: 0.0,
        axles: Some(in_order(worm, [a, b])),
        turns: in_order(worm, [of_screw, of_wheel]),
        first: in_order(worm, [screw.first, wheel.first]),
        psi: in_order(worm, [angle(a, normal), angle(b, back)]),
        side: in_order(worm, factors.map(f64::signum)),
        touch: Some(if worm == 0 { touch } else { touch.reversed() }),
    })
}

/// What is of the screw and of its wheel, in the order of the pair.
fn in_order<T>(worm: usize, [of_screw, of_wheel]: [T; 2]) -> [T; 2] {
    if worm == 0 { [of_screw, of_wheel] } else { [of_wheel, of_screw] }
}
