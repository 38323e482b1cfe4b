//! A power as other languages write it.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
        param a [m^2] = 2 ** 2;
    }
}

fn main() {}
