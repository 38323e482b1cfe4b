//! A statement that begins with no known word.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joinnt pivot: revolute(ground(0, 0) [m], arm.start);
    }
}

fn main() {}
