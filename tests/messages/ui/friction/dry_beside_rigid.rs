//! Friction that sticks in a joint, where something strikes rigidly.

linkwright::mechanism! {
    planar Mount {
        gravity [m/s^2] = (0, -9.81);
        rod arm { mass [kg] = 1; length [m] = 1; surface tip: point(arm.end); }
        surface floor: half_plane(line(ground(0, -0.5) [m], ground(1, -0.5) [m]));
        joint pin: revolute(ground(0, 0) [m], arm.start);
        contact stop: between(arm.tip, floor) = rigid(restitution = 0.5);
        friction rub: on(pin) = dry(static = 0.5, radius [m] = 0.02);
        start { pin.angle [deg] = 0; }
    }
}

fn main() {}
