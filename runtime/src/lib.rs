//! The runtime of Linkwright: what emitted equations of motion call and what drives them.
//!
//! `no_std`, without allocation, without unsafe code. The compiler turns a definition into an implementation of
//! [`Mechanism`] and [`Assemble`]; this crate holds everything that does not depend on the mechanism:
//!
//! | subject | module |
//! |---|---|
//! | scalars, vectors, named numbers | [`real`], [`vector`], [`fields`] |
//! | positions that are no vector space | [`rotation`], [`quaternion`], [`layout`], by name [`named`] |
//! | the traits that emitted code implements | [`mechanism`] |
//! | states that satisfy the constraints | [`assembly`], over the sparse factorisations of `ldl.rs` and `tabled.rs` |
//! | derivatives, and what follows from them | [`tangent`], [`linearisation`] |
//! | motion | [`formulation`], [`input`], [`integrator`], [`simulation`] |
//! | motion in a control loop; control itself | [`stepper`]; [`control`] |
//! | many mechanisms of one definition at once | [`lanes`] |
//! | what can go wrong | [`error`] |
//!
//! The feature `std` (default) takes the square root from the hardware, and the fused multiply-add where the target
//! has one; `nalgebra` adds [`dense`](https://docs.rs/linkwright-runtime) matrices; `wide` numbers in lanes.
#![no_std]
#![forbid(unsafe_code)]
#![warn(missing_docs)]

#[cfg(feature = "std")]
extern crate std;

pub mod assembly;
pub mod body;
#[doc(hidden)]
pub mod c_interface;
mod clock;
pub mod condition;
pub mod control;
#[cfg(feature = "nalgebra")]
pub mod dense;
pub mod error;
pub mod fields;
pub mod formulation;
pub mod input;
pub mod integrator;
pub mod lanes;
pub mod layout;
#[doc(hidden)]
pub mod ldl;
pub mod linearisation;
pub mod mechanism;
pub mod named;
#[doc(hidden)]
pub mod partition;
pub mod quaternion;
pub mod real;
pub mod report;
pub mod rotation;
pub mod simulation;
pub mod state;
pub mod stepper;
#[doc(hidden)]
pub mod table;
#[doc(hidden)]
pub mod tabled;
pub mod tangent;
mod trigger;
pub mod vector;

pub use assembly::{
    AssembleExt, assemble_acceleration, assemble_position, assemble_velocity, project_position,
    project_velocity, smallest_pivot,
};
pub use body::{BodyMotion, Reaction, SpatialMotion, SpatialReaction};
pub use condition::reciprocal_condition;
pub use control::{
    Actuators, Reading, Reduced, StepMap, StepMapOf, coordinate, coordinate_rates, coordinate_values,
    measured, step_map, zero_order_hold,
};
pub use error::{AssemblyError, LinearisationError, SettingError, SimulationError, StepError};
pub use fields::{Fields, Parametric};
pub use formulation::{
    AugmentedLagrangian, Baumgarte, Corrected, Evaluation, Formulation, LagrangeIndex1, NullSpace,
    Partitioned, Penalty, PivotOf, Projected, Settled, WithMultipliers,
};
pub use input::{Held, InputSource, NoInputs, Sampled};
pub use integrator::{
    Ali3p, DormandPrince, DormandPrinceMemory, Dynamics, ExplicitTrapezoidal, FixedStep, GeneralisedAlpha,
    ImplicitDynamics, ImplicitTrapezoidal, Integrator, Interpolate, Method, Rejections, Rk4,
    SemiImplicitEuler, StepFailure, Stepped, SteppedOf,
};
#[cfg(feature = "wide")]
pub use lanes::{F32x8, F32x16, F64x4, F64x8};
pub use lanes::{InScalars, LaneMethod, LaneStepper, Lanes, Ticks};
pub use layout::{Layout, MultiTurn, inverse_differential, retract, retract_counting};
pub use linearisation::{
    Actuation, Assembled, ByParameters, Equilibrium, EquilibriumOf, Linearisation, Moved, MovedOf, Response,
    StateSpace, actuation, equilibrium,
};
pub use mechanism::{Assemble, Condition, ConditionKind, Elimination, Flips, Mechanism, Row};
pub use named::{Angle, Turns};
pub use real::Real;
pub use report::Report;
pub use rotation::unwrap_angle;
pub use simulation::{
    Direction, EVENTS_PER_STEP, Event, IMPACTS_PER_STEP, MechanismDynamics, NearSingular, Occurrence,
    RIGID_TOUCHING, Residual, Sample, Samples, Simulation, Solution, SolutionOf, Step,
};
pub use state::{Derivative, DerivativeOf, Kinematics, Motion, State, StateOf, Variables};
pub use stepper::{Saved, SavedOf, StepMethod, Stepper, Tick};
pub use tangent::Tangent;
pub use trigger::Trigger;
pub use vector::Vector;

/// The names that emitted code may use. The path has its own version, so that a later runtime can serve older code.
#[doc(hidden)]
pub mod __private {
    /// The first version.
    pub mod v1 {
        pub use crate::assembly::AssembleExt;
        pub use crate::body::{
            BodyMotion, Reaction, SpatialMotion, SpatialReaction, check_constants, check_finite, check_mass,
            check_setting,
        };
        pub use crate::c_interface;
        pub use crate::error::{AssemblyError, SettingError, SimulationError};
        pub use crate::fields::{Fields, Parametric};
        pub use crate::formulation::{Corrected, LagrangeIndex1};
        pub use crate::integrator::{Rk4, SemiImplicitEuler};
        pub use crate::lanes::{InScalars, zip_arrays, zip_fields};
        pub use crate::layout::{Layout, MultiTurn, retract};
        pub use crate::mechanism::{Assemble, Condition, ConditionKind, Elimination, Flips, Mechanism, Row};
        pub use crate::named::{Angle, Turns};
        pub use crate::real::Real;
        pub use crate::report::Report;
        pub use crate::rotation::unwrap_angle;
        pub use crate::state::{Kinematics, Motion, State, Variables};
        pub use crate::stepper::Tick;
        pub use crate::table;
        pub use crate::tabled;
        pub use crate::tangent::Tangent;
        pub use crate::trigger::Trigger;
        pub use crate::vector::Vector;
        pub use core;
    }
}
