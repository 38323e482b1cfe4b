//! A point without its body.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
        joint knee: revolute(ground(1, 0) [m], end);
    }
}

fn main() {}
