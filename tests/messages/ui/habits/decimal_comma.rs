//! A decimal comma.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
        rod link { mass [kg] = 1,5; length [m] = 1; }
    }
}

fn main() {}
