//! A joint of space by another name.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
        joint stop: ball(ground(1, 0) [m], arm.end);
    }
}

fn main() {}
