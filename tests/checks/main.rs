//! The checks of the shipped models, in one binary, because generic models are compiled again in each.


mod architecture;
mod ceilings;
mod balances;
mod convergence;
mod emitted_code;
mod every_operation;
mod golden;
mod identities;
mod kinematics;
mod language;
mod no_alloc;
mod registry;
mod reference;
mod published;
mod walking;
mod zoo;
