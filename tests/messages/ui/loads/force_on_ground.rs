//! A force on what nothing moves.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
        force push: force(ground(0, 0)) = (1, 0) [N];
    }
}

fn main() {}
