//! The kind of the mechanism is missing.

linkwright::mechanism! {
    Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
    }
}

fn main() {}
