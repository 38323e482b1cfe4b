//! A property that a rod does not have.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mas [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
    }
}

fn main() {}
