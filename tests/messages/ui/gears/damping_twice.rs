//! Damping and its ratio.

linkwright::mechanism! {
    planar Pair {
        body one { mass [kg] = 1; inertia [kg*m^2] = 1e-3; toothing rim: external(teeth = 20, module [mm] = 2, face_width [mm] = 20); }
        body two { mass [kg] = 1; inertia [kg*m^2] = 1e-3; toothing rim: external(teeth = 20, module [mm] = 2, face_width [mm] = 20); }
        joint a: revolute(ground(0, 0) [mm], one.center);
        joint b: revolute(ground(40, 0) [mm], two.center);
        mesh teeth: mesh(one.rim, two.rim, stiffness [N/m] = 1e8, damping [N*s/m] = 60, damping_ratio = 0.05);
    }
}

fn main() {}
