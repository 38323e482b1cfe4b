//! Gates of nothing.

linkwright::mechanism! {
    planar Bench {
        gravity [m/s^2] = (0, -9.81);
        disk ball { mass [kg] = 1; radius [m] = 0.1; }
        start { ball.center.x [m] = 0; ball.center.y [m] = 1; ball.angle [rad] = 0; }
        options { contact = held; }
    }
}

fn main() {}
