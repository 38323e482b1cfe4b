//! A part of the library on a joint that does not turn.

linkwright::mechanism! {
    planar Walker {
        gravity [m/s^2] = (0, -9.81);
        body hull { mass [kg] = 10; inertia [kg*m^2] = 1; point left [m] = (-0.2, 0); }
        joint rail: prismatic(ground(0, 1) [m], hull.center, axis = (1, 0));
        part motor: DcMotor(shaft = rail, voltage [V] = 12, resistance [ohm] = 1, inductance [H] = 0.1, constant [N*m/A] = 0.1);
    }
}

fn main() {}
