//! A torque on a joint with two angles.

linkwright::mechanism! {
    spatial Wrong {
        body arm { mass [kg] = 1; inertia [kg*m^2] = (0.1, 0.1, 0.1); point tip [m] = (1, 0, 0); }
        joint cross: universal(ground(0, 0, 0) [m], arm.origin, axis = (0, 0, 1), second_axis = (0, 1, 0));
        torque motor: torque(cross) = 3 [N*m];
    }
}

fn main() {}
