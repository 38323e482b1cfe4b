//! Axes that are neither held nor moving; damping that acts always where they move; centres too far apart.

linkwright::mechanism! {
    planar Floats {
        body one { mass [kg] = 1; inertia [kg*m^2] = 1e-3; toothing rim: external(teeth = 20, module [mm] = 2); }
        body two { mass [kg] = 1; inertia [kg*m^2] = 1e-3; toothing rim: external(teeth = 20, module [mm] = 2); }
        joint b: revolute(ground(40, 0) [mm], two.center);
        mesh teeth: mesh(one.rim, two.rim, stiffness [N/m] = 1e7, axes = floating);
    }
}

linkwright::mechanism! {
    planar Damped {
        body one { mass [kg] = 1; inertia [kg*m^2] = 1e-3; toothing rim: external(teeth = 20, module [mm] = 2); }
        body two { mass [kg] = 1; inertia [kg*m^2] = 1e-3; toothing rim: external(teeth = 20, module [mm] = 2); }
        joint b: revolute(ground(40, 0) [mm], two.center);
        mesh teeth: mesh(one.rim, two.rim, stiffness [N/m] = 1e7, damping = always(60 [N*s/m]), axes = moving);
    }
}

linkwright::mechanism! {
    planar Unheld {
        body one { mass [kg] = 1; inertia [kg*m^2] = 1e-3; toothing rim: external(teeth = 20, module [mm] = 2); }
        body two { mass [kg] = 1; inertia [kg*m^2] = 1e-3; toothing rim: external(teeth = 20, module [mm] = 2); }
        joint b: revolute(ground(40, 0) [mm], two.center);
        mesh teeth: mesh(one.rim, two.rim, stiffness [N/m] = 1e7);
    }
}

linkwright::mechanism! {
    planar Far {
        body one { mass [kg] = 1; inertia [kg*m^2] = 1e-3; toothing rim: external(teeth = 20, module [mm] = 2); }
        body two { mass [kg] = 1; inertia [kg*m^2] = 1e-3; toothing rim: external(teeth = 20, module [mm] = 2); }
        joint b: revolute(ground(60, 0) [mm], two.center);
        mesh teeth: mesh(one.rim, two.rim, stiffness [N/m] = 1e7, axes = moving);
        start { one.center.x [mm] = 0; one.center.y [mm] = 0; }
    }
}

linkwright::mechanism! {
    spatial Tilts {
        body one { mass [kg] = 1; inertia [kg*m^2] = (1e-3, 1e-3, 1e-3); toothing rim: external(teeth = 20, module [mm] = 2); }
        body two { mass [kg] = 1; inertia [kg*m^2] = (1e-3, 1e-3, 1e-3); toothing rim: external(teeth = 20, module [mm] = 2); }
        joint b: revolute(ground(40, 0, 0) [mm], two.center, axis = (0, 0, 1));
        mesh teeth: mesh(one.rim, two.rim, stiffness [N/m] = 1e7, axes = moving);
    }
}

fn main() {}
