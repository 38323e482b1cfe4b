//! A revolute joint between places without axes of their own.

linkwright::mechanism! {
    spatial Wrong {
        body arm { mass [kg] = 1; inertia [kg*m^2] = (0.1, 0.1, 0.1); point tip [m] = (1, 0, 0); }
        joint hinge: revolute(ground(0, 0, 0) [m], arm.origin);
    }
}

fn main() {}
