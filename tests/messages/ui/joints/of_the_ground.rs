//! A joint between two places of the ground.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
        joint nothing: revolute(ground(0, 0), ground(1, 0) [m]);
    }
}

fn main() {}
