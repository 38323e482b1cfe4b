//! An orientation that is none.

linkwright::mechanism! {
    spatial Wrong {
        body arm { mass [kg] = 1; inertia [kg*m^2] = (0.1, 0.1, 0.1); point tip [m] = (1, 0, 0); }
        start { arm.orientation = (0, 0, 0, 0); }
    }
}

fn main() {}
