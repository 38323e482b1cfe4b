//! A unit that is converted by hand.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
        const REACH [inch] = 3;
    }
}

fn main() {}
