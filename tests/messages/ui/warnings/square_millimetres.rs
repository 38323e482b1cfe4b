//! A moment of inertia in kg mm², said to be in kg m².
#![deny(unused_variables)] // for an error, without which nothing is shown here

linkwright::mechanism! {
    planar Pendulum {
        body arm { mass [kg] = 1.2; inertia [kg*m^2] = 4000; point eye [m] = (0.2, 0); }
        joint pivot: revolute(ground(0, 0), arm.eye);
    }
}

fn main() {
    let the_only_error = ();
}
