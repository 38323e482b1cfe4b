//! A dimension that does not fit the property.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [m] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
    }
}

fn main() {}
