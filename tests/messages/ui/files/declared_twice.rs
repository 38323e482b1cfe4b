//! Two places of a file in one message.

linkwright::mechanism!(file = "declared_twice.mech");

fn main() {}
