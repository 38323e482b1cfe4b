//! A damping that gives a force, in the law of a torque.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
        torque t: torque(pivot) = -0.1 [N*s/m]*pivot.rate;
    }
}

fn main() {}
