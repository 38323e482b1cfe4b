//! A parenthesis closed by a brace.

linkwright::mechanism!(file = "wrong_delimiter.mech");

fn main() {}
