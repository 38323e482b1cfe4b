//! Products of inertia beside no moments.

linkwright::mechanism! {
    spatial Wrong {
        cylinder arm { mass [kg] = 1; length [m] = 1; radius [m] = 0.1; products [kg*m^2] = (0.1, 0, 0); }
        joint hinge: revolute(ground(0, 0, 0) [m], arm.start, axis = (0, 0, 1));
    }
}

fn main() {}
