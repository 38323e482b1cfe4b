//! What does not twist, or lacks what resists it.

linkwright::mechanism! {
    spatial Soft {
        beam shaft { length [m] = 1; section = circle(diameter [mm] = 10); young [GPa] = 210; density [kg/m^3] = 7800;
                     modes = (torsion = 2); }
        joint base: fixed(ground(0, 0, 0) [m], shaft.start);
    }
}

linkwright::mechanism! {
    spatial Straight {
        beam shaft { length [m] = 1; section = circle(diameter [mm] = 10); young [GPa] = 210; density [kg/m^3] = 7800;
                     shear_modulus [GPa] = 80; modes = (bending_y = 2); }
        joint base: fixed(ground(0, 0, 0) [m], shaft.start);
    }
}

linkwright::mechanism! {
    spatial Open {
        beam shaft { length [m] = 1; area [mm^2] = 78; second_moment_z [mm^4] = 490; second_moment_y [mm^4] = 490; young [GPa] = 210;
                     shear_modulus [GPa] = 80; density [kg/m^3] = 7800; modes = (torsion = 2); }
        joint base: fixed(ground(0, 0, 0) [m], shaft.start);
    }
}

linkwright::mechanism! {
    planar Flat {
        beam shaft { length [m] = 1; section = circle(diameter [mm] = 10); young [GPa] = 210; density [kg/m^3] = 7800;
                     modes = (torsion = 2); }
        joint base: fixed(ground(0, 0) [m], shaft.start);
    }
}

linkwright::mechanism! {
    spatial Length {
        beam shaft { length [m] = 1; section = circle(diameter [mm] = 10); young [GPa] = 210; density [kg/m^3] = 7800;
                     shear_modulus [GPa] = 80; modes = (torsion = 2); }
        joint base: fixed(ground(0, 0, 0) [m], shaft.start);
        output twist [mm] = shaft.torsion[0];
    }
}

fn main() {}
