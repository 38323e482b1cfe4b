//! `axes = moving` between a pinion and its rack.

linkwright::mechanism! {
    planar Rack {
        body pinion { mass [kg] = 1; inertia [kg*m^2] = 1e-3; toothing rim: external(teeth = 20, module [mm] = 2); }
        body bar { mass [kg] = 1; inertia [kg*m^2] = 1e-3; point near [mm] = (-90, 0); point far [mm] = (90, 0); line pitch = (bar.near, bar.far);
                   toothing teeth: rack(module [mm] = 2, line = bar.pitch); }
        joint axle: revolute(ground(0, 20) [mm], pinion.center);
        joint rail: prismatic(ground(0, 0), bar.center, axis = (1, 0));
        mesh drive: mesh(pinion.rim, bar.teeth, stiffness [N/m] = 1e8, axes = moving);
    }
}

fn main() {}
