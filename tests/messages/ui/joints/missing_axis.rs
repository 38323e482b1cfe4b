//! A prismatic joint without its axis.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint rail: prismatic(ground(0, 0) [m], arm.center);
    }
}

fn main() {}
