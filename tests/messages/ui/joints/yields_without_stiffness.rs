//! A penalty that does not say how stiffly it holds a turn.

linkwright::mechanism! {
    planar Mount {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint wall: fixed(ground(0, 0), arm.start) = penalty(stiffness [N/m] = 1e5);
    }
}

fn main() {}
