//! A part that is there only sometimes.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
        #[cfg(feature = "long")] rod link { mass [kg] = 1; length [m] = 1; }
    }
}

fn main() {}
