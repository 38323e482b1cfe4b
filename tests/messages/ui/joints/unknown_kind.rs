//! A kind of joint that does not exist.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolte(ground(0, 0) [m], arm.start);
    }
}

fn main() {}
