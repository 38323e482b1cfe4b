//! A force on what cannot move.
#![deny(unused_variables)] // for an error, without which nothing is shown here

linkwright::mechanism! {
    planar Pendulum {
        box frame { mass [kg] = 1; width [m] = 1; height [m] = 1; }
        joint weld: fixed(ground(0, 0), frame.center);
        force push: force(frame.center) = (1, 0) [N];
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
    }
}

fn main() {
    let the_only_error = ();
}
