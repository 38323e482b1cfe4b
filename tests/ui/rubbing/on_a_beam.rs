//! Friction along a beam.

linkwright::mechanism! {
    planar Floor {
        gravity [m/s^2] = (0, -9.81);
        disk ball { mass [kg] = 1; radius [m] = 0.1; }
        beam bar { length [m] = 1; section = circle(diameter [mm] = 8); young [GPa] = 70; density [kg/m^3] = 2700; modes = (bending = 1); }
        joint root: revolute(ground(-0.5, 0) [m], bar.start);
        surface top: circle(bar.end, radius [mm] = 10);
        contact touch: between(ball.surface, top) = kelvin_voigt(stiffness [N/m] = 1e4);
        friction grip: on(touch) = coulomb(coefficient = 0.3, speed [m/s] = 0.01);
        start { ball.center.x [m] = 0; ball.center.y [m] = 0.2; ball.angle [rad] = 0; }
    }
}

fn main() {}
