//! Equations of motion of mechanisms, derived at compile time.
//!
//! A mechanism is written as its parts list and joint table in [`mechanism!`]. What comes out is straight-line Rust
//! without allocation and without trigonometry: the mass matrix, the constraints, and accelerations and multipliers with
//! the linear system already eliminated; a consistent start state as a constant; and an implementation of
//! [`Mechanism`], which the runtime simulates.
//!
//! ```
//! use linkwright::{AssembleExt, Baumgarte, Simulation, mechanism};
//!
//! mechanism! {
//!     /// A crank that drives a rocker.
//!     pub planar FourBar {
//!         param heavy [kg] = 1 in 0.1..10;
//!         gravity [m/s^2] = (0, -9.81);
//!         rod crank   { mass [kg] = 1; length [m] = 1; }
//!         rod coupler { mass [kg] = heavy; length [m] = 2; }
//!         rod rocker  { mass [kg] = 1; length [m] = 1.5; }
//!         joint crank_pin:  revolute(ground(0, 0) [m], crank.start);
//!         joint rocker_pin: revolute(ground(2, 0) [m], rocker.start);
//!         joint left:  revolute(crank.end, coupler.start);
//!         joint right: revolute(coupler.end, rocker.end);
//!         start  { crank_pin.angle [deg] = 90; crank_pin.rate [rad/s] = 2; rocker_pin.angle [deg] ~ 90; }
//!         expect { degrees_of_freedom = 1; }
//!         output x [m] = coupler.center.x;
//!     }
//! }
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let model = FourBar::prepare(FourBarParameters { heavy: 2.0 })?; // bounds are checked here
//! let start = model.assemble(&FourBar::START)?; // START itself serves the default parameters
//! let mut simulation = Simulation::new(&model, start)
//!     .formulation(Baumgarte { alpha: 10.0, beta: 10.0 })
//!     .step(1e-3);
//! let energy = simulation.energy();
//! simulation.run_until(1.0, |sample| assert!(sample.outputs.x.is_finite()))?;
//! assert!((simulation.energy() - energy).abs() < 1e-6);
//! assert!(simulation.constraint_residual().position < 1e-8);
//! # Ok(())
//! # }
//! ```
//!
//! - [`language`]: how a mechanism is written, and what a definition becomes.
//! - [`Simulation`]: formulations, inputs, integrators, samples.
//! - [`AssembleExt`]: consistent states, the motion of everything from that of the independent coordinates.
//! - [`Linearisation`], [`equilibrium`], [`actuation`]: derivatives of the motion, state matrices, static positions, inputs for
//!   given accelerations, of definitions that say `options { emit = (tangent); }`.
//! - [`Stepper`], and [`control`] beside it: a mechanism in a control loop; equations in independent coordinates, steps with their derivatives.
//! - [`Mechanism`]: the equations, one function each, for use without a simulation; [`functions`]: all that a model can
//!   compute, with signatures, orders and examples.
//!
//! Without the default feature `std` everything works on bare metal, square roots then being `libm`'s.
#![no_std]
#![forbid(unsafe_code)]
#![warn(missing_docs)]

pub use linkwright_runtime::*;

/// Compiles a definition of a mechanism into its equations of motion.
///
/// ```text
/// mechanism! {
///     pub planar Pendulum {
///         gravity [m/s^2] = (0, -9.81);
///         rod arm { mass [kg] = 1; length [m] = 1; }
///         joint pivot: revolute(ground(0, 0) [m], arm.start);
///         start { pivot.angle [rad] = 0.5; }
///     }
/// }
/// ```
/// A definition may also stand in a file of its own, beside the Rust file that names it, which holds what stands in the
/// braces above:
///
/// ```text
/// mechanism!(file = "pendulum.mech");
/// ```
/// The language, and what is emitted, are described in [`language`]. What is emitted finds this crate under whatever name it has
/// where the macro is called: renamed in `Cargo.toml`, or re-exported by another crate.
// Only `$crate` says which crate this is, whatever it is called there.
#[macro_export]
macro_rules! mechanism {
    ($($definition:tt)*) => { $crate::__private::v1::mechanism! { ($crate) $($definition)* } };
}

#[cfg(doc)]
#[doc = include_str!("../docs/language.md")]
pub mod language {}

#[cfg(doc)]
#[doc = include_str!("../docs/functions.md")]
pub mod functions {}

/// The examples of further documents.
#[cfg(doctest)]
mod documents {
    #[doc = include_str!("../docs/formulations.md")]
    struct Formulations;
    #[doc = include_str!("../docs/in-a-controller.md")]
    struct InAController;
    #[doc = include_str!("../docs/linearisation.md")]
    struct Linearisation;
}

/// What emitted code may name: the runtime's, and the macro that writes its documentation; and the one that `mechanism!` calls.
#[doc(hidden)]
pub mod __private {
    /// The first version.
    pub mod v1 {
        pub use linkwright_macros::{mechanism, mechanism_page};
        pub use linkwright_runtime::__private::v1::*;
    }
}
