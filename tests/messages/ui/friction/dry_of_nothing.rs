//! Friction that neither holds nor slides with anything.

linkwright::mechanism! {
    planar Mount {
        gravity [m/s^2] = (0, -9.81);
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pin: revolute(ground(0, 0) [m], arm.start);
        friction rub: on(pin) = dry(radius [m] = 0.02);
    }
}

fn main() {}
