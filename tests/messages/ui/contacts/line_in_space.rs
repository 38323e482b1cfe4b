//! Spheres touch at a point.

linkwright::mechanism! {
    spatial Bench {
        material steel { modulus [Pa] = 207e9; poisson = 0.3; }
        sphere ball { mass [kg] = 1; radius [m] = 0.1; }
        surface post: sphere(ground(0, 0, 0) [m], radius [m] = 0.2);
        contact touch: between(ball.surface, post) = hertz_line(first = steel, second = steel, length [mm] = 20, dissipation [s/m] = 0);
        start { ball.center.x [m] = 0; ball.center.y [m] = 0; ball.center.z [m] = 1; ball.orientation = (1, 0, 0, 0); }
    }
}

fn main() {}
