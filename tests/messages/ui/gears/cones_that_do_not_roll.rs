//! Cones of 45 degrees with 20 and 40 teeth.

linkwright::mechanism! {
    spatial Cones {
        body small { mass [kg] = 1; inertia [kg*m^2] = (1e-4, 1e-4, 1e-4); toothing rim: bevel(teeth = 20, module [mm] = 2, cone [deg] = 45); }
        body large { mass [kg] = 1; inertia [kg*m^2] = (1e-4, 1e-4, 1e-4); toothing rim: bevel(teeth = 40, module [mm] = 2, cone [deg] = 45); }
        joint first: revolute(ground(40, 0, 0) [mm], small.center, axis = (1, 0, 0));
        joint second: revolute(ground(0, 0, 20) [mm], large.center, axis = (0, 0, 1));
        gear pair: gear(small.rim, large.rim);
    }
}

fn main() {}
