//! A body that nothing is attached to.
#![deny(unused_variables)] // for an error, without which nothing is shown here

linkwright::mechanism! {
    planar Pendulum {
        rod spare { mass [kg] = 1; length [m] = 1; }
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
    }
}

fn main() {
    let the_only_error = ();
}
