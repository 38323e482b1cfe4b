//! A part that is declared and not used.
#![deny(unused_variables)] // for an error, without which nothing is shown here

linkwright::mechanism! {
    planar Pendulum {
        part Bob(hook: place) { particle weight { mass [kg] = 1; } joint pin: revolute(hook, weight.center); }
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
    }
}

fn main() {
    let the_only_error = ();
}
