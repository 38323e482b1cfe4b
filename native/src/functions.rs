//! Functions that machine code calls: those of the interpreter, which are those of emitted code.

use linkwright_compiler::symbolic::Unary;
use linkwright_runtime::Real;

macro_rules! functions {
    ($($function:ident $name:literal),* $(,)?) => {
        /// The name that machine code calls a function by, and where it is.
        pub fn unary(function: Unary) -> (&'static str, *const u8) {
            match function {
                $( Unary::$function => {
                    extern "C" fn call(x: f64) -> f64 {
                        Unary::$function.value(x)
                    }
                    ($name, call as *const u8)
                } )*
            }
        }
    };
}

functions! {
    Reciprocal "reciprocal", Sqrt "square_root", Abs "magnitude", Sign "sign_of", Sin "sine", Cos "cosine", Tan "tangent", Asin "arcsine",
    Acos "arccosine", Exp "exponential", Ln "logarithm", Log10 "logarithm_ten", Sinh "hyperbolic_sine", Cosh "hyperbolic_cosine",
    Tanh "hyperbolic_tangent", Floor "whole_below",
}

/// The angle of (x, y).
pub extern "C" fn atan2(y: f64, x: f64) -> f64 {
    Real::atan2(y, x)
}
