//! A body without a mass.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
    }
}

fn main() {}
