//! A curve with a corner, where its point would jump from one velocity to another.

linkwright::mechanism! {
    planar Wire {
        gravity [m/s^2] = (0, -9.81);
        particle bead { mass [kg] = 0.2; }
        joint wire: point_on_curve(ground(0, 0) [m], bead.center, y = abs(wire.parameter));
    }
}

fn main() {}
