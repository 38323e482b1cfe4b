//! A choice as in Rust.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
        torque stop: torque(pivot) = if pivot.angle > 0 { -1 [N*m] } else { 0 };
    }
}

fn main() {}
