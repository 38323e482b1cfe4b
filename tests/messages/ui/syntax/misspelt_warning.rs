//! A warning that does not exist.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
        #[allow(unusd)] const SPARE [m] = 1;
    }
}

fn main() {}
