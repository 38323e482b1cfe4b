//! A function that does not exist.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
        output x [1] = sine(pivot.angle);
    }
}

fn main() {}
