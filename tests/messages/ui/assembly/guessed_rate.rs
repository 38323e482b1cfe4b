//! A guess of a rate, which would have no effect.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
        start { pivot.angle [deg] = 30; pivot.rate [rad/s] ~ 2; }
    }
}

fn main() {}
