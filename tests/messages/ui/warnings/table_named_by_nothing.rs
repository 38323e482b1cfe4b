//! A table that nothing names.
#![deny(unused_variables)] // for an error, without which nothing is shown here

linkwright::mechanism! {
    planar Pendulum {
        table law(angle [deg]) [N*m] = [(-90, 1), (0, 0), (90, -1)];
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
    }
}

fn main() {
    let the_only_error = ();
}
