//! Two drivers of one angle under two names, which agree at the start.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
        drive motor: pivot.angle = 1 [rad] + 2 [rad/s] * time;
        drive brake: arm.angle = 1 [rad] + 2 [rad/s] * time;
    }
}

fn main() {}
