//! A quantity in quotes.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
        rod link { mass = "1 kg"; length [m] = 1; }
    }
}

fn main() {}
