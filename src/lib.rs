//! Equations of motion of mechanisms, derived at compile time.
#![no_std]
#![forbid(unsafe_code)]
#![warn(missing_docs)]

pub use linkwright_macros::mechanism;
pub use linkwright_runtime::*;

#[doc(hidden)]
pub use linkwright_runtime::__private;
