//! The checks of the shipped models, in one binary, because generic models are compiled again in each. Only
//! `tests/no_alloc.rs`, as much again, is one of its own, which is built beside this one.

mod agreement;
mod architecture;
mod balances;
mod both_orders;
mod ceilings;
mod convergence;
mod dormand_prince;
mod dry;
mod dry_along_several;
mod dry_joints;
mod emitted_code;
mod events;
mod every_operation;
mod formulations;
mod gates;
mod golden;
mod held;
mod identities;
mod implicit;
mod interpreted;
mod jumps;
mod kinematics;
mod language;
mod linearisation;
mod memories;
mod overconstrained;
mod page;
mod page_equations;
mod published;
mod rank;
mod redundant;
mod reference;
mod rigid;
mod rubbing;
mod self_check;
mod space_convergence;
mod starts;
mod tangent;
mod walking;

use mechanisms::{registry, zoo, zoo_laws, zoo_space, zoo_tangent};
