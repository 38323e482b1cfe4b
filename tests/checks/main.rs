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
mod linearisation;
#[path = "../runtime_fuzz/methods.rs"]
mod methods;
mod no_alloc;
mod overconstrained;
mod page;
mod page_equations;
mod published;
#[path = "../runtime_fuzz/random.rs"]
mod random;
mod rank;
mod redundant;
mod reference;
mod registry;
mod self_check;
mod space_convergence;
mod starts;
mod tangent;
mod walking;
mod zoo;
mod zoo_laws;
mod zoo_space;
mod zoo_tangent;
