//! The symbol of a stiffness for its name.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
        spring s: spring(arm.end, ground(0, 1) [m], k [N/m] = 100, length [m] = 1);
    }
}

fn main() {}
