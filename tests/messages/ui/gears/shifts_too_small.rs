//! Shifts with which teeth are too thin to touch on both sides.

linkwright::mechanism! {
    planar Pair {
        body one { mass [kg] = 1; inertia [kg*m^2] = 1e-3; toothing rim: external(teeth = 10, module [mm] = 2, shift = -0.5); }
        body two { mass [kg] = 1; inertia [kg*m^2] = 1e-3; toothing rim: external(teeth = 10, module [mm] = 2, shift = -0.5); }
        joint a: revolute(ground(0, 0) [mm], one.center);
        joint b: revolute(ground(19, 0) [mm], two.center);
        gear pair: gear(one.rim, two.rim);
    }
}

fn main() {}
