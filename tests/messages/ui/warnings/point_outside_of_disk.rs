//! A point beyond the rim.
#![deny(unused_variables)] // for an error, without which nothing is shown here

linkwright::mechanism! {
    planar Pendulum {
        disk wheel { mass [kg] = 1; radius [mm] = 100; point rim [mm] = (0, 120); }
        joint hinge: revolute(arm.end, wheel.rim);
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
    }
}

fn main() {
    let the_only_error = ();
}
