//! The checks of the shipped models, in one binary, because generic models are compiled again in each.


mod emitted_code;
mod registry;
