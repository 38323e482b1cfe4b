//! A default that its own bounds exclude.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0) [m], arm.start);
        param load [kg] = 5 in 0..2;
    }
}

fn main() {}
