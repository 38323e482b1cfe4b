//! The checks of the shipped models, in one binary, because generic models are compiled again in each.

mod architecture;
mod balances;
mod ceilings;
mod convergence;
mod dormand_prince;
mod emitted_code;
mod events;
mod every_operation;
mod formulations;
mod golden;
mod identities;
mod implicit;
mod kinematics;
mod language;
mod no_alloc;
mod published;
mod redundant;
mod reference;
mod registry;
mod space_convergence;
mod starts;
mod walking;
mod zoo;
mod zoo_space;
