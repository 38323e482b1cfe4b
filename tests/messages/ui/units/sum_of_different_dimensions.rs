//! A sum of a length and an angle.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
        output x [m] = arm.end.x + pivot.angle;
    }
}

fn main() {}
