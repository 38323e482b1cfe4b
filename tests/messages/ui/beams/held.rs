//! Joints and loads that a beam does not take.

linkwright::mechanism! {
    planar Held {
        beam rod { length [m] = 1; section = circle(diameter [mm] = 7); young [GPa] = 70; mass [kg] = 1; shapes = pinned; }
        beam arm { length [m] = 1; section = circle(diameter [mm] = 7); young [GPa] = 70; mass [kg] = 1; }
        body sled { mass [kg] = 1; inertia [kg*m^2] = 1; }
        disk wheel { mass [kg] = 1; radius [m] = 0.1; }
        joint clamp: fixed(ground(0, 0) [m], rod.start);
        joint rail: prismatic(arm.end, sled.center, axis = (1, 0));
        joint axle: revolute(ground(0, 0) [m], wheel.center);
        joint middle: revolute(arm.origin, sled.center);
        torque twist: torque(arm) = 1 [N*m];
        gear mesh: gear(arm, axle, ratio = 2);
        bushing rubber: bushing(arm.end, ground(0, 0) [m], stiffness [N/m] = 3, torsional_stiffness = 0);
    }
}

fn main() {}
