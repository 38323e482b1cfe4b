//! Random mechanisms put together: those that close by construction, with rough guesses, must be; of those that cannot, the
//! least gap must be named.
//!
//! A few hundred at each `cargo test`; as many as are asked for by
//!
//! ```text
//! LINKWRIGHT_ASSEMBLIES=2000 cargo test -p linkwright-compiler --test assembly -- --nocapture
//! ```
//! (and a quarter as many that cannot close). What is true of them is known from how they were made, or by closed forms and
//! brute force that share nothing with the compiler.

mod blame;
mod closable;
mod nearest;
mod open;
mod overconstrained;
mod random;

use linkwright_compiler::{Start, start};
use proc_macro2::TokenStream;
use std::str::FromStr;

/// A start, or the errors, one line each.
fn put_together(source: &str) -> Result<Start, String> {
    let tokens = TokenStream::from_str(source).expect("the source consists of tokens");
    start(tokens).map_err(|errors| errors.to_string())
}

/// How many closable mechanisms are tried.
fn cases() -> usize {
    let asked = std::env::var("LINKWRIGHT_ASSEMBLIES").ok();
    asked.map_or(300, |asked| asked.parse().expect("LINKWRIGHT_ASSEMBLIES is a number"))
}
