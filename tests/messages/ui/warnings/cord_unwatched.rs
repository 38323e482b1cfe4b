//! Nothing looks at the tension.
#![deny(unused_variables)] // for an error, without which nothing is shown here

linkwright::mechanism! {
    planar Crane {
        gravity [m/s^2] = (0, -9.81);
        input drawn [m];
        particle load { mass [kg] = 2; }
        rod boom { mass [kg] = 4; length [m] = 1; }
        joint foot: revolute(ground(0, 0) [m], boom.start);
        output angle [rad] = foot.angle;
        joint rope: cord(boom.end, load.center, length [m] = 0.5);
        start { foot.angle [deg] = -60; load.center.x [m] ~ 0.5; load.center.y [m] ~ -1.4; }
        output length [m] = drawn;
    }
}

fn main() {
    let the_only_error = ();
}
