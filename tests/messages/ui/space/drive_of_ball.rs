//! A driver of something that is no coordinate.

linkwright::mechanism! {
    spatial Wrong {
        body arm { mass [kg] = 1; inertia [kg*m^2] = (0.1, 0.1, 0.1); point tip [m] = (1, 0, 0); }
        joint ball: spherical(ground(0, 0, 0) [m], arm.origin);
        drive spin: arm.rate.x = 3 [rad/s];
    }
}

fn main() {}
