//! Held gates of what yields beside a rigid contact.

linkwright::mechanism! {
    planar Bench {
        gravity [m/s^2] = (0, -9.81);
        disk ball { mass [kg] = 1; radius [m] = 0.1; }
        surface floor: half_plane(line(ground(0, 0) [m], ground(1, 0) [m]));
        disk other { mass [kg] = 1; radius [m] = 0.1; }
        contact touch: between(ball.surface, floor) = rigid(restitution = 0.5);
        contact soft: between(other.surface, floor) = kelvin_voigt(stiffness [N/m] = 1e4);
        options { contact = held; }
        start { ball.center.x [m] = 0; ball.center.y [m] = 1; ball.angle [rad] = 0; other.center.x [m] = 1; other.center.y [m] = 1; other.angle [rad] = 0; }
    }
}

fn main() {}
