//! A load behind a joint.

linkwright::mechanism! {
    planar Mount {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pin: revolute(ground(0, 0), arm.start) = spring(stiffness [N/m] = 1e5);
    }
}

fn main() {}
