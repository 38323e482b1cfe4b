//! A million rods.

linkwright::mechanism! {
    planar Chain {
        repeat i in 0..1000000 {
            rod link[i] { mass [kg] = 1; length [m] = 1; }
        }
    }
}

fn main() {}
