//! A direction, and components besides.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
        force push: force(arm.end, direction = (1, 0)) = (1, 0) [N];
    }
}

fn main() {}
