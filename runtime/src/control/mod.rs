//! For control work: what a controller or an estimator asks of a mechanism at each tick, without allocation.
//!
//! | | file | needs |
//! |---|---|---|
//! | inputs for given accelerations, by the joints that are driven | `actuators.rs` | |
//! | mass matrix, bias and gravity in independent coordinates | `reduced.rs` | |
//! | coordinates by name, and a state from what was measured | `coordinates.rs` | |
//! | the step and its derivatives A_d, B_d | `step_map.rs`, through the stages in `follow.rs` | [`Tangent`](crate::Tangent) |
//! | A_d and B_d of a linear plant with inputs held | `hold.rs` | |
//!
//! Motions that the constraints admit are `basis.rs`. The continuous A, B, C and D are [`Linearisation`](crate::Linearisation)'s, states off the
//! constraints are brought to them by [`project`](crate::AssembleExt::project).

mod actuators;
mod basis;
mod coordinates;
mod follow;
mod hold;
mod reduced;
mod step_map;

pub use crate::formulation::Stabilisation;
pub use actuators::Actuators;
pub use coordinates::{Reading, coordinate, coordinate_rates, coordinate_values, measured};
pub use follow::StepTangent;
pub use hold::zero_order_hold;
pub use reduced::Reduced;
pub use step_map::{StepMap, StepMapOf, step_map};
