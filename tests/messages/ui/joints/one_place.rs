//! A joint with one place.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(arm.start);
    }
}

fn main() {}
