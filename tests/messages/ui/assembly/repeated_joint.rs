//! A joint that repeats what another does already.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
        joint again: revolute(ground(0, 0) [m], arm.start);
    }
}

fn main() {}
