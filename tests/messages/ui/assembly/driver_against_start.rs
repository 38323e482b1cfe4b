//! A start that contradicts a driver.

linkwright::mechanism! {
    planar Arm {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
        drive motor: pivot.angle = 0.5 [rad] + 2 [rad/s] * time;
        start { pivot.angle [deg] = 60; }
    }
}

fn main() {}
