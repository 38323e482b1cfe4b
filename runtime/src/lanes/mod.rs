//! Several mechanisms of one definition that move together, one in each lane of a vector register.
//!
//! A [`Real`] may be a row of numbers ([`Lanes`]); equations and integrators are then evaluated for all of them at once. What
//! belongs to one lane alone is here: how models and states are put into lanes (`in_scalars.rs`), which methods can be (`method.rs`),
//! and a stepper whose lanes do not feel one another (`stepper.rs`). The numbers themselves are `wide.rs`, with the feature `wide`.
//! Threads, and batches of more than a register holds, are the package `linkwright-batch`.

mod in_scalars;
mod method;
mod stages;
mod stepper;
#[cfg(feature = "wide")]
mod wide;

pub use in_scalars::{
    InScalars, InputsIn, OutputsIn, ParametersIn, StateIn, fields_in_lane, gather_fields, state_in_lane,
    zip_arrays, zip_fields,
};
pub use method::{InLanes, LaneMethod};
pub use stepper::{LaneStepper, Ticks};
#[cfg(feature = "wide")]
pub use wide::{F32x8, F32x16, F64x4, F64x8};

use crate::real::Real;

/// The most lanes that there may be.
pub const MOST_LANES: usize = 16;

/// A row of numbers, [`LANES`](Real::LANES) of them, at most [`MOST_LANES`].
///
/// Every operation of a lane gives the bits that it gives of its number alone.
pub trait Lanes: Real {
    /// One of the numbers.
    type Scalar: Real;

    /// This number in every lane.
    fn splat(value: Self::Scalar) -> Self;
    /// The number in this lane; in the last one where there are fewer.
    fn lane(self, index: usize) -> Self::Scalar;
    /// Writes the number in this lane; nothing where there are fewer.
    fn set_lane(&mut self, index: usize, value: Self::Scalar);
    /// The lanes in which a mask is true, one bit each, the first lowest.
    fn bits(mask: Self::Mask) -> u32;
    /// The mask that is true in these lanes.
    fn mask(bits: u32) -> Self::Mask;
}
