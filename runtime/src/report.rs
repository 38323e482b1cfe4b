//! What follows from a state and its solution: motions of bodies, reactions of joints, inverse dynamics, powers.
//!
//! The compiler emits one implementation of [`Report`] per definition. Names stand beside the lists, and the entries are
//! [`Fields`], so that what writes tables or compares can be written once for all mechanisms:
//!
//! ```
//! use linkwright_runtime::{Fields, Report, Vector};
//!
//! /// `crank.position.x` and so on, with their values.
//! fn each_number<M: Report<f64>>(model: &M, motions: &M::Motions, mut show: impl FnMut(&str, &str, f64)) {
//!     for (body, motion) in model.bodies().iter().zip(motions.as_ref()) {
//!         for (name, value) in M::Motion::NAMES.iter().zip(motion.to_array().as_slice()) {
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
/// Every function writes all entries of its result and never fails; those of a compiled mechanism allocate nothing.
///
/// ```
/// use linkwright_runtime::{Report, StateOf, Vector};
///
/// /// The load that does most work at a state, and its power, W.
/// fn strongest<M: Report<f64>>(model: &M, time: f64, state: &StateOf<M>, u: &M::Inputs) -> Option<(&'static str, f64)> {
///     let powers = model.powers(time, state, u);
///     let named = model.loads().iter().copied().zip(powers.as_slice().iter().copied());
///     named.max_by(|a, b| a.1.total_cmp(&b.1))
/// }
/// ```
pub trait Report<R: Real>: Mechanism<R> {
    /// Names of the bodies, in the order of [`motions`](Report::motions).
    fn bodies(&self) -> &[&'static str];
    /// Names of the joints, in the order of [`reactions`](Report::reactions).
    fn joints(&self) -> &[&'static str];
    /// Names of the loads, in the order of [`powers`](Report::powers).
    fn loads(&self) -> &[&'static str];

    /// [`BodyMotion`](crate::BodyMotion), in space [`SpatialMotion`](crate::SpatialMotion).
    type Motion: Fields<R>;
    /// One for each body.
    type Motions: Clone + Debug + AsRef<[Self::Motion]>;
    /// [`Reaction`](crate::Reaction), in space [`SpatialReaction`](crate::SpatialReaction).
    type Reaction: Fields<R>;
    /// One for each joint.
    type Reactions: Clone + Debug + AsRef<[Self::Reaction]>;
    /// One for each load.
    type Powers: Vector<R>;
    /// One for each driver.
    type Efforts: Clone + Debug + AsRef<[[R; 2]]>;

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
    /// [`rows`](Mechanism::rows).
    fn driver_efforts(&self, time: R, q: &Self::Q, v: &Self::V, lambda: &Self::Lambda) -> Self::Efforts;
}
