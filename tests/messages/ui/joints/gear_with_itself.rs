//! A gear that couples a joint with itself.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
        gear pair: gear(pivot, pivot, ratio = 2);
    }
}

fn main() {}
