//! The checks of the shipped models, in one binary, because generic models are compiled again in each.

mod architecture;
mod balances;
mod ceilings;
mod convergence;
mod emitted_code;
mod every_operation;
mod golden;
mod identities;
mod kinematics;
mod language;
mod linearisation;
mod no_alloc;
mod published;
mod redundant;
mod reference;
mod registry;
mod space_convergence;
mod starts;
mod tangent;
mod walking;
mod zoo;
mod zoo_space;
mod zoo_tangent;
