//! Dry friction where surfaces slide along any direction.

linkwright::mechanism! {
    spatial Floor {
        gravity [m/s^2] = (0, 0, -9.81);
        sphere ball { mass [kg] = 1; radius [m] = 0.1; }
        surface floor: plane(ground(0, 0, 0) [m], axis = (0, 0, 1));
        contact touch: between(ball.surface, floor) = rigid(restitution = 0.5);
        friction grip: on(touch) = dry(static = 0.3);
        start { ball.center.x [m] = 0; ball.center.y [m] = 0; ball.center.z [m] = 0.2; }
    }
}

fn main() {}
