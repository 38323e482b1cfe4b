//! A marker with an axis and a turn.

linkwright::mechanism! {
    spatial Wrong {
        body arm { mass [kg] = 1; inertia [kg*m^2] = (0.1, 0.1, 0.1); marker tip [m] = (1, 0, 0), axis = (0, 0, 1), about_x [deg] = 90; }
        joint hinge: revolute(ground(0, 0, 0) [m], arm.origin, axis = (0, 0, 1));
    }
}

fn main() {}
