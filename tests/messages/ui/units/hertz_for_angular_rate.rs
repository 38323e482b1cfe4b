//! A frequency where an angular rate is expected.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
        start { pivot.rate [Hz] = 1; }
    }
}

fn main() {}
