//! The checks of the shipped models, in one binary, because generic models are compiled again in each.


mod emitted_code;
mod every_operation;
mod no_alloc;
mod registry;
mod reference;
mod published;
