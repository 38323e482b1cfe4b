//! A value that is not declared.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
        const LENGTH [m] = 1;
        output x [m] = LENGHT;
    }
}

fn main() {}
