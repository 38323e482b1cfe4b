//! A particle has no extent.

linkwright::mechanism! {
    planar Bead {
        particle bead { mass [kg] = 1; point top [m] = (0, 1); }
        joint wire: point_on_line(line(ground(0, 0), ground(1, 0) [m]), bead.center);
    }
}

fn main() {}
