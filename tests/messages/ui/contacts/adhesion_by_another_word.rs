//! It is on, or not written.

linkwright::mechanism! {
    planar Bench {
        gravity [m/s^2] = (0, -9.81);
        material steel { modulus [Pa] = 207e9; poisson = 0.3; }
        disk ball { mass [kg] = 1; radius [m] = 0.1; }
        surface floor: half_plane(line(ground(0, 0) [m], ground(1, 0) [m]));
        contact touch: between(ball.surface, floor) = kelvin_voigt(stiffness [N/m] = 1e4, adhesion = strong);
        start { ball.center.x [m] = 0; ball.center.y [m] = 1; ball.angle [rad] = 0; }
    }
}

fn main() {}
