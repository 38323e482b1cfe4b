//! Friction of what is no contact.

linkwright::mechanism! {
    planar Floor {
        gravity [m/s^2] = (0, -9.81);
        disk ball { mass [kg] = 1; radius [m] = 0.1; }
        surface floor: half_plane(line(ground(0, 0) [m], ground(1, 0) [m]));
        contact touch: between(ball.surface, floor) = kelvin_voigt(stiffness [N/m] = 1e4);
        friction grip: on(touhc) = coulomb(coefficient = 0.3, speed [m/s] = 0.01);
        start { ball.center.x [m] = 0; ball.center.y [m] = 0.2; ball.angle [rad] = 0; }
    }
}

fn main() {}
