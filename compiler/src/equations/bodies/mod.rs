//! The kinds of bodies, one file each with its record, `BODY`.

mod beam;
mod body;
mod cuboid;
mod cylinder;
mod disk;
mod flexible;
mod particle;
mod rod;
mod sphere;

use crate::forms::BodyForm;

/// All kinds of bodies.
pub static BODIES: &[&BodyForm] = &[
    &body::BODY,
    &rod::BODY,
    &disk::BODY,
    &cuboid::BODY,
    &sphere::BODY,
    &cylinder::BODY,
    &particle::BODY,
    &beam::BODY,
    &flexible::BODY,
];
