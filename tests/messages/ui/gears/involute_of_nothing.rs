//! A shape of teeth that there is not.

linkwright::mechanism! {
    planar Pair {
        body one { mass [kg] = 1; inertia [kg*m^2] = 1e-3; toothing rim: external(teeth = 20, module [mm] = 2, face_width [mm] = 20); }
        body two { mass [kg] = 1; inertia [kg*m^2] = 1e-3; toothing rim: external(teeth = 20, module [mm] = 2, face_width [mm] = 20); }
        joint a: revolute(ground(0, 0) [mm], one.center);
        joint b: revolute(ground(40, 0) [mm], two.center);
        mesh teeth: mesh(one.rim, two.rim, stiffness = involute(young [GPa] = 210, tooth = round));
    }
}

fn main() {}
