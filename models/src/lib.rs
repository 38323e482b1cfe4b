//! Mechanisms that ship with Linkwright.

pub mod four_bar;
