//! A name without the index of the round.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
        repeat i in 0..3 { rod link { mass [kg] = 1; length [m] = 1; } }
    }
}

fn main() {}
