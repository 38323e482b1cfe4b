//! Friction that sticks along one coordinate, in a ball that slides about any axis.

linkwright::mechanism! {
    spatial Mount {
        gravity [m/s^2] = (0, 0, -9.81);
        body bob { mass [kg] = 1; inertia [kg*m^2] = (0.1, 0.1, 0.1); point eye [m] = (0, 0, 0.5); }
        joint ball: spherical(ground(0, 0, 0) [m], bob.eye);
        friction rub: on(ball) = dry(static = 0.5, radius [m] = 0.02);
    }
}

fn main() {}
