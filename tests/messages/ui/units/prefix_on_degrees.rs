//! A prefix on a unit that takes none.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
        start { pivot.angle [mdeg] = 1; }
    }
}

fn main() {}
