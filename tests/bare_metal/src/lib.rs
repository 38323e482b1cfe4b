//! What the images do: every model that ships, stepped and counted; and what they count with.
//!
//! A line a model goes out: its name, a digest of the state that it reaches, and, where a [`Meter`] counts, instructions and stack. The
//! digests of the host's program are the same to the bit.
#![no_std]

pub mod exercise;
#[cfg(target_os = "none")]
pub mod machine;
pub mod text;

/// Counts what a function executes.
pub trait Meter {
    /// Instructions executed by `work`.
    fn instructions(&mut self, work: impl FnMut()) -> u32;
    /// Bytes of stack used by `work`.
    fn stack(&mut self, work: impl FnMut()) -> u32;
    /// Sends text to whoever runs the program.
    fn tell(&mut self, text: &str);
}
