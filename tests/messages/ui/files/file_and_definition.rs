//! A file and a definition.

linkwright::mechanism! {
    file = "misspelt_body.mech",
    planar FourBar { }
}

fn main() {}
