//! A point driven along the line to its pivot: at the start no turning moves it that way.

linkwright::mechanism! {
    planar Arm {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
        drive pull: arm.end.x = -1 [m] + 0.1 [m/s^2] * time^2;
        start { pivot.angle [deg] ~ 180; }
    }
}

fn main() {}
