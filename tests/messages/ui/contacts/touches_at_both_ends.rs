//! Each with a speed of its own.

linkwright::mechanism! {
    planar Bench {
        rod bar { mass [kg] = 1; length [m] = 1; surface sole: segment(bar.start, bar.end, radius [m] = 0.05); }
        surface floor: half_plane(line(ground(0, 0) [m], ground(1, 0) [m]));
        contact touch: between(bar.sole, floor) = hunt_crossley(force [N] = 900, depth [mm] = 10, restitution = 0.8, speed = touch);
        start { bar.center.x [m] = 0; bar.center.y [m] = 1; bar.angle [rad] = 0.2; }
        options { contact = held; }
    }
}

fn main() {}
