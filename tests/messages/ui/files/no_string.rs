//! The name of a file is a string.

linkwright::mechanism!(file = misspelt_body);

fn main() {}
