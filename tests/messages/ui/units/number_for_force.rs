//! A law that is a plain number where a force is expected.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
        force push: force(arm.end, direction = (1, 0)) = 3;
    }
}

fn main() {}
