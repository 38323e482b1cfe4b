//! Wheels, and a wheel in a ring, about parallel axes.
//!
//! z₁(θ₁ − ψ) + z₂(θ₂ − ψ − π) = π + 2πk of two wheels, z₁(θ₁ − ψ) − z₂(θ₂ − ψ) = π + 2πk of a ring, angles against what holds them.

use super::super::{Frame, Rotor, Space};
use super::holding::Orientations;
use super::pair::facing;
use super::{Coupled, Wheels, about_axes, collected, times};
use crate::messages;

pub fn couple(wheels: &Wheels) -> Result<Coupled, String> {
    let [first, second] = wheels.toothings;
    let (carrier, [from, to]) = wheels.held()?;
    let across = [0, 1, 2].map(|k| to[k] - from[k]);
    let sense = if first.is_internal() || second.is_internal() { -1.0 } else { 1.0 };
    let (between, terms, fixed) = match wheels.mechanism.space {
        Space::Planar => {
            let factors = [first.teeth, sense * second.teeth, -(first.teeth + sense * second.teeth)];
            let frames = [wheels.own[0], wheels.own[1], carrier];
            let (terms, fixed) = in_the_plane(wheels.orientations, factors, frames);
            ([across[0], across[1]], terms, fixed)
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
            let terms = times(first.teeth, one.terms).chain(times(sign * sense * second.teeth, other.terms));
            (about_axes::across(axis, across), collected(terms), 0.0)
        }
    };
    let constant = facing(first, second, between) - fixed;
    Ok(Coupled { carrier, between, terms, travels: Vec::new(), constant })
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
