//! A spring between two points of one body.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
        spring s: spring(arm.start, arm.end, stiffness [N/m] = 100, length [m] = 1);
    }
}

fn main() {}
