//! Beams that start as their loads bend them, and how far that may be.

linkwright::mechanism! {
    planar Far {
        gravity [m/s^2] = (0, -9.81);
        beam arm { length [m] = 1; section = circle(diameter [mm] = 8); young [GPa] = 70; density [kg/m^3] = 2700; shapes = clamped; }
        body load { mass [kg] = 1; inertia [kg*m^2] = 1; }
        joint foot: fixed(ground(0, 0) [m], arm.start);
        joint top: fixed(arm.end, load.center);
        start { arm = static; }
        expect { deflection(arm.end) <= 1 [mm]; }
    }
}

linkwright::mechanism! {
    planar NoBeam {
        body load { mass [kg] = 1; inertia [kg*m^2] = 1; }
        joint foot: revolute(ground(0, 0) [m], load.center);
        start { load = static; }
        expect { deflection(load.center) <= 1 [mm]; }
    }
}

linkwright::mechanism! {
    planar Twice {
        beam arm { length [m] = 1; section = circle(diameter [mm] = 8); young [GPa] = 70; density [kg/m^3] = 2700; shapes = clamped; }
        joint foot: fixed(ground(0, 0) [m], arm.start);
        start { arm = static; arm.bending[0] [mm] = 1; }
    }
}

linkwright::mechanism! {
    planar Held {
        gravity [m/s^2] = (0, -9.81);
        beam arm { length [m] = 1; section = circle(diameter [mm] = 8); young [GPa] = 70; density [kg/m^3] = 2700; modes = (bending = 5); }
        body sled { mass [kg] = 1; inertia [kg*m^2] = 1; }
        joint left: fixed(ground(0, 0) [m], arm.start);
        joint right: fixed(sled.center, arm.end);
        joint rail: prismatic(ground(0, 0) [m], sled.center, axis = (1, 0));
        start { arm = static; arm.angle [rad] ~ 0; rail.travel [m] ~ 1; }
    }
}

fn main() {}
