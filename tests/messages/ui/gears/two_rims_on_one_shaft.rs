//! A mesh between two toothings of one body.

linkwright::mechanism! {
    planar Pair {
        body one { mass [kg] = 1; inertia [kg*m^2] = 1e-3; toothing near: external(teeth = 20, module [mm] = 2); toothing far: external(teeth = 30, module [mm] = 2); }
        joint a: revolute(ground(0, 0), one.center);
        mesh teeth: mesh(one.near, one.far, stiffness [N/m] = 1e8);
    }
}

fn main() {}
