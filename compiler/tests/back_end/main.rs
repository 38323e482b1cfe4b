//! The back end: budgets of what comes out, and the compiler's check of its own work.

mod budgets;
mod exported;
mod look_up;
mod mechanisms;
mod repetition;
mod self_check;
mod signatures;
mod spread;
mod ways;

use linkwright_compiler::diagnostics::Diagnostics;
use linkwright_compiler::{Compiled, compile};

fn compiled(source: &str) -> Result<Compiled, Diagnostics> {
    compile(source.parse().expect("the source consists of tokens"), None)
}
