//! A marker whose reference points along its axis.

linkwright::mechanism! {
    spatial Wrong {
        body arm { mass [kg] = 1; inertia [kg*m^2] = (0.1, 0.1, 0.1); marker tip [m] = (1, 0, 0), axis = (0, 0, 1), reference = (0, 0, 2); }
        joint hinge: revolute(ground(0, 0, 0) [m], arm.origin, axis = (0, 0, 1));
    }
}

fn main() {}
