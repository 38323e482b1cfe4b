//! It keeps none.

linkwright::mechanism! {
    planar Bench {
        gravity [m/s^2] = (0, -9.81);
        material steel { modulus [Pa] = 207e9; poisson = 0.3; }
        disk ball { mass [kg] = 1; radius [m] = 0.1; }
        surface floor: half_plane(line(ground(0, 0) [m], ground(1, 0) [m]));
        contact touch: between(ball.surface, floor) = hunt_crossley(force [N] = 900, depth [mm] = 10, restitution = 0.8, speed [m/s] = 1);
        start { ball.center.x [m] = 0; ball.center.y [m] = 1; ball.angle [rad] = 0; }
        output last [m/s] = touch.speed;
    }
}

fn main() {}
