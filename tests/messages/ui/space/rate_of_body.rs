//! An angular velocity without a component.

linkwright::mechanism! {
    spatial Wrong {
        body arm { mass [kg] = 1; inertia [kg*m^2] = (0.1, 0.1, 0.1); point tip [m] = (1, 0, 0); }
        joint hinge: revolute(ground(0, 0, 0) [m], arm.origin, axis = (0, 0, 1));
        output spin [rad/s] = arm.rate;
    }
}

fn main() {}
