//! A mistake that is found by assembling what the file defines.

linkwright::mechanism!(file = "loop_cannot_close.mech");

fn main() {}
