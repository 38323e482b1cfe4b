//! Products of inertia too large for the moments.

linkwright::mechanism! {
    spatial Wrong {
        body arm { mass [kg] = 1; inertia [kg*m^2] = (0.1, 0.1, 0.1); products [kg*m^2] = (0.2, 0, 0); point tip [m] = (1, 0, 0); }
        joint hinge: revolute(ground(0, 0, 0) [m], arm.origin, axis = (0, 0, 1));
    }
}

fn main() {}
