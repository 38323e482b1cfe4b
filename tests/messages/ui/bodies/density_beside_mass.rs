//! A mass, and a density besides.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
        rod link { mass [kg] = 1; length [m] = 1; radius [m] = 0.01; density [kg/m^3] = 7800; }
    }
}

fn main() {}
