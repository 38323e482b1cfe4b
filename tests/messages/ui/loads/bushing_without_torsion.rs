//! A bushing of which is not said how it turns.

linkwright::mechanism! {
    planar Mount {
        rod arm { mass [kg] = 1; length [m] = 1; }
        bushing b: bushing(ground(0, 0), arm.start, stiffness [N/m] = (100, 200));
    }
}

fn main() {}
