//! A file that is not there, with a name close to one that is.

linkwright::mechanism!(file = "mispelt_body.mech");

fn main() {}
