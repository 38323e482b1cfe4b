//! The user's own types, traits, macros and modules by the names that emitted code uses.
#![allow(dead_code, non_camel_case_types, unused_macros)]

pub struct Option;
pub struct Some;
pub struct None;
pub struct Result;
pub struct Ok;
pub struct Err;
pub struct Vec;
pub struct Box;
pub struct String;
pub struct f64;
pub struct usize;
pub struct bool;
pub struct str;
pub struct R;
pub struct Q;
pub struct V;
pub struct State;
pub struct Inputs;
pub trait Default {}
pub trait Clone {}
pub trait Copy {}
pub trait Sized {}
pub trait Debug {}
pub trait PartialEq {}
pub trait Mechanism {}
pub trait Assemble {}
pub trait Tangent {}
pub trait Real {}
pub trait Fields {}
pub mod core {}
pub mod std {}
pub mod linkwright {}
macro_rules! panic {
    ($($anything:tt)*) => {
        compile_error!("captured")
    };
}
macro_rules! debug_assert {
    ($($anything:tt)*) => {
        compile_error!("captured")
    };
}

::linkwright::mechanism! {
    pub planar Shadowed {
        param length [m] = 1 in 0.1..2;
        input push [N];
        rod arm { mass [kg] = 1; length [m] = length; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
        force hand: force(arm.end) = (push, 0);
        start { pivot.angle [rad] = 0.5; }
        options { emit = (penalty, projection, null_space, tangent); }
        output height [m] = arm.end.y;
    }
}

fn main() {
    let model: Shadowed = ::core::default::Default::default();
    let inputs = ShadowedInputs { push: 1.0 };
    let outputs: ShadowedOutputs =
        ::linkwright::Mechanism::outputs(&model, 0.0, &Shadowed::START, &inputs);
    assert!((outputs.height - 0.479_425_538_604_203).abs() < 1e-12);
}
