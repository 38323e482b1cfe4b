//! A spring that only damps.
#![deny(unused_variables)] // for an error, without which nothing is shown here

linkwright::mechanism! {
    planar Pendulum {
        spring s: spring(arm.end, ground(0, 2) [m], stiffness [N/m] = 0, length [m] = 1, damping [N*s/m] = 3);
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
    }
}

fn main() {
    let the_only_error = ();
}
