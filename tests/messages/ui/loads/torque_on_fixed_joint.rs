//! A torque about a joint that holds every angle.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
        rod tip { mass [kg] = 1; length [m] = 1; }
        joint weld: fixed(arm.end, tip.start);
        torque t: torque(weld) = 1 [N*m];
    }
}

fn main() {}
