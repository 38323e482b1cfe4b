//! What does not stiffen, and axial shapes that are not where the frame is.

linkwright::mechanism! {
    planar Straight {
        beam bar { length [m] = 1; section = circle(diameter [mm] = 8); young [GPa] = 200; density [kg/m^3] = 7800;
                   modes = (axial = 2); stiffening = on; }
        joint pin: revolute(ground(0, 0) [m], bar.start);
    }
}

linkwright::mechanism! {
    planar Twice {
        beam bar { length [m] = 1; section = circle(diameter [mm] = 8); young [GPa] = 200; density [kg/m^3] = 7800;
                   stiffening = on; stiffening = off; }
        joint pin: revolute(ground(0, 0) [m], bar.start);
    }
}

linkwright::mechanism! {
    planar Elements {
        beam bar { length [m] = 1; section = circle(diameter [mm] = 8); young [GPa] = 200; density [kg/m^3] = 7800;
                   modes = (axial = quadratic, bending = 2); }
        joint pin: revolute(ground(0, 0) [m], bar.start);
    }
}

linkwright::mechanism! {
    planar Across {
        beam bar { length [m] = 1; section = circle(diameter [mm] = 8); young [GPa] = 200; density [kg/m^3] = 7800;
                   modes = (bending = quadratic); }
        joint pin: revolute(ground(0, 0) [m], bar.start);
    }
}

fn main() {}
