//! An axis that points nowhere.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint rail: prismatic(ground(0, 0) [m], arm.center, axis = (0, 0));
    }
}

fn main() {}
