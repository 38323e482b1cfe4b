//! Principal moments that break the triangle inequality.

linkwright::mechanism! {
    spatial Wrong {
        body arm { mass [kg] = 1; inertia [kg*m^2] = (1, 1, 3); point tip [m] = (1, 0, 0); }
        joint hinge: revolute(ground(0, 0, 0) [m], arm.origin, axis = (0, 0, 1));
    }
}

fn main() {}
