//! A planar loop of revolute joints in space: three rows repeat others.

linkwright::mechanism! {
    spatial Wrong {
        box left  { mass [kg] = 1; size [m] = (1, 0.1, 0.1); point near [m] = (-0.5, 0, 0); point far [m] = (0.5, 0, 0); }
        box above { mass [kg] = 2; size [m] = (2, 0.1, 0.1); point near [m] = (-1, 0, 0); point far [m] = (1, 0, 0); }
        box right { mass [kg] = 1; size [m] = (1.5, 0.1, 0.1); point near [m] = (-0.75, 0, 0); point far [m] = (0.75, 0, 0); }
        joint a: revolute(ground(0, 0, 0) [m], left.near, axis = (0, 0, 1));
        joint b: revolute(left.far, above.near, axis = (0, 0, 1));
        joint c: revolute(above.far, right.far, axis = (0, 0, 1));
        joint d: revolute(ground(2, 0, 0) [m], right.near, axis = (0, 0, 1));
        start { a.angle [deg] = 90; d.angle [deg] ~ 90; }
    }
}

fn main() {}
