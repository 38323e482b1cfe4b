//! A damper between two places, where that of a joint was meant.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
        damper friction: damper(pivot, damping [N*m*s] = 0.1);
    }
}

fn main() {}
