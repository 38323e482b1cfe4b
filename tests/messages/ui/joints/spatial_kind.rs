//! A kind of joint of space.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: spherical(ground(0, 0) [m], arm.start);
    }
}

fn main() {}
