//! What a beam is made of.

linkwright::mechanism! {
    planar Beams {
        param span [m] = 1;
        beam no_section { length [m] = 1; young [GPa] = 70; mass [kg] = 1; }
        beam no_young   { length [m] = 1; section = circle(diameter [mm] = 7); mass [kg] = 1; }
        beam no_length  { section = circle(diameter [mm] = 7); young [GPa] = 70; mass [kg] = 1; }
        beam no_mass    { length [m] = 1; section = circle(diameter [mm] = 7); young [GPa] = 70; }
        beam soft       { length [m] = 1; section = circle(diameter [mm] = 7); young [GPa] = 0; mass [kg] = 1; }
        beam thin       { length [m] = 1; section = circle(diameter [mm] = -7); young [GPa] = 70; mass [kg] = 1; }
        beam hollow     { length [m] = 1; section = tube(outer [mm] = 6, inner [mm] = 8); young [GPa] = 70; mass [kg] = 1; }
        beam twice      { length [m] = 1; section = circle(diameter [mm] = 7); area [mm^2] = 3; young [GPa] = 70; mass [kg] = 1; }
        beam excited    { length [m] = 1; section = circle(diameter [mm] = 7); young [GPa] = 70; mass [kg] = 1; damping_ratio = -0.1; }
        beam growing    { length = span; section = circle(diameter [mm] = 7); young [GPa] = 70; mass [kg] = 1; }
    }
}

fn main() {}
