//! A driver where nothing can move.

linkwright::mechanism! {
    planar Triangle {
        rod left  { mass [kg] = 1; length [m] = 1; }
        rod right { mass [kg] = 1; length [m] = 1; }
        joint foot:  revolute(ground(0, 0) [m], left.start);
        joint toe:   revolute(ground(1, 0) [m], right.start);
        joint top:   revolute(left.end, right.end);
        drive motor: foot.angle = 60 [deg] + 2 [rad/s] * time;
        start { foot.angle [deg] ~ 60; }
    }
}

fn main() {}
