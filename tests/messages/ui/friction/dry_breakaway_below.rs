//! What holds is less than what slides.

linkwright::mechanism! {
    planar Mount {
        gravity [m/s^2] = (0, -9.81);
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pin: revolute(ground(0, 0) [m], arm.start);
        friction rub: on(pin) = dry(torque [N*m] = 3, breakaway [N*m] = 2);
    }
}

fn main() {}
