//! A quantity that a joint of this kind does not have.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
        output travelled [m] = pivot.travel;
    }
}

fn main() {}
