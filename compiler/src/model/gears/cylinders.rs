//! Wheels, and a wheel in a ring, about parallel axes.
//!
//! z₁(θ₁ − ψ) + z₂(θ₂ − ψ − π) = π + 2πk of two wheels, z₁(θ₁ − ψ) − z₂(θ₂ − ψ) = π + 2πk of a ring, angles against what holds them.

use super::super::{Frame, Rotor, Space};
use super::holding::Orientations;
use super::pair::{facing, nominal};
use super::{Coupled, Toothing, Wheels, about_axes, collected, times, vector};
use crate::messages;

pub fn couple(wheels: &Wheels) -> Result<Coupled, String> {
    let [first, second] = wheels.toothings;
    if wheels.axes_move {
        return free(wheels);
    }
    let (carrier, [from, to]) = wheels.held()?;
    let across = [0, 1, 2].map(|k| to[k] - from[k]);
    let sense = if first.is_internal() || second.is_internal() { -1.0 } else { 1.0 };
    let (mut turns, mut beside) = ([Vec::new(), Vec::new()], 0.0);
    let mut teeth = [first.first, second.first];
    let (between, axes, terms, fixed) = match wheels.mechanism.space {
        Space::Planar => {
            let factors = [first.teeth, sense * second.teeth, -(first.teeth + sense * second.teeth)];
            let frames = [wheels.own[0], wheels.own[1], carrier];
            let (terms, fixed) = in_the_plane(wheels.orientations, factors, frames);
            ([across[0], across[1]], None, terms, fixed)
        }
        Space::Spatial => {
            let [one, other] = wheels.turning(carrier)?;
            let (axis, sign) = match (one.axis, other.axis) {
                (Some(a), Some(b)) => match about_axes::parallel(a, b) {
                    Some(sign) => (a, sign),
                    None => return Err(messages::axes_not_parallel(&first.text, &second.text)),
                },
                (Some(axis), None) | (None, Some(axis)) => (axis, 1.0),
                (None, None) => return Err(messages::teeth_on_one_shaft(&first.text, &second.text)),
            };
            turns = [one.terms, times(sign, other.terms).collect()];
            // J of an axle that is turned round has the same x and the opposite y.
            teeth[1] *= sign;
            let terms =
                times(first.teeth, turns[0].clone()).chain(times(sense * second.teeth, turns[1].clone()));
            let axes = about_axes::axes(axis);
            beside = vector::dot(axis, across);
            ([0, 1].map(|k| vector::dot(axes[k], across)), Some(axes), collected(terms), 0.0)
        }
    };
    let constant = facing(first, second, between, teeth) - fixed;
    let (psi, side) = (toward(wheels.toothings, between), [1.0, sense]);
    let travels = Vec::new();
    let axles = axes.map(|[_, _, axle]| [axle; 2]);
    let first = teeth;
    Ok(Coupled {
        carrier,
        between,
        terms,
        travels,
        constant,
        axes,
        beside,
        axles,
        turns,
        first,
        psi,
        side,
        touch: None,
    })
}

/// The direction from the first centre to the second, of a ring from its centre to the wheel's.
fn toward([_, second]: [&Toothing; 2], [x, y]: [f64; 2]) -> [f64; 2] {
    [if second.is_internal() { libm::atan2(-y, -x) } else { libm::atan2(y, x) }; 2]
}

/// On axes that move: nothing holds them, and ψ is zero.
fn free(wheels: &Wheels) -> Result<Coupled, String> {
    let [first, second] = wheels.toothings;
    if wheels.mechanism.space == Space::Spatial {
        return Err(messages::moving_axes_in_space(&first.text, &second.text));
    }
    // From the first centre to the second; ψ of a ring goes from its centre to the wheel's.
    let side = if second.is_internal() { -1.0 } else { 1.0 };
    let between = [side * nominal(first, second), 0.0];
    let teeth = [first.first, second.first];
    let constant = facing(first, second, [side, 0.0], teeth);
    let sense = if first.is_internal() || second.is_internal() { -1.0 } else { 1.0 };
    Ok(Coupled {
        carrier: Frame::Ground,
        between,
        terms: Vec::new(),
        travels: Vec::new(),
        constant,
        axes: None,
        beside: 0.0,
        axles: None,
        turns: [Vec::new(), Vec::new()],
        first: teeth,
        psi: toward(wheels.toothings, between),
        side: [1.0, sense],
        touch: None,
    })
}

/// Factors and angles of what turns against the ground, and what the others are.
pub fn in_the_plane(
    orientations: &Orientations,
    factors: [f64; 3],
    frames: [Frame; 3],
) -> (Vec<(f64, Rotor)>, f64) {
    let (mut terms, mut fixed) = (Vec::new(), 0.0);
    for (factor, frame) in factors.into_iter().zip(frames) {
        match (frame, orientations.class(frame)) {
            (_, (0, angle)) => fixed += factor * angle,
            (Frame::Body(body), _) if factor != 0.0 => terms.push((factor, Rotor::Body(body))),
            _ => {}
        }
    }
    (terms, fixed)
}
