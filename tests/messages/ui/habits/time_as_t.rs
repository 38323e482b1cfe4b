//! The letter of time.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
        drive motor: pivot.angle = 3 [rad/s]*t;
    }
}

fn main() {}
