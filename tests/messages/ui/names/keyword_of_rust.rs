//! A name that Rust keeps for itself.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
        output type [rad] = pivot.angle;
    }
}

fn main() {}
