//! The inertia of space in the plane.

linkwright::mechanism! {
    planar Pendulum {
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pivot: revolute(ground(0, 0), arm.start);
        body plate { mass [kg] = 1; inertia [kg*m^2] = (1, 1, 2); }
    }
}

fn main() {}
