//! The damping ratio of a stiffness that changes with what moves.

linkwright::mechanism! {
    planar Pair {
        body one { mass [kg] = 1; inertia [kg*m^2] = 1e-3; toothing rim: external(teeth = 20, module [mm] = 2); }
        body two { mass [kg] = 1; inertia [kg*m^2] = 1e-3; toothing rim: external(teeth = 20, module [mm] = 2); }
        joint a: revolute(ground(0, 0) [mm], one.center);
        joint b: revolute(ground(40, 0) [mm], two.center);
        mesh teeth: mesh(one.rim, two.rim, stiffness = 1e8 [N/m]*(1 + 0.2*cos(20*a.angle)), damping_ratio = 0.05);
    }
}

fn main() {}
