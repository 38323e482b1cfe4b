//! A driver of what two others move together.

linkwright::mechanism! {
    planar Arm {
        rod upper { mass [kg] = 1; length [m] = 1; }
        rod lower { mass [kg] = 1; length [m] = 1; }
        joint shoulder: revolute(ground(0, 0) [m], upper.start);
        joint elbow:    revolute(upper.end, lower.start);
        drive along:  lower.end.x = 1 [m];
        drive across: lower.end.y = 0.5 [m];
        drive turn:   shoulder.angle = 0.2 [rad];
        start { shoulder.angle [rad] ~ 0.3; elbow.angle [rad] ~ 0.5; }
    }
}

fn main() {}
