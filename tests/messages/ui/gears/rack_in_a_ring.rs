//! A rack in a ring.

linkwright::mechanism! {
    planar Rack {
        disk pinion { mass [kg] = 1; radius [mm] = 20; toothing rim: internal(teeth = 20, module [mm] = 2); }
        body bar {
            mass [kg] = 1; inertia [kg*m^2] = 0.01;
            point near [mm] = (-90, 0); point far [mm] = (90, 0);
            line pitch = (bar.near, bar.far);
            toothing teeth: rack(module [mm] = 2, line = bar.pitch);
        }
        joint axle: revolute(ground(0, 20) [mm], pinion.center);
        joint rail: prismatic(ground(0, 0) [mm], bar.center, axis = (1, 0));
        gear drive: gear(pinion.rim, bar.teeth);
    }
}

fn main() {}
