//! A folder.

linkwright::mechanism!(file = "../files");

fn main() {}
