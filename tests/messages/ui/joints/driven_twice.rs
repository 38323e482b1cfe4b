//! Two drivers of one quantity.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
        drive first: pivot.angle = 1 [rad/s]*time;
        drive second: pivot.angle = 2 [rad/s]*time;
    }
}

fn main() {}
