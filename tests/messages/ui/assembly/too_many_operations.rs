//! A budget that is exceeded.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
        expect { operations(outputs) <= 1; }
        output thrice [rad/s] = 3*pivot.rate;
        output fivefold [rad/s] = 5*pivot.rate;
    }
}

fn main() {}
