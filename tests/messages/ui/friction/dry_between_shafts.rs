//! It would hold along two axes that turn with it.

linkwright::mechanism! {
    spatial Bench {
        gravity [m/s^2] = (0, 1, -9.81);
        body shaft { mass [kg] = 2; inertia [kg*m^2] = (0.004, 0.004, 0.002); point far [m] = (0, 0, 0.1); }
        joint knuckle: constant_velocity(ground(0, 0, 0) [m], shaft.far, axis = (0, 0, 1));
        friction rub: on(knuckle) = dry(static = 0.2, radius [mm] = 20);
        start { shaft.orientation = (1, 0, 0, 0); }
    }
}

fn main() {}
