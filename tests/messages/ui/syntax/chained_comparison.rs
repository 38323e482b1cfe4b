//! Comparisons that are chained.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
        output x [1] = if(0 < 1 < 2, 1, 0);
    }
}

fn main() {}
