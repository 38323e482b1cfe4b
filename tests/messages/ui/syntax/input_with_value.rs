//! An input with a value.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
        input drive [N*m] = 3;
    }
}

fn main() {}
