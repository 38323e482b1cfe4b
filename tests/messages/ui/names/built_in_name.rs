//! A name that the language keeps for itself.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
        param time [s] = 1;
    }
}

fn main() {}
