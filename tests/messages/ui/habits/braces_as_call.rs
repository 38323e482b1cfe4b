//! Properties in parentheses.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
        rod link(mass = 1, length = 1);
    }
}

fn main() {}
