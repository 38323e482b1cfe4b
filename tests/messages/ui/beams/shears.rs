//! Beams whose sections shear: what they lack, and what they cannot have.

linkwright::mechanism! {
    planar Soft {
        beam rod { length [m] = 1; section = circle(diameter [mm] = 80); young [GPa] = 210; mass [kg] = 1; theory = timoshenko; }
        joint foot: fixed(ground(0, 0) [m], rod.start);
    }
}

linkwright::mechanism! {
    planar Stated {
        beam rod { length [m] = 1; area [mm^2] = 500; second_moment [mm^4] = 3e5; young [GPa] = 210; shear_modulus [GPa] = 80; mass [kg] = 1;
                   theory = timoshenko; }
        joint foot: fixed(ground(0, 0) [m], rod.start);
    }
}

linkwright::mechanism! {
    planar Factor {
        beam rod { length [m] = 1; section = circle(diameter [mm] = 80); young [GPa] = 210; shear_modulus [GPa] = 80; mass [kg] = 1;
                   theory = timoshenko; shear_factor = 1.2; }
        joint foot: fixed(ground(0, 0) [m], rod.start);
    }
}

linkwright::mechanism! {
    planar Poisson {
        beam rod { length [m] = 1; section = circle(diameter [mm] = 80); young [GPa] = 210; shear_modulus [GPa] = 60; mass [kg] = 1;
                   theory = timoshenko; }
        joint foot: fixed(ground(0, 0) [m], rod.start);
    }
}

linkwright::mechanism! {
    planar CutOff {
        beam rod { length [m] = 1; section = circle(diameter [mm] = 200); young [GPa] = 210; shear_modulus [GPa] = 80; mass [kg] = 1;
                   theory = timoshenko; modes = (bending = 12); }
        joint foot: fixed(ground(0, 0) [m], rod.start);
    }
}

linkwright::mechanism! {
    planar Shapes {
        beam rod { length [m] = 1; section = circle(diameter [mm] = 80); young [GPa] = 210; shear_modulus [GPa] = 80; mass [kg] = 1;
                   theory = timoshenko; shapes = static; }
        joint foot: fixed(ground(0, 0) [m], rod.start);
    }
}

linkwright::mechanism! {
    planar Idle {
        beam rod { length [m] = 1; section = circle(diameter [mm] = 80); young [GPa] = 210; mass [kg] = 1; shear_factor = 0.9; }
        joint foot: fixed(ground(0, 0) [m], rod.start);
    }
}

fn main() {}
