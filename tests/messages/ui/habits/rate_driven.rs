//! A driver of a rate.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
        drive motor: pivot.rate = 3 [rad/s];
    }
}

fn main() {}
