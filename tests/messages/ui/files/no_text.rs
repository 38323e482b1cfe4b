//! A file that is not UTF-8.

linkwright::mechanism!(file = "no_text.mech");

fn main() {}
