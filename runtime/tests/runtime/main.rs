//! The runtime on mechanisms written by hand: one binary, one module a subject.

mod assembly;
mod at_run_time;
mod bounds;
mod bracket;
#[cfg(feature = "nalgebra")]
mod dense;
mod dormand_prince;
mod double_pendulum;
mod events;
mod factorisation;
mod four_bar;
mod motion;
mod motor;
mod solve;
mod space;
mod support;
mod ticks;
