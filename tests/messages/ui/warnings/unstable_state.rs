//! A rate with the wrong sign.
#![deny(unused_variables)] // for an error, without which nothing is shown here

linkwright::mechanism! {
    planar Filtered {
        state felt [rad/s] = 0;
        rate  felt = (felt - pivot.rate)/1e-4 [s];
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
        output felt [rad/s] = felt;
    }
}

fn main() {
    let the_only_error = ();
}
