//! Its ends rise by different ways.

linkwright::mechanism! {
    planar Bench {
        gravity [m/s^2] = (0, -9.81);
        signal lift [m] = 0.1 [m]*sin(3 [rad/s]*time);
        disk ball { mass [kg] = 1; radius [m] = 0.1; }
        surface pan: half_plane(line(ground(0 [m], lift), ground(1 [m], 0.2 [m])));
        contact touch: between(ball.surface, pan) = kelvin_voigt(stiffness [N/m] = 1000);
        start { ball.center.x [m] = 0; ball.center.y [m] = 1; ball.angle [rad] = 0; }
    }
}

fn main() {}
