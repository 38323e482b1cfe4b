//! Periodic motions of mechanisms: frequency responses with folds, jumps and Floquet multipliers.
//!
//! A [`Cycle`] is a mechanism under a load of some period, as it depends on one number. [`Cycle::close`] finds a motion that repeats, stable or not, by
//! shooting with the exact derivative of a period; [`Cycle::branch`] follows such motions through folds, where a sweep jumps;
//! [`Cycle::measure`] says what an output does in one. Where a law has a kink or a jump, such as the flanks of a backlash, [`Cycle::switch`] names the output that
//! tells, and no step goes across.
//!
//! ```
//! use linkwright::{AssembleExt, mechanism};
//! use linkwright_periodic::{Along, Cycle};
//! use std::f64::consts::TAU;
//!
//! mechanism! {
//!     /// A wheel on a spring, shaken by a torque, with a stop.
//!     pub planar Stopped {
//!         param omega [rad/s] = 3 in 0.1..20;
//!         body wheel { mass [kg] = 1; inertia [kg*m^2] = 0.5; }
//!         joint axle: revolute(ground(0, 0) [m], wheel.center);
//!         torsion_spring spring: torsion_spring(axle, stiffness [N*m/rad] = 8, damping [N*m*s/rad] = 0.2);
//!         torque stop: torque(axle) = -200 [N*m/rad]*max(axle.angle - 0.1 [rad], 0);
//!         torque shaking: torque(axle) = 0.3 [N*m]*cos(omega*time);
//!         start { axle.angle [rad] = 0; }
//!         options { emit = (tangent); }
//!         output angle [rad] = axle.angle;
//!     }
//! }
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let cycle = Cycle::new(|omega| Stopped::prepare(StoppedParameters { omega }), |omega| TAU / omega).switch("angle", 0.1).steps(40);
//! let motion = cycle.settle(3.0, &Stopped::<f64>::default().start(), 10)?;
//! // It does not come to the stop: 0.6/√((16 − 9)² + 1.2²) rad.
//! assert!(motion.is_stable() && motion.switchings.is_empty());
//! assert!((cycle.measure(&motion, "angle")?.largest - 0.084482).abs() < 1e-4);
//! // The motions at other frequencies; where they fold a sweep jumps.
//! let branch = cycle.branch(&motion, &Along { most: 3, ..Along::new(2.0..=6.0) })?;
//! assert!(branch.folds.is_empty() && branch.motions[2].value > 3.0);
//! # Ok(())
//! # }
//! ```
#![forbid(unsafe_code)]
#![warn(missing_docs)]

mod branch;
mod coordinates;
mod crossing;
mod cycle;
mod error;
mod flow;
mod map;
mod measure;
mod motion;

pub use branch::{Along, Branch, End};
pub use cycle::{Cycle, Switch};
pub use error::PeriodicError;
pub use flow::Switching;
pub use map::PeriodMap;
pub use measure::Measure;
pub use motion::PeriodicMotion;
pub use nalgebra;
