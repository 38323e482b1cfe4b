//! Places that are not on the axis of a beam, and modes that it has not.

linkwright::mechanism! {
    planar Beams {
        param at [m] = 0.1;
        beam rod { length [m] = 1; section = circle(diameter [mm] = 7); young [GPa] = 70; mass [kg] = 1;
                   point aside [m] = (0.1, 0.01); point far [m] = (0.6, 0); point moved = (at, 0 [m]); }
        beam arm { length [m] = 1; section = circle(diameter [mm] = 7); young [GPa] = 70; mass [kg] = 1; shapes = clamped;
                   point before [m] = (-0.1, 0); point end [m] = (0.5, 0); }
    }
}

linkwright::mechanism! {
    planar Modes {
        beam rod { length [m] = 1; section = circle(diameter [mm] = 7); young [GPa] = 70; mass [kg] = 1; }
        joint pin: revolute(ground(0, 0) [m], rod.start);
        output fourth [mm] = rod.bending[3];
        output along [mm] = rod.axial[0];
    }
}

fn main() {}
