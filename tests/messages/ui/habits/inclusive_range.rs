//! A range that includes its end.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
        repeat i in 0..=3 { output half[i] [m] = i * 0.5 [m]; }
    }
}

fn main() {}
