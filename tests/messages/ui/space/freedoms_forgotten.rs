//! Fewer degrees of freedom expected than there are.

linkwright::mechanism! {
    spatial Wrong {
        body arm { mass [kg] = 1; inertia [kg*m^2] = (0.1, 0.1, 0.1); point tip [m] = (1, 0, 0); }
        joint ball: spherical(ground(0, 0, 0) [m], arm.tip);
        expect { degrees_of_freedom = 1; }
    }
}

fn main() {}
