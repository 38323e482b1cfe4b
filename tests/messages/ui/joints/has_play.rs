//! Joints with play.

linkwright::mechanism! {
    planar Firm {
        body arm { mass [kg] = 1; inertia [kg*m^2] = 0.1; }
        joint pin: fixed(ground(0, 0) [m], arm.origin, play [mm] = 0.5, radius [mm] = 10) = kelvin_voigt(stiffness [N/m] = 1e6);
    }
}

linkwright::mechanism! {
    planar Lawless {
        body arm { mass [kg] = 1; inertia [kg*m^2] = 0.1; }
        joint pin: revolute(ground(0, 0) [m], arm.origin, play [mm] = 0.5, radius [mm] = 10);
    }
}

linkwright::mechanism! {
    planar Wide {
        body arm { mass [kg] = 1; inertia [kg*m^2] = 0.1; }
        joint pin: revolute(ground(0, 0) [m], arm.origin, play [mm] = 20, radius [mm] = 10) = kelvin_voigt(stiffness [N/m] = 1e6);
    }
}

linkwright::mechanism! {
    planar Reaction {
        body arm { mass [kg] = 1; inertia [kg*m^2] = 0.1; }
        joint pin: revolute(ground(0, 0) [m], arm.origin, play [mm] = 0.5, radius [mm] = 10) = kelvin_voigt(stiffness [N/m] = 1e6);
        output pressed [N] = pin.reaction.size;
    }
}

linkwright::mechanism! {
    spatial Axis {
        body arm { mass [kg] = 1; inertia [kg*m^2] = (0.1, 0.1, 0.1); }
        joint pin: revolute(ground(0, 0, 0) [m], arm.origin, axis = (0, 0, 1), play [mm] = 0.5, radius [mm] = 10) = kelvin_voigt(stiffness [N/m] = 1e6);
    }
}

linkwright::mechanism! {
    planar Spring {
        body arm { mass [kg] = 1; inertia [kg*m^2] = 0.1; }
        joint pin: revolute(ground(0, 0) [m], arm.origin);
        torsion_spring bar: torsion_spring(pin, stiffness [N*m/rad] = 5, play [rad] = 0);
    }
}

fn main() {}
