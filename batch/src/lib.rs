//! Many mechanisms of one definition at once: parameter sweeps, Monte Carlo, environments for learning.
//!
//! A [`Batch`] has members: mechanisms of one definition, each with parameters, a time and a state of its own. They stand in the lanes
//! of vector registers ([`LaneStepper`](linkwright::LaneStepper)), and groups of them are moved by the threads of `rayon`. A member
//! moves to the bit as a [`Stepper`](linkwright::Stepper) moves it alone, with any number of lanes and threads. One that fails stays where it
//! was and is named by [`failures`](Batch::failures); the others go on.
//!
//! ```
//! use linkwright::{Rk4, mechanism};
//! use linkwright_batch::{Batch, Constant};
//!
//! mechanism! {
//!     /// A pendulum on a motor.
//!     pub planar Pendulum {
//!         param length [m] = 1 in 0.1..2;
//!         input torque [N*m];
//!         gravity [m/s^2] = (0, -9.81);
//!         rod arm { mass [kg] = 1; length [m] = length; }
//!         joint pivot: revolute(ground(0, 0) [m], arm.start);
//!         torque motor: torque(arm) = torque;
//!         start { pivot.angle [deg] = 0; }
//!         output height [m] = arm.end.y;
//!     }
//! }
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! // A hundred lengths, one of which is not allowed.
//! let lengths: Vec<f64> = (0..100).map(|member| 0.05 + 0.01 * member as f64).collect();
//! let mut batch = Batch::<Pendulum, _>::prepare(100, Rk4, |member| PendulumParameters { length: lengths[member] })?;
//! assert_eq!(batch.failures().map(|(member, _)| member).collect::<Vec<_>>(), [0, 1, 2, 3, 4]);
//!
//! let torque = Constant(PendulumInputs { torque: 0.2 });
//! let summary = batch.run(&torque, 1e-3, 500);
//! assert_eq!(summary.failed, 0);
//! let heights = batch.outputs(&torque).column("height").ok_or("no such output")?.to_vec();
//! assert!(heights[50] < 0.0 && heights[4].is_nan());
//! # Ok(())
//! # }
//! ```
//!
//! With the feature `arrow` results become record batches of Apache Arrow: `record_batch` of [`Columns`] and [`Recording`].
//!
//! Lanes pay where the processor is told of them: `RUSTFLAGS="-C target-cpu=native"`.
#![forbid(unsafe_code)]
#![warn(missing_docs)]

#[cfg(feature = "arrow")]
mod arrow;
mod batch;
mod failure;
mod law;
mod results;

#[cfg(feature = "arrow")]
pub use arrow::InArrow;
pub use batch::{Batch, Summary, Widest};
pub use failure::{BatchError, Failure};
pub use law::{Constant, Each, Group, InLanesOf, Law, PerMember};
pub use results::{Columns, Recording};
