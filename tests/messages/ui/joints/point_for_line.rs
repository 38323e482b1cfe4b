//! A point where a line is expected.

linkwright::mechanism! {
    planar Slider {
        body guide { mass [kg] = 1; inertia [kg*m^2] = 1; point tip [m] = (1, 0); }
        particle block { mass [kg] = 1; }
        joint pivot: revolute(ground(0, 0) [m], guide.center);
        joint slot: point_on_line(guide.tip, block.center);
    }
}

fn main() {}
