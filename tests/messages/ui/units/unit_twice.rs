//! A unit beside the name and behind the parentheses.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
        gravity [m/s^2] = (0, -9.81) [m/s^2];
    }
}

fn main() {}
