//! A named argument without its name.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
        disk wheel { mass [kg] = 1; radius [m] = 1; }
        joint hub: revolute(arm.end, wheel.center);
        gear g: gear(pivot, hub, 2);
    }
}

fn main() {}
