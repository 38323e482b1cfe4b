//! A torque on what cannot turn.
#![deny(unused_variables)] // for an error, without which nothing is shown here

linkwright::mechanism! {
    planar Pendulum {
        box slider { mass [kg] = 1; width [m] = 1; height [m] = 1; }
        joint rail: prismatic(ground(0, 0), slider.center, axis = (1, 0));
        force twist: torque(slider) = 1 [N*m];
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
    }
}

fn main() {
    let the_only_error = ();
}
