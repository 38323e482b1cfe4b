//! A point that nothing names.
#![deny(unused_variables)] // for an error, without which nothing is shown here

linkwright::mechanism! {
    planar Pendulum {
        body plate { mass [kg] = 1; inertia [kg*m^2] = 1; point corner [m] = (0.1, 0.1); }
        joint hinge: revolute(arm.end, plate.origin);
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
    }
}

fn main() {
    let the_only_error = ();
}
