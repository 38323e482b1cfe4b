//! A parameter that nothing depends on.
#![deny(unused_variables)] // for an error, without which nothing is shown here

linkwright::mechanism! {
    planar Pendulum {
        param payload [kg] = 2 in 0.5..10;
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
    }
}

fn main() {
    let the_only_error = ();
}
