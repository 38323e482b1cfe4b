//! Everything that is declared and not used, and what takes it back.
#![deny(unused_variables)] // for an error, without which nothing is shown here

linkwright::mechanism! {
    planar Pendulum {
        const LENGTH [m] = 1;
        #[allow(unused)] const SPARE [m] = 1;
        param _reserved [kg] = 1;
        input drive [N*m];
        line rail = (ground(0, 0), ground(1, 0) [m]);
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
    }
}

fn main() {
    let the_only_error = ();
}
