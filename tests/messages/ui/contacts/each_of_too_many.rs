//! 81 pairs.

linkwright::mechanism! {
    planar Bench {
        repeat i in 0..9 {
            disk ball[i] { mass [kg] = 1; radius [m] = 0.1; }
            start { ball[i].center.x [m] = i; ball[i].center.y [m] = 1; ball[i].angle [rad] = 0; }
        }
        surface floor: half_plane(line(ground(0, 0) [m], ground(1, 0) [m]));
        repeat j in 0..9 { surface pan[j]: circle(ground(j, -2) [m], radius [m] = 0.1); }
        contact lies: between(each ball[i].surface, each pan[j]) = kelvin_voigt(stiffness [N/m] = 1e4);
    }
}

fn main() {}
