//! The power of what is no load.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
        output lost [W] = power(pivot);
    }
}

fn main() {}
