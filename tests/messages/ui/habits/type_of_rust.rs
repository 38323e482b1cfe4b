//! A type for a unit.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
        param payload: f64 = 1;
    }
}

fn main() {}
