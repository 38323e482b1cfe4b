//! A joint in the braces of a body.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
        rod link { mass [kg] = 1; length [m] = 1; joint knee: revolute(arm.end, link.start); }
    }
}

fn main() {}
