//! A density, and no thickness.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
        disk wheel { density [kg/m^3] = 7800; radius [m] = 0.1; }
        joint hub: revolute(arm.end, wheel.center);
    }
}

fn main() {}
