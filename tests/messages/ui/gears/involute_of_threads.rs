//! Threads of a worm have no stiffness by the shape of involute teeth.

linkwright::mechanism! {
    spatial Drive {
        const LEAD [rad] = atan2(2, 20);
        body screw { mass [kg] = 1; inertia [kg*m^2] = (1e-4, 1e-4, 1e-4); toothing thread: worm(starts = 1, module [mm] = 2, diameter [mm] = 20); }
        body wheel { mass [kg] = 1; inertia [kg*m^2] = (1e-4, 1e-4, 1e-4); toothing rim: external(teeth = 40, module = 2 [mm]*cos(LEAD), helix = LEAD, face_width [mm] = 16); }
        joint a: revolute(ground(0, 0, 0), screw.center, axis = (1, 0, 0));
        joint b: revolute(ground(0, 50, 0) [mm], wheel.center, axis = (0, 0, 1));
        mesh teeth: mesh(screw.thread, wheel.rim, stiffness = involute(young [GPa] = 210));
    }
}

fn main() {}
