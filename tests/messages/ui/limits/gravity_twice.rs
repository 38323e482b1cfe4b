//! Gravity, and again.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
        gravity [m/s^2] = (0, -9.81);
        gravity [m/s^2] = (0, -1.62);
    }
}

fn main() {}
