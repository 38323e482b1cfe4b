//! Bevel gears in the plane.

linkwright::mechanism! {
    planar Cones {
        disk small { mass [kg] = 1; radius [mm] = 20; toothing rim: bevel(teeth = 20, module [mm] = 2, cone [deg] = 45); }
        disk large { mass [kg] = 1; radius [mm] = 20; toothing rim: bevel(teeth = 20, module [mm] = 2, cone [deg] = 45); }
        joint first: revolute(ground(0, 0) [mm], small.center);
        joint second: revolute(ground(40, 0) [mm], large.center);
        gear pair: gear(small.rim, large.rim);
    }
}

fn main() {}
