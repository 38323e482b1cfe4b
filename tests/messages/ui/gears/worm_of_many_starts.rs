//! A worm with the teeth of its wheel.

linkwright::mechanism! {
    spatial Drive {
        body small { mass [kg] = 1; inertia [kg*m^2] = (1e-4, 1e-4, 1e-4); toothing rim: worm(starts = 40, module [mm] = 2, diameter [mm] = 20); }
        body large { mass [kg] = 1; inertia [kg*m^2] = (1e-4, 1e-4, 1e-4); toothing rim: external(teeth = 40, module [mm] = 2); }
        joint first: revolute(ground(0, 0, 0) [mm], small.center, axis = (1, 0, 0));
        joint second: revolute(ground(0, 50, 0) [mm], large.center, axis = (0, 0, 1));
        gear pair: gear(small.rim, large.rim);
    }
}

fn main() {}
