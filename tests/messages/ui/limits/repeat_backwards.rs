//! Rounds that are counted downwards.

linkwright::mechanism! {
    planar Chain {
        repeat i in 3..1 { rod link[i] { mass [kg] = 1; length [m] = 1; } }
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
    }
}

fn main() {}
