//! What rustc prints of mistakes, one pair of files each: `tests/rustc.rs`.
