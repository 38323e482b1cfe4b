//! What follows from a state and its solution: motions of bodies, reactions of joints, inverse dynamics, powers.
//!
//! The compiler emits one implementation of [`Report`] per definition. Names stand beside the lists, and the entries are
//! [`Fields`], so that what writes tables or compares can be written once for all mechanisms:
//!
//! ```
//! use linkwright_runtime::{Fields, Report};
//!
//! /// `crank.position.x` and so on, with their values.
//! fn each_number<M: Report<f64>>(motions: &M::Motions, mut show: impl FnMut(&str, &str, f64)) {
//!     for (body, motion) in M::BODIES.iter().zip(motions.as_ref()) {
//!         for (name, value) in M::Motion::NAMES.iter().zip(motion.to_array().as_ref()) {
//!             show(body, name, *value);
//!         }
//!     }
//! }
//! ```

use crate::fields::Fields;
use crate::mechanism::Mechanism;
use crate::real::Real;
use crate::state::StateOf;
use crate::vector::Vector;
use core::fmt::Debug;

/// Motions, reactions, inverse dynamics and powers, evaluated in the scalars `R`.
///
/// `a` and `lambda` are those of [`acceleration`](Mechanism::acceleration) with the same inputs, unless something else is said.
/// Every function writes all entries of its result, allocates nothing and never fails.
pub trait Report<R: Real>: Mechanism<R> {
    /// Names of the bodies, in the order of [`motions`](Report::motions).
    const BODIES: &'static [&'static str];
    /// Names of the joints, in the order of [`reactions`](Report::reactions).
    const JOINTS: &'static [&'static str];
    /// Names of the loads, in the order of [`powers`](Report::powers).
    const LOADS: &'static [&'static str];

    /// [`BodyMotion`](crate::BodyMotion), in space [`SpatialMotion`](crate::SpatialMotion).
    type Motion: Fields<R>;
    /// One for each body.
    type Motions: Copy + Debug + AsRef<[Self::Motion]>;
    /// [`Reaction`](crate::Reaction), in space [`SpatialReaction`](crate::SpatialReaction).
    type Reaction: Fields<R>;
    /// One for each joint.
    type Reactions: Copy + Debug + AsRef<[Self::Reaction]>;
    /// One for each load.
    type Powers: Vector<R>;
    /// One for each driver.
    type Efforts: Copy + Debug + AsRef<[[R; 2]]>;

    /// Position, velocity and acceleration of every body's centre of mass, orientation, ω and ω̇, from a state and any accelerations.
    fn motions(&self, time: R, q: &Self::Q, v: &Self::V, a: &Self::V) -> Self::Motions;
    /// Force and torque that each joint exerts on the body of its second place: force in world axes at that place (N), torque
    /// about it (N m).
    fn reactions(
        &self,
        time: R,
        state: &StateOf<Self, R>,
        u: &Self::Inputs,
        a: &Self::V,
        lambda: &Self::Lambda,
    ) -> Self::Reactions;
    /// M a − Q: the forces that any accelerations `a` need beside loads and constraints, one for each velocity (N m or N). Of a
    /// tree without constraints these are the efforts of its joints.
    fn inverse_dynamics(&self, time: R, state: &StateOf<Self, R>, u: &Self::Inputs, a: &Self::V) -> Self::V;
    /// Power of each load (W), what springs store included.
    fn powers(&self, time: R, state: &StateOf<Self, R>, u: &Self::Inputs) -> Self::Powers;
    /// Effort of each driver along its quantity (N m or N) and its power (W), from the multipliers; drivers in the order of their
    /// [`ROWS`](Mechanism::ROWS).
    fn driver_efforts(&self, time: R, q: &Self::Q, v: &Self::V, lambda: &Self::Lambda) -> Self::Efforts;
}
