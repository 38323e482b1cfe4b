//! There is none of that name.

linkwright::mechanism! {
    planar Bench {
        gravity [m/s^2] = (0, -9.81);
        disk ball { mass [kg] = 1; radius [m] = 0.1; }
        disk other { mass [kg] = 1; radius [m] = 0.2; }
        rod arm { mass [kg] = 1; length [m] = 1; surface tip: point(arm.end); surface foot: circle(arm.start, radius [m] = 0.05); }
        surface floor: half_plane(line(ground(0, 0) [m], ground(1, 0) [m]));
        contact first: between(other.surface, floor) = kelvin_voigt(stiffness [N/m] = 1e4);
        contact second: between(arm.tip, floor) = kelvin_voigt(stiffness [N/m] = 1e4);
        contact third: between(arm.foot, floor) = kelvin_voigt(stiffness [N/m] = 1e4);
        start { ball.center.x [m] = 0; ball.center.y [m] = 1; other.center.x [m] = 3; other.center.y [m] = 1; arm.center.x [m] = 6; arm.center.y [m] = 1; }
        contact touch: between(ball.surface, floor) = kelvin_voigt(stiffness [N/m] = 1e4);
        output speed [m/s] = touch.swing;
    }
}

fn main() {}
