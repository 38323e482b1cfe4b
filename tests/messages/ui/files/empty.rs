//! An empty file.

linkwright::mechanism!(file = "empty.mech");

fn main() {}
