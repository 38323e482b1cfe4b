//! Surfaces that go along what bends.

linkwright::mechanism! {
    planar Floor {
        gravity [m/s^2] = (0, -9.81);
        disk ball { mass [kg] = 1; radius [m] = 0.1; }
        beam bar { length [m] = 1; section = circle(diameter [mm] = 8); young [GPa] = 70; density [kg/m^3] = 2700; modes = (bending = 1);
                   surface back: half_plane(line(bar.start, bar.end)); }
        joint root: revolute(ground(-0.5, 0) [m], bar.start);
        surface edge: segment(bar.start, bar.center, radius [mm] = 4);
        surface all: polygon(bar.start, bar.center, bar.end);
        contact touch: between(ball.surface, bar.back) = kelvin_voigt(stiffness [N/m] = 1e4);
        contact other: between(ball.surface, edge) = kelvin_voigt(stiffness [N/m] = 1e4);
        contact third: between(ball.surface, all) = kelvin_voigt(stiffness [N/m] = 1e4);
        friction grip: on(touch) = coulomb(coefficient = 0.3, speed [m/s] = 0.01);
        start { ball.center.x [m] = 0; ball.center.y [m] = 0.2; ball.angle [rad] = 0; }
    }
}

fn main() {}
