//! One ball has no other.

linkwright::mechanism! {
    planar Bench {
        disk ball[0] { mass [kg] = 1; radius [m] = 0.1; }
        contact hit: between(each ball[i].surface, each ball[j].surface) = kelvin_voigt(stiffness [N/m] = 1e4);
        start { ball[0].center.x [m] = 0; ball[0].center.y [m] = 1; ball[0].angle [rad] = 0; }
    }
}

fn main() {}
