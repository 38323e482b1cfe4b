//! A damping of the wrong sign.
#![deny(unused_variables)] // for an error, without which nothing is shown here

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
        damper wind: damper(arm.end, ground(0, 2) [m], damping [N*s/m] = -0.1);
    }
}

fn main() {
    let the_only_error = ();
}
