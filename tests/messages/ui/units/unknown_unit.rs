//! A unit that does not exist, close to one that does.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
        input drive [Nm];
        force motor: torque(pivot) = drive;
    }
}

fn main() {}
