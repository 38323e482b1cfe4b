//! Angles at the start that put teeth on teeth.

linkwright::mechanism! {
    planar Pair {
        body one { mass [kg] = 1; inertia [kg*m^2] = 1e-3; toothing rim: external(teeth = 20, module [mm] = 2); }
        body two { mass [kg] = 1; inertia [kg*m^2] = 1e-3; toothing rim: external(teeth = 20, module [mm] = 2); }
        joint a: revolute(ground(0, 0) [mm], one.center);
        joint b: revolute(ground(40, 0) [mm], two.center);
        gear pair: gear(one.rim, two.rim); start { a.angle [rad] = 0; b.angle [rad] = 0; }
    }
}

fn main() {}
