//! A file holds what stands inside of the macro's braces.

linkwright::mechanism!(file = "macro_inside.mech");

fn main() {}
