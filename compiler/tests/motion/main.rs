//! Mobility and range of motion against closed forms.

mod efforts;
mod four_bars;
mod linkages;
mod mobility;
mod reflected;
mod sliders;

use linkwright_compiler::check::motion::{Motion, Range};
use linkwright_compiler::{Compiled, compile};
use proc_macro2::TokenStream;
use std::str::FromStr;

fn compiled(source: &str) -> Compiled {
    let tokens = TokenStream::from_str(source).expect("the source consists of tokens");
    compile(tokens, None).unwrap_or_else(|errors| panic!("{source}\n{errors}"))
}

/// The errors of a definition, one line each.
fn errors(source: &str) -> String {
    let tokens = TokenStream::from_str(source).expect("the source consists of tokens");
    compile(tokens, None).map(|_| ()).expect_err("the definition has a mistake").to_string()
}

fn motion(source: &str) -> Motion {
    compiled(source).motion().unwrap_or_else(|unswept| panic!("{source}\n{unswept:?}"))
}

fn range<'m>(motion: &'m Motion, of: &str) -> &'m Range {
    motion.ranges.iter().find(|range| range.of == of).unwrap_or_else(|| panic!("no {of}"))
}

/// Numbers between 0 and 1 by a linear congruential generator (Knuth's MMIX), the same at every run.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn between(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * self.next()
    }
}
