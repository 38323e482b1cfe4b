//! A string that never ends.

linkwright::mechanism!(file = "string_unterminated.mech");

fn main() {}
